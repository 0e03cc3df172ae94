//! The picture as a list of things to paint: drawn once, written in every format.
//!
//! All coordinates are whole hundredths of a unit (a pixel at scale 1), x rightwards, y downwards, so that every writer
//! starts from the same numbers and no format can round differently from another.

use super::palette::Rgb;
use super::typeset::Line;
use crate::text::Lang;
use std::rc::Rc;

/// Hundredths to the unit.
pub(super) const FINE: f64 = 100.0;

/// The coordinate nearest to `units`.
///
/// A fixed offset of 0.00137 units goes first: round values, which figures are full of, then never lie on a rounding
/// tie, where the last bit of a computation, which differs between processors, would decide.
pub(super) fn fine(units: f64) -> i32 {
    (units * FINE + 0.137).round() as i32
}

/// A place in hundredths of a unit.
pub(super) type Place = (i32, i32);

/// A picture that can be written as SVG, PNG and PDF; all three are the same picture.
///
/// It is made by [`draw`](super::draw).
#[derive(Debug, Clone, PartialEq)]
pub struct Scene {
    pub(super) size: (u32, u32),
    pub(super) scale: f64,
    pub(super) lang: Lang,
    pub(super) title: String,
    pub(super) about: String,
    pub(super) paper: Rgb,
    /// Rectangles `(left, top, right, bottom)` that operations may be clipped to.
    pub(super) clips: Vec<(Place, Place)>,
    pub(super) ops: Vec<Op>,
}

#[derive(Debug, Clone, PartialEq)]
pub(super) enum Op {
    Shape(Shape),
    Words(Words),
    Image(Image),
}

/// Lines and areas of one colour.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Shape {
    pub contours: Vec<Contour>,
    pub fill: Option<Paint>,
    pub pen: Option<Pen>,
    /// Which of the scene's clips it is cut to.
    pub clip: Option<usize>,
}

/// Points joined by straight lines; a single point is a dot as wide as the pen.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Contour {
    pub points: Vec<Place>,
    pub closed: bool,
}

/// A colour and how much of it, in per cent.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) struct Paint {
    pub rgb: [u8; 3],
    pub percent: u8,
}

impl Paint {
    pub(super) fn solid(rgb: Rgb) -> Self {
        Self { rgb: rgb.0, percent: 100 }
    }
}

/// How a line is drawn.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Pen {
    pub paint: Paint,
    /// In hundredths of a unit.
    pub width: i32,
    /// Lengths of dashes and gaps by turns, in hundredths of a unit; empty for a solid line.
    pub dash: Vec<i32>,
    /// Whether ends are round; otherwise they are cut off.
    pub round: bool,
}

/// A line of text.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Words {
    pub line: Rc<Line>,
    /// Where its baseline starts.
    pub at: Place,
    /// The size of its letters, in hundredths of a unit.
    pub size: i32,
    /// Whether it runs upwards instead of rightwards.
    pub upright: bool,
    pub paint: Paint,
    /// A halo behind the letters: its colour and how far it reaches, in hundredths of a unit.
    pub halo: Option<(Paint, i32)>,
}

/// A grid of even cells.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Image {
    /// Upper left and lower right corner.
    pub corners: (Place, Place),
    /// Cells across and down.
    pub cells: (usize, usize),
    /// Row by row from the top, indices of the table.
    pub tones: Vec<u8>,
    pub table: Rc<[[u8; 3]; 256]>,
    pub clip: Option<usize>,
}

impl Op {
    pub(super) fn clip(&self) -> Option<usize> {
        match self {
            Self::Shape(shape) => shape.clip,
            Self::Image(image) => image.clip,
            Self::Words(_) => None,
        }
    }
}

impl Scene {
    /// Adds `shape`, to the last operation if that differs in nothing but where it is.
    pub(super) fn push(&mut self, mut shape: Shape) {
        if let Some(Op::Shape(last)) = self.ops.last_mut() {
            let opaque = shape.fill.is_none_or(|f| f.percent == 100)
                && shape.pen.as_ref().is_none_or(|p| p.paint.percent == 100);
            // Strokes and fills of one shape are painted fill first: only one of the two can be merged.
            let one = shape.fill.is_none() || shape.pen.is_none();
            if opaque && one && last.fill == shape.fill && last.pen == shape.pen && last.clip == shape.clip {
                last.contours.append(&mut shape.contours);
                return;
            }
        }
        self.ops.push(Op::Shape(shape));
    }

    /// The width and height in units: pixels of the PNG at scale 1, user units of the SVG.
    pub fn size(&self) -> (u32, u32) {
        self.size
    }
}
