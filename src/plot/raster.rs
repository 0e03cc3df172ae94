//! Grids of values as images whose cells stay sharp.

use super::chart::Frame;
use super::palette::{srgb, table};
use super::ruler::Ruler;
use super::scene::{Image, Pixels, fine};
use crate::figure::{Mark, Panel, Tones};
use ndarray::Array2;
use std::rc::Rc;

/// Which of the 256 colours of `tones` stands for a part, 0 to 1, of their range.
pub(super) fn tone(part: f64, tones: Tones) -> u8 {
    match tones {
        Tones::Grey => srgb(part),
        Tones::Data => (part.clamp(0.0, 1.0) * 255.0 + 0.5) as u8,
    }
}

/// Where a grid of values lies in the picture; its edges lie on whole units, so that its cells can be whole pixels.
pub(super) struct Place {
    corners: ((i32, i32), (i32, i32)),
    /// Rows and columns.
    size: (usize, usize),
    /// Whether the scales run leftwards and downwards.
    flipped: (bool, bool),
}

impl Place {
    /// None where it has no place that coordinates can name.
    pub(super) fn of(
        (x0, x1): (f64, f64),
        (y0, y1): (f64, f64),
        size: (usize, usize),
        (x, y): (&Ruler, &Ruler),
        plot: Frame,
    ) -> Option<Self> {
        let across = |v: f64| (plot.left + x.part(v) * plot.width() + 0.00137).round();
        let down = |v: f64| (plot.bottom - y.part(v) * plot.height() + 0.00137).round();
        let (left, right, top, bottom) = (across(x0), across(x1), down(y1), down(y0));
        if size.0 * size.1 == 0 || [left, right, top, bottom].iter().any(|v| v.is_nan() || v.abs() > 1e6) {
            return None;
        }
        let corner = |x: f64, y: f64| (fine(x), fine(y));
        let corners = (corner(left.min(right), top.min(bottom)), corner(left.max(right), top.max(bottom)));
        Some(Self { corners, size, flipped: (right < left, bottom < top) })
    }

    /// The cells as an image has them: row 0 is the lowest y, but the first of an image is the uppermost; a reversed
    /// range turns it round.
    fn cells(&self) -> impl Iterator<Item = [usize; 2]> {
        let ((rows, columns), (flip_x, flip_y)) = (self.size, self.flipped);
        let row = move |j: usize| if flip_y { j } else { rows - 1 - j };
        let column = move |i: usize| if flip_x { columns - 1 - i } else { i };
        (0..rows).flat_map(move |j| (0..columns).map(move |i| [row(j), column(i)]))
    }

    fn image(&self, pixels: Pixels) -> Image {
        Image { corners: self.corners, cells: (self.size.1, self.size.0), pixels, clip: None }
    }

    /// Values in tones.
    pub(super) fn toned(&self, values: &Array2<f64>, (low, high): (f64, f64), tones: Tones) -> Image {
        let cells = self.cells().map(|at| tone((values[at] - low) / (high - low), tones)).collect();
        self.image(Pixels::Toned { tones: cells, table: Rc::new(table(tones)) })
    }

    /// Red, green and blue light.
    pub(super) fn colored(&self, light: &[Array2<f64>; 3]) -> Image {
        self.image(Pixels::Colored(self.cells().map(|at| light.each_ref().map(|plane| srgb(plane[at]))).collect()))
    }
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
    if let Some((across, down)) = cells(panel) {
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
pub(super) fn cells(panel: &Panel) -> Option<(f64, f64)> {
    if panel.x.log || panel.y.log {
        return None;
    }
    let [dx, dy] = [panel.x.range, panel.y.range].map(|(low, high)| (high - low).abs());
    let grids = panel.layers.iter().filter_map(|layer| match &layer.mark {
        Mark::Raster { x, y, .. } | Mark::Colors { x, y, .. } => {
            let (rows, columns) = layer.mark.cells();
            let across = dx / ((x.1 - x.0).abs() / columns as f64);
            let down = dy / ((y.1 - y.0).abs() / rows as f64);
            (across.is_finite() && down.is_finite() && across >= 1.0 && down >= 1.0).then_some((across, down))
        }
        _ => None,
    });
    grids.max_by(|a, b| a.0.total_cmp(&b.0))
}
