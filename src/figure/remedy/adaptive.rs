//! Adaptive sampling: what it finds and what it cannot find (slide «Адаптивное сэмплирование»).

use crate::axis::Axis;
use crate::beyond::refined::Refined;
use crate::error::Result;
use crate::figure::common::{signal_curve, space, values};
use crate::figure::params::{Param, Params};
use crate::figure::{Entry, Figure, Layer, Legend, Meaning, Panel, Scale};
use crate::residual::Residual;
use crate::signal::boxcar::Boxcar;
use crate::signal::theorem::Shifted;
use crate::text;
use crate::text::{Text, number};

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[ADAPTIVE];

static COUNT: Text = Text::fixed("uniform samples on [0, 4)", "равномерных отсчётов на [0, 4)");
static HALVINGS: Text = Text::fixed("halvings of an interval at most", "не более стольких делений отрезка пополам");

const LENGTH: f64 = 4.0;
/// Half of the jump.
const CONTRAST: f64 = 0.5;
/// The most halvings in the diagram of costs.
const MOST: u32 = 12;

const ADAPTIVE: Entry = Entry {
    id: "f41-adaptive",
    inventory: &["F41"],
    errata: &[],
    title: &Text::fixed("Adaptive sampling", "Адаптивное сэмплирование"),
    caption: &Text::fixed(
        "Where neighbouring samples differ, the interval between them is halved, again and again. One sample more halves \
         the uncertainty of an edge: log₂(T/δ) samples where uniform sampling must become T/δ times as dense. But a \
         spike between two equal samples gives no reason to look closer, and is never found.",
        "Где соседние отсчёты различаются, отрезок между ними делится пополам, снова и снова. Каждый новый отсчёт вдвое \
         уточняет место границы: нужно log₂(T/δ) отсчётов, а равномерно — в T/δ раз чаще. Но пик между двумя \
         одинаковыми отсчётами не даёт повода присмотреться и никогда не будет найден.",
    ),
    params: &[Param::count("n", &COUNT, 16, 8, 64), Param::count("halvings", &HALVINGS, 6, 1, 10)],
    build: |params| adaptive(params),
};

/// A pulse whose edges, at irrational places, are on no grid.
fn pulse() -> Result<(Shifted<Boxcar>, [f64; 2])> {
    let (left, width) = (2f64.sqrt() - 0.1, 3f64.sqrt() - 0.3);
    Ok((Shifted::new(left + 0.5 * width, Boxcar::new(width)?)?, [left, left + width]))
}

