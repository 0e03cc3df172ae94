//! Sampling: the basic idea, and the Dirac comb that formalises it (slides «Основная идея дискретизации», «Формализация
//! сэмплирования»).

use crate::axis::Axis;
use crate::comb::{Comb, sample};
use crate::error::Result;
use crate::figure::common::{PIECES, signal_curve, space, values};
use crate::figure::params::Param;
use crate::figure::{Entry, Figure, Layer, Legend, Meaning, Panel, Scale};
use crate::kernel::tent::TentKernel;
use crate::laws::poisson::{raised_cosine_tail, sum_rounding, trapezoid_exact};
use crate::num::quadrature::integrate_pieces;
use crate::reconstruct::reconstruct;
use crate::residual::Residual;
use crate::signal::lecture::SPIKES;
use crate::signal::raised_cosine::RaisedCosine;
use crate::signal::spline::Spline;
use crate::signal::{FourierPair, Signal};
use crate::spectrum::Impulse;
use crate::text;
use crate::text::{Text, number};

static STEP: Text = Text::fixed("sampling step T", "шаг дискретизации T");

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[SAMPLING, COMB, WEIGHTS];

/// The smooth curve through the heights that the source's figures of sampling show at `x = 0 … 8`.
pub(in crate::figure) fn spikes() -> Result<Spline> {
    Spline::natural(Axis::new(0.0, 1.0, SPIKES.len())?, &SPIKES)
}

/// Where that curve ends; it starts at 0.
pub(in crate::figure) const SPIKES_END: f64 = (SPIKES.len() - 1) as f64;

/// How much is shown beyond either end, so that no sample stands on the frame.
pub(in crate::figure) const SPIKES_MARGIN: f64 = 0.3;

const SAMPLING: Entry = Entry {
    id: "f06-sampling",
    inventory: &["F06"],
    errata: &[],
    title: &Text::fixed("The basic idea of sampling", "Основная идея дискретизации"),
    caption: &Text::fixed(
        "Sampling reads a continuous signal at the points iT and forgets everything else. Straight lines between the \
         samples already give back a function that agrees with the signal at every sample; in between the error is at \
         most T²/8 times the largest curvature |f″|, so half the step means a quarter of the error.",
        "Дискретизация читает непрерывный сигнал в точках iT и забывает всё остальное. Уже отрезки прямых между \
         отсчётами дают функцию, которая совпадает с сигналом в каждом отсчёте; между ними ошибка не больше T²/8, \
         умноженных на наибольшую кривизну |f″|: вдвое меньший шаг — вчетверо меньшая ошибка.",
    ),
    params: &[Param::real("T", &STEP, 1.0, 0.25, 2.0, "")],
    build: |params| sampling(params.real("T")),
};

