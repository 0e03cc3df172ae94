//! Which step suffices (slides «Алиасинг», «Теорема Найквиста-Шеннона (теорема Котельникова)»).

use crate::axis::{Axis, Edge};
use crate::error::Result;
use crate::figure::common::{PIECES, signal_curve, space, unmarked, values};
use crate::figure::params::{Param, Params};
use crate::figure::{Entry, Figure, Layer, Legend, Meaning, Panel, Scale};
use crate::kernel::ideal::Ideal;
use crate::laws::alias::{alias_energy, alias_energy_identity};
use crate::laws::poisson::raised_cosine_tail;
use crate::laws::truncation::truncated_tone;
use crate::num::extremum::maximum;
use crate::num::quadrature::{even_breaks, integrate_pieces};
use crate::num::{cos_pi, sinc};
use crate::reconstruct::reconstruct;
use crate::residual::Residual;
use crate::sampled::Samples;
use crate::signal::raised_cosine::RaisedCosine;
use crate::signal::tone::{Cosine, Sine};
use crate::signal::{FourierPair, Signal};
use crate::text;
use crate::text::{Text, number};
use std::f64::consts::PI;

static BAND: Text = Text::fixed("band limit B of the signal", "верхняя частота B сигнала");
static PHASE: Text = Text::fixed("phase φ of the tone", "фаза φ тона");
static RATE: Text = Text::fixed("sampling rate over band limit, f_{s}/B", "частота дискретизации f_{s}/B");

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[STEP, THEOREM];

const STEP: Entry = Entry {
    id: "f29-step",
    inventory: &["F29"],
    errata: &["E07"],
    title: &Text::fixed("Aliasing: which step is needed?", "Алиасинг: какой нужно взять шаг?"),
    caption: &Text::fixed(
        "The error of the ideal reconstruction of a signal with no frequency above B, against the sampling rate. From \
         1/T = 2B on it is zero; below, it grows with the step: aliasing comes when T is too large, not «not large \
         enough» as the slide says.",
        "Ошибка идеальной реконструкции сигнала без частот выше B в зависимости от частоты дискретизации. Начиная с \
         1/T = 2B она равна нулю, а ниже растёт вместе с шагом: алиасинг возникает, когда T слишком велик, а не \
         «недостаточно большой», как сказано на слайде.",
    ),
    params: &[Param::real("B", &BAND, 1.0, 0.5, 2.0, "")],
    build: |params| which_step(params.real("B")),
};

/// How many samples to either side the cardinal series has, where the supremum is looked for.
const TERMS: usize = 100;

/// `sup |f̃ − f|` for samples `step` apart.
fn largest_error(f: &RaisedCosine, step: f64) -> Result<f64> {
    let samples = Samples::of(f, Axis::centered(step, 2 * TERMS + 1)?);
    let back = reconstruct(&samples, Ideal);
    Ok(maximum(|x| (back.at(x) - f.at(x)).abs(), 0.0, 2.5 * step, 30).value)
}

