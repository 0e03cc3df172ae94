//! The comb of the plane and the copies that it makes: larger steps, closer copies, in both directions.

use crate::error::Result;
use crate::field::star::SiemensStar;
use crate::figure::images::view::{in_decibels, picture, spectrum};
use crate::figure::params::Param;
use crate::figure::picture::part;
use crate::figure::{Entry, Figure, Layer, Meaning, Panel};
use crate::grid::Grid;
use crate::image::dft::forward;
use crate::image::filter::{Filter, Shape};
use crate::image::{Image, ImageBins};
use crate::laws::plane::transform_rounding;
use crate::num::{cos_pi, sin_pi};
use crate::residual::Residual;
use crate::text;
use crate::text::{Text, number};
use num_complex::Complex;

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[COPIES];

static BAND: Text =
    Text::fixed("highest frequency, periods across the picture", "верхняя частота, периодов на картинку");

const COPIES: Entry = Entry {
    id: "x-plane-copies",
    inventory: &["F20"],
    errata: &["E07"],
    title: &Text::fixed("The larger the step, the closer the copies", "Чем больше шаг, тем ближе копии"),
    caption: &Text::fixed(
        "A star without frequencies above the circle, times the comb of the plane: every second, fourth, sixth pixel is \
         kept, in both directions. Its spectrum repeats on a square lattice, 1/T apart. As long as the circles do not meet, \
         the one in the middle is untouched, and cutting it out restores the star; with the largest step they overlap. (Of the pictures the middle quarter is shown.)",
        "Звезда без частот за пределами круга, умноженная на плоский гребень Дирака: по обоим направлениям остаётся каждый \
         второй, четвёртый, шестой пиксель. Её спектр повторяется на квадратной решётке с шагом 1/T. Пока круги не \
         пересеклись, средний цел, и, вырезав его, можно восстановить звезду; при самом большом шаге они накладываются. (От картинок показана середина.)",
    ),
    params: &[Param::count("B", &BAND, 14, 8, 24)],
    build: |params| copies(params.count("B")),
};

/// Pixels along a side: all the steps divide it.
const SIDE: usize = 120;
const STEPS: [usize; 3] = [2, 4, 6];
/// Pixels along a side of what is shown of the pictures.
const MIDDLE: usize = 60;
/// The darkest tone of a spectrum, in decibels.
const FLOOR: f64 = -60.0;

/// `Ш·f`: every `step`-th pixel in both directions with the weight `step²`, zero between.
fn combed(image: &Image, step: usize) -> Result<Image> {
    let weight = (step * step) as f64;
    let kept = |i: usize| i.is_multiple_of(step);
    let values = image.values().iter().enumerate();
    let combed = values.map(|(n, v)| if kept(n % SIDE) && kept(n / SIDE) { weight * v } else { 0.0 });
    Image::new(image.grid(), combed.collect())
}

/// The middle of a picture.
fn middle(image: &Image) -> Result<Image> {
    let along = (SIDE - MIDDLE) / 2..(SIDE + MIDDLE) / 2;
    part(image, along.clone(), along)
}

/// The circle of the band around every copy whose middle is shown, as one line.
fn circles(step: usize, radius: f64) -> Vec<[f64; 2]> {
    let apart = (SIDE / step) as f64;
    let most = (step / 2) as i64;
    let middles = (-most..=most).flat_map(|k| (-most..=most).map(move |l| [k as f64 * apart, l as f64 * apart]));
    let end = 0.5 * SIDE as f64 - 0.5;
    let circle = |[u, v]: [f64; 2]| {
        let turn = move |i: i32| 2.0 * f64::from(i) / 48.0;
        let around = (0..=48).map(move |i| [u + radius * cos_pi(turn(i)), v + radius * sin_pi(turn(i))]);
        around.map(move |p| if p.iter().all(|x| x.abs() <= end) { p } else { [f64::NAN; 2] }).chain([[f64::NAN; 2]])
    };
    middles.flat_map(circle).collect()
}

