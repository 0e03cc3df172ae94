//! A square wave from its harmonics (slide «Преобразование Фурье»: f, f + 3f, f + 3f + 5f, …).

use crate::error::Result;
use crate::figure::common::{PIECES, peak, signal_curve, space, values};
use crate::figure::params::Param;
use crate::figure::{Entry, Figure, Layer, Legend, Meaning, Panel, Scale};
use crate::laws::poisson::sum_rounding;
use crate::num::extremum::maximum;
use crate::num::quadrature::{even_breaks, integrate_pieces};
use crate::num::sin_pi;
use crate::num::special::si;
use crate::residual::Residual;
use crate::signal::series::{PartialSum, Wave};
use crate::signal::{FourierPair, Signal, from_fn};
use crate::text;
use crate::text::{Text, number};
use std::f64::consts::PI;

static TERMS: Text = Text::fixed("number of terms N in the last stage", "число слагаемых N на последней стадии");
static LITERAL_TERMS: Text = Text::fixed("number of terms N", "число слагаемых N");

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[SERIES, LITERAL];

/// What is shown: one period and a quarter to either side.
const SHOWN: (f64, f64) = (-0.25, 1.25);

/// `f + 3f + … + (2N−1)f`, as short as it can be said.
fn name(terms: u32) -> Text {
    match terms {
        1 => text!("f", "f"),
        2 => text!("f + 3f", "f + 3f"),
        3 => text!("f + 3f + 5f", "f + 3f + 5f"),
        n => text!("f + … + {}f", "f + … + {}f", 2 * n - 1),
    }
}

/// The square wave as a curve, its jumps as vertical strokes.
fn square() -> Layer {
    let jumps =
        [0.0, 0.5, 1.0].into_iter().flat_map(|x| [[x, Wave::Square.at(x - 0.1)], [x, Wave::Square.at(x + 0.1)]]);
    let (low, high) = SHOWN;
    let ends = |x: f64| [x, Wave::Square.at(x)];
    let points: Vec<_> = std::iter::once(ends(low)).chain(jumps).chain(std::iter::once(ends(high))).collect();
    Layer::line("square", Meaning::Guide, points).dashed()
}

const SERIES: Entry = Entry {
    id: "f11-series",
    inventory: &["F11"],
    errata: &["E16"],
    title: &Text::fixed("A square wave, harmonic by harmonic", "Прямоугольная волна из гармоник"),
    caption: &Text::fixed(
        "Waves of the odd frequencies f, 3f, 5f, … with amplitudes 4/π·(1, 1/3, 1/5, …) add up to a square wave. Every \
         further one brings the sum closer on average; the overshoot at the jumps only gets narrower, and its height tends \
         to 8.95 % of the jump (Wilbraham, Gibbs). (The slide's labels leave the amplitudes out.)",
        "Волны нечётных частот f, 3f, 5f, … с амплитудами 4/π·(1, 1/3, 1/5, …) складываются в прямоугольную волну. С каждой \
         следующей сумма в среднем ближе; выброс у скачка становится только уже, а высота его стремится к 8,95 % скачка \
         (Уилбрэм, Гиббс). (В подписях на слайде амплитуды пропущены.)",
    ),
    params: &[Param::count("N", &TERMS, 8, 4, 30)],
    build: |params| series(params.count("N")),
};

