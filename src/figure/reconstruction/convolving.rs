//! Reconstruction by convolution (slides «Реконструкция с помощью свертки», «Реконструированная функция»).

use crate::comb::{Comb, sample};
use crate::error::Result;
use crate::figure::common::{PIECES, difference, signal_curve, space, unmarked, values};
use crate::figure::formal::sampling::{SPIKES_END, SPIKES_MARGIN, spikes};
use crate::figure::params::Param;
use crate::figure::{Entry, Figure, Layer, Legend, Meaning, Panel};
use crate::kernel::Kernel;
use crate::kernel::catalog::by_name;
use crate::kernel::tent::TentKernel;
use crate::kernel::widened::Widened;
use crate::laws::poisson::sum_rounding;
use crate::reconstruct::reconstruct;
use crate::residual::Residual;
use crate::sampled::Samples;
use crate::signal::Signal;
use crate::text;
use crate::text::{Text, number};

static STEP: Text = Text::fixed("sampling step T", "шаг дискретизации T");
static KERNEL: Text = Text::fixed("the filter", "фильтр");

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[CONVOLUTION, TENTS];

/// Where the pictures start and end.
const LOW: f64 = -SPIKES_MARGIN;
const HIGH: f64 = SPIKES_END + SPIKES_MARGIN;

const CONVOLUTION: Entry = Entry {
    id: "f15-convolution",
    inventory: &["F15"],
    errata: &[],
    title: &Text::fixed("Reconstruction by convolution", "Реконструкция с помощью свёртки"),
    caption: &Text::fixed(
        "Above: the signal times the comb leaves impulses of weight T·f(iT). Below: the filter r slides along them; at every \
         place the sum of the weights, each times the filter there, is the value of the reconstruction.",
        "Сверху: от произведения сигнала на гребень Дирака остаются импульсы с весами T·f(iT). Снизу: фильтр r скользит по \
         ним, и сумма весов, умноженных на значения фильтра, даёт в каждой точке значение реконструкции.",
    ),
    params: &[
        Param::choice("r", &KERNEL, &["tent", "box", "catmull-rom", "mitchell", "b-spline", "lanczos-3"]),
        Param::real("T", &STEP, 1.0, 0.5, 1.5, ""),
    ],
    build: |params| convolution(by_name(params.choice("r"))?.as_ref(), params.real("T")),
};

/// Where the filter stands in the pictures.
const PLACES: [f64; 2] = [2.4, 5.7];

