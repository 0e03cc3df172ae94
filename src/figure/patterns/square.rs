//! What the figures of patterns share: the unit square with points in it, and the plane of frequencies.

use crate::figure::common::unmarked;
use crate::figure::{Layer, Meaning, Panel, Scale, Tones};
use crate::pattern::measure::periodogram::Periodogram;
use crate::text::Text;

pub(super) static SEED: Text = Text::fixed("seed of the random numbers", "начальное число генератора");
pub(super) static SIDE: Text = Text::fixed("cells along a side", "ячеек вдоль стороны");

/// A scale of distances from zero in the plane of frequencies, in cycles per unit of length.
pub(super) fn frequencies(reach: f64) -> Scale {
    Scale::linear(Text::same("|ν|"), 0.0, reach)
}

/// The unit square, without numbers.
pub(super) fn square(name: &'static str, title: Text) -> Panel {
    Panel::new(name, title, unmarked(0.0, 1.0), unmarked(0.0, 1.0)).square()
}

/// The unit square with points in it.
pub(super) fn points_panel(
    name: &'static str,
    title: Text,
    meaning: Meaning,
    points: impl IntoIterator<Item = [f64; 2]>,
) -> Panel {
    square(name, title).with(Layer::dots("points", meaning, points))
}

/// The lines that cut the unit square into `columns × rows` boxes, as one layer.
pub(super) fn cell_lines(columns: usize, rows: usize) -> Layer {
    let part = |i: usize, n: usize| i as f64 / n as f64;
    let up = (1..columns).flat_map(|i| [[part(i, columns), 0.0], [part(i, columns), 1.0], [f64::NAN; 2]]);
    let across = (1..rows).flat_map(|i| [[0.0, part(i, rows)], [1.0, part(i, rows)], [f64::NAN; 2]]);
    Layer::line("cells", Meaning::Guide, up.chain(across)).thin()
}

/// A periodogram as tones between `low` and `high`; the line at zero is left out, it is `N` for all patterns.
pub(super) fn power_panel(name: &'static str, title: Text, found: &Periodogram, tones: (f64, f64)) -> Panel {
    let reach = found.reach();
    let mut power = found.power().clone();
    power[[reach, reach]] = tones.0;
    let edge = reach as f64 + 0.5;
    let ticks = || {
        let mark = round_below(0.8 * reach as f64);
        [-mark, 0, mark].map(|f| (f as f64, Text::of(f.to_string(), f.to_string())))
    };
    Panel::new(
        name,
        title,
        Scale::linear(Text::EMPTY, -edge, edge).ticks(ticks()),
        Scale::linear(Text::EMPTY, -edge, edge).ticks(ticks()),
    )
    .square()
    .with(Layer::raster("power", (-edge, edge), (-edge, edge), power, tones, Tones::Data))
}

/// The largest of 1, 2, 4, 8, … and of their threefold that does not exceed `limit`.
fn round_below(limit: f64) -> i64 {
    let mut power = 1.0;
    while 2.0 * power <= limit {
        power *= 2.0;
    }
    (if 1.5 * power <= limit && power > 1.0 { 1.5 * power } else { power }) as i64
}
