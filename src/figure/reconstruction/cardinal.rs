//! Ideal reconstruction in space, and its problems (slides «Реконструкция функции в пространственной области»,
//! «Идеальная реконструкция – проблемы»).

use crate::axis::Axis;
use crate::error::Result;
use crate::figure::common::{PIECES, signal_curve, space, values};
use crate::figure::params::Param;
use crate::figure::{Entry, Figure, Layer, Legend, Meaning, Panel, Scale};
use crate::kernel::Kernel;
use crate::kernel::ideal::Ideal;
use crate::laws::truncation::{sinc_energy_beyond, truncated_energy, truncated_tone};
use crate::num::extremum::maximum;
use crate::num::quadrature::{even_breaks, integrate_pieces};
use crate::num::random::uniform;
use crate::num::special::si;
use crate::num::{cos_pi, sinc};
use crate::reconstruct::reconstruct;
use crate::residual::Residual;
use crate::sampled::Samples;
use crate::signal::lecture::LecturePulse;
use crate::signal::raised_cosine::RaisedCosine;
use crate::signal::tone::Cosine;
use crate::signal::{Signal, from_fn};
use crate::text;
use crate::text::{Text, number};
use std::f64::consts::PI;

static STEP: Text = Text::fixed("sampling step T", "шаг дискретизации T");
static TONE: Text = Text::fixed("frequency of the tone", "частота тона");

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[CARDINAL, PROBLEMS];

const CARDINAL: Entry = Entry {
    id: "f23-cardinal",
    inventory: &["F23"],
    errata: &["E06"],
    title: &Text::fixed(
        "Reconstruction in space: the cardinal series",
        "Реконструкция в пространстве: ряд Котельникова",
    ),
    caption: &Text::fixed(
        "To cut out one copy of the spectrum is to put a sinc, as wide as the step, in place of every sample. Each sinc is \
         zero at all the other samples, so that the sum passes through any data; and for a signal with no frequency above \
         1/(2T) it is the signal. The missing samples of a finite record are all that is in error.",
        "Вырезать одну копию спектра — значит поставить на место каждого отсчёта функцию sinc шириной в шаг. Каждая из них \
         равна нулю во всех остальных отсчётах, поэтому сумма проходит через любые данные; а если в сигнале нет частот выше \
         1/(2T), сумма и есть сигнал. Ошибка возникает только из-за отсчётов, которых нет в конечной записи.",
    ),
    params: &[Param::real("T", &STEP, 0.4, 0.25, 0.49, "")],
    build: |params| cardinal(params.real("T")),
};

/// Where the signal is shown, to either side of zero.
const REACH: f64 = 2.4;

