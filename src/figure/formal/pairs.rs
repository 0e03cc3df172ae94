//! The lecture's table of Fourier pairs (slide «Преобразования Фурье для некоторых функций»).

use crate::axis::Axis;
use crate::comb::Comb;
use crate::error::Result;
use crate::figure::common::{density_curve, frequency, line_arrows, peak, signal_curve, space, values};
use crate::figure::params::Param;
use crate::figure::{Entry, Figure, Layer, Legend, Meaning, Panel, Scale};
use crate::laws::poisson::{comb_pairing, copies_by_fft, sum_rounding};
use crate::laws::theorems::pair_by_quadrature;
use crate::num::extremum::maximum;
use crate::num::quadrature::even_breaks;
use crate::residual::Residual;
use crate::sampled::dft::forward;
use crate::sampled::{Bins, Samples};
use crate::signal::boxcar::Boxcar;
use crate::signal::constant::Constant;
use crate::signal::gaussian::Gaussian;
use crate::signal::sinc::Sinc;
use crate::signal::theorem::Product;
use crate::signal::tone::Cosine;
use crate::signal::{FourierPair, Signal};
use crate::spectrum::Spectrum;
use crate::text;
use crate::text::{Text, number};
use std::f64::consts::PI;

static STEP: Text = Text::fixed("step T of the comb", "шаг гребня T");

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[TABLE, LIMITS];

/// The tone of the table: `cos x`, ordinary frequency `1/2π`.
fn cos_x() -> Result<Cosine> {
    Cosine::new(0.5 / PI)
}

const TABLE: Entry = Entry {
    id: "f13-pairs",
    inventory: &["F13"],
    errata: &["E01", "E02", "E04"],
    title: &Text::fixed("Functions and their spectra", "Функции и их спектры"),
    caption: &Text::fixed(
        "Five pairs, each with its spectrum to the right; arrows are impulses, their height the weight. Two rows of the \
         printed table are wrong in its own convention: cos x has lines of weight ½ at ±1/(2π), not of weight π at ±½; and \
         the comb Ш_{T} = T·Σδ(x − iT) has lines of weight 1, not 1/T (dashed). The right-hand column is F(ω), not f(ω).",
        "Пять пар, справа от каждой функции — её спектр; стрелки — импульсы, высота — вес. Две строки напечатанной таблицы \
         неверны в её же соглашении: у cos x линии веса ½ в ±1/(2π), а не веса π в ±½; у гребня Ш_{T} = T·Σδ(x − iT) линии \
         веса 1, а не 1/T (штрих). В правом столбце должно стоять F(ω), а не f(ω).",
    ),
    params: &[Param::real("T", &STEP, 2.0, 0.5, 3.0, "")],
    build: |params| table(params.real("T")),
};

/// A panel of the table: small, so with nothing but title and numbers.
fn cell(name: &'static str, title: Text, x: (f64, f64), y: (f64, f64), of_frequency: bool) -> Panel {
    let scale = if of_frequency { frequency(x.0, x.1) } else { space(x.0, x.1) };
    Panel::new(name, title, scale, Scale::linear(Text::EMPTY, y.0, y.1)).legend(Legend::Above)
}

