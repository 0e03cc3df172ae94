//! Grids of values as images whose cells stay sharp.

use super::chart::Frame;
use super::palette::{srgb, table};
use super::ruler::Ruler;
use super::scene::{Image, fine};
use crate::figure::{Mark, Panel, Tones};
use ndarray::Array2;
use std::rc::Rc;

/// A raster layer's data.
pub(super) struct Cells<'a> {
    pub x: (f64, f64),
    pub y: (f64, f64),
    pub values: &'a Array2<f64>,
    pub low: f64,
    pub high: f64,
    pub tones: Tones,
}

/// The image of a raster in a panel; its edges lie on whole units, so that its cells can be whole pixels. None where it
/// has no place that coordinates can name.
pub(super) fn image(cells: &Cells<'_>, x: &Ruler, y: &Ruler, plot: Frame, clip: usize) -> Option<Image> {
    let across = |v: f64| (plot.left + x.part(v) * plot.width() + 0.00137).round();
    let down = |v: f64| (plot.bottom - y.part(v) * plot.height() + 0.00137).round();
    let (left, right) = (across(cells.x.0), across(cells.x.1));
    let (top, bottom) = (down(cells.y.1), down(cells.y.0));
    if cells.values.is_empty() || [left, right, top, bottom].iter().any(|v| v.is_nan() || v.abs() > 1e6) {
        return None;
    }
    let (rows, columns) = cells.values.dim();
    let tone = |v: f64| {
        let part = (v - cells.low) / (cells.high - cells.low);
        match cells.tones {
            Tones::Grey => srgb(part),
            Tones::Data => (part.clamp(0.0, 1.0) * 255.0 + 0.5) as u8,
        }
    };
    // Row 0 is the lowest y, but the first of an image is the uppermost; a reversed range turns it round.
    let (flip_x, flip_y) = (right < left, bottom < top);
    let mut tones = Vec::with_capacity(rows * columns);
    for row in 0..rows {
        let iy = if flip_y { row } else { rows - 1 - row };
        let line = (0..columns).map(|c| cells.values[[iy, if flip_x { columns - 1 - c } else { c }]]);
        tones.extend(line.map(tone));
    }
    let corner = |x: f64, y: f64| (fine(x), fine(y));
    Some(Image {
        corners: (corner(left.min(right), top.min(bottom)), corner(left.max(right), top.max(bottom))),
        cells: (columns, rows),
        tones,
        table: Rc::new(table(cells.tones)),
        clip: Some(clip),
    })
}

/// The room for a panel's plot, made such that units are equal where the panel asks for it, and that the cells of its
/// largest raster are whole pixels where they are at least one pixel large.
pub(super) fn settled(panel: &Panel, room: Frame) -> Frame {
    let length = |(low, high): (f64, f64)| (high - low).abs();
    let (dx, dy) = (length(panel.x.range), length(panel.y.range));
    let (mut width, mut height) = (room.width(), room.height());
    if panel.square && dx > 0.0 && dy > 0.0 && dx.is_finite() && dy.is_finite() {
        let unit = (width / dx).min(height / dy);
        (width, height) = (unit * dx, unit * dy);
    }
    if let Some((across, down)) = grid(panel, dx, dy) {
        let (mut a, mut b) = ((width / across + 1e-6).floor(), (height / down + 1e-6).floor());
        if panel.square && (across / down - dx / dy).abs() < 1e-9 * (dx / dy) {
            (a, b) = (a.min(b), a.min(b));
        }
        // Cells below one pixel cannot be whole: such a raster is averaged down.
        if a >= 1.0 && b >= 1.0 {
            (width, height) = ((a * across).round(), (b * down).round());
        }
    }
    let (width, height) = (width.floor().max(1.0), height.floor().max(1.0));
    let left = (room.left + 0.5 * (room.width() - width)).round();
    let top = (room.top + 0.5 * (room.height() - height)).round();
    Frame { left, top, right: left + width, bottom: top + height }
}

/// How many cells of the panel's finest raster its scales are long.
fn grid(panel: &Panel, dx: f64, dy: f64) -> Option<(f64, f64)> {
    if panel.x.log || panel.y.log {
        return None;
    }
    let grids = panel.layers.iter().filter_map(|layer| match &layer.mark {
        Mark::Raster { x, y, values, .. } if !values.is_empty() => {
            let (rows, columns) = values.dim();
            let across = dx / ((x.1 - x.0).abs() / columns as f64);
            let down = dy / ((y.1 - y.0).abs() / rows as f64);
            (across.is_finite() && down.is_finite() && across >= 1.0 && down >= 1.0).then_some((across, down))
        }
        _ => None,
    });
    grids.max_by(|a, b| a.0.total_cmp(&b.0))
}