fn cardinal(step: f64) -> Result<Figure> {
    let f = RaisedCosine::new(1.0)?;
    let record = |terms: usize| Ok(Samples::of(&f, Axis::centered(step, 2 * terms + 1)?));
    let samples = record(200)?;
    let shown: Vec<[f64; 2]> = samples.points().filter(|[x, _]| x.abs() <= REACH).collect();
    let mut sum = Panel::new(
        "sum",
        text!("a sinc for every sample, and their sum", "по sinc на отсчёт и их сумма"),
        space(-REACH, REACH),
        values("f(x)", -0.3, 1.15),
    )
    .legend(Legend::Above)
    .span(2)
    .with(
        Layer::curve("signal", Meaning::Signal, -REACH, REACH, PIECES, |x| f.at(x))
            .thick()
            .label(text!("signal", "сигнал")),
    );
    for &[at, value] in &shown {
        let one = Layer::curve("sinc", Meaning::Kernel, -REACH, REACH, PIECES, |x| value * sinc((x - at) / step));
        let one = one.thin().dashed();
        sum = sum.with(if at == 0.0 {
            one.label(text!("f(iT)·sinc(x/T − i)", "f(iT)·sinc(x/T − i)"))
        } else {
            one
        });
    }
    let back = reconstruct(&samples, Ideal);
    let sum = sum
        .with(signal_curve("reconstruction", Meaning::Reconstructed, &back, -REACH, REACH).label(text!("sum", "сумма")))
        .with(Layer::dots("samples", Meaning::Samples, shown).label(text!("samples", "отсчёты")));

    let terms = [8, 32, 128];
    let mut errors = Panel::new(
        "error",
        text!("the error with N samples each side", "ошибка при N отсчётах по сторонам"),
        space(-REACH, REACH),
        Scale::log(Text::same("|f̃ − f|"), 1e-13, 1e-3),
    )
    .legend(Legend::Above);
    for (i, n) in terms.into_iter().enumerate() {
        let samples = record(n)?;
        let back = reconstruct(&samples, Ideal);
        // nothing at a sample, where a logarithm has no place
        let error = |x: f64| Some((back.at(x) - f.at(x)).abs()).filter(|e| *e > 0.0).unwrap_or(f64::NAN);
        let curve =
            Layer::curve(["error-8", "error-32", "error-128"][i], Meaning::Series(i as u8), -REACH, REACH, 300, error);
        errors = errors.with(curve.label(text!("N = {}", "N = {}", n)));
    }

    let (data, any) = any_data()?;
    let places: Vec<f64> = (0..=48).map(|i| REACH * f64::from(i) / 48.0).collect();
    let long = record(TERMS)?;
    let long = reconstruct(&long, Ideal);
    let worst = places.iter().map(|&x| (long.at(x) - f.at(x)).abs()).fold(0.0, f64::max);
    // V09 speaks of samples one apart
    let unit = RaisedCosine::new(step)?;
    let near: Vec<f64> = places.iter().map(|x| x / step).filter(|x| *x < terms[0] as f64).collect();
    let cut = terms.map(|n| truncated_energy(&unit, n, &near).measured).into_iter().fold(0.0, f64::max);
    Ok(Figure::new(2)
        .heights([1.15, 1.0])
        .with(sum)
        .with(errors)
        .with(any)
        .claim(
            text!(
                "with {} samples on each side the error is below 10^{{−12}}: the sum is the signal",
                "с {} отсчётами с каждой стороны ошибка меньше 10^{{−12}}: сумма и есть сигнал",
                TERMS
            ),
            Residual::at_most("cardinal series = signal", worst, beyond(step) + series_rounding()),
        )
        .claim(
            text!(
                "with fewer samples the error stays within what the energy of the missing ones allows",
                "с меньшим числом отсчётов ошибка не больше, чем позволяет энергия отброшенных"
            ),
            Residual::at_most("error of the cut series / its bound (V09)", cut, 1.0),
        )
        .claim(
            text!(
                "the sum passes through any data, random here",
                "сумма проходит через любые данные, здесь — случайные"
            ),
            Residual::at_most(
                "sinc sum = data at every sample",
                data.points().map(|[x, v]| (reconstruct(&data, Ideal).at(x) - v).abs()).fold(0.0, f64::max),
                // whole indices are exact, and so is every sinc there
                0.0,
            ),
        ))
}

/// The samples to either side for which the series is held against the signal.
const TERMS: usize = 4000;

/// What the samples beyond [`TERMS`] can add: with `u = 2T`, `f(kT)·(−1)^k` is `sin(πuk)(−1)^k`, whose partial sums are at
/// most `1/cos(πu/2)`, times a falling factor (Abel), on both sides; or, without that, the sum of the absolute values.
fn beyond(step: f64) -> f64 {
    let (u, n) = (2.0 * step, TERMS as f64 + 1.0);
    let first = 1.0 / (PI * PI * u * n * ((u * n).powi(2) - 1.0) * (n - REACH / step));
    2.0 * first * (1.0 / cos_pi(0.5 * u).abs()).min(n)
}

/// The rounding of the series: once it is past the middle each of [`TERMS`] partial sums is about the signal, at most one,
/// and rounded; and every term is off by a few ε.
fn series_rounding() -> f64 {
    f64::EPSILON * (0.5 * TERMS as f64 + 16.0)
}

