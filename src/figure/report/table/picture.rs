//! The picture of a table's report.

use crate::figure::report::table::frequency;
use crate::figure::report::table::spectrum::{self, DRAWN};
use crate::figure::{Figure, Layer, Legend, Meaning, Panel, Scale};
use crate::inspect::table::{ColumnCheck, Landing, Prediction, TableCheck};
use crate::nyquist::Alias;
use crate::record::Kind;
use crate::text;
use crate::text::Text;

/// Samples up to which each is drawn as a dot.
const DOTS: usize = 500;
/// Gaps up to which each is shaded.
const SHADED: usize = 200;

/// Samples over time, ways between them where these are not all the same, and the spectrum.
pub(super) fn figure(check: &TableCheck, column: &ColumnCheck, prediction: Option<&Prediction<'_>>) -> Figure {
    let even = check.sampling.axis().is_some();
    let (samples, before) = (samples(check, column), amplitudes(check, column, prediction));
    let figure = Figure::new(10).heights([1.0, 1.15]);
    match (prediction.map(|prediction| after(check, column, prediction, &before)), even) {
        (None, true) => figure.with(samples.span(10)).with(before.span(10)),
        (None, false) => figure.with(samples.span(10)).with(ways(check).span(4)).with(before.span(6)),
        (Some(after), true) => figure.with(samples.span(10)).with(before.span(5)).with(after.span(5)),
        (Some(after), false) => {
            figure.with(samples.span(6)).with(ways(check).span(4)).with(before.span(5)).with(after.span(5))
        }
    }
}

/// The spectrum at the new rate, as high as that before: what stays, and what lands on it.
fn after(check: &TableCheck, column: &ColumnCheck, prediction: &Prediction<'_>, before: &Panel) -> Panel {
    let (found, half) = (&column.found, 0.5 * prediction.rate);
    let (resolution, high) = (found.spectrum.resolution(), half.min(before.x.range.1));
    let mut folded = vec![0.0f64; (half / resolution).min(found.spectrum.highest() / resolution) as usize + 1];
    for [frequency, amplitude] in found.spectrum.amplitudes().filter(|p| p[0] >= half) {
        let lands = Alias::of(frequency, prediction.rate).map_or(half, |alias| alias.frequency());
        if let Some(sum) = folded.get_mut((lands / resolution).round() as usize) {
            *sum += amplitude * amplitude;
        }
    }
    let folds = folded.iter().any(|sum| *sum > 0.0);
    let folded = folded.iter().enumerate().map(|(m, sum)| [m as f64 * resolution, sum.sqrt()]);
    let folded: Vec<[f64; 2]> = folded.filter(|p| p[1] > 0.0).collect();
    let stays: Vec<[f64; 2]> = found.spectrum.amplitudes().filter(|p| p[0] < half).collect();
    let rate = frequency(check, prediction.rate, 6);
    let x = Scale { range: (0.0, 1.02 * high), ..before.x.clone() };
    let mut panel = Panel::new("after", text!("at the rate {rate}", "при частоте {rate}"), x, before.y.clone())
        .legend(Legend::Above)
        .with(Layer::line("stays", Meaning::Signal, spectrum::thinned(&stays)).thin());
    if folds {
        let folded = Layer::line("folded", Meaning::Leaked, spectrum::thinned(&folded)).thin();
        panel = panel.with(folded.label(text!("folded", "наложившееся")));
    }
    let kept = found.lines.iter().filter(|line| line.frequency < half).map(|line| [line.frequency, line.amplitude]);
    let kept: Vec<[f64; 2]> = kept.collect();
    if !kept.is_empty() {
        panel = panel.with(Layer::dots("kept", Meaning::Samples, kept).label(text!("lines", "линии")));
    }
    let landed: Vec<[f64; 2]> = prediction.landings.iter().map(|l| [l.alias.frequency(), l.line.amplitude]).collect();
    if landed.is_empty() {
        return panel;
    }
    panel.with(Layer::dots("landed", Meaning::Leaked, landed).label(text!("aliases", "образы")))
}