fn which_step(band: f64) -> Result<Figure> {
    let f = RaisedCosine::new(band)?;
    let spectrum = f.spectrum();
    let (low, high, n) = (0.8, 3.0, 66);
    let rates: Vec<f64> = (0..=n).map(|i| low + (high - low) * f64::from(i) / f64::from(n)).collect();
    // rates in units of B, errors relative to the signal
    let root = |rate: f64| Ok([rate, alias_energy(&spectrum, 1.0 / (rate * band))?.relative().sqrt()]);
    let most = |rate: f64| Ok([rate, largest_error(&f, 1.0 / (rate * band))? / f.at(0.0)]);
    let allowed = |rate: f64| {
        let half = (0.5 * rate * band).min(band);
        let beyond = |nu: f64| spectrum.density(nu).norm();
        [rate, 4.0 * integrate_pieces(beyond, &even_breaks(half, band, 0.25 * band), 1e-15).value / f.at(0.0)]
    };
    let energies: Vec<[f64; 2]> = rates.iter().map(|&r| root(r)).collect::<Result<_>>()?;
    let suprema: Vec<[f64; 2]> = rates.iter().map(|&r| most(r)).collect::<Result<_>>()?;
    let bounds: Vec<[f64; 2]> = rates.iter().map(|&r| allowed(r)).collect();
    let marked = [0.6, 0.8, 1.0].map(|step: f64| 1.0 / step);
    let marks: Vec<[f64; 2]> = marked.iter().map(|&r| root(r)).collect::<Result<_>>()?;
    let peaks: Vec<[f64; 2]> = marked.iter().map(|&r| most(r)).collect::<Result<_>>()?;
    let panel = |name, title, top: f64| {
        let x = Scale::linear(
            text!("sampling rate 1/T, in units of B", "частота дискретизации 1/T, в единицах B"),
            low,
            high,
        );
        Panel::new(name, title, x, values("", 0.0, top))
            .legend(Legend::Above)
            .with(Layer::spans("enough", Meaning::Reconstructed, [[2.0, high]]).label(if name == "energy" {
                text!("1/T ≥ 2B: exact", "1/T ≥ 2B: точно")
            } else {
                Text::EMPTY
            }))
            .with(Layer::verticals("nyquist-rate", Meaning::Guide, [2.0]).dashed())
    };
    let steps = |i: usize| number([0.6, 0.8, 1.0][i], 2);
    let left = panel("energy", text!("mean error ‖f̃ − f‖/‖f‖", "средняя ошибка ‖f̃ − f‖/‖f‖"), 0.64)
        .with(Layer::line("energy", Meaning::Error, energies.clone()).thick())
        .with(Layer::dots("marked", Meaning::Samples, marks.clone()).label(text!(
            "T·B = {}; {}; {}",
            "T·B = {}; {}; {}",
            steps(2),
            steps(1),
            steps(0)
        )));
    let right = panel("supremum", text!("largest error max|f̃ − f|/f(0)", "наибольшая ошибка max|f̃ − f|/f(0)"), 0.64)
        .with(Layer::line("supremum", Meaning::Error, suprema.clone()).thick().label(text!("measured", "измерено")))
        .with(
            Layer::line("bound", Meaning::Theory, bounds.clone()).dashed().label(text!("bound 2∫|F|", "граница 2∫|F|")),
        )
        .with(Layer::dots("marked", Meaning::Samples, peaks.clone()));

    let enough = |p: &&[f64; 2]| p[0] >= 2.0 - 4.0 * f64::EPSILON;
    let exact = energies.iter().filter(enough).map(|p| p[1]).fold(0.0, f64::max);
    let reached = largest_error(&f, 0.5 / band)? / band;
    let identity = marked.iter().map(|r| alias_energy_identity(&spectrum, 1.0 / (r * band)));
    let worst = identity
        .collect::<Result<Vec<_>>>()?
        .into_iter()
        .fold(Residual::at_most("folded energy = lost energy (V07)", 0.0, f64::INFINITY), |worst, r| {
            Residual::at_most(worst.law, worst.measured.max(r.measured), worst.bound.min(r.bound))
        });
    let above = suprema.iter().zip(&bounds).map(|(s, b)| s[1] - b[1]).fold(f64::NEG_INFINITY, f64::max);
    let energy = |i: usize| number(marks[i][1].powi(2), 4);
    Ok(Figure::new(2)
        .with(left)
        .with(right)
        .claim(
            text!("from 1/T = 2B on the error is zero", "начиная с 1/T = 2B ошибка равна нулю"),
            // the copies no longer overlap, and nothing is left over to integrate
            Residual::at_most("relative error at 1/T ≥ 2B", exact, 0.0),
        )
        .claim(
            text!(
                "at 1/T = 2B itself the series of the samples is the signal",
                "и при 1/T = 2B ряд по отсчётам равен сигналу"
            ),
            // the samples beyond ±T are zero: what they round to, 2ε each, and the sum of the three that are not
            Residual::at_most("sup|f̃ − f| at 1/T = 2B", reached, 2.0 * f64::EPSILON * (2.0 * TERMS as f64 + 1.0)),
        )
        .claim(
            text!(
                "error energy over signal energy is {}, {}, {} at T·B = {}, {}, {}; half is lost, half folded",
                "энергия ошибки к энергии сигнала: {}; {}; {} при T·B = {}; {}; {}; половина потеряна, половина завернулась",
                energy(0),
                energy(1),
                energy(2),
                steps(0),
                steps(1),
                steps(2)
            ),
            worst,
        )
        .claim(
            text!(
                "the largest error, {} at T·B = {}, keeps under its bound",
                "наибольшая ошибка, {} при T·B = {}, не превышает границы",
                number(peaks[2][1], 4),
                steps(2)
            ),
            // what the series leaves out, at the smallest step
            Residual::at_most("sup|f̃ − f| − 2∫|F| (V08)", above, tail(band, high)),
        ))
}

/// The most that the samples beyond [`TERMS`] add, relative to `f(0) = B`, at a rate in units of B.
fn tail(band: f64, rate: f64) -> f64 {
    let step = 1.0 / (rate * band);
    raised_cosine_tail(band, step, TERMS) / step / band
}