/// Random numbers and the sum of sincs through them.
fn any_data() -> Result<(Samples, Panel)> {
    let n = 17;
    let numbers = (0..n).map(|i| 2.0 * uniform(23, i, 0) - 1.0).collect();
    let samples = Samples::new(Axis::new(0.0, 1.0, n as usize)?, numbers)?;
    let (low, high) = (-0.5, n as f64 - 0.5);
    let panel = Panel::new(
        "any-data",
        text!("it passes through any data", "сумма проходит через любые данные"),
        Scale::linear(Text::same("x/T"), low, high),
        values("", -1.9, 1.9),
    )
    .legend(Legend::Above)
    .with(
        signal_curve("through", Meaning::Reconstructed, &reconstruct(&samples, Ideal), low, high)
            .label(text!("sum of sincs", "сумма sinc")),
    )
    .with(Layer::dots("data", Meaning::Samples, samples.points()).label(text!("random numbers", "случайные числа")));
    Ok((samples, panel))
}

const PROBLEMS: Entry = Entry {
    id: "f24-problems",
    inventory: &["F24"],
    errata: &["E15"],
    title: &Text::fixed("Ideal reconstruction: the problems", "Идеальная реконструкция — проблемы"),
    caption: &Text::fixed(
        "The sinc never ends: cut off at N steps it loses 1/(π²N) of its energy, and the error of a tone falls like 1/N \
         only, the slower the nearer it is to Nyquist. And samples of a jump ring: a step overshoots by 14.11 % (not by \
         Gibbs's 8.95 %), this pulse of eight samples by a little more. Correctly sampled signals do not ring.",
        "У sinc нет конца: обрезанная на N шагах, она теряет 1/(π²N) энергии, а ошибка для тона падает лишь как 1/N, и тем \
         медленнее, чем ближе он к частоте Найквиста. И отсчёты скачка «звенят»: выброс ступеньки 14,11 % (а не 8,95 % по \
         Гиббсу), у этого импульса из восьми отсчётов — чуть больше. Правильно дискретизованный сигнал не звенит.",
    ),
    params: &[Param::real("f", &TONE, 0.45, 0.05, 0.48, "cycles per step")],
    build: |params| problems(params.real("f")),
};

/// The numbers of steps at which the series is cut off.
const CUTS: [u32; 7] = [1, 2, 4, 8, 16, 32, 64];