/// The largest difference of the combed image's spectrum to the sum of the copies, and the energy that the other copies
/// have inside the circle, relative to the one in the middle.
fn found(whole: &ImageBins, sampled: &ImageBins, step: usize, radius: f64) -> [f64; 2] {
    let (n, apart) = (SIDE as i64, (SIDE / step) as i64);
    let (mut worst, mut leaked, mut own) = (0.0f64, 0.0, 0.0);
    for l in -n / 2..n / 2 {
        for k in -n / 2..n / 2 {
            let copies = (0..step as i64).flat_map(|a| (0..step as i64).map(move |b| [k - a * apart, l - b * apart]));
            let sum: Complex<f64> = copies.map(|[k, l]| whole.bin(k, l)).sum();
            worst = worst.max((sampled.bin(k, l) - sum).norm());
            if (k as f64).hypot(l as f64) < radius {
                leaked += (sampled.bin(k, l) - whole.bin(k, l)).norm_sqr();
                own += whole.bin(k, l).norm_sqr();
            }
        }
    }
    [worst, leaked / own]
}

fn copies(band: usize) -> Result<Figure> {
    let side = SIDE as f64;
    let radius = band as f64 + 0.5; // between two bins
    let star = Image::averaged(&SiemensStar::new([0.0, 0.0], 6)?, Grid::centered(1.0, SIDE, SIDE)?);
    let limited = Filter::low_pass(radius / side, Shape::Ideal)?.apply(&star);
    let whole = forward(&limited);
    let size = whole.bin(0, 0).norm();
    let rounding = transform_rounding(SIDE * SIDE) * limited.values().iter().map(|v| v.abs()).sum::<f64>();
    let reach = SIDE / 2 - 1;
    let view = |name, bins: &ImageBins, step: usize| -> Result<Panel> {
        let title = if step == 1 { in_decibels(FLOOR) } else { Text::EMPTY };
        Ok(spectrum(name, title, bins, FLOOR, reach)?
            .with(Layer::line("copies", Meaning::Replica, circles(step, radius)).thin())
            .with(Layer::line("band", Meaning::Leaked, circles(1, radius)).thick()))
    };
    let mut figure =
        Figure::new(4).with(picture("whole", text!("every pixel", "все пиксели"), &middle(&limited)?, (0.0, 1.0)));
    let mut below = vec![view("whole-spectrum", &whole, 1)?];
    let mut claims = Vec::new();
    for (step, names) in STEPS.into_iter().zip([
        ["second", "second-spectrum"],
        ["fourth", "fourth-spectrum"],
        ["sixth", "sixth-spectrum"],
    ]) {
        let sampled = combed(&limited, step)?;
        let bins = forward(&sampled);
        let [worst, leaked] = found(&whole, &bins, step, radius);
        let apart = SIDE / step;
        let (weight, white) = ((step * step) as f64, (SIDE * SIDE) as f64);
        figure = figure.with(picture(names[0], text!("T = {step}", "T = {step}"), &middle(&sampled)?, (0.0, weight)));
        below.push(view(names[1], &bins, step)?);
        claims.push((
            text!(
                "T = {step}: the spectrum is the sum of copies {apart} bins apart in both directions",
                "T = {step}: спектр есть сумма копий через {apart} отсчётов по обоим направлениям"
            ),
            // as parts of what white would have at zero
            Residual::at_most(
                "spectrum of the combed image = sum of the copies",
                worst / white,
                2.0 * weight * rounding / white,
            ),
        ));
        let free = apart as f64 > 2.0 * radius;
        claims.push(if free {
            (
                text!(
                    "T = {step}: {apart} > 2B = {}: the copy in the middle is untouched",
                    "T = {step}: {apart} > 2B = {}: средняя копия не тронута",
                    number(2.0 * radius, 3)
                ),
                // each bin by the rounding of both transforms, whose squares add up over the circle
                Residual::at_most(
                    "leaked energy over own energy",
                    leaked,
                    (2.0 * weight * rounding / size).powi(2) * 4.0 * radius * radius,
                ),
            )
        } else {
            (
                text!(
                    "T = {step}: {apart} < 2B = {}: {} % as much energy as its own leaks into it",
                    "T = {step}: {apart} < 2B = {}: в неё протекает {} % её собственной энергии",
                    number(2.0 * radius, 3),
                    number(100.0 * leaked, 2)
                ),
                // a real overlap is far above what rounding could make of it
                Residual::at_least("leaked energy over own energy", leaked, 1e3 * rounding / size),
            )
        });
    }
    let figure = below.into_iter().fold(figure, Figure::with);
    Ok(claims.into_iter().fold(figure, |figure, (says, residual)| figure.claim(says, residual)))
}