fn series(last: usize) -> Result<Figure> {
    let stages: Vec<u32> = [1, 2, 3, last as u32].into();
    let sums: Vec<PartialSum> = stages.iter().map(|&n| PartialSum::new(Wave::Square, n, 1.0)).collect::<Result<_>>()?;
    let mut figure = Figure::new(4);
    // the drawn grid holds every 1/(4N) of the lecture's stages: 1/4, 1/8, 1/12, 1/32
    let pieces = 1440;
    const WAVES: [&str; 4] = ["wave 1", "wave 2", "wave 3", "wave 4"];
    const BARS: [&str; 4] = ["bars 1", "bars 2", "bars 3", "bars 4"];
    let top = 2.0 * f64::from(stages[3]);
    for ((sum, &n), id) in sums.iter().zip(&stages).zip(WAVES) {
        let curve = Layer::curve("sum", Meaning::Signal, SHOWN.0, SHOWN.1, pieces, |x| sum.at(x)).thick();
        let panel = Panel::new(id, name(n), space(SHOWN.0, SHOWN.1), values("f(x)", -1.6, 1.6));
        figure = figure.with(panel.with(square()).with(curve));
    }
    for (sum, id) in sums.iter().zip(BARS) {
        let lines = sum.spectrum();
        // sine of amplitude a: lines of weight a/2
        let bars = lines.lines().iter().filter(|l| l.at > 0.0).map(|l| [l.at, 2.0 * l.weight.norm()]);
        let harmonic = Scale::linear(text!("frequency / f", "частота / f"), 0.0, top);
        let amplitude = Scale::linear(text!("amplitude", "амплитуда"), 0.0, 1.5);
        let layer = Layer::bars("amplitudes", Meaning::Signal, 0.035 * top, bars);
        figure = figure.with(Panel::new(id, Text::EMPTY, harmonic, amplitude).with(layer));
    }
    let limit = 2.0 * si(PI) / PI;
    for (sum, &n) in sums.iter().zip(&stages) {
        let terms = f64::from(n);
        let first = maximum(|x| sum.at(x), 0.0, 0.5 / terms, 16);
        // S′ = 4·sin(4πNx)/sin(2πx): the first zero is 1/(4N); midpoint rule of (2/π)·∫₀^π sin t/t, whose second
        // derivative is at most 1/3: off by no more than π²/(36N²)
        figure = figure.claim(
            text!(
                "N = {n}: the first peak is {} at x = 1/(4N)",
                "N = {n}: первый пик равен {} при x = 1/(4N)",
                number(first.value, 7)
            ),
            Residual::near("S(1/(4N)) is the first peak", sum.at(0.25 / terms), first.value, sum_rounding(8, 2.0)),
        );
        figure = figure.claim(
            text!(
                "N = {n}: the mean square error is {}",
                "N = {n}: средний квадрат ошибки равен {}",
                number(mean_square_error(sum, n), 5)
            ),
            Residual::near(
                "mean square error = power of the harmonics left out",
                mean_square_error(sum, n),
                1.0 - (1..=n).map(|k| 0.5 * Wave::Square.term(k).1.powi(2)).sum::<f64>(),
                sum_rounding(16 * n as usize, 4.0),
            ),
        );
    }
    let overshoot = maximum(|x| sums[3].at(x), 0.0, 0.5 / f64::from(stages[3]), 16).value;
    let highest = figure.panel("wave 4").and_then(|p| p.layer("sum")).map_or(f64::NAN, peak);
    Ok(figure
        .claim(
            text!(
                "the overshoot stays: with N = {last} it is {} % of the jump, in the limit {} %",
                "выброс не исчезает: при N = {last} он равен {} % скачка, в пределе {} %",
                number(50.0 * (overshoot - 1.0), 4),
                number(50.0 * (limit - 1.0), 4)
            ),
            Residual::near("peak → (2/π)Si(π)", overshoot, limit, (PI / (6.0 * last as f64)).powi(2)),
        )
        .claim(
            text!("no later peak is higher than the first", "ни один следующий пик не выше первого"),
            Residual::at_most("drawn points above the first peak", highest - overshoot, sum_rounding(8, 2.0)),
        ))
}

/// `∫₀¹ (square − S)²` by quadrature, a piece per swing of the last harmonic.
fn mean_square_error(sum: &PartialSum, terms: u32) -> f64 {
    let half = |a: f64, sign: f64| {
        let breaks = even_breaks(a, a + 0.5, 0.25 / f64::from(terms));
        integrate_pieces(|x| (sign - sum.at(x)).powi(2), &breaks, 1e-15).value
    };
    half(0.0, 1.0) + half(0.5, -1.0)
}

const LITERAL: Entry = Entry {
    id: "f11-literal",
    inventory: &["F11"],
    errata: &["E16"],
    title: &Text::fixed("Why the amplitudes matter", "Почему важны амплитуды"),
    caption: &Text::fixed(
        "The slide labels its stages «f + 3f + … + 15f». Read literally, all harmonics equally strong, the sum is no square \
         wave but a train of spikes; with the amplitudes 4/π·1/(2k − 1) it is one.",
        "На слайде стадии подписаны «f + 3f + … + 15f». Буквально, с одинаково сильными гармониками, сумма — не прямоугольная \
         волна, а череда всплесков; волну дают амплитуды 4/π·1/(2k − 1).",
    ),
    params: &[Param::count("N", &LITERAL_TERMS, 8, 2, 30)],
    build: |params| literal(params.count("N")),
};