fn problems(f: f64) -> Result<Figure> {
    let inside = |n: u32| integrate_pieces(|x| sinc(x).powi(2), &even_breaks(0.0, f64::from(n), 0.5), 1e-15);
    let lost = CUTS.map(|n| [f64::from(n), 1.0 - 2.0 * inside(n).value]);
    let steps = || Scale::log(text!("N, steps", "N, шагов"), 0.8, 80.0);
    let rough = |n: f64| 1.0 / (PI * PI * n);
    let ends = |line: &dyn Fn(f64) -> f64| [0.8, 80.0].map(|n| [n, line(n)]);
    let energy = Panel::new(
        "energy",
        text!("energy of sinc beyond N steps", "энергия sinc дальше N шагов"),
        steps(),
        Scale::log(text!("lost", "потеряно"), 1e-3, 0.3),
    )
    .legend(Legend::Above)
    .with(Layer::line("theory", Meaning::Theory, ends(&rough)).dashed().label(Text::same("1/(π²N)")))
    .with(Layer::dots("lost", Meaning::Error, lost).label(text!("measured", "измерено")));

    // errors show between samples, and of all phases the worst counts
    let places: Vec<f64> = (0..=16).map(|i| f64::from(i) / 16.0 - 0.5).collect();
    let mut errors = Panel::new(
        "truncation",
        text!("error of a tone, N samples each side", "ошибка тона при N отсчётах по сторонам"),
        steps(),
        Scale::log(text!("largest error", "наибольшая ошибка"), 1e-3, 30.0),
    )
    .legend(Legend::Above);
    let mut worst = 0.0f64;
    for (i, f) in [f, 0.1].into_iter().enumerate() {
        let bound = |n: f64| 2.0 / (PI * cos_pi(f) * (n + 0.5));
        let mut measured = Vec::with_capacity(CUTS.len());
        for n in CUTS {
            let mut largest = 0.0f64;
            for phase in (0..16).map(|i| PI * f64::from(i) / 16.0) {
                let tone = Cosine::with_phase(f, phase)?;
                let samples = Samples::of(&tone, Axis::centered(1.0, 2 * n as usize + 1)?);
                let back = reconstruct(&samples, Ideal);
                largest = places.iter().map(|&x| (back.at(x) - tone.at(x)).abs()).fold(largest, f64::max);
                worst = worst.max(truncated_tone(f, phase, n as usize, &places)?.measured);
            }
            measured.push([f64::from(n), largest]);
        }
        let meaning = Meaning::Series(i as u8);
        let line = Layer::line(["bound", "bound-slow"][i], Meaning::Theory, ends(&bound)).dashed();
        let line = if i == 0 { line.label(text!("bounds, ∝ 1/N", "границы, ∝ 1/N")) } else { line };
        errors = errors.with(line).with(Layer::dots(["error", "error-slow"][i], meaning, measured).label(text!(
            "tone {}",
            "тон {}",
            number(f, 3)
        )));
    }

    let step_up = maximum(|u| Ideal.step_response(u), 0.0, 1.0, 16).value;
    let step = 0.125;
    let pulse = Samples::of(&LecturePulse, Axis::new(0.0, step, 32)?);
    let back = reconstruct(&pulse, Ideal);
    let ringing = Panel::new(
        "ringing",
        text!("a sampled pulse rings", "отсчёты импульса «звенят»"),
        space(0.0, 3.0),
        values("f(x)", -0.3, 1.35),
    )
    .legend(Legend::Above)
    .span(2)
    .with(Layer::horizontals("overshoot", Meaning::Theory, [step_up]).dashed().label(text!(
        "a step: +{} %",
        "ступенька: +{} %",
        number(100.0 * (step_up - 1.0), 4)
    )))
    .with(
        Layer::line("pulse", Meaning::Signal, [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [2.0, 1.0], [2.0, 0.0], [3.0, 0.0]])
            .dashed()
            .label(text!("pulse", "импульс")),
    )
    .with(signal_curve("sinc", Meaning::Reconstructed, &back, 0.0, 3.0).label(text!("sum of sincs", "сумма sinc")))
    .with(
        Layer::dots("samples", Meaning::Samples, pulse.points().filter(|p| p[0] <= 3.0))
            .label(text!("samples", "отсчёты")),
    );

    // eight samples of one are a step up and a step down eight later
    let closed = from_fn(|x| Ideal.step_response(x) - Ideal.step_response(x - 8.0));
    let (seen, expected) = (maximum(|x| back.at(x), 1.0, 1.5, 32), maximum(|u| closed.at(u), 0.0, 4.0, 32));
    let [_, [_, second], _, [_, eighth], ..] = lost;
    let exact = |n: f64| 1.0 - 2.0 / PI * si(2.0 * PI * n);
    let measured = lost.iter().map(|p| (p[1] - exact(p[0])).abs()).fold(0.0, f64::max);
    Ok(Figure::new(2)
        .heights([1.0, 1.0])
        .with(energy)
        .with(errors)
        .with(ringing)
        .claim(
            text!(
                "the sinc has {} of its energy beyond 1 step, {} beyond 2 and {} beyond 8",
                "дальше 1 шага у sinc {} энергии, дальше 2 — {}, дальше 8 — {}",
                number(lost[0][1], 3),
                number(second, 3),
                number(eighth, 3)
            ),
            // the quadrature's tolerance and rounding, twice
            Residual::at_most("energy beyond N = 1 − (2/π)·Si(2πN)", measured, 4e-15 + 32.0 * f64::EPSILON),
        )
        .claim(
            text!("that is 1/(π²N), the better the larger N is", "это 1/(π²N), и тем точнее, чем больше N"),
            {
                let [_, rough] = sinc_energy_beyond(8);
                rough
            },
        )
        .claim(
            text!(
                "the errors of the tones keep under their bound 2/(π·cos πν·(N + ½)), which falls like 1/N",
                "ошибки для тонов не превышают границы 2/(π·cos πν·(N + ½)), которая падает как 1/N"
            ),
            Residual::at_most("error of the cut series / its bound (V09)", worst, 1.0),
        )
        .claim(
            text!(
                "the pulse overshoots by {} %, a single step by {} %",
                "выброс импульса {} %, одиночной ступеньки — {} %",
                number(100.0 * (seen.value - 1.0), 4),
                number(100.0 * (step_up - 1.0), 4)
            ),
            // the sum of eight sincs, and two closed forms, each to a few ε
            Residual::near("overshoot of eight samples", seen.value, expected.value, 64.0 * f64::EPSILON),
        ))
}
