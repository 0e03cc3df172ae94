//! Square and hexagonal lattices for a round band (V26; Petersen and Middleton 1962).

use crate::error::Result;
use crate::figure::params::Param;
use crate::figure::{Entry, Figure, Layer, Meaning, Panel, Scale};
use crate::image::lattice::Lattice;
use crate::num::{cos_pi, sin_pi};
use crate::residual::Residual;
use crate::text;
use crate::text::{Lang, Text, number};

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[HEXAGONAL];

static STEP: Text = Text::fixed("step, over the largest that suffices", "шаг относительно наибольшего достаточного");

const HEXAGONAL: Entry = Entry {
    id: "x-hexagonal",
    inventory: &[],
    errata: &[],
    title: &Text::fixed(
        "A hexagonal lattice needs 13.4 % fewer samples",
        "Гексагональной решётке нужно на 13,4 % меньше отсчётов",
    ),
    caption: &Text::fixed(
        "An image whose spectrum fills a disc of the radius B. Its copies stand on the dual of the lattice of samples, and may \
         touch but not overlap. Six neighbours leave less room between the discs than four: on the hexagonal lattice they \
         touch at √3/2 = 0.866 of the samples, and no other lattice does with less.",
        "Изображение, спектр которого заполняет круг радиуса B. Копии спектра стоят на решётке, двойственной к решётке \
         отсчётов; им можно касаться, но не пересекаться. Шесть соседей оставляют между кругами меньше места, чем четыре: на \
         гексагональной решётке они касаются при √3/2 = 0,866 числа отсчётов, и меньшим не обойдётся никакая решётка.",
    ),
    params: &[Param::real("step", &STEP, 1.0, 0.8, 1.2, "")],
    build: |params| hexagonal(params.real("step")),
};

/// The radius of the band.
const BAND: f64 = 0.5;
/// Half the width and half the height of the panels.
const SHOWN: [f64; 2] = [4.4, 1.8];

/// The same lattice with the steps that many times as long.
fn scaled(lattice: &Lattice, by: f64) -> Result<Lattice> {
    let [a, b] = lattice.basis();
    Lattice::new(a.map(|v| v * by), b.map(|v| v * by))
}

/// The upper and the lower half of the circle around a place.
fn disc([u, v]: [f64; 2]) -> Vec<[f64; 3]> {
    let at = |i: i32| f64::from(i) / 24.0;
    let half = |t: f64| BAND * sin_pi(t);
    let filled = (0..=24).map(|i| [u - BAND * cos_pi(at(i)), v - half(at(i)), v + half(at(i))]);
    filled.chain([[f64::NAN; 3]]).collect()
}

fn circle([u, v]: [f64; 2]) -> Vec<[f64; 2]> {
    let around = (0..=48).map(|i| 2.0 * f64::from(i) / 48.0);
    around.map(|t| [u + BAND * cos_pi(t), v + BAND * sin_pi(t)]).chain([[f64::NAN; 2]]).collect()
}

fn shown(&[x, y]: &[f64; 2], margin: f64) -> bool {
    x.abs() < SHOWN[0] + margin && y.abs() < SHOWN[1] + margin
}

fn panel(name: &'static str, title: Text, below: Text) -> Panel {
    let scale = |label, end: f64| Scale::linear(label, -end, end);
    Panel::new(name, title, scale(below, SHOWN[0]), scale(Text::EMPTY, SHOWN[1])).square()
}

fn hexagonal(step: f64) -> Result<Figure> {
    let lattices = [scaled(&Lattice::square_for(BAND)?, step)?, scaled(&Lattice::hexagonal_for(BAND)?, step)?];
    let names = [["square", "square-copies"], ["hexagonal", "hexagonal-copies"]];
    let called = [text!("square", "квадратная"), text!("hexagonal", "гексагональная")];
    let reach = SHOWN[0].hypot(SHOWN[1]) + 1.0;
    let (mut above, mut below, mut claims) = (Vec::new(), Vec::new(), Vec::new());
    for ((lattice, [space, copies]), called) in lattices.iter().zip(names).zip(&called) {
        let density = number(lattice.density(), 3);
        let (en, ru) = (called.get(Lang::En), called.get(Lang::Ru));
        let title = text!("{en}: {density} per unit²", "{ru}: {density} на ед.²");
        let points: Vec<[f64; 2]> = lattice.points(reach)?.into_iter().filter(|p| shown(p, -0.1)).collect();
        above.push(panel(space, title, Text::same("x")).with(Layer::dots("samples", Meaning::Samples, points)));

        let dual = lattice.dual();
        let middles: Vec<[f64; 2]> = dual.points(reach)?.into_iter().filter(|p| shown(p, BAND)).collect();
        let (own, others): (Vec<[f64; 2]>, Vec<[f64; 2]>) = middles.iter().partition(|p| p[0].hypot(p[1]) < BAND);
        let discs = |of: &[[f64; 2]]| of.iter().flat_map(|&p| disc(p)).collect::<Vec<_>>();
        let covered = std::f64::consts::PI * BAND * BAND * lattice.density().recip();
        let filled = number(100.0 * covered, 3);
        below.push(
            panel(copies, text!("copies: {filled} % of the plane", "копии: {filled} % плоскости"), Text::same("u"))
                .with(Layer::between("copies", Meaning::Replica, discs(&others)))
                .with(Layer::line("edges", Meaning::Replica, others.iter().flat_map(|&p| circle(p))))
                .with(Layer::between("own", Meaning::Signal, discs(&own)))
                .with(Layer::line("edge", Meaning::Signal, own.iter().flat_map(|&p| circle(p))).thick()),
        );
        // the copies that are drawn
        let distance = others.iter().map(|p| p[0].hypot(p[1])).fold(f64::INFINITY, f64::min);
        let neighbours = others.iter().filter(|p| p[0].hypot(p[1]) < distance * (1.0 + 1e-9)).count();
        let apart = number(distance / BAND, 4);
        claims.push((
            match step.total_cmp(&1.0) {
                std::cmp::Ordering::Equal => {
                    text!(
                        "{en}: {neighbours} neighbours, {apart}·B away: they touch",
                        "{ru}: соседей {neighbours}, на расстоянии {apart}·B: касаются"
                    )
                }
                std::cmp::Ordering::Less => {
                    text!(
                        "{en}: {neighbours} neighbours, {apart}·B away: room is left",
                        "{ru}: соседей {neighbours}, на расстоянии {apart}·B: остаётся зазор"
                    )
                }
                std::cmp::Ordering::Greater => {
                    text!(
                        "{en}: {neighbours} neighbours, {apart}·B away: they overlap",
                        "{ru}: соседей {neighbours}, на расстоянии {apart}·B: пересекаются"
                    )
                }
            },
            Residual::near("distance of the nearest copies = 2B/step", distance, 2.0 * BAND / step, 8.0 * f64::EPSILON),
        ));
    }
    let ratio = lattices[1].density() / lattices[0].density();
    let figure = above.into_iter().chain(below).fold(Figure::new(2), Figure::with);
    let figure = claims.into_iter().fold(figure, |figure, (says, residual)| figure.claim(says, residual));
    Ok(figure.claim(
        text!(
            "the hexagonal lattice needs √3/2 = {} of the samples",
            "гексагональной решётке нужно √3/2 = {} отсчётов",
            number(ratio, 4)
        ),
        Residual::near("hexagonal over square density = √3/2", ratio, 0.75f64.sqrt(), 8.0 * f64::EPSILON),
    ))
}