fn sampling(step: f64) -> Result<Figure> {
    let f = spikes()?;
    let samples = sample(&f, Comb::new(step)?, -1..=(SPIKES_END / step).ceil() as i64 + 1)?;
    let joined = reconstruct(&samples, TentKernel);
    let shown = || samples.points().filter(|[x, _]| (0.0..=SPIKES_END).contains(x));
    let (low, high) = (-SPIKES_MARGIN, SPIKES_END + SPIKES_MARGIN);
    let signal = || signal_curve("signal", Meaning::Signal, &f, low, high);
    let heights = || values("f(x)", 0.0, 1.1);
    let signal_label = || text!("signal f", "сигнал f");
    let reading =
        Panel::new("sampled", text!("reading f at x = iT", "чтение f в точках x = iT"), space(low, high), heights())
            .legend(Legend::Above)
            .with(signal().label(signal_label()))
            .with(Layer::stems("samples", Meaning::Samples, shown()).label(text!("samples f(iT)", "отсчёты f(iT)")));
    let lines = signal_curve("joined", Meaning::Reconstructed, &joined, 0.0, SPIKES_END);
    let joining = Panel::new(
        "joined",
        text!("samples joined by lines", "отсчёты соединены отрезками"),
        space(low, high),
        heights(),
    )
    .legend(Legend::Above)
    .with(signal().dashed().label(signal_label()))
    .with(lines.thick().label(text!("reconstruction", "реконструкция")))
    .with(Layer::dots("samples", Meaning::Samples, shown()));

    let bound = step * step / 8.0 * f.max_curvature();
    let error = Layer::curve("error", Meaning::Error, 0.0, SPIKES_END, 2 * PIECES, |x| joined.at(x) - f.at(x)).thick();
    let worst = crate::figure::common::peak(&error);
    let errors = Panel::new(
        "error",
        text!("what is lost in between", "что потеряно между отсчётами"),
        space(low, high),
        Scale::linear(text!("error", "ошибка"), -1.25 * bound, 1.25 * bound),
    )
    .legend(Legend::Above)
    .span(2)
    .with(Layer::horizontals("zero", Meaning::Guide, [0.0]).thin())
    .with(error.label(text!("reconstruction − signal", "реконструкция − сигнал")))
    .with(
        Layer::horizontals("bound", Meaning::Theory, [-bound, bound])
            .dashed()
            .label(text!("±T²/8·max|f″|", "±T²/8·max|f″|")),
    )
    .with(Layer::dots("samples", Meaning::Samples, shown().map(|[x, _]| [x, 0.0])));

    let at_samples = samples.points().map(|[x, v]| (joined.at(x) - v).abs()).fold(0.0, f64::max);
    let size = samples.values().iter().fold(0.0, |most: f64, v| most.max(v.abs()));
    Ok(Figure::new(2)
        .heights([3.0, 2.0])
        .with(reading)
        .with(joining)
        .with(errors)
        .claim(
            text!(
                "at every sample the reconstruction equals the signal",
                "в каждом отсчёте реконструкция равна сигналу"
            ),
            // the position of a sample in steps, (x − x₀)/T, is off by at most ε times itself, and so are the two weights
            Residual::at_most("f̃(iT) = f(iT)", at_samples, 4.0 * f64::EPSILON * samples.values().len() as f64 * size),
        )
        .claim(
            text!(
                "between samples the error reaches {} and never exceeds T²/8·max|f″| = {}",
                "между отсчётами ошибка достигает {} и не превышает T²/8·max|f″| = {}",
                number(worst, 3),
                number(bound, 3)
            ),
            Residual::at_most("|f̃ − f| ≤ T²/8·max|f″|", worst, bound + 8.0 * f64::EPSILON * size),
        ))
}

/// Impulses as `[position, weight]`.
fn weights(impulses: &[Impulse]) -> impl Iterator<Item = [f64; 2]> + '_ {
    impulses.iter().map(|i| [i.at, i.weight.re])
}

/// A scale of weights.
fn weight_scale(low: f64, high: f64) -> Scale {
    Scale::linear(text!("weight", "вес"), low, high)
}

const COMB: Entry = Entry {
    id: "f14-comb",
    inventory: &["F14"],
    errata: &[],
    title: &Text::fixed("Sampling is a product with the Dirac comb", "Дискретизация — умножение на гребень Дирака"),
    caption: &Text::fixed(
        "The signal times the comb Ш_{T} = T·Σδ(x − iT) leaves impulses at the samples. An arrow's height is its weight, the \
         area under the impulse: T for the comb, T·f(iT) for the product. The weights add up to the trapezoid rule for \
         ∫f, which is why the factor T belongs to the comb.",
        "Сигнал, умноженный на гребень Ш_{T} = T·Σδ(x − iT), — это импульсы в отсчётах. Высота стрелки есть вес, площадь под \
         импульсом: у гребня T, у произведения T·f(iT). Сумма весов — формула трапеций для ∫f; вот почему множитель T \
         принадлежит гребню.",
    ),
    params: &[Param::real("T", &STEP, 1.0, 0.25, 2.0, "")],
    build: |params| comb(params.real("T")),
};