fn convolution(kernel: &dyn Kernel, step: f64) -> Result<Figure> {
    let f = spikes()?;
    let comb = Comb::new(step)?;
    // all impulses that the filter reaches from within the picture
    let beyond = kernel.radius().ceil() as i64 + 1;
    let numbers = -beyond..=(SPIKES_END / step).ceil() as i64 + beyond;
    let impulses: Vec<[f64; 2]> = comb.times(&f, numbers.clone()).iter().map(|i| [i.at, i.weight.re]).collect();
    let samples = sample(&f, comb, numbers)?;
    let back = reconstruct(&samples, kernel);
    // the lecture's r(x) = k(x/T)/T
    let filter = |x: f64| kernel.at(x / step) / step;

    let top = 1.2 * (1.0 / step).max(step);
    let inside = |p: &&[f64; 2]| (LOW..=HIGH).contains(&p[0]);
    let arrows = || Layer::arrows("impulses", Meaning::Samples, impulses.iter().filter(inside).copied());
    let upper = |name, title, top: f64| Panel::new(name, title, unmarked(LOW, HIGH), unmarked(-0.15 * top, top));
    let zero = || Layer::horizontals("zero", Meaning::Guide, [0.0]).thin();
    let lower = |name, title| Panel::new(name, title, space(LOW, HIGH), unmarked(-0.15 * top, top)).with(zero());
    let mut figure = Figure::new(3)
        .with(upper("signal", text!("signal f", "сигнал f"), 1.1).with(zero()).with(signal_curve(
            "signal",
            Meaning::Signal,
            &f,
            LOW,
            HIGH,
        )))
        .with(upper("comb", text!("× comb Ш_{{T}}", "× гребень Ш_{{T}}"), 1.1 * step).with(zero()).with(Layer::arrows(
            "comb",
            Meaning::Samples,
            impulses.iter().filter(inside).map(|p| [p[0], step]),
        )))
        .with(
            upper("product", text!("= impulses T·f(iT)", "= импульсы T·f(iT)"), 1.1 * step).with(zero()).with(arrows()),
        );
    let mut worst = 0.0f64;
    for (name, place) in ["sliding", "slid"].into_iter().zip(PLACES) {
        let near = Layer::curve("filter", Meaning::Kernel, LOW, HIGH, 2 * PIECES, |x| filter(place - x));
        let area = Layer::area("filter-area", Meaning::Kernel, near.points().iter().copied());
        let so_far = signal_curve("so-far", Meaning::Reconstructed, &back, LOW, place).thick();
        // ∫ of the impulses times the filter: the sum of its values at them, each times the weight
        let sum: f64 = impulses.iter().map(|[at, weight]| weight * filter(place - at)).sum();
        worst = worst.max((sum - back.at(place)).abs());
        figure = figure.with(
            lower(name, text!("⊗ r, at x = {}", "⊗ r, в точке x = {}", number(place, 2)))
                .with(area)
                .with(near)
                .with(arrows())
                .with(so_far)
                .with(Layer::dots("sum", Meaning::Reconstructed, [[place, sum]])),
        );
    }
    let whole = signal_curve("result", Meaning::Reconstructed, &back, LOW, HIGH).thick();
    let figure = figure.with(
        lower("result", text!("= f̃ at every x", "= f̃ во всех x"))
            .with(signal_curve("signal", Meaning::Signal, &f, LOW, HIGH).dashed())
            .with(whole)
            .with(Layer::dots("samples", Meaning::Samples, samples.points().filter(|p| (LOW..=HIGH).contains(&p[0])))),
    );
    let size: f64 = samples.values().iter().map(|v| v.abs()).sum();
    let says = |place: f64| number(back.at(place), 4);
    let ends: f64 = impulses.iter().filter(inside).map(|p| p[1]).sum();
    let trapezoid: f64 = samples.points().filter(|p| (LOW..=HIGH).contains(&p[0])).map(|p| step * p[1]).sum();
    Ok(figure
        .claim(
            text!(
                "the weights times the filter add up to the reconstruction: {} at x = {}, {} at x = {}",
                "сумма весов, умноженных на фильтр, равна реконструкции: {} при x = {}, {} при x = {}",
                says(PLACES[0]),
                number(PLACES[0], 2),
                says(PLACES[1]),
                number(PLACES[1], 2)
            ),
            // T in the weight and 1/T in the filter cancel but for rounding, and the argument of the filter, up to n
            // steps, is off by ε times itself, at a slope of 3 a step at most
            Residual::at_most("Σ T·f(iT)·r(x − iT) = f̃(x)", worst, sum_rounding(4 * samples.values().len(), size)),
        )
        .claim(
            text!("the weights are T·f(iT)", "веса равны T·f(iT)"),
            Residual::near(
                "sum of the weights = T·Σf(iT)",
                ends,
                trapezoid,
                sum_rounding(samples.values().len(), size),
            ),
        ))
}

const TENTS: Entry = Entry {
    id: "f16-tents",
    inventory: &["F16"],
    errata: &["E06"],
    title: &Text::fixed("The reconstructed function", "Реконструированная функция"),
    caption: &Text::fixed(
        "One filter for every sample, scaled by it, and their sum: with r(x) = tent(x/T)/T that is linear interpolation for \
         any step. The book's tent max(0, 1 − |x|) is right for T = 1 only; at another step the same formula blurs and \
         misses the samples (lower right).",
        "По одному фильтру на каждый отсчёт, умноженному на него, и их сумма: с r(x) = tent(x/T)/T это линейная \
         интерполяция при любом шаге. Треугольник max(0, 1 − |x|) из книги верен только при T = 1; при другом шаге та же \
         формула размывает сигнал и не проходит через отсчёты (справа внизу).",
    ),
    params: &[Param::real("T", &STEP, 0.5, 0.25, 0.9, "")],
    build: |params| tents(params.real("T")),
};