const THEOREM: Entry = Entry {
    id: "f30-theorem",
    inventory: &["F30"],
    errata: &["E08", "E09"],
    title: &Text::fixed("The sampling theorem, to the letter", "Теорема Котельникова: точная формулировка"),
    caption: &Text::fixed(
        "«At least 2B» needs care. A tone at B itself, sampled at 2B, comes back with amplitude cos φ: of a sine nothing is \
         left, so that B = f_{s}/2 is a supremum and never reached. A little faster is enough, but slowly so: ever more \
         samples are needed. A signal without a line at B is restored even at 2B exactly.",
        "«Как минимум 2B» требует оговорки. Тон на самой частоте B при f_{s} = 2B возвращается с амплитудой cos φ: от \
         синуса не остаётся ничего, так что f_{s}/2 — недостижимый предел. Чуть чаще — уже достаточно, но сходимость \
         медленная: нужно очень много отсчётов. Сигнал без линии на частоте B восстанавливается и точно при 2B.",
    ),
    params: &[Param::real("phi", &PHASE, 60.0, 0.0, 90.0, "°"), Param::real("rate", &RATE, 2.05, 2.01, 4.0, "")],
    build: theorem,
};

fn theorem(params: &Params) -> Result<Figure> {
    let (phi, ratio) = (params.real("phi"), params.real("rate"));
    // B = 1 throughout
    let (band, step) = (1.0, 0.5);
    let critical = |phase: f64| Ok(Samples::of(&Cosine::with_phase(band, phase)?, Axis::new(0.0, step, 8)?));
    // twice the mean product with cos 2πBx over the record, which a sum of 64 products gives exactly
    let amplitude = |samples: &Samples| {
        let back = reconstruct(samples, Ideal).edge(Edge::Wrap);
        let n = 64;
        let at = |i: i32| samples.axis().span() * (f64::from(i) + 0.5) / f64::from(n);
        2.0 * (0..n).map(|i| back.at(at(i)) * cos_pi(2.0 * band * at(i))).sum::<f64>() / f64::from(n)
    };
    let tone = Cosine::with_phase(band, phi.to_radians())?;
    let samples = critical(phi.to_radians())?;
    let back = reconstruct(&samples, Ideal).edge(Edge::Wrap);
    let end = 3.0;
    let one = Panel::new(
        "critical",
        text!("f_{{s}} = 2B, φ = {}°", "f_{{s}} = 2B, φ = {}°", number(phi, 3)),
        space(0.0, end),
        unmarked(-1.2, 1.2),
    )
    .legend(Legend::Above)
    .with(signal_curve("tone", Meaning::Signal, &tone, 0.0, end).label(text!("tone", "тон")))
    .with(
        signal_curve("back", Meaning::Reconstructed, &back, 0.0, end)
            .thick()
            .label(text!("what returns", "что вернулось")),
    )
    .with(
        Layer::dots("samples", Meaning::Samples, samples.points().filter(|p| p[0] <= end))
            .label(text!("samples", "отсчёты")),
    );

    let degrees: Vec<f64> = (0..=12).map(|i| 15.0 * f64::from(i)).collect();
    let mut recovered = Vec::with_capacity(degrees.len());
    for &phase in &degrees {
        recovered.push([phase, amplitude(&critical(phase.to_radians())?)]);
    }
    let turns = (0..=4).map(|i| 45.0 * f64::from(i)).map(|d| (d, text!("{}°", "{}°", d)));
    let all = Panel::new(
        "phases",
        text!("f_{{s}} = 2B: amplitude returned", "f_{{s}} = 2B: вернувшаяся амплитуда"),
        Scale::linear(text!("phase φ", "фаза φ"), 0.0, 180.0).ticks(turns),
        values("", -1.2, 1.2),
    )
    .legend(Legend::Above)
    .with(
        Layer::curve("cosine", Meaning::Theory, 0.0, 180.0, PIECES, |d| cos_pi(d / 180.0))
            .dashed()
            .label(Text::same("cos φ")),
    )
    .with(Layer::dots("amplitude", Meaning::Reconstructed, recovered.clone()).label(text!("measured", "измерено")));

    let (long, worst) = record_lengths(ratio)?;

    let f = RaisedCosine::new(band)?;
    let exact = Samples::of(&f, Axis::centered(step, 2 * TERMS + 1)?);
    let rebuilt = reconstruct(&exact, Ideal);
    let result = signal_curve("back", Meaning::Reconstructed, &rebuilt, -2.25, 2.25).thick();
    let error = result.points().iter().map(|p| (p[1] - f.at(p[0])).abs()).fold(0.0, f64::max);
    let smooth = Panel::new(
        "no-line",
        text!("no line at B: f_{{s}} = 2B is enough", "нет линии на B: f_{{s}} = 2B хватает"),
        space(-2.25, 2.25),
        unmarked(-0.25, 1.2),
    )
    .legend(Legend::Above)
    .with(result.label(text!("reconstruction", "реконструкция")))
    .with(signal_curve("signal", Meaning::Signal, &f, -2.25, 2.25).dashed().label(text!("signal", "сигнал")))
    .with(
        Layer::dots("samples", Meaning::Samples, exact.points().filter(|p| p[0].abs() <= 2.25))
            .label(text!("samples", "отсчёты")),
    );

    let off = recovered.iter().map(|p| (p[1] - cos_pi(p[0] / 180.0)).abs()).fold(0.0, f64::max);
    let sine = Samples::of(&Sine::new(band)?, Axis::new(0.0, step, 1000)?);
    let silent = sine.values().iter().map(|v| v.abs()).fold(0.0, f64::max);
    let needed = (2.0 / (PI * cos_pi(band / ratio) * 0.01)).ceil();
    Ok(Figure::new(2)
        .with(one)
        .with(all)
        .with(long)
        .with(smooth)
        .claim(
            text!(
                "sampled at 2B, a tone at B returns with amplitude cos φ: {} at φ = {}°",
                "при f_{{s}} = 2B тон частоты B возвращается с амплитудой cos φ: {} при φ = {}°",
                number((1e4 * amplitude(&samples)).round() / 1e4, 4),
                number(phi, 3)
            ),
            // the phase in radians is off by ε, and so are 64 products of sums of eight
            Residual::at_most("returned amplitude = cos φ", off, 32.0 * PI * f64::EPSILON),
        )
        .claim(
            text!(
                "of a sine at B nothing is seen: all its samples are zero",
                "синуса частоты B не видно: все отсчёты — нули"
            ),
            // whole multiples of half a period are exact
            Residual::at_most("sin(2πB·k/2B) = 0", silent, 0.0),
        )
        .claim(
            text!(
                "at {}B the error falls like 1/N: for 1 % some {} samples to either side suffice",
                "при {}B ошибка падает как 1/N: для 1 % достаточно {} отсчётов с каждой стороны",
                number(ratio, 3),
                number(needed, 2)
            ),
            Residual::at_most("error of the cut series / its bound (V09)", worst, 1.0),
        )
        .claim(
            text!(
                "a signal without a line at B is restored exactly at f_{{s}} = 2B",
                "сигнал без линии на частоте B при f_{{s}} = 2B восстанавливается точно"
            ),
            // as in the figure of the step: samples that should be zero, 2ε each
            Residual::at_most("sup|f̃ − f| at f_s = 2B", error, 2.0 * f64::EPSILON * (2.0 * TERMS as f64 + 1.0)),
        ))
}

