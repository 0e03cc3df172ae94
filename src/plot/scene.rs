//! The picture as a list of things to paint: drawn once, written in every format.
//!
//! All coordinates are whole hundredths of a unit (a pixel at scale 1), x rightwards, y downwards, so that every writer
//! starts from the same numbers and no format can round differently from another.

use super::palette::Rgb;
use super::typeset::{EM, Line, Segment, outline};
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
    pub pixels: Pixels,
    pub clip: Option<usize>,
}

/// What cells look like, row by row from the top.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Pixels {
    /// Indices of a table.
    Toned { tones: Vec<u8>, table: Rc<[[u8; 3]; 256]> },
    /// Colours of their own.
    Colored(Vec<[u8; 3]>),
}

impl Pixels {
    /// The cells as bytes, and how many a cell has.
    pub(super) fn bytes(&self) -> (&[u8], usize) {
        match self {
            Self::Toned { tones, .. } => (tones, 1),
            Self::Colored(colors) => (colors.as_flattened(), 3),
        }
    }

    /// The colours there are, and which of them a cell has.
    pub(super) fn colors(&self) -> (&[[u8; 3]], impl Fn(usize) -> usize) {
        let (colors, tones) = match self {
            Self::Toned { tones, table } => (&table[..], Some(tones)),
            Self::Colored(colors) => (&colors[..], None),
        };
        (colors, move |cell| tones.map_or(cell, |tones| usize::from(tones[cell])))
    }
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

/// A line of text as it stands in the picture.
#[derive(Debug, Clone, PartialEq)]
pub struct Label {
    /// What it says, with its markup.
    pub text: String,
    /// The least rectangle around its ink, `[left, top, right, bottom]` in units.
    pub ink: [f64; 4],
    /// How large its letters are, in units.
    pub size: f64,
    /// Whether it is a note among the data; all others stand in the margins or in legends.
    pub note: bool,
    /// Whether one of its letters is in none of the fonts.
    pub incomplete: bool,
}

impl Label {
    /// Whether the ink of two labels overlaps.
    pub fn overlaps(&self, other: &Self) -> bool {
        let (a, b) = (self.ink, other.ink);
        a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3]
    }
}

impl Scene {
    /// All text of the picture: what a test looks at to know that nothing is clipped, collides or lacks a letter.
    pub fn labels(&self) -> Vec<Label> {
        let words = self.ops.iter().filter_map(|op| if let Op::Words(words) = op { Some(words) } else { None });
        words.filter_map(Words::label).collect()
    }
}

impl Words {
    fn label(&self) -> Option<Label> {
        let em = f64::from(self.size) / f64::from(EM) / FINE;
        let mut ink = [f64::INFINITY, f64::INFINITY, f64::NEG_INFINITY, f64::NEG_INFINITY];
        for glyph in &self.line.glyphs {
            for segment in outline(glyph.face, glyph.id) {
                let (Segment::Move(x, y) | Segment::Line(x, y) | Segment::Curve(_, _, x, y)) = segment else {
                    continue;
                };
                let on = |at: i32, v: i32| (f64::from(at) + f64::from(glyph.size) / 1000.0 * f64::from(v)) * em;
                let (along, up) = (on(glyph.x, x), on(glyph.y, y));
                let (dx, dy) = if self.upright { (-up, -along) } else { (along, -up) };
                let (x, y) = (f64::from(self.at.0) / FINE + dx, f64::from(self.at.1) / FINE + dy);
                ink = [ink[0].min(x), ink[1].min(y), ink[2].max(x), ink[3].max(y)];
            }
        }
        let incomplete = self.line.glyphs.iter().any(|g| g.id == 0);
        let seen = ink[0] <= ink[2];
        let (text, size) = (self.line.text.clone(), f64::from(self.size) / FINE);
        seen.then(|| Label { text, ink, size, note: self.halo.is_some(), incomplete })
    }
}