fn table(step: f64) -> Result<Figure> {
    let (unit, bell, tone) = (Boxcar::new(1.0)?, Gaussian::new(1.0)?, cos_x()?);
    let (one, comb) = (Constant::new(1.0)?, Comb::new(step)?);
    let (sinc, bell_spectrum, wave) = (unit.spectrum(), bell.spectrum(), tone.spectrum());
    let (reach, order) = (6.6, 2.7);
    let teeth = (reach / step).floor() as i64;
    let impulses = comb.times(&one, -teeth..=teeth);
    let lines = comb.spectrum((order * step).floor() as usize);
    let printed = |label: Text, layer: Layer| layer.dashed().label(label);
    let curve = |s: &dyn Signal, end: f64| signal_curve("f", Meaning::Signal, &s, -end, end).thick();
    let density = |s: &Spectrum, end: f64| density_curve("F", Meaning::Signal, s, -end, end).thick();
    let figure = Figure::new(4)
        .with(cell("box", text!("box", "box"), (-1.5, 1.5), (-0.3, 1.2), false).with(curve(&unit, 1.5)))
        .with(cell("sinc", text!("sinc ν", "sinc ν"), (-4.5, 4.5), (-0.3, 1.2), true).with(density(&sinc, 4.5)))
        .with(
            cell("gaussian", text!("e^{{−πx²}}", "e^{{−πx²}}"), (-1.8, 1.8), (-0.3, 1.2), false)
                .with(curve(&bell, 1.8)),
        )
        .with(
            cell("gaussian spectrum", text!("e^{{−πν²}}", "e^{{−πν²}}"), (-1.8, 1.8), (-0.3, 1.2), true)
                .with(density(&bell_spectrum, 1.8)),
        )
        .with(cell("constant", text!("1", "1"), (-1.5, 1.5), (-0.3, 1.3), false).with(curve(&one, 1.5)))
        .with(cell("delta", text!("δ(ν)", "δ(ν)"), (-1.2, 1.2), (-0.3, 1.3), true).with(line_arrows(
            "lines",
            Meaning::Samples,
            &one.spectrum(),
        )))
        .with(cell("cosine", text!("cos x", "cos x"), (-9.9, 9.9), (-1.5, 1.5), false).with(curve(&tone, 9.9)))
        .with(
            cell("cosine lines", text!("½ at ±1/(2π)", "½ в ±1/(2π)"), (-0.7, 0.7), (-0.3, 0.7), true)
                .with(printed(
                    text!("printed: ±½", "напечатано: ±½"),
                    Layer::verticals("printed", Meaning::Error, [-0.5, 0.5]),
                ))
                .with(line_arrows("lines", Meaning::Samples, &wave)),
        )
        .with(
            cell(
                "comb",
                text!("Ш_{{T}}: impulses of weight T = {}", "Ш_{{T}}: импульсы веса T = {}", number(step, 3)),
                (-reach - 0.4, reach + 0.4),
                (0.0, 1.3 * step),
                false,
            )
            .span(2)
            .with(Layer::arrows(
                "impulses",
                Meaning::Samples,
                impulses.iter().map(|i| [i.at, i.weight.re]),
            )),
        )
        .with(
            cell(
                "comb lines",
                text!("its lines: weight 1 at k/T", "его линии: вес 1 в k/T"),
                (-order - 0.15, order + 0.15),
                (0.0, 1.3 * (1.0 / step).max(1.0)),
                true,
            )
            .span(2)
            .with(printed(
                text!("printed: 1/T", "напечатано: 1/T"),
                Layer::horizontals("printed", Meaning::Error, [1.0 / step]),
            ))
            .with(line_arrows("lines", Meaning::Samples, &lines)),
        );
    table_claims(figure, step)
}

fn table_claims(figure: Figure, step: f64) -> Result<Figure> {
    let (unit, bell, tone) = (Boxcar::new(1.0)?, Gaussian::new(1.0)?, cos_x()?);
    let sinc = unit.spectrum();
    let size = |nu: f64| sinc.density(nu).norm();
    let lobe = maximum(size, 1.0, 2.0, 16);
    let beyond = figure.panel("sinc").and_then(|p| p.layer("F")).map_or(&[][..], Layer::points);
    let beyond = beyond.iter().filter(|p| p[0].abs() >= 1.0).map(|p| p[1].abs()).fold(0.0, f64::max);
    let zeros = (1..=4).map(f64::from).map(size).fold(0.0, f64::max);
    let frequencies = [0.0, 0.3, 0.5, 1.43, 2.0, 3.7];
    let back = |x: f64| -> Result<f64> { Ok((tone.spectrum().inverse_at(x)?.re - x.cos()).abs()) };
    let worst = (-40..=40).try_fold(0.0f64, |worst, i| Ok(worst.max(back(0.25 * f64::from(i))?)))?;
    let again = Sinc::new(1.0)?.spectrum();
    let same = |x: f64| (again.density(-x).re - unit.at(x)).abs();
    let box_back = (-30..=30).map(|i| same(0.05 * f64::from(i))).fold(0.0, f64::max);
    let self_dual = match (figure.panel("gaussian"), figure.panel("gaussian spectrum")) {
        (Some(f), Some(spectrum)) => match (f.layer("f"), spectrum.layer("F")) {
            (Some(a), Some(b)) => crate::figure::common::difference(a, b),
            _ => f64::NAN,
        },
        _ => f64::NAN,
    };
    Ok(figure
        .claim(
            text!(
                "the box's spectrum is sinc ν: {} at ½, zero at 1, 2, 3, 4",
                "спектр box — sinc ν: {} в ½, нуль в 1, 2, 3, 4",
                number(size(0.5), 4)
            ),
            pair_by_quadrature(&unit, &[-0.5, 0.5], &frequencies, zeros),
        )
        .claim(
            text!(
                "its highest side lobe is {} dB, at ν = {}",
                "высший боковой лепесток: {} дБ при ν = {}",
                number(20.0 * lobe.value.log10(), 4),
                number(lobe.at, 4)
            ),
            Residual::at_most("drawn side lobes ≤ the first", beyond, lobe.value + 2.0 * f64::EPSILON),
        )
        .claim(
            text!("e^{{−πx²}} is its own transform", "e^{{−πx²}} — сама себе преобразование"),
            Residual::at_most("f(t) = F(t)", self_dual, 2.0 * f64::EPSILON),
        )
        .claim(
            text!("and the integral says so too", "и интеграл это подтверждает"),
            pair_by_quadrature(&bell, &even_breaks(-8.0, 8.0, 1.0), &frequencies, 0.0),
        )
        .claim(
            text!(
                "two lines of weight ½ at ±{} give back cos x",
                "две линии веса ½ в ±{} возвращают cos x",
                number(0.5 / PI, 6)
            ),
            // the angle x ≤ 10 is known to 3ε·x on either side
            Residual::at_most("½e^{ix} + ½e^{−ix} = cos x", worst, 8.0 * f64::EPSILON * 10.0),
        )
        .claim(
            text!(
                "with lines of weight 1 the comb's pairing comes out",
                "с линиями веса 1 гребень сходится со своим спектром"
            ),
            comb_pairing(&Gaussian::new(0.6)?, step, 60, 1.0)?,
        )
        .claim(
            text!(
                "transformed twice a function is mirrored: the sinc's spectrum is the box again",
                "после двух преобразований функция зеркальна: спектр sinc — снова box"
            ),
            Residual::at_most("F{sinc}(−x) = box(x)", box_back, 0.0),
        ))
}