/// The error of a tone at B against the length of the record, at that rate and at twice the Nyquist rate, and the largest
/// ratio of an error to its bound.
fn record_lengths(ratio: f64) -> Result<(Panel, f64)> {
    let (first, last) = (4, 1024);
    let places: Vec<f64> = (0..=8).map(|i| f64::from(i) / 8.0 - 0.5).collect();
    let mut panel = Panel::new(
        "record",
        text!("a tone at B: error against N", "тон частоты B: ошибка от N"),
        Scale::log(text!("samples to either side, N", "отсчётов с каждой стороны, N"), 3.0, 1300.0),
        Scale::log(Text::EMPTY, 1e-4, 30.0),
    )
    .legend(Legend::Above);
    let mut worst = 0.0f64;
    for (i, ratio) in [ratio, 4.0].into_iter().enumerate() {
        let nu = 1.0 / ratio;
        let mut errors = vec![0.0f64; last + 1];
        for phase in [0.0, 0.25, 0.5, 0.75].map(|t| t * PI) {
            let tone = Cosine::with_phase(nu, phase)?;
            for &x in &places {
                // the partial sums of the series, from the middle outwards
                let term = |k: f64| tone.at(k) * sinc(x - k);
                let mut rest = tone.at(x) - term(0.0);
                for (n, error) in errors.iter_mut().enumerate().skip(1) {
                    rest -= term(n as f64) + term(-(n as f64));
                    *error = error.max(rest.abs());
                }
            }
            for n in [4, 16, 64, 256] {
                worst = worst.max(truncated_tone(nu, phase, n, &places)?.measured);
            }
        }
        let bound = |n: f64| 2.0 / (PI * cos_pi(nu) * (n + 0.5));
        let drawn = errors.iter().enumerate().skip(first).map(|(n, e)| [n as f64, *e]);
        worst = drawn.clone().map(|[n, e]| e / bound(n)).fold(worst, f64::max);
        let line = Layer::line(["bound", "bound-double"][i], Meaning::Theory, [3.0, 1300.0].map(|n| [n, bound(n)]));
        panel = panel
            .with(Layer::line(["error", "error-double"][i], Meaning::Series(i as u8), drawn).label(text!(
                "f_{{s}} = {}B",
                "f_{{s}} = {}B",
                number(ratio, 3)
            )))
            .with(if i == 0 {
                line.dashed().label(text!("bounds, ∝ 1/N", "границы, ∝ 1/N"))
            } else {
                line.dashed()
            });
    }
    Ok((panel, worst))
}
