//! How fast the cardinal series converges, bare and under a Gaussian (V09).

use crate::axis::Axis;
use crate::error::Result;
use crate::figure::params::Param;
use crate::figure::{Entry, Figure, Layer, Legend, Meaning, Panel, Scale};
use crate::kernel::Kernel;
use crate::kernel::ideal::Ideal;
use crate::kernel::regularised::Regularised;
use crate::laws::truncation::{regularised_tone, truncated_energy, truncated_tone};
use crate::num::{cos_pi, sin_pi};
use crate::reconstruct::reconstruct;
use crate::residual::Residual;
use crate::sampled::Samples;
use crate::signal::raised_cosine::RaisedCosine;
use crate::signal::tone::Cosine;
use crate::signal::{FourierPair, Signal};
use crate::text;
use crate::text::{Text, number};
use std::f64::consts::{FRAC_PI_2, PI};

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[TRUNCATION];

static BAND: Text = Text::fixed("band of the signal, as a part of Nyquist", "полоса сигнала в долях частоты Найквиста");

const TRUNCATION: Entry = Entry {
    id: "x-truncation",
    inventory: &[],
    errata: &[],
    title: &Text::fixed("How many samples for how many digits", "Сколько отсчётов нужно на сколько цифр"),
    caption: &Text::fixed(
        "Error between samples when only n of them to either side are used. The bare sinc gains a digit for every ten times \
         as many samples of a tone. Under a Gaussian of the right width each further sample gains the same share of a digit, \
         if the signal leaves room below Nyquist: oversampling buys short filters.",
        "Ошибка между отсчётами, если взять по n отсчётов с каждой стороны. Голый sinc на тоне добавляет цифру за каждое \
         десятикратное увеличение n. Под гауссианом нужной ширины каждый новый отсчёт прибавляет одну и ту же долю цифры, \
         если до частоты Найквиста есть запас: передискретизация окупается короткими фильтрами.",
    ),
    params: &[Param::real("r", &BAND, 0.5, 0.1, 0.9, "")],
    build: |params| truncation(params.real("r")),
};

/// Where errors are looked at, inside one step.
fn places() -> Vec<f64> {
    (1..20).map(|i| f64::from(i) / 20.0).collect()
}

/// The largest error inside one step when `signals`, sampled one apart at `|k| ≤ n`, come back through `kernel`; of
/// several signals the root of the sum of squares: of a cosine and a sine it is the error of the worst phase.
fn error(signals: &[&dyn Signal], kernel: &dyn Kernel, n: usize) -> Result<f64> {
    let axis = Axis::centered(1.0, 2 * n + 1)?;
    let samples: Vec<Samples> = signals.iter().map(|signal| Samples::of(signal, axis)).collect();
    let at = |x: f64| {
        let each = signals.iter().zip(&samples).map(|(f, kept)| (reconstruct(kept, kernel).at(x) - f.at(x)).powi(2));
        each.sum::<f64>().sqrt()
    };
    Ok(places().into_iter().map(at).fold(0.0, f64::max))
}

