//! The lecture's last slide: three links, and from each a fact that can be checked.

use crate::axis::Axis;
use crate::beyond::jitter::{Jitter, JitteredComb};
use crate::error::Result;
use crate::field::FourierField;
use crate::field::grating::Grating;
use crate::figure::params::{Param, Params};
use crate::figure::{Entry, Figure, Layer, Legend, Meaning, Panel, Scale};
use crate::grid::Grid;
use crate::image::Image;
use crate::image::dft::forward;
use crate::laws::jitter::jitter_spectrum;
use crate::laws::plane::spectrum_by_transform;
use crate::num::cos_pi;
use crate::residual::Residual;
use crate::sampled::Samples;
use crate::signal::from_fn;
use crate::text;
use crate::text::{Text, number};
use std::f64::consts::{FRAC_PI_2, PI};

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[REFERENCES];

static PERIOD: Text = Text::fixed("pixels per period", "пикселей на период");
static SEED: Text = Text::fixed("seed of the random places", "начальное число случайных позиций");

const REFERENCES: Entry = Entry {
    id: "f59-references",
    inventory: &["F59"],
    errata: &["E08", "E32", "E36"],
    title: &Text::fixed("References: a fact from each", "Ссылки: по факту из каждой"),
    caption: &Text::fixed(
        "CS148 (graphics.stanford.edu/courses/cs148-10-summer): a sine of 32 pixels in a picture of 128 is the bins ±4. \
         HyperGraph (siggraph.org, aliasing/alias0.htm) asks for a rate «greater than or equal to twice» the highest \
         frequency: at equality only cos φ of a tone is left. CS348B (wikis/cs348b-09): jittered samples have the spectrum \
         1 − sinc² and no false lines. (The facts are those of the courses' slides; the linked pages themselves may be gone.)",
        "CS148 (graphics.stanford.edu/courses/cs148-10-summer): синус с периодом 32 пикселя на картинке в 128 — это отсчёты \
         ±4. HyperGraph (siggraph.org, aliasing/alias0.htm) требует частоты «не меньше удвоенной»: при равенстве от тона \
         остаётся лишь cos φ. CS348B (wikis/cs348b-09): у отсчётов с джиттером спектр 1 − sinc² и нет ложных линий. (Факты \
         взяты из слайдов этих курсов; сами страницы могли исчезнуть.)",
    ),
    params: &[Param::choice("period", &PERIOD, &["32", "64", "16", "8"]), Param::count("seed", &SEED, 1, 1, 100)],
    build: |params| references(params),
};

/// Pixels along a side of the picture.
const SIDE: usize = 128;
/// Jittered spikes in a pattern, and how many patterns are averaged.
const COUNT: usize = 24;
const PATTERNS: u32 = 300;
/// How many samples the tone at the edge has.
const RECORD: usize = 64;

/// `cos(πk + φ)` sampled at exactly twice its frequency: the amplitude of the alternation, which is all there is.
fn alternation(phase: f64) -> Result<f64> {
    let tone = from_fn(|x| cos_pi(x + phase / PI));
    let samples = Samples::of(&tone, Axis::new(0.0, 1.0, RECORD)?);
    let signed = samples.values().iter().enumerate().map(|(k, v)| if k.is_multiple_of(2) { *v } else { -v });
    Ok(signed.sum::<f64>() / RECORD as f64)
}