fn literal(terms: usize) -> Result<Figure> {
    let right = PartialSum::new(Wave::Square, terms as u32, 1.0)?;
    let equal = from_fn(|x| (1..=terms).map(|k| sin_pi(2.0 * (2 * k - 1) as f64 * x)).sum());
    let harmonics = || (1..=terms).map(|k| (2 * k - 1) as f64);
    let top = 2.0 * terms as f64;
    let bars = |name: &'static str, meaning: Meaning, bars: Vec<[f64; 2]>| {
        let harmonic = Scale::linear(text!("frequency / f", "частота / f"), 0.0, top);
        let amplitude = Scale::linear(text!("amplitude", "амплитуда"), 0.0, 1.5);
        Panel::new(name, text!("amplitudes", "амплитуды"), harmonic, amplitude).with(Layer::bars(
            "amplitudes",
            meaning,
            0.03 * top,
            bars,
        ))
    };
    let weighted: Vec<[f64; 2]> =
        (1..=terms as u32).map(|k| Wave::Square.term(k)).map(|(h, a)| [f64::from(h), a]).collect();
    let crest = maximum(|x| equal.at(x), 0.0, 0.5 / terms as f64, 16).value;
    let right_top = maximum(|x| right.at(x), 0.0, 0.5 / terms as f64, 16).value;
    let wave = |name: &'static str, title: Text, limit: f64| {
        Panel::new(name, title, space(SHOWN.0, SHOWN.1), values("f(x)", -limit, limit)).legend(Legend::Above)
    };
    let drawn = signal_curve("sum", Meaning::Error, &equal, SHOWN.0, SHOWN.1);
    // Σ sin((2k−1)θ) = sin²(Nθ)/sin θ, apart from the places where both vanish
    let closed = |x: f64| sin_pi(2.0 * terms as f64 * x).powi(2) / sin_pi(2.0 * x);
    let off = drawn.points().iter().filter(|[x, _]| sin_pi(2.0 * x).abs() > 1e-3);
    let off = off.map(|[x, y]| (y - closed(*x)).abs()).fold(0.0, f64::max);
    Ok(Figure::new(2)
        .with(
            wave("right", text!("4/π·Σ sin(2π(2k − 1)fx)/(2k − 1)", "4/π·Σ sin(2π(2k − 1)fx)/(2k − 1)"), 1.6)
                .with(square())
                .with(Layer::curve("sum", Meaning::Signal, SHOWN.0, SHOWN.1, 2 * PIECES, |x| right.at(x)).thick()),
        )
        .with(bars("right amplitudes", Meaning::Signal, weighted))
        .with(
            wave(
                "literal",
                text!("Σ sin(2π(2k − 1)fx): as printed", "Σ sin(2π(2k − 1)fx): как напечатано"),
                1.25 * crest,
            )
            .with(square())
            .with(drawn.thick()),
        )
        .with(bars("literal amplitudes", Meaning::Error, harmonics().map(|h| [h, 1.0]).collect()))
        .claim(
            text!(
                "{terms} equal harmonics peak at {}, not at {}",
                "{terms} одинаковых гармоник дают пик {}, а не {}",
                number(crest, 4),
                number(right_top, 4)
            ),
            // at θ = π/(2N) the sum is 1/sin(π/2N) ≥ 2N/π
            Residual::at_least("peak of equal harmonics ≥ 2N/π", crest, 2.0 * terms as f64 / PI),
        )
        .claim(
            text!(
                "the literal sum is sin²(2πNfx)/sin(2πfx), a train of spikes",
                "буквальная сумма равна sin²(2πNfx)/sin(2πfx): череда всплесков"
            ),
            // the quotient is taken where its divisor exceeds 1e-3, and both sides know their angles to 4πNε
            Residual::at_most("Σ sin((2k−1)θ) = sin²(Nθ)/sin θ", off, 1e3 * sum_rounding(terms, 8.0 * terms as f64)),
        ))
}