fn comb(step: f64) -> Result<Figure> {
    let (f, comb) = (spikes()?, Comb::new(step)?);
    // a step that divides the length must not lose its last impulse to rounding
    let last = (SPIKES_END / step + 1e-9).floor() as i64;
    let teeth: Vec<Impulse> = comb.times(&crate::signal::from_fn(|_| 1.0), 0..=last);
    let product = comb.times(&f, 0..=last);
    let (low, high) = (-SPIKES_MARGIN, SPIKES_END + SPIKES_MARGIN);
    let top = 1.2 * step.max(1.0);
    let signal = Panel::new("signal", text!("the signal f", "сигнал f"), space(low, high), values("f(x)", 0.0, 1.2))
        .with(signal_curve("signal", Meaning::Signal, &f, low, high).thick());
    let comb_panel = Panel::new(
        "comb",
        text!("times the comb Ш_{{T}}: weights T", "умножить на гребень Ш_{{T}}: веса T"),
        space(low, high),
        weight_scale(0.0, top),
    )
    .with(Layer::arrows("comb", Meaning::Samples, weights(&teeth)));
    let product_panel = Panel::new(
        "product",
        text!("the product Ш_{{T}}·f: weights T·f(iT)", "произведение Ш_{{T}}·f: веса T·f(iT)"),
        space(low, high),
        weight_scale(0.0, top),
    )
    .with(Layer::curve("envelope", Meaning::Signal, low, high, PIECES, |x| step * f.at(x)).dashed().thin())
    .with(Layer::arrows("weights", Meaning::Samples, weights(&product)));

    let drawn: Vec<[f64; 2]> = product_panel.layer("weights").map_or(&[][..], Layer::points).to_vec();
    let off = drawn.iter().map(|[x, w]| (w - step * f.at(*x)).abs()).fold(0.0, f64::max);
    // the trapezoid rule halves both ends; the oracle is the quadrature of a piecewise cubic, exact between its knots
    let ends: f64 = 0.5 * (drawn.first().map_or(0.0, |p| p[1]) + drawn.last().map_or(0.0, |p| p[1]));
    let sum = drawn.iter().map(|p| p[1]).sum::<f64>() - ends;
    let end = last as f64 * step;
    let mut knots: Vec<f64> = f.axis().iter().filter(|x| *x < end).collect();
    knots.push(end);
    let integral = integrate_pieces(|x| f.at(x), &knots, 1e-14);
    let allowed = end * step * step / 12.0 * f.max_curvature() + integral.error + sum_rounding(drawn.len(), sum);
    Ok(Figure::new(1)
        .heights([1.0, 1.0, 1.28])
        .with(signal)
        .with(comb_panel)
        .with(product_panel)
        .claim(
            text!("the impulse at iT weighs T·f(iT)", "импульс в точке iT весит T·f(iT)"),
            Residual::at_most("weight − T·f(iT)", off, 4.0 * f64::EPSILON * step),
        )
        .claim(
            text!(
                "the weights, the two ends halved, add up to {}; the integral from 0 to {} is {}",
                "сумма весов (крайние пополам) равна {}; интеграл от 0 до {} равен {}",
                number(sum, 4),
                number(end, 4),
                number(integral.value, 4)
            ),
            Residual::near("trapezoid rule: error ≤ length·T²/12·max|f″|", sum, integral.value, allowed),
        ))
}

const WEIGHTS: Entry = Entry {
    id: "f14-weights",
    inventory: &["F14"],
    errata: &[],
    title: &Text::fixed("What the weights add up to", "Чему равна сумма весов"),
    caption: &Text::fixed(
        "The weights T·f(iT) of a band-limited signal add up to its integral, exactly, as soon as the rate 1/T exceeds the \
         band limit B: no copy of the spectrum reaches frequency zero. That is half the rate at which the signal itself \
         can be reconstructed. At lower rates copies land on zero and the sum is too large.",
        "Сумма весов T·f(iT) сигнала с ограниченной полосой точно равна его интегралу, как только частота дискретизации 1/T \
         превысит границу полосы B: ни одна копия спектра не достаёт до нуля. Это вдвое меньше, чем нужно для \
         реконструкции самого сигнала. При меньшей частоте копии попадают в нуль, и сумма слишком велика.",
    ),
    params: &[Param::real("T", &STEP, 0.75, 0.35, 2.4, "")],
    build: |params| sums(params.real("T")),
};

/// How far the sums reach to either side: `|f|` falls like `x⁻³`, which leaves out less than 1e-7.
const REACH: f64 = 1000.0;

