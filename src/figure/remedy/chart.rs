//! Three ways against aliasing, measured (slide «Способы антиалиасинга»).

use crate::axis::Axis;
use crate::error::Result;
use crate::figure::common::{PIECES, unmarked};
use crate::figure::params::{Param, Params};
use crate::figure::{Entry, Figure, Layer, Meaning, Panel, Scale};
use crate::kernel::Kernel;
use crate::kernel::catalog::by_name;
use crate::laws::hold::uniform_transfer;
use crate::num::quadrature::{even_breaks, integrate_pieces};
use crate::num::random::uniform;
use crate::num::{cos_pi, sinc};
use crate::residual::Residual;
use crate::sampled::Samples;
use crate::sampled::dft::forward;
use crate::text;
use crate::text::{Text, number};
use num_complex::Complex;
use std::f64::consts::PI;

static TONE: Text = Text::fixed("frequency of the first tone", "частота первого тона");
static COUNT: Text = Text::fixed("samples per pixel n", "отсчётов на пиксель n");
static FILTER: Text = Text::fixed("filter before sampling", "фильтр перед дискретизацией");

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[REMEDIES];

const REMEDIES: Entry = Entry {
    id: "f31-remedies",
    inventory: &["F31"],
    errata: &["E13"],
    title: &Text::fixed("Ways to fight aliasing", "Способы антиалиасинга"),
    caption: &Text::fixed(
        "Two tones that one sample per pixel turns into the same false slow wave, and what three remedies leave of it: \
         a filter before sampling almost nothing; n uniform samples, averaged, little of the slower tone, but the faster \
         one, near n·f_{s}, comes through whole; stochastic samples damp both, and what they take away returns as noise.",
        "Два тона, которые при одном отсчёте на пиксель становятся одной и той же ложной медленной волной, и что от неё \
         оставляют три способа: фильтр перед дискретизацией — почти ничего; среднее n равномерных отсчётов — немного от \
         первого тона, но второй, около n·f_{s}, проходит целиком; случайные отсчёты ослабляют оба, а отнятое \
         возвращается шумом.",
    ),
    params: &[
        Param::count("f", &TONE, 90, 55, 95),
        Param::count("n", &COUNT, 4, 2, 16),
        Param::choice("filter", &FILTER, &["lanczos-3", "box", "tent", "mitchell", "gaussian"]),
    ],
    build: remedies,
};

/// Pixels in a record, a multiple of 100, so that whole percents of the rate fall on its bins; and records.
const PIXELS: usize = 200;
const RECORDS: u64 = 16;
/// How many standard deviations of the noise a measured amplitude or power may be off: one case in 15 000 would be.
const DEVIATIONS: f64 = 4.0;

/// What becomes of a tone: the alias that is the same in every record, and the rest.
struct Outcome {
    /// The first pixels.
    pixels: Vec<[f64; 2]>,
    /// Amplitude and phase of the alias `|c|·cos(2π·at·x + arg c)`.
    coherent: Complex<f64>,
    /// Its frequency.
    at: f64,
    /// The root of the mean square of the rest.
    noise: f64,
}

/// The outcome for pixels `pixel(j)`, `j = 0, 1, …` through all records.
fn outcome(at: f64, pixel: impl Fn(u64) -> f64) -> Result<Outcome> {
    let axis = Axis::new(0.0, 1.0, PIXELS)?;
    let values: Vec<f64> = (0..RECORDS * PIXELS as u64).map(pixel).collect();
    let mut coherent = Complex::<f64>::ZERO;
    for record in values.chunks_exact(PIXELS) {
        // a whole number of periods fits into a record, so that all start with the same phase
        let bins = forward(&Samples::new(axis, record.to_vec())?);
        coherent += bins.near(at) * (2.0 / (axis.span() * RECORDS as f64));
    }
    let mean_square = values.iter().map(|v| v * v).sum::<f64>() / values.len() as f64;
    Ok(Outcome {
        pixels: axis.iter().zip(values).map(|(x, v)| [x, v]).collect(),
        coherent,
        at,
        noise: (mean_square - 0.5 * coherent.norm_sqr()).max(0.0).sqrt(),
    })
}

/// The pixel averaged with that kernel around its middle.
fn averaged(kernel: &dyn Kernel, nu: f64) -> impl Fn(u64) -> f64 {
    // ∫ k(t)·cos 2πν(j − t) dt, where k is even: one integral for all pixels
    let radius = kernel.radius();
    let breaks = even_breaks(-radius, radius, 0.25 / nu.max(1.0));
    let gain = integrate_pieces(|t| kernel.at(t) * cos_pi(2.0 * nu * t), &breaks, 1e-14).value;
    move |j| gain * cos_pi(2.0 * nu * j as f64)
}

/// The mean of `n` samples of a pixel, one in each of its `n` equal parts, `place(j, s)` of the part from its start.
fn mean(nu: f64, n: u32, place: impl Fn(u64, u32) -> f64) -> impl Fn(u64) -> f64 {
    let count = f64::from(n);
    move |j| {
        let at = |s: u32| j as f64 + (f64::from(s) + place(j, s)) / count - 0.5;
        (0..n).map(|s| cos_pi(2.0 * nu * at(s))).sum::<f64>() / count
    }
}