fn truncation(r: f64) -> Result<Figure> {
    let counts: Vec<usize> = (1..=16).map(|i| 2 * i).collect();
    let (nu, places) = (0.5 * r, places());
    let (cosine, sine) = (Cosine::new(nu)?, Cosine::with_phase(nu, -FRAC_PI_2)?);
    let pulse = RaisedCosine::new(nu)?;
    let tones: [&dyn Signal; 2] = [&cosine, &sine];
    let points = |value: &dyn Fn(usize) -> Result<f64>| {
        counts.iter().map(|&n| Ok([n as f64, value(n)?])).collect::<Result<Vec<[f64; 2]>>>()
    };
    let gaussian = |n: usize| Regularised::for_band(n as f64, r);
    // its radius reaches one sample beyond the record of the bare series
    let regularised = |signals: &[&dyn Signal], n: usize| error(signals, &gaussian(n)?, n + 1);
    let bare_tone = points(&|n| error(&tones, &Ideal, n))?;
    let fine_tone = points(&|n| regularised(&tones, n))?;
    let bare_pulse = points(&|n| error(&[&pulse], &Ideal, n))?;
    let fine_pulse = points(&|n| regularised(&[&pulse], n))?;

    let most = |f: &dyn Fn(f64) -> f64| places.iter().map(|&x| f(x)).fold(0.0, f64::max);
    let ends = |n: f64, x: f64| 1.0 / (n - x) + 1.0 / (n + x);
    let tone_bound = points(&|n| Ok(most(&|x| sin_pi(x) / (PI * cos_pi(nu)) * ends(n as f64 + 1.0, x))))?;
    let fine_bound = points(&|n| Ok(regularised_tone(n as f64, r, nu, &places)?.bound))?;
    let spectrum = pulse.spectrum();
    let whole = spectrum.energy(-nu, nu);
    let pulse_bound = points(&|n| {
        let kept = Samples::of(&pulse, Axis::centered(1.0, 2 * n + 1)?);
        let beyond = (whole - kept.values().iter().map(|v| v * v).sum::<f64>()).max(0.0) + 64.0 * f64::EPSILON * whole;
        Ok(most(&|x| sin_pi(x) / PI * (ends(n as f64, x) * beyond).sqrt()))
    })?;
    // F ≥ 0 weighs tones of the band: the bound for one of them, times ∫F = f(0)
    let fine_pulse_bound: Vec<[f64; 2]> = fine_bound.iter().map(|[n, b]| [*n, b * pulse.at(0.0)]).collect();

    let plot = |name, title, bare: &[[f64; 2]], bare_bound: &[[f64; 2]], fine: &[[f64; 2]], fine_bound: &[[f64; 2]]| {
        let samples = Scale::linear(text!("samples to either side, n", "отсчётов с каждой стороны, n"), 0.0, 33.5);
        Panel::new(name, title, samples, Scale::log(text!("error", "ошибка"), 1e-17, 5.0))
            .legend(Legend::Above)
            .with(
                Layer::line("bare-bound", Meaning::Theory, bare_bound.iter().copied()).label(text!("bounds", "оценки")),
            )
            .with(Layer::line("fine-bound", Meaning::Theory, fine_bound.iter().copied()))
            .with(
                Layer::dots("bare", Meaning::Error, bare.iter().copied())
                    .label(text!("sinc, cut off", "sinc, обрезан")),
            )
            .with(
                Layer::dots("fine", Meaning::Reconstructed, fine.iter().copied())
                    .label(text!("sinc × Gaussian", "sinc × гауссиан")),
            )
    };
    let tone_panel = plot(
        "tone",
        text!("a tone at the band's edge", "тон на краю полосы"),
        &bare_tone,
        &tone_bound,
        &fine_tone,
        &fine_bound,
    );
    let pulse_panel = plot(
        "pulse",
        text!("a pulse of that band", "импульс той же полосы"),
        &bare_pulse,
        &pulse_bound,
        &fine_pulse,
        &fine_pulse_bound,
    );

    let worst = |law: &dyn Fn(usize) -> Result<Residual>| -> Result<f64> {
        let ratios = counts.iter().map(|&n| law(n).map(|r| r.measured / r.bound)).collect::<Result<Vec<_>>>()?;
        Ok(ratios.into_iter().fold(0.0, f64::max))
    };
    let by_abel = worst(&|n| {
        let phases = [0.0, 0.25 * PI, 0.5 * PI].map(|phase| truncated_tone(nu, phase, n, &places));
        let [a, b, c] = phases;
        let [a, b, c] = [a?, b?, c?];
        Ok(Residual::at_most("three phases", a.measured.max(b.measured).max(c.measured), 1.0))
    })?;
    let by_energy = worst(&|n| Ok(truncated_energy(&pulse, n, &places)))?;
    let by_gaussian = worst(&|n| regularised_tone(n as f64, r, nu, &places))?;
    let pairs = fine_pulse.iter().zip(&fine_pulse_bound);
    let by_weight = pairs.map(|(error, bound)| error[1] / bound[1]).fold(0.0, f64::max);
    let sixteen = |points: &[[f64; 2]]| points.iter().find(|p| p[0] == 16.0).map_or(f64::NAN, |p| p[1]);
    Ok(Figure::new(2)
        .with(tone_panel)
        .with(pulse_panel)
        .claim(
            text!(
                "tone, 16 samples to either side, sinc cut off: error {}",
                "тон, по 16 отсчётов с каждой стороны, обрезанный sinc: ошибка {}",
                number(sixteen(&bare_tone), 2)
            ),
            Residual::at_most("truncated tone, in units of its bound", by_abel, 1.0),
        )
        .claim(
            text!("the same under the Gaussian: {}", "то же под гауссианом: {}", number(sixteen(&fine_tone), 2)),
            Residual::at_most("regularised tone, in units of its bound", by_gaussian, 1.0),
        )
        .claim(
            text!(
                "pulse, 16 samples to either side, sinc cut off: error {}",
                "импульс, по 16 отсчётов с каждой стороны, обрезанный sinc: ошибка {}",
                number(sixteen(&bare_pulse), 2)
            ),
            Residual::at_most("truncated pulse, in units of the energy bound", by_energy, 1.0),
        )
        .claim(
            text!("the same under the Gaussian: {}", "то же под гауссианом: {}", number(sixteen(&fine_pulse), 2)),
            Residual::at_most("regularised pulse, in units of its bound", by_weight, 1.0),
        ))
}