fn sums(step: f64) -> Result<Figure> {
    let band = 1.0;
    let f = RaisedCosine::new(band)?;
    let spectrum = f.spectrum();
    let terms = |step: f64| (REACH / step).ceil() as usize;
    let sum = |step: f64| -> Result<f64> {
        let n = terms(step) as i64;
        Ok(Comb::new(step)?.times(&f, -n..=n).iter().map(|i| i.weight.re).sum())
    };
    // Σ_k F(k/T), Poisson's other side
    let copies =
        |rate: f64| -> Result<f64> { Ok(spectrum.replicated(rate, (band / rate).ceil() as usize)?.density(0.0).re) };
    let allowed = |step: f64| {
        // Σ T|f(iT)| ≤ T·B + ∫|f| < 2 + T·B
        raised_cosine_tail(band, step, terms(step)) + sum_rounding(2 * terms(step) + 1, 2.0 + step * band)
    };

    let (low, high) = (-3.2, 3.2);
    let tall = step * band;
    let shown = (3.0 / step).floor() as i64;
    let arrows = Comb::new(step)?.times(&f, -shown..=shown);
    let space_panel = Panel::new(
        "space",
        text!("the weights T·f(iT)", "веса T·f(iT)"),
        space(low, high),
        weight_scale(-0.2 * tall, 1.15 * tall),
    )
    .with(Layer::horizontals("axis", Meaning::Guide, [0.0]).thin())
    .with(Layer::curve("envelope", Meaning::Signal, low, high, PIECES, |x| step * f.at(x)).dashed().thin())
    .with(Layer::arrows("weights", Meaning::Samples, weights(&arrows)));

    let (least, most) = (0.4, 3.0);
    let rates: Vec<f64> = (0..=52).map(|i| least + 0.05 * f64::from(i)).collect();
    let measured: Vec<[f64; 2]> = rates.iter().map(|r| Ok([*r, sum(1.0 / r)?])).collect::<Result<_>>()?;
    let theory: Vec<[f64; 2]> = (0..=PIECES)
        .map(|i| least + (most - least) * i as f64 / PIECES as f64)
        .map(|r| Ok([r, copies(r)?]))
        .collect::<Result<_>>()?;
    let top = theory.iter().map(|p| p[1]).fold(0.0, f64::max);
    let (rate, here) = (1.0 / step, sum(step)?);
    let rate_scale = Scale::linear(text!("rate 1/T", "частота дискретизации 1/T"), least - 0.1, most + 0.1);
    let sum_panel = Panel::new("sum", text!("their sum", "их сумма"), rate_scale, values("ΣT·f(iT)", 0.0, 1.1 * top))
        .legend(Legend::Above)
        .with(Layer::verticals("limits", Meaning::Guide, [band, 2.0 * band]).dashed())
        .with(Layer::line("theory", Meaning::Theory, theory).label(text!("ΣF(k/T)", "ΣF(k/T)")))
        .with(Layer::dots("measured", Meaning::Samples, measured.iter().copied()).label(text!("sum", "сумма")))
        .with(Layer::dots("here", Meaning::Reconstructed, [[rate, here]]).thick().label(text!("this T", "этот T")));

    let notes = [
        ([1.5 * band, 0.5], text!("∫f is exact", "∫f точен")),
        ([2.5 * band, 0.5], text!("so is f", "f — тоже")),
        ([1.1 * band, 0.12], text!("B", "B")),
        ([2.12 * band, 0.12], text!("2B", "2B")),
    ];
    let sum_panel = sum_panel.with(Layer::notes("what is exact", Meaning::Guide, notes));
    let against = |rule: &dyn Fn(f64) -> Result<Option<f64>>| -> Result<f64> {
        let worst = |worst: Result<f64>, [r, s]: &[f64; 2]| {
            let off = rule(*r)?.map_or(0.0, |right| (s - right).abs() / allowed(1.0 / r));
            Ok(worst?.max(off))
        };
        measured.iter().fold(Ok(0.0), worst)
    };
    let poisson = against(&|r| copies(r).map(Some))?;
    let exact = against(&|r| Ok((r > band).then_some(1.0)))?;
    let figure = Figure::new(2)
        .with(space_panel)
        .with(sum_panel)
        .claim(
            text!(
                "at every rate the sum of the weights is the sum of the copies at zero, ΣF(k/T)",
                "при любой частоте сумма весов равна сумме копий в нуле, ΣF(k/T)"
            ),
            Residual::at_most("|ΣT·f(iT) − ΣF(k/T)| / (tail + rounding)", poisson, 1.0),
        )
        .claim(
            text!("for 1/T > B it is the integral F(0) = 1, exactly", "при 1/T > B это в точности интеграл F(0) = 1"),
            Residual::at_most("|ΣT·f(iT) − F(0)| / (tail + rounding) for 1/T > B", exact, 1.0),
        );
    if rate > band {
        let residual = trapezoid_exact(&f, step, terms(step), raised_cosine_tail(band, step, terms(step)))?;
        return Ok(figure.claim(text!("with this T the sum is 1", "при этом T сумма равна 1"), residual));
    }
    Ok(figure.claim(
        text!(
            "with this T the sum is {}: the copies at ±1/T reach zero",
            "при этом T сумма равна {}: копии в ±1/T достают до нуля",
            number(here, 5)
        ),
        Residual::near("ΣT·f(iT) = ΣF(k/T)", here, copies(rate)?, allowed(step)),
    ))
}