const LIMITS: Entry = Entry {
    id: "f13-windows",
    inventory: &["F13"],
    errata: &["E01", "E02"],
    title: &Text::fixed("Impulses as limits", "Импульсы как пределы"),
    caption: &Text::fixed(
        "A constant, a cosine and a comb never end, so they are multiplied by a window e^{−π(x/L)²} and transformed by FFT. \
         The wider the window, the taller and narrower the peaks: height grows like L, the area stays 1, ½ and 1. That area \
         is the weight of the impulse in the limit; the peaks of cos x stand at ±1/(2π) ≈ ±0.159.",
        "Константа, косинус и гребень не кончаются, поэтому они умножены на окно e^{−π(x/L)²} и преобразованы БПФ. Чем шире \
         окно, тем выше и уже пики: высота растёт как L, площадь остаётся 1, ½ и 1. Эта площадь и есть вес импульса в \
         пределе; пики cos x стоят в ±1/(2π) ≈ ±0,159.",
    ),
    params: &[Param::real("T", &STEP, 2.0, 0.5, 3.0, "")],
    build: |params| limits(params.real("T")),
};

const WINDOWS: [f64; 3] = [10.0, 20.0, 40.0];

/// Half the length of the records: `e^{−π(256/40)²}` is far below rounding.
const HALF: f64 = 256.0;