fn adaptive(params: &Params) -> Result<Figure> {
    let (n, halvings) = (params.count("n"), params.count("halvings") as u32);
    let axis = Axis::nodes(0.0..LENGTH, n)?;
    let (pulse, edges) = pulse()?;
    let refined = Refined::of(&pulse, axis, CONTRAST, halvings)?;
    let found: Vec<[f64; 2]> = refined.steep().collect();
    let of_level = |from: u32, to: u32| {
        let mut of: Vec<_> = refined.samples().iter().filter(|s| (from..=to).contains(&s.level)).collect();
        of.sort_by_key(|s| s.level);
        of.into_iter().map(|s| [s.at, s.value]).collect::<Vec<_>>()
    };
    let samples_panel = Panel::new(
        "samples",
        text!("more where neighbours differ", "чаще, где соседи различны"),
        space(-0.1, LENGTH + 0.1),
        values("f(x)", -0.15, 1.25),
    )
    .legend(Legend::Above)
    .with(signal_curve("signal", Meaning::Signal, &pulse, 0.0, LENGTH).thin())
    .with(Layer::dots("uniform", Meaning::Samples, of_level(0, 0)).label(text!("uniform", "равномерные")))
    .with(Layer::dots("extra", Meaning::Reconstructed, of_level(1, halvings)).label(text!("added", "добавленные")));

    // the search for the left edge, step by step
    let step = axis.step();
    let near = |x: f64| (x - edges[0]).abs() < 1.5 * step;
    let search = refined.samples().iter().filter(|s| near(s.at));
    let steps = |from: u32, to: u32| {
        let of = search.clone().filter(move |s| (from..=to).contains(&s.level));
        of.map(|s| [s.at, f64::from(s.level)]).collect::<Vec<_>>()
    };
    let mut path = steps(1, halvings);
    path.sort_by(|a, b| a[1].total_cmp(&b[1]));
    let search_panel = Panel::new(
        "search",
        text!("the search for one edge", "поиск одной границы"),
        space(edges[0] - 1.1 * step, edges[0] + 1.1 * step),
        Scale::linear(text!("halvings", "делений"), -0.5, f64::from(halvings) + 0.8),
    )
    .legend(Legend::Above)
    .with(Layer::verticals("edge", Meaning::Signal, [edges[0]]).label(text!("edge", "граница")))
    .with(Layer::line("path", Meaning::Reconstructed, path.iter().copied()).thin())
    .with(Layer::dots("uniform", Meaning::Samples, steps(0, 0)).label(text!("uniform", "равномерные")))
    .with(Layer::dots("tried", Meaning::Reconstructed, path.iter().copied()).label(text!("added", "добавленные")));

    let costs = |k: u32| Ok(Refined::of(&pulse, axis, CONTRAST, k)?.samples().len() as f64);
    let width = |k: u32| step / f64::from(1u32 << k);
    let taken = (0..=MOST).map(|k| Ok([width(k), costs(k)?])).collect::<Result<Vec<_>>>()?;
    let uniform = (0..=MOST).map(|k| [width(k), LENGTH / width(k)]);
    let cost_panel = Panel::new(
        "cost",
        text!("what it costs", "сколько это стоит"),
        Scale::log(text!("edge known to δ", "точность границы δ"), 0.7 * width(MOST), 1.4 * step),
        Scale::log(text!("samples", "отсчётов"), 0.5 * n as f64, 2.0 * LENGTH / width(MOST)),
    )
    .legend(Legend::UpperRight)
    .with(Layer::line("uniform", Meaning::Samples, uniform).label(text!("uniform: 4/δ", "равномерно: 4/δ")))
    .with(
        Layer::curve("theory", Meaning::Theory, width(MOST), step, 200, |d| n as f64 + 2.0 * (step / d).log2())
            .label(text!("n + 2 log₂(T/δ)", "n + 2 log₂(T/δ)")),
    )
    .with(Layer::dots("adaptive", Meaning::Reconstructed, taken.iter().copied()).label(text!("adaptive", "адаптивно")));

    // a spike as narrow as a twelfth of a step, half-way between two samples
    let at = axis.at(n as i64 / 2) + 0.5 * step;
    let spike = Shifted::new(at, Boxcar::new(step / 12.0)?)?;
    let blind = Refined::of(&spike, axis, CONTRAST, halvings)?;
    let heights = blind.samples().iter().map(|s| s.value.abs()).fold(0.0, f64::max);
    let (low, high) = (at - 4.5 * step, at + 4.5 * step);
    let failure = Panel::new(
        "failure",
        text!("never found", "не будет найден"),
        space(low - 0.3 * step, high + 0.3 * step),
        values("f(x)", -0.15, 1.25),
    )
    .legend(Legend::Above)
    .with(signal_curve("spike", Meaning::Error, &spike, low, high).thick().label(text!("spike", "пик")))
    .with(
        Layer::dots("samples", Meaning::Samples, {
            blind.samples().iter().map(|s| [s.at, s.value]).filter(|p| (low..=high).contains(&p[0]))
        })
        .label(text!("all samples: none added", "все отсчёты: ни одного нового")),
    );

    let finest = width(halvings);
    let miss = found.iter().zip(edges).map(|(i, edge)| (0.5 * (i[0] + i[1]) - edge).abs()).fold(0.0, f64::max);
    // every halving rounds a place of size 4 once
    let rounding = f64::from(halvings + 1) * f64::EPSILON * LENGTH;
    let per_edge = refined.extra() as f64 / found.len() as f64;
    let factor = 1u32 << halvings;
    Ok(Figure::new(2)
        .with(samples_panel)
        .with(search_panel)
        .with(cost_panel)
        .with(failure)
        .claim(
            text!(
                "further samples per edge: {} = log₂(T/δ); uniform ones would have to stand {factor} times as dense",
                "новых отсчётов на границу: {} = log₂(T/δ); плотность равномерных пришлось бы умножить на {factor}",
                number(per_edge, 3)
            ),
            Residual::near("further samples per edge = log₂(T/δ)", per_edge, (step / finest).log2(), 1e-12),
        )
        .claim(
            text!(
                "both edges are known to within δ = {}",
                "обе границы известны с точностью до δ = {}",
                number(finest, 3)
            ),
            Residual::at_most("distance of an edge from the middle of its interval", miss, 0.5 * finest + rounding),
        )
        .claim(
            text!(
                "the spike of height 1 is missed by all {n} samples, and none is added",
                "пик высоты 1 не попал ни на один отсчёт (всего их {n}), и ни один не добавлен"
            ),
            Residual::at_most("further samples, and the largest value found", blind.extra() as f64 + heights, 0.0),
        ))
}