fn remedies(params: &Params) -> Result<Figure> {
    let (percent, n) = (params.count("f") as f64, params.count("n") as u32);
    let kernel = by_name(params.choice("filter"))?;
    let alias = (100.0 - percent) / 100.0;
    let tones = [1.0 - alias, f64::from(n) - alias];
    let mut figure = Figure::new(4);
    let mut measured = Vec::new();
    for (row, nu) in tones.into_iter().enumerate() {
        let outcomes = [
            outcome(alias, |j| cos_pi(2.0 * nu * j as f64))?,
            outcome(alias, averaged(kernel.as_ref(), nu))?,
            outcome(alias, mean(nu, n, |_, _| 0.5))?,
            outcome(alias, mean(nu, n, |j, s| uniform(31, j, s)))?,
        ];
        for (column, outcome) in outcomes.iter().enumerate() {
            figure = figure.with(panel(row, column, nu, n, outcome));
        }
        measured.push(outcomes);
    }
    for (nu, [_, filtered, regular, random]) in tones.into_iter().zip(measured) {
        let tone = number(nu, 4);
        let (passed, taps) = (kernel.response(nu).abs(), uniform_transfer(n, nu).abs());
        // what a part of width 1/n leaves of the tone, and turns into noise that n samples halve n times
        let power = 0.5 * (1.0 - sinc(nu / f64::from(n)).powi(2)) / f64::from(n);
        let pixels = (RECORDS * PIXELS as u64) as f64;
        // ε for each turn of the argument, and for each pixel's rounding
        let rounding = 8.0 * f64::EPSILON * (1.0 + nu) * pixels;
        figure = figure
            .claim(
                text!(
                    "tone {}: the filter {} leaves {}",
                    "тон {}: фильтр {} оставляет {}",
                    tone,
                    kernel.name(),
                    number((1e4 * filtered.coherent.norm()).round() / 1e4, 3)
                ),
                Residual::near("alias after the filter = |K(ν)|", filtered.coherent.norm(), passed, rounding),
            )
            .claim(
                text!(
                    "tone {}: the mean of {} uniform samples leaves {}",
                    "тон {}: среднее {} равномерных отсчётов оставляет {}",
                    tone,
                    n,
                    number(regular.coherent.norm(), 3)
                ),
                Residual::near("alias after the mean = |D(ν)|", regular.coherent.norm(), taps, rounding),
            )
            .claim(
                text!(
                    "tone {}: {} stochastic samples leave {} and noise of {} (root mean square)",
                    "тон {}: случайных отсчётов {}, остаётся {} и шум {} (среднеквадратичный)",
                    tone,
                    n,
                    number(random.coherent.norm(), 2),
                    number(random.noise, 2)
                ),
                // the amplitude is twice the mean product with a wave: the noise in it has the variance 4·power/(2·pixels)
                // in either direction
                Residual::near(
                    "alias after stochastic samples = |sinc ν|",
                    random.coherent.norm(),
                    sinc(nu).abs(),
                    DEVIATIONS * (2.0 * power / pixels).sqrt() * 2f64.sqrt() + rounding,
                ),
            )
            .claim(
                text!(
                    "tone {}: the noise has the power {} that the parts of the pixel took away",
                    "тон {}: мощность шума {} — та, что отняли части пикселя",
                    tone,
                    number(random.noise.powi(2), 2)
                ),
                // the noise of a pixel is the mean of n bounded ones: its square deviates by less than √2 of its mean,
                // doubled for the samples' unequal variances
                Residual::near(
                    "noise power = ½(1 − sinc²(ν/n))/n",
                    random.noise.powi(2),
                    power,
                    DEVIATIONS * 2.0 * power * (2.0 / pixels).sqrt(),
                ),
            );
    }
    Ok(figure)
}

fn panel(row: usize, column: usize, nu: f64, n: u32, outcome: &Outcome) -> Panel {
    const NAMES: [[&str; 4]; 2] = [
        ["point", "filtered", "uniform", "stochastic"],
        ["point-fast", "filtered-fast", "uniform-fast", "stochastic-fast"],
    ];
    let titles = [
        text!("1 sample", "1 отсчёт"),
        text!("filter first", "сначала фильтр"),
        text!("{n} uniform", "{n} равномерных"),
        text!("{n} stochastic", "{n} случайных"),
    ];
    let title = if row == 0 { titles[column].clone() } else { Text::EMPTY };
    let label = match column {
        0 => text!("tone {} f_{{s}}", "тон {} f_{{s}}", number(nu, 4)),
        _ => Text::EMPTY,
    };
    let (end, top) = (30.0, 1.9);
    let x = match row {
        0 => unmarked(0.0, end),
        _ => Scale::linear(text!("pixel", "пиксель"), 0.0, end),
    };
    let y = Scale::linear(label, -1.3, top);
    let y =
        if column == 0 { y.ticks([-1.0, 0.0, 1.0].map(|v| (v, text!("{}", "{}", number(v, 1))))) } else { y.bare() };
    let (amplitude, phase) = outcome.coherent.to_polar();
    let wave = |x: f64| amplitude * (2.0 * PI * outcome.at * x + phase).cos();
    let rounded = |v: f64| number((1e3 * v).round() / 1e3, 3);
    let noise = rounded(outcome.noise);
    let says = text!("alias {}", "алиас {}", rounded(amplitude));
    let middle = if noise == "0" { 0.5 * end } else { 0.28 * end };
    let panel = Panel::new(NAMES[row][column], title, x, y)
        .with(Layer::curve("alias", Meaning::Leaked, 0.0, end, PIECES / 4, wave).thick())
        .with(Layer::dots("pixels", Meaning::Samples, outcome.pixels.iter().copied().filter(|p| p[0] <= end)))
        .with(Layer::notes("says-alias", Meaning::Leaked, [([middle, 1.55], says)]));
    if noise == "0" {
        return panel;
    }
    let says = text!("noise {}", "шум {}", noise);
    panel.with(Layer::notes("says-noise", Meaning::Error, [([0.76 * end, 1.55], says)]))
}