fn limits(step: f64) -> Result<Figure> {
    let axis = Axis::centered(0.25, (8.0 * HALF) as usize)?;
    let teeth = Axis::centered(step, 2 * (HALF / step).ceil() as usize)?;
    let (one, tone) = (Constant::new(1.0)?, cos_x()?);
    let labels = || [text!("L = 10", "L = 10"), text!("20", "20"), text!("40", "40")];
    let columns = [("constant", 0.2, 44.0), ("cosine", 0.3, 22.0), ("comb", 1.3 / step, 44.0)];
    let titles = [
        text!("1: a peak of area 1", "1: пик площади 1"),
        text!("cos x: peaks of area ½", "cos x: пики площади ½"),
        text!("Ш_{{T}}: peaks of area 1", "Ш_{{T}}: пики площади 1"),
    ];
    let mut figure = Figure::new(3);
    for ((name, limit, top), title) in columns.into_iter().zip(titles) {
        let mut panel = Panel::new(name, title, frequency(-limit, limit), values("F(ν)", -0.03 * top, top));
        for ((window, label), i) in WINDOWS.into_iter().zip(labels()).zip(0u8..) {
            let window = Gaussian::new(window)?;
            let bins = match name {
                "constant" => forward(&Samples::of(&Product::new(one, window)?, axis)),
                "cosine" => forward(&Samples::of(&Product::new(tone, window)?, axis)),
                _ => forward(&Samples::of(&window, teeth)),
            };
            // the last one, narrowest and tallest, stands on top and has the leading colour
            let layer = Layer::line("peaks", Meaning::Series(2 - i), unrolled(&bins, limit)).label(label);
            panel = panel.with(if i == 2 { layer.thick() } else { layer });
        }
        figure = figure.with(panel.legend(Legend::Above));
    }
    let drawn: Vec<Vec<Vec<[f64; 2]>>> =
        figure.panels.iter().map(|p| p.layers.iter().map(|l| l.points().to_vec()).collect()).collect();
    let heights = figure.panels.iter().map(|p| p.layers.iter().map(peak).collect::<Vec<_>>()).collect::<Vec<_>>();
    // one transform: rounding of an FFT on values of size ΣT·w = L
    let fft = |l: f64| 8.0 * f64::EPSILON * (axis.len() as f64).log2() * l;
    let worst = |of: &dyn Fn(usize) -> f64| (0..3).map(of).fold(0.0, f64::max);
    let area = |points: &[[f64; 2]], low: f64, high: f64| -> f64 {
        let spacing = points[1][0] - points[0][0];
        points.iter().filter(|p| (low..=high).contains(&p[0])).map(|p| p[1] * spacing).sum()
    };
    let nu = 0.5 / PI;
    let crest = |points: &[[f64; 2]]| {
        points.iter().filter(|p| p[0] > 0.0).fold([0.0, 0.0], |a, b| if b[1] > a[1] { *b } else { a })[0]
    };
    let spacing = 1.0 / axis.span();
    let at_peak = crest(&drawn[1][2]);
    // ∫ beyond z of L·e^{−π(Lν)²} is below e^{−π(Lz)²}/(2πLz), on both sides; and the sum of bins is the integral exactly
    let beyond = |l: f64, z: f64| (-PI * (l * z).powi(2)).exp() / (PI * l * z);
    Ok(figure
        .claim(
            text!(
                "the constant's peak is as high as the window is wide: 10, 20, 40",
                "высота пика константы равна ширине окна: 10, 20, 40"
            ),
            Residual::at_most("F(0) = L", worst(&|i| (heights[0][i] - WINDOWS[i]).abs() / fft(WINDOWS[i])), 1.0),
        )
        .claim(
            text!("and its area is 1 every time", "а площадь его каждый раз 1"),
            Residual::at_most(
                "|area − 1| / (rest beyond the panel + rounding)",
                worst(&|i| {
                    let room = beyond(WINDOWS[i], 0.2) + sum_rounding(axis.len(), 2.0);
                    (area(&drawn[0][i], -0.2, 0.2) - 1.0).abs() / room
                }),
                1.0,
            ),
        )
        .claim(
            text!(
                "the right-hand peak of cos x stands at {} (1/(2π) = {}) and has the area ½",
                "правый пик cos x стоит в {} (1/(2π) = {}), его площадь ½",
                number(at_peak, 3),
                number(nu, 6)
            ),
            Residual::at_most(
                "|area − ½| / (rest beyond the panel + rounding)",
                worst(&|i| {
                    // the bin at zero belongs to both peaks; each loses what lies beyond 0 and beyond the panel's 0.3
                    let half = 0.5 * area(&drawn[1][i], -0.5 * spacing, 0.5 * spacing);
                    let room = 2.0 * beyond(WINDOWS[i], 0.3 - nu) + sum_rounding(axis.len(), 2.0);
                    (area(&drawn[1][i], 0.5 * spacing, 0.3) + half - 0.5).abs() / room
                }),
                1.0,
            ),
        )
        .claim(
            text!("its place is 1/(2π) to half a bin", "место его — 1/(2π) с точностью до полбина"),
            Residual::near("place of the peak", at_peak, nu, 0.5 * spacing + f64::EPSILON),
        )
        .claim(
            text!("the FFT agrees with two shifted Gaussians", "БПФ совпадает с двумя сдвинутыми гауссианами"),
            copies_by_fft(&Product::new(tone, Gaussian::new(40.0)?)?, axis, 1, 0.0)?,
        )
        .claim(
            text!(
                "every line of the comb with T = {} has the area 1",
                "у каждой линии гребня с T = {} площадь 1",
                number(step, 3)
            ),
            Residual::at_most(
                "|area over one period of the copies − 1|",
                worst(&|i| {
                    // half a period to either side, tails of all neighbours included: the sum of all bins is w(0) = 1
                    let (half, edge) = (0.5 / step, 0.25 / teeth.span());
                    (area(&drawn[2][i], -half - edge, half - edge) - 1.0).abs()
                }),
                fft(WINDOWS[2]) + sum_rounding(teeth.len(), 1.0),
            ),
        ))
}

/// The bins over `|ν| ≤ limit`, repeated with the rate as the spectrum of samples is; the record is centred on a sample,
/// so that the repetition has no phase.
fn unrolled(bins: &Bins, limit: f64) -> Vec<[f64; 2]> {
    let axis = bins.axis();
    let count = (limit / axis.step()).floor() as i64;
    (-count..=count).map(|k| k as f64 * axis.step()).map(|nu| [nu, bins.near(nu).re]).collect()
}