fn references(params: &Params) -> Result<Figure> {
    let seed = params.count("seed") as u64;
    let period = match params.choice("period") {
        "64" => 64,
        "16" => 16,
        "8" => 8,
        _ => 32,
    };
    let k = SIDE / period;
    let wave = Grating::with_phase([1.0 / period as f64, 0.0], -FRAC_PI_2)?;
    let image = Image::of(&wave, Grid::centered(1.0, SIDE, SIDE)?);
    let bins = forward(&image);
    let reach = 20i64;
    let stems = (-reach..=reach).map(|k| [k as f64, bins.bin(k, 0).norm() / bins.space().area()]);
    let sine = Panel::new(
        "cs148",
        text!("CS148: sin(2πx/{period})", "CS148: sin(2πx/{period})"),
        Scale::linear(text!("periods across 128 pixels", "периодов на 128 пикселей"), -20.5, 20.5),
        Scale::linear(Text::same("|F|/N²"), 0.0, 0.62),
    )
    .with(Layer::stems("bins", Meaning::Signal, stems))
    .with(Layer::notes("peaks", Meaning::Signal, [([0.0, 0.56], text!("bins ±{k}", "отсчёты ±{k}"))]));

    let phases = (0..=16).map(|i| f64::from(i) / 16.0);
    let found = phases.map(|turn| Ok([turn, alternation(PI * turn)?])).collect::<Result<Vec<_>>>()?;
    let off = found.iter().map(|[turn, a]| (a - cos_pi(*turn)).abs()).fold(0.0, f64::max);
    let edge = Panel::new(
        "hypergraph",
        text!("HyperGraph: «or equal»", "HyperGraph: «или равно»"),
        Scale::linear(text!("phase φ of the tone, half turns", "фаза тона φ, в полуоборотах"), 0.0, 1.0),
        Scale::linear(text!("amplitude found", "найденная амплитуда"), -1.2, 1.35),
    )
    .legend(Legend::UpperRight)
    .with(Layer::horizontals("true", Meaning::Signal, [1.0]).dashed())
    .with(Layer::curve("theory", Meaning::Theory, 0.0, 1.0, 200, cos_pi).label(Text::same("cos φ")))
    .with(Layer::dots("found", Meaning::Error, found).label(Text::same("f_{s} = 2B")));

    let comb = JitteredComb::new(1.0, Jitter::Uniform { width: 1.0 })?;
    let order = 2;
    let mean = comb.mean_periodogram(seed, COUNT, PATTERNS, order);
    let half = mean[COUNT / 2][1];
    let noise = Panel::new(
        "cs348b",
        text!("CS348B: jitter", "CS348B: джиттер"),
        Scale::linear(text!("frequency, in units of the rate", "частота, в единицах f_{{s}}"), 0.0, 2.05),
        Scale::linear(text!("power", "мощность"), 0.0, 1.35),
    )
    .legend(Legend::LowerRight)
    .with(
        Layer::curve("theory", Meaning::Theory, 0.0, 2.05, 205, |nu| comb.noise(nu))
            .thick()
            .label(Text::same("1 − sinc²")),
    )
    .with(
        Layer::dots("noise", Meaning::Samples, mean.iter().skip(1).copied())
            .label(text!("mean of {PATTERNS}", "среднее по {PATTERNS}")),
    );

    let expected = number((SIDE * SIDE / 2) as f64, 4);
    Ok(Figure::new(3)
        .with(sine)
        .with(edge)
        .with(noise)
        .claim(
            text!(
                "a sine of {period} pixels is the bins ±{k} of {SIDE}, of the size N²/2 = {expected}",
                "синус с периодом {period} px — отсчёты ±{k} из {SIDE} величины N²/2 = {expected}"
            ),
            spectrum_by_transform(&image, &wave.spectrum(), 0.0),
        )
        .claim(
            text!(
                "at exactly twice the frequency the amplitude found is cos φ: nothing of a sine",
                "при частоте ровно вдвое большей найденная амплитуда равна cos φ: от синуса — ничего"
            ),
            // the phase k + φ/π to ε of itself, in half turns
            Residual::at_most("amplitude at f_s = 2B = cos φ", off, 2.0 * PI * f64::EPSILON * RECORD as f64),
        )
        .claim(
            text!(
                "jitter has the spectrum 1 − sinc²: {} at half the rate, theory {}",
                "спектр джиттера 1 − sinc²: {} на половине частоты, теория {}",
                number(half, 2),
                number(comb.noise(0.5), 4)
            ),
            jitter_spectrum(&comb, &comb, seed, COUNT, PATTERNS, order),
        ))
}