fn tents(step: f64) -> Result<Figure> {
    let (unit, _) = sum_of_tents("unit", text!("T = 1", "T = 1"), 1.0, 1.0)?;
    let titles = [
        text!("T = {}: r scaled with the step", "T = {}: r сжат вместе с шагом", number(step, 3)),
        text!("T = {}: the tent of T = 1", "T = {}: треугольник для T = 1", number(step, 3)),
    ];
    let [scaled_title, wrong_title] = titles;
    let (scaled, samples) = sum_of_tents("scaled", scaled_title, step, 1.0)?;
    let (wrong, _) = sum_of_tents("unscaled", wrong_title, step, 1.0 / step)?;
    let sum = |panel: &Panel| panel.layer("sum").map_or(Vec::new(), |l| l.points().to_vec());
    let straight = |samples: &Samples, x: f64| {
        let u = samples.axis().index_of(x);
        let (i, t) = (u.floor() as usize, u - u.floor());
        samples.values()[i] * (1.0 - t) + samples.values()[i + 1] * t
    };
    let apart = |panel: &Panel, samples: &Samples| {
        sum(panel).iter().map(|p| (p[1] - straight(samples, p[0])).abs()).fold(0.0, f64::max)
    };
    let at_samples = |j: usize| {
        // T·Σ f(iT)·tent((j − i)T)
        let weight = |i: usize| (1.0 - (j.abs_diff(i) as f64 * step)).max(0.0);
        samples.values().iter().enumerate().map(|(i, v)| step * v * weight(i)).sum::<f64>()
    };
    let unit_samples = record(1.0)?;
    let blurred = reconstruct(&samples, Widened::new(TentKernel, 1.0 / step)?);
    let shown = samples.points().enumerate().filter(|(_, p)| (0.0..=SPIKES_END).contains(&p[0]));
    let (mut missed, mut off) = (0.0f64, 0.0f64);
    for (j, [x, v]) in shown {
        missed = missed.max((blurred.at(x) - v).abs());
        off = off.max((blurred.at(x) - at_samples(j)).abs());
    }
    // the sum of the drawn tents is the drawn sum
    let adds_up = |panel: &Panel| {
        let tents: Vec<&Layer> = panel.layers.iter().filter(|l| l.name == "tent").collect();
        let drawn = sum(panel);
        let total = |i: usize| tents.iter().map(|t| t.points()[i][1]).sum::<f64>();
        let all = Layer::line("total", Meaning::Theory, drawn.iter().enumerate().map(|(i, p)| [p[0], total(i)]));
        panel.layer("sum").map_or(f64::NAN, |sum| difference(sum, &all))
    };
    let added = adds_up(&unit).max(adds_up(&scaled)).max(adds_up(&wrong));
    let linear = apart(&unit, &unit_samples).max(apart(&scaled, &samples));
    let n = samples.values().len() as f64;
    Ok(Figure::new(2)
        .with(unit.span(2))
        .with(scaled)
        .with(wrong)
        .claim(
            text!(
                "the solid curves are the sums of the dashed tents",
                "сплошные кривые — суммы пунктирных треугольников"
            ),
            // positions in steps, up to n of them, are off by ε times themselves
            Residual::at_most("sum = Σ tents", added, 8.0 * n * f64::EPSILON),
        )
        .claim(
            text!(
                "scaled with the step, the sum is linear interpolation",
                "с шириной в шаг сумма — линейная интерполяция"
            ),
            Residual::at_most("sum of scaled tents = linear interpolation", linear, 8.0 * n * f64::EPSILON),
        )
        .claim(
            text!(
                "the tent of T = 1 at T = {} misses the samples by up to {}: it averages each with its neighbours",
                "треугольник для T = 1 при T = {} не попадает в отсчёты, ошибка до {}: он усредняет отсчёт с соседними",
                number(step, 3),
                number(missed, 3)
            ),
            Residual::at_most("blurred = T·Σf(iT)·tent((j − i)T) at jT", off, 8.0 * n * f64::EPSILON),
        ))
}

/// The samples that tents of width one reach from within the picture.
fn record(step: f64) -> Result<Samples> {
    let beyond = ((SPIKES_MARGIN + 1.0) / step).ceil() as i64;
    sample(&spikes()?, Comb::new(step)?, -beyond..=(SPIKES_END / step).ceil() as i64 + beyond)
}

/// Tents `width` steps wide for samples `step` apart, dashed, and their sum.
fn sum_of_tents(name: &'static str, title: Text, step: f64, width: f64) -> Result<(Panel, Samples)> {
    let samples = record(step)?;
    let kernel = Widened::new(TentKernel, width)?;
    let mut panel = Panel::new(name, title, space(LOW, HIGH), values("", 0.0, 1.1)).legend(Legend::Above);
    let reaches = |x: f64| (LOW - width * step..=HIGH + width * step).contains(&x);
    let first = samples.points().position(|p| p[0] >= 0.0);
    for (i, [at, value]) in samples.points().enumerate().filter(|(_, p)| reaches(p[0])) {
        let tent = |x: f64| value * kernel.at((x - at) / step);
        let tent = Layer::curve("tent", Meaning::Kernel, LOW, HIGH, 2 * PIECES, tent).thin().dashed();
        let labelled = name == "unit" && Some(i) == first;
        panel = panel.with(if labelled {
            tent.label(text!("T·f(iT)·r(x − iT)", "T·f(iT)·r(x − iT)"))
        } else {
            tent
        });
    }
    let sum =
        Layer::curve("sum", Meaning::Reconstructed, LOW, HIGH, 2 * PIECES, |x| reconstruct(&samples, kernel).at(x));
    let dots = Layer::dots("samples", Meaning::Samples, samples.points().filter(|p| (LOW..=HIGH).contains(&p[0])));
    let named = |layer: Layer, label| if name == "unit" { layer.label(label) } else { layer };
    Ok((
        panel
            .with(named(sum.thick(), text!("their sum f̃", "их сумма f̃")))
            .with(named(dots, text!("samples", "отсчёты"))),
        samples,
    ))
}