/// Times from the first on; where there is room, with what that is.
fn times(check: &TableCheck, wide: bool) -> Scale {
    let positions = check.sampling.positions();
    let unit = check.unit();
    let name = check.table.clock.as_ref().map_or("t", |clock| clock.heading.name.as_str());
    let first = check.shown(0);
    let zero = check.table.clock.as_ref().is_none_or(|clock| clock.times[check.sampling.row(0)].value() == 0.0);
    let shown = if unit.is_empty() { name.to_owned() } else { format!("{name}, {unit}") };
    let label = match zero || !wide {
        true => Text::of(shown.clone(), shown),
        false => Text::of(format!("{shown}, since {first}"), format!("{shown}, от {first}")),
    };
    Scale::linear(label, 0.0, (positions[positions.len() - 1] - positions[0]) * (1.0 + 1e-9))
}

fn range(low: f64, high: f64) -> (f64, f64) {
    let margin = if high > low { 0.06 * (high - low) } else { high.abs().max(1.0) };
    (low - margin, high + margin)
}

fn samples(check: &TableCheck, column: &ColumnCheck) -> Panel {
    let (positions, values) = (check.sampling.positions(), &column.values);
    let extreme = |pick: fn(f64, f64) -> f64, from: f64| values.iter().copied().fold(from, pick);
    let (low, high) = range(extreme(f64::min, f64::INFINITY), extreme(f64::max, f64::NEG_INFINITY));
    let heading = &column.heading;
    let value = Scale::linear(text!("{heading}", "{heading}"), low, high);
    let n = positions.len();
    let title = text!("samples: {n}", "отсчётов: {n}");
    let mut panel = Panel::new("samples", title, times(check, true), value).legend(Legend::Above);
    let gaps = check.sampling.gaps();
    let since = |x: f64| x - positions[0];
    let mut longest = gaps.clone();
    longest.sort_by_key(|gap| std::cmp::Reverse(gap.missing));
    longest.truncate(SHADED);
    if !longest.is_empty() {
        let spans = longest.iter().map(|gap| gap.between.map(since));
        let missing = gaps.iter().map(|gap| gap.missing).sum::<usize>();
        panel = panel.with(
            Layer::spans("gaps", Meaning::Error, spans).label(text!("missing: {missing}", "пропущено: {missing}")),
        );
    }
    let nodes = check.sampling.nodes();
    let lifted = |i: usize| i > 0 && nodes.get(i).is_some_and(|node| *node > nodes[i - 1] + 1);
    let points = (0..n).flat_map(|i| {
        // the pen is lifted over gaps
        let lift = lifted(i).then_some([f64::NAN, f64::NAN]);
        lift.into_iter().chain([[since(positions[i]), values[i]]])
    });
    let points: Vec<[f64; 2]> = points.collect();
    let length = positions[n - 1] - positions[0];
    let drawn = if n > DRAWN { envelope(&points, length) } else { points.clone() };
    let panel = panel.with(Layer::line("values", Meaning::Signal, drawn).thin());
    if n > DOTS { panel } else { panel.with(Layer::dots("samples", Meaning::Samples, points)) }
}

/// Of each column of a curve too dense to be drawn the first, the least, the greatest and the last point.
fn envelope(points: &[[f64; 2]], length: f64) -> Vec<[f64; 2]> {
    let column = |p: &[f64; 2]| if p[0].is_nan() { -1.0 } else { (p[0] / length * DRAWN as f64).floor() };
    let mut drawn = Vec::new();
    for group in points.chunk_by(|a, b| column(a) == column(b)) {
        let by = |a: &&[f64; 2], b: &&[f64; 2]| a[1].total_cmp(&b[1]);
        let ends = [group.first(), group.iter().min_by(by), group.iter().max_by(by), group.last()];
        drawn.extend(ends.into_iter().flatten().copied());
    }
    drawn
}

