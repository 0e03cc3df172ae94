//! The spectrum of a picture as a picture.

use crate::axis::Axis;
use crate::figure::{Figure, Layer, Legend, Meaning, Panel, Portrait, Scale, Tones};
use crate::inspect::picture::band::Fall;
use crate::inspect::picture::power::PowerSpectrum;
use crate::text;
use crate::text::{Text, number};
use ndarray::Array2;

/// How many cells of a spectrum are drawn along a side at most: as many units as there is room.
const CELLS: usize = 640;
/// How far below the highest value of a spectrum it is shown, in dB.
const DEEPEST: f64 = 120.0;

/// The power spectrum of a picture: over the plane, and its means over rings and along both directions.
///
/// ```
/// use nyquist::figure::report::picture::spectrum::portrait;
/// use nyquist::inspect::picture::power::{Border, PowerSpectrum};
/// use nyquist::prelude::*;
/// let image = Image::of(&ZonePlate::new(64.0)?, Grid::centered(1.0, 64, 64)?);
/// let drawn = portrait("rings.png", &PowerSpectrum::of(&image, Border::Periodic));
/// assert_eq!(drawn.figure.panels.len(), 2);
/// # Ok::<(), Error>(())
/// ```
pub fn portrait(name: &str, spectrum: &PowerSpectrum) -> Portrait {
    let deviation = number(spectrum.deviation(), 3);
    let mean = number(spectrum.mean(), 3);
    Portrait {
        title: text!("{name}: power spectrum in linear light", "{name}: спектр мощности в линейном свете"),
        caption: text!(
            "Power per area of the plane of frequencies, in dB of white² px²; the sum over the plane is the variance. The \
             mean of the picture, {mean} of white, is left out; its standard deviation is {deviation}. Left: zero frequency in \
             the middle, v downwards as rows are. Right: means over rings and along both directions.",
            "Мощность на единицу площади плоскости частот, дБ от белого² пкс²; сумма по плоскости равна дисперсии. Среднее \
             изображения, {mean} от белого, вычтено; среднеквадратичное отклонение {deviation}. Слева: нулевая частота в \
             середине, v вниз, как строки. Справа: средние по кольцам и вдоль обоих направлений."
        ),
        figure: Figure::new(2).with(plane_panel(spectrum, CELLS)).with(fall_panel(spectrum)),
    }
}

/// The power in decibels over the plane, in `most` cells along a side at most.
pub(super) fn plane_panel(spectrum: &PowerSpectrum, most: usize) -> Panel {
    let power = spectrum.power();
    let grid = power.grid();
    let (nx, ny) = (grid.width(), grid.height());
    let cell = nx.max(ny).div_ceil(most);
    let (columns, rows) = (nx.div_ceil(cell), ny.div_ceil(cell));
    // the highest of each cell, so that lines are not averaged away
    let mut highest = Array2::<f64>::zeros((rows, columns));
    for (l, row) in power.pixels().rows().into_iter().enumerate() {
        for (k, value) in row.iter().enumerate() {
            let cell = &mut highest[[l / cell, k / cell]];
            *cell = cell.max(*value);
        }
    }
    let top = highest.iter().fold(0.0f64, |a, b| a.max(*b));
    let mut sorted: Vec<f64> = highest.iter().copied().filter(|p| *p > 0.0).collect();
    sorted.sort_unstable_by(f64::total_cmp);
    let low = sorted.get(sorted.len() / 100).copied().unwrap_or(1.0).max(top * 10f64.powf(-0.1 * DEEPEST));
    let decibels = highest.mapv(|p| if p > 0.0 { (10.0 * p.log10()).round() } else { -1e3 });
    let (low, top) = if top > 0.0 { (10.0 * low.log10(), 10.0 * top.log10()) } else { (-1.0, 0.0) };
    // half a bin beyond the outermost middles
    let extent = |axis: Axis, cells: usize| {
        let start = axis.start() - 0.5 * axis.step();
        (start, start + axis.step() * (cells * cell) as f64)
    };
    let (x, y) = (extent(grid.x(), columns), extent(grid.y(), rows));
    let layer = Layer::raster("power", x, y, decibels, (low, top.max(low + 1.0)), Tones::Data);
    let scale = |label: Text, from: f64, to: f64| Scale::linear(label, from, to);
    Panel::new(
        "spectrum",
        text!("spectrum, {} to {} dB", "спектр, от {} до {} дБ", number(low, 2), number(top, 2)),
        scale(text!("u, cycles/px", "u, периодов/пкс"), -0.5, 0.5),
        scale(text!("v, cycles/px", "v, периодов/пкс"), 0.5, -0.5),
    )
    .square()
    .with(layer)
}

/// How the power falls with frequency.
pub(super) fn fall_panel(spectrum: &PowerSpectrum) -> Panel {
    let decibels = |fall: &Fall| -> Vec<[f64; 2]> {
        fall.levels.iter().filter(|l| l[1] > 0.0).map(|[nu, p]| [*nu, 10.0 * p.log10()]).collect()
    };
    let curves = [Fall::radial(spectrum), Fall::along(spectrum, 0), Fall::along(spectrum, 1)].map(|f| decibels(&f));
    let all = || curves.iter().flatten().map(|p| p[1]);
    let (low, high) = (all().fold(f64::INFINITY, f64::min), all().fold(f64::NEG_INFINITY, f64::max));
    let (low, high) = if low < high { (low.max(high - DEEPEST), high) } else { (-1.0, 1.0) };
    let labels =
        [text!("all directions", "все направления"), text!("across", "по горизонтали"), text!("down", "по вертикали")];
    let mut panel = Panel::new(
        "fall",
        text!("how it falls", "как он спадает"),
        Scale::linear(text!("frequency, cycles/px", "частота, периодов/пкс"), 0.0, 0.5),
        Scale::linear(text!("power, dB", "мощность, дБ"), low - 0.05 * (high - low), high + 0.05 * (high - low)),
    )
    .legend(Legend::UpperRight);
    let names = ["radial", "across", "down"];
    for (i, ((points, label), name)) in (0u8..).zip(curves.into_iter().zip(labels).zip(names)) {
        let layer = Layer::line(name, Meaning::Series(i), points).label(label);
        panel = panel.with(if i == 0 { layer.thick() } else { layer });
    }
    panel
}
