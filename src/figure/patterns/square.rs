//! What the figures of patterns share: the unit square with points in it, and the plane of frequencies.

use crate::figure::common::unmarked;
use crate::figure::{Layer, Meaning, Panel, Scale, Tones};
use crate::laws::jitter::deviations;
use crate::pattern::measure::periodogram::Periodogram;
use crate::text::Text;
use ndarray::Array2;

pub(super) static SEED: Text = Text::fixed("seed of the random numbers", "начальное число генератора");

/// How many seeds a figure offers: a statistical bound must hold for all of them.
pub(super) const SEEDS: usize = 100;

/// How many standard deviations the worst of `trials` numbers may be off, for all seeds of a figure.
pub(super) fn for_all_seeds(trials: usize) -> f64 {
    deviations(SEEDS * trials)
}

/// A mean and its standard error.
pub(super) fn mean(values: &[f64]) -> [f64; 2] {
    let n = values.len() as f64;
    let mean = values.iter().sum::<f64>() / n;
    let squares: f64 = values.iter().map(|v| (v - mean).powi(2)).sum();
    [mean, (squares / (n * (n - 1.0).max(1.0))).sqrt()]
}

/// A scale of distances from zero in the plane of frequencies.
pub(super) fn frequencies(label: Text, reach: f64) -> Scale {
    Scale::linear(label, 0.0, reach)
}

/// The unit square, without numbers.
pub(super) fn square(name: &'static str, title: Text) -> Panel {
    Panel::new(name, title, unmarked(0.0, 1.0), unmarked(0.0, 1.0)).square()
}

/// The unit square with points in it.
pub(super) fn points_panel(name: &'static str, title: Text, points: &[[f64; 2]]) -> Panel {
    square(name, title).with(Layer::dots("points", Meaning::Samples, points.iter().copied()))
}

/// The unit square, cut into `columns × rows` boxes, with points in it.
pub(super) fn boxes_panel(name: &'static str, title: Text, [columns, rows]: [usize; 2], points: &[[f64; 2]]) -> Panel {
    square(name, title).with(cell_lines(columns, rows)).with(Layer::dots(
        "points",
        Meaning::Samples,
        points.iter().copied(),
    ))
}

/// The lines that cut the unit square into `columns × rows` boxes, as one layer.
pub(super) fn cell_lines(columns: usize, rows: usize) -> Layer {
    let part = |i: usize, n: usize| i as f64 / n as f64;
    let up = (1..columns).flat_map(|i| [[part(i, columns), 0.0], [part(i, columns), 1.0], [f64::NAN; 2]]);
    let across = (1..rows).flat_map(|i| [[0.0, part(i, rows)], [1.0, part(i, rows)], [f64::NAN; 2]]);
    Layer::line("cells", Meaning::Guide, up.chain(across)).thin()
}

/// A periodogram as tones between `low` and `high`, over frequencies in multiples of `unit`; the line at zero is left out,
/// it is `N` for all patterns.
pub(super) fn power_panel(name: &'static str, title: Text, found: &Periodogram, unit: f64, tones: (f64, f64)) -> Panel {
    let mut power = found.power().clone();
    power[[found.reach(), found.reach()]] = tones.0;
    tones_panel(name, title, power, unit, tones)
}

/// Values at the integer frequencies up to some reach as tones.
pub(super) fn tones_panel(name: &'static str, title: Text, values: Array2<f64>, unit: f64, tones: (f64, f64)) -> Panel {
    let reach = (values.ncols() / 2) as f64;
    let edge = (reach + 0.5) / unit;
    // whole units, or quarters where there is no whole one
    let most = 0.9 * reach / unit;
    let mark = if most >= 1.0 { most.floor() } else { (4.0 * most).floor() / 4.0 };
    let ticks = || [-mark, 0.0, mark].map(|f| (f, Text::of(f.to_string(), f.to_string())));
    let scale = || Scale::linear(Text::EMPTY, -edge, edge).ticks(ticks());
    Panel::new(name, title, scale(), scale()).square().with(Layer::raster(
        "power",
        (-edge, edge),
        (-edge, edge),
        values,
        tones,
        Tones::Data,
    ))
}