fn ways(check: &TableCheck) -> Panel {
    let positions = check.sampling.positions();
    let [least, _, most] = check.sampling.ways();
    let log = most > 20.0 * least;
    let unit = check.unit();
    let label = text!("step, {unit}", "шаг, {unit}");
    let label = if unit.is_empty() { text!("step", "шаг") } else { label };
    let scale = match log {
        true => Scale::log(label, 0.5 * least, 2.0 * most),
        false => {
            let (low, high) = range(least, most);
            Scale::linear(label, low, high)
        }
    };
    let way = |pair: &[f64]| [pair[0] - positions[0], pair[1] - pair[0]];
    let all: Vec<[f64; 2]> = positions.windows(2).map(way).collect();
    // of many, those that are farthest from the others
    let stride = all.len().div_ceil(DRAWN);
    let shown = all.chunks(stride.max(1)).flat_map(|chunk| {
        let by = |a: &&[f64; 2], b: &&[f64; 2]| a[1].total_cmp(&b[1]);
        let (low, high) = (chunk.iter().min_by(by), chunk.iter().max_by(by));
        if stride > 1 { [low, high] } else { [low, None] }.into_iter().flatten().copied().collect::<Vec<_>>()
    });
    let panel = Panel::new("ways", text!("from sample to sample", "промежутки"), times(check, false), scale)
        .legend(Legend::Above);
    let panel = match check.sampling.step() {
        Some(step) => panel
            .with(Layer::horizontals("step", Meaning::Theory, [step]).label(text!("nominal step", "номинальный шаг"))),
        None => panel,
    };
    panel.with(Layer::dots("ways", Meaning::Samples, shown))
}

fn amplitudes(check: &TableCheck, column: &ColumnCheck, prediction: Option<&Prediction<'_>>) -> Panel {
    let found = &column.found;
    let mut panel = spectrum::panel(check.unit(), &column.heading, &found.spectrum);
    let (low, high) = panel.y.range;
    let sampling = &check.sampling;
    // lines may stand above their bins, and below the bottom
    let strongest = found.lines.first().map_or(high, |line| 2.0 * line.amplitude);
    panel.y.range = (low, high.max(strongest));
    let top = panel.x.range.1;
    if let Some(prediction) = prediction {
        let half = 0.5 * prediction.rate;
        if half < top {
            let shown = frequency(check, half, 4);
            panel = panel.with(Layer::spans("beyond", Meaning::Leaked, [[half, top]]));
            panel = panel.with(
                Layer::verticals("half", Meaning::Leaked, [half])
                    .dashed()
                    .label(text!("half the new rate: {shown}", "половина новой частоты: {shown}")),
            );
        }
    }
    if let Some(step) = sampling.step().filter(|_| sampling.kind() != Kind::Jittered) {
        let nyquist = Layer::verticals("nyquist", Meaning::Guide, [0.5 / step]);
        panel = panel.with(nyquist.label(text!("Nyquist frequency", "частота Найквиста")));
    }
    if sampling.axis().is_none() {
        let safe = Layer::verticals("safe", Meaning::Theory, [sampling.safe_band()]).thin();
        let density = Layer::verticals("density", Meaning::Theory, [sampling.highest_band()]).dashed();
        panel = panel
            .with(safe.label(text!("determined below (gap)", "определено ниже (промежуток)")))
            .with(density.label(text!("undetermined above (density)", "не определено выше (плотность)")));
    }
    let dots = found.lines.iter().map(|line| [line.frequency, line.amplitude]);
    if !found.lines.is_empty() {
        panel = panel.with(Layer::dots("lines", Meaning::Samples, dots).label(text!("lines", "линии")));
    }
    let Some(prediction) = prediction.filter(|prediction| !prediction.landings.is_empty()) else { return panel };
    let from = |l: &Landing| [l.line.frequency, l.line.amplitude];
    let to = |l: &Landing| [l.alias.frequency(), l.line.amplitude];
    let arrows: Vec<[[f64; 2]; 2]> = prediction.landings.iter().map(|l| [from(l), to(l)]).collect();
    panel.with(Layer::pointers("fold", Meaning::Leaked, arrows)).with(
        Layer::dots("aliases", Meaning::Leaked, prediction.landings.iter().map(to))
            .label(text!("their aliases", "их образы")),
    )
}
