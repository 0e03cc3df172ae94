//! What a layer looks like: colour, width, dashes, marker.

use super::palette::{Rgb, Theme};
use super::scene::{FINE, Paint};
use crate::figure::{Layer, Mark, Meaning, Stroke};
use plotters::style::{Color, RGBAColor, RGBColor, ShapeStyle};

/// The sizes of letters and lines of one figure, in units of the picture.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sizes {
    /// What one pixel of a picture of 1600 × 900 is.
    pub one: f64,
    /// Numbers, labels, notes, legends.
    pub body: f64,
    /// Titles of panels.
    pub heading: f64,
    /// The title of the figure.
    pub title: f64,
    /// What text is never smaller than.
    pub least: f64,
    /// A normal line.
    pub line: f64,
}

impl Sizes {
    /// For a picture of that size with so many panels: the more there are, the smaller, but always readable.
    pub(super) fn new((width, height): (u32, u32), panels: usize) -> Self {
        let one = (f64::from(width) / 1600.0 * f64::from(height) / 900.0).sqrt();
        let (body, line) = match panels {
            0..=2 => (26.0, 3.5),
            3..=4 => (24.0, 3.2),
            5..=6 => (22.0, 3.0),
            7..=9 => (20.0, 2.7),
            _ => (18.0, 2.5),
        };
        Self {
            one,
            body: body * one,
            heading: body * 1.08 * one,
            title: 36.0 * one,
            least: 18.0 * one,
            line: line * one,
        }
    }
}

/// The shapes of dots.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Marker {
    Circle,
    Square,
    Triangle,
    Diamond,
}

/// What a layer looks like.
#[derive(Debug, Clone)]
pub(super) struct Look {
    pub rgb: Rgb,
    /// How wide its lines are, in units.
    pub width: f64,
    /// Dashes and gaps in hundredths of a unit.
    pub dash: Vec<i32>,
    pub marker: Marker,
}

impl Look {
    pub(super) fn of(layer: &Layer, theme: Theme, sizes: &Sizes) -> Self {
        let stroke = match layer.stroke {
            Stroke::Thin => 0.55,
            Stroke::Normal => 1.0,
            Stroke::Thick => 1.5,
        };
        let guide = layer.meaning == Meaning::Guide || matches!(layer.mark, Mark::Verticals(_) | Mark::Horizontals(_));
        let width = sizes.line * stroke * if guide { 0.75 } else { 1.0 };
        let kind = match layer.meaning {
            Meaning::Series(n) => usize::from(n),
            _ => 0,
        };
        // In widths of the line: dash, gap, …; the first is solid.
        const DASHES: [&[f64]; 6] =
            [&[], &[4.2, 2.4], &[1.2, 1.8], &[6.0, 2.0, 1.2, 2.0], &[9.0, 2.4], &[6.0, 1.8, 1.2, 1.8, 1.2, 1.8]];
        let pattern = match DASHES[kind % DASHES.len()] {
            [] if layer.dashed => DASHES[1],
            pattern => pattern,
        };
        let dash = pattern.iter().map(|d| (d * width.max(2.0 * sizes.one) * FINE).round() as i32).collect();
        let markers = [Marker::Circle, Marker::Square, Marker::Triangle, Marker::Diamond];
        Self { rgb: theme.colour(layer.meaning), width, dash, marker: markers[kind % markers.len()] }
    }

    /// A line in this colour.
    pub(super) fn line(&self) -> ShapeStyle {
        stroke(self.rgb, self.width)
    }
}

/// A solid line.
pub(super) fn stroke(rgb: Rgb, width: f64) -> ShapeStyle {
    ShapeStyle { color: ink(rgb, 1.0), filled: false, stroke_width: (width * FINE).round() as u32 }
}

/// An area.
pub(super) fn filled(rgb: Rgb, opacity: f64) -> ShapeStyle {
    ShapeStyle { color: ink(rgb, opacity), filled: true, stroke_width: 0 }
}

/// plotters' name for a colour.
pub(super) fn ink(rgb: Rgb, opacity: f64) -> RGBAColor {
    let [r, g, b] = rgb.0;
    RGBColor(r, g, b).mix(opacity)
}

/// A halo of the paper's colour around letters of `size` units.
pub(super) fn halo(theme: Theme, size: f64) -> (Paint, i32) {
    (Paint { percent: 85, ..Paint::solid(theme.paper()) }, (size * 0.22 * FINE).round() as i32)
}
