//! What is drawn in a chart and plotters lacks: curves that leave the panel, arrows, markers.
//!
//! plotters moves every point of its own elements into the drawing area, which bends a curve that leaves it into a line
//! along the frame. These elements keep their points, and the canvas cuts them where the frame does.

use super::canvas::Canvas;
use super::look::{Look, Marker, filled, stroke};
use super::scene::{FINE, Place};
use plotters::coord::CoordTranslate;
use plotters::drawing::Rect;
use plotters::element::{CoordMapper, Drawable, PointCollection};
use plotters::style::ShapeStyle;
use plotters_backend::{BackendCoord, DrawingBackend, DrawingErrorKind};
use std::convert::Infallible;

type Drawn = Result<(), DrawingErrorKind<Infallible>>;

/// Points stay where they are, also outside the drawing area.
pub(super) struct Anywhere;

impl CoordMapper for Anywhere {
    type Output = BackendCoord;

    fn map<T: CoordTranslate>(translate: &T, from: &T::From, _: &Rect) -> BackendCoord {
        translate.translate(from)
    }
}

/// A polyline, or an area within one.
pub(super) struct Curve {
    points: Vec<(f64, f64)>,
    style: ShapeStyle,
}

impl Curve {
    /// A line, or, if the style is filled, the area that it encloses.
    pub(super) fn new(points: impl IntoIterator<Item = (f64, f64)>, style: ShapeStyle) -> Self {
        Self { points: points.into_iter().collect(), style }
    }
}

impl<'a> PointCollection<'a, (f64, f64), Anywhere> for &'a Curve {
    type Point = &'a (f64, f64);
    type IntoIter = &'a [(f64, f64)];

    fn point_iter(self) -> &'a [(f64, f64)] {
        &self.points
    }
}

impl Drawable<Canvas, Anywhere> for Curve {
    fn draw<I: Iterator<Item = BackendCoord>>(&self, points: I, canvas: &mut Canvas, _: (u32, u32)) -> Drawn {
        if self.style.filled { canvas.fill_polygon(points, &self.style) } else { canvas.draw_path(points, &self.style) }
    }
}

/// How an arrow is drawn, all lengths in units of the picture.
#[derive(Clone, Copy)]
pub(super) struct Tip {
    /// How wide the shaft is.
    pub shaft: f64,
    /// How long the head may be; it is never more than 0.6 of the arrow.
    pub head: f64,
}

/// The shaft or the head of an arrow: drawn apart, so that all shafts are one line of the picture and all heads another.
pub(super) struct Arrow {
    pub ends: [(f64, f64); 2],
    pub style: ShapeStyle,
    pub tip: Tip,
}

impl Arrow {
    /// Arrows `[from, to]`: first their shafts, then their heads.
    pub(super) fn all(ends: &[[(f64, f64); 2]], look: &Look, tip: Tip) -> Vec<Self> {
        let styles = [stroke(look.rgb, tip.shaft), filled(look.rgb, 1.0)];
        styles.iter().flat_map(|style| ends.iter().map(move |e| Self { ends: *e, style: *style, tip })).collect()
    }
}

impl<'a> PointCollection<'a, (f64, f64), Anywhere> for &'a Arrow {
    type Point = &'a (f64, f64);
    type IntoIter = &'a [(f64, f64)];

    fn point_iter(self) -> &'a [(f64, f64)] {
        &self.ends
    }
}

impl Drawable<Canvas, Anywhere> for Arrow {
    fn draw<I: Iterator<Item = BackendCoord>>(&self, mut ends: I, canvas: &mut Canvas, _: (u32, u32)) -> Drawn {
        let (Some(from), Some(to)) = (ends.next(), ends.next()) else { return Ok(()) };
        let (dx, dy) = (f64::from(to.0 - from.0), f64::from(to.1 - from.1));
        let length = (dx * dx + dy * dy).sqrt();
        if length < 1.0 {
            return Ok(());
        }
        let (ux, uy) = (dx / length, dy / length);
        let head = (self.tip.head * FINE).min(0.6 * length);
        // A place so far behind the tip and so far aside of the shaft.
        let at = |behind: f64, aside: f64| -> Place {
            let x = f64::from(to.0) - ux * behind - uy * aside;
            let y = f64::from(to.1) - uy * behind + ux * aside;
            ((x + 0.137).round() as i32, (y + 0.137).round() as i32)
        };
        let neck = at(0.8 * head, 0.0);
        if self.style.filled {
            let half = 0.4 * head;
            canvas.fill_polygon([to, at(head, half), neck, at(head, -half)], &self.style)
        } else {
            canvas.draw_path([from, neck], &self.style)
        }
    }
}

/// The corners of a marker about its middle, in hundredths of a unit; all look equally heavy.
pub(super) fn corners(marker: Marker, radius: f64) -> Vec<Place> {
    let corners: &[(f64, f64)] = match marker {
        Marker::Circle => &[],
        Marker::Square => &[(-0.89, -0.89), (0.89, -0.89), (0.89, 0.89), (-0.89, 0.89)],
        Marker::Triangle => &[(0.0, -1.28), (1.18, 0.8), (-1.18, 0.8)],
        Marker::Diamond => &[(0.0, -1.28), (1.28, 0.0), (0.0, 1.28), (-1.28, 0.0)],
    };
    corners.iter().map(|(x, y)| ((x * radius * FINE).round() as i32, (y * radius * FINE).round() as i32)).collect()
}
