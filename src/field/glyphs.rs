//! Detail like text: strokes, straight and slanted.

use crate::error::{Result, finite, positive, unknown};
use crate::field::polygon::ConvexPolygon;
use crate::field::{ExactMean, Field};

/// A word in a plain stroke alphabet: one on the strokes, zero on the paper.
///
/// Every letter is a few convex pieces that touch and do not overlap, so that the mean, a sum of exact coverages, is
/// exact; where two pieces touch, their halves add up. `Ш` is among the letters: it is the comb.
///
/// ```
/// use nyquist::prelude::*;
/// let word = Glyphs::new("ШAV", [0.0, 0.0], 10.0)?;
/// assert_eq!((word.at(1.0, 5.0), word.at(2.5, 5.0)), (1.0, 0.0)); // the first tooth of the comb, and beside it
/// let ink = word.mean([0.0, word.width()], [0.0, 10.0]) * word.width() * 10.0;
/// assert!((ink - word.area()).abs() < 1e-12 * ink);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Glyphs {
    pieces: Vec<(ConvexPolygon, [[f64; 2]; 2])>,
    width: f64,
}

/// The letters there are, and a space.
pub const LETTERS: &str = "AEFHILTVЁШГП ";

/// The thickness of a stroke, in letter heights.
const STROKE: f64 = 0.15;
/// The width of a letter, and the distance from one to the next, in letter heights.
const WIDTH: f64 = 0.75;
const ADVANCE: f64 = 1.0;

impl Glyphs {
    /// `word` with its upper left corner (at the least `x` and `y`) at `origin`, `height` high; a letter takes as much
    /// room as it is high.
    ///
    /// # Errors
    /// A letter that is not among [`LETTERS`], an origin that is not finite, a height that is not positive and finite.
    pub fn new(word: &str, origin: [f64; 2], height: f64) -> Result<Self> {
        for part in origin {
            finite("the origin of a word", part)?;
        }
        positive("the height of a word", height)?;
        let mut pieces = Vec::new();
        for (i, letter) in word.chars().enumerate() {
            let left = i as f64 * ADVANCE;
            let place = |[x, y]: [f64; 2]| [origin[0] + height * (left + x), origin[1] + height * y];
            for outline in strokes(letter)? {
                let outline: Vec<[f64; 2]> = outline.into_iter().map(place).collect();
                let bounds = [0, 1].map(|axis| {
                    let ends = outline.iter().map(|p| p[axis]);
                    [ends.clone().fold(f64::INFINITY, f64::min), ends.fold(f64::NEG_INFINITY, f64::max)]
                });
                pieces.push((ConvexPolygon::new(&outline)?, bounds));
            }
        }
        Ok(Self { pieces, width: height * ADVANCE * word.chars().count() as f64 })
    }

    /// The width of the whole word.
    pub fn width(&self) -> f64 {
        self.width
    }

    /// The area of all strokes.
    pub fn area(&self) -> f64 {
        self.pieces.iter().map(|(piece, _)| piece.area()).sum()
    }

    /// The pieces that the strokes are made of.
    pub fn pieces(&self) -> impl ExactSizeIterator<Item = &ConvexPolygon> {
        self.pieces.iter().map(|(piece, _)| piece)
    }
}

type Outline = Vec<[f64; 2]>;

fn bar([x0, x1]: [f64; 2], [y0, y1]: [f64; 2]) -> Outline {
    vec![[x0, y0], [x1, y0], [x1, y1], [x0, y1]]
}

/// The pieces of a letter in a box of the height one, the first row at the top.
fn strokes(letter: char) -> Result<Vec<Outline>> {
    let (s, w) = (STROKE, WIDTH);
    let (middle, low) = ([0.5 - 0.5 * s, 0.5 + 0.5 * s], [1.0 - s, 1.0]);
    let stem = || bar([0.0, s], [0.0, 1.0]);
    let arm = |y: [f64; 2]| bar([s, w], y);
    // V: two slanted strokes that meet in the middle; the inner edges are parallel to the outer ones
    let v = |flip: bool| -> Vec<Outline> {
        let fork = (0.5 * w - s) / (0.5 * (w - s));
        let left = [[0.0, 0.0], [s, 0.0], [0.5 * w, fork], [0.5 * w, 1.0], [0.5 * (w - s), 1.0]];
        let mirrored = left.map(|[x, y]| [w - x, y]);
        let turn = |[x, y]: [f64; 2]| [x, if flip { 1.0 - y } else { y }];
        vec![left.map(turn).to_vec(), mirrored.map(turn).to_vec()]
    };
    let pieces = match letter {
        ' ' => vec![],
        'I' => vec![stem()],
        'L' => vec![stem(), arm(low)],
        'T' => vec![bar([0.0, w], [0.0, s]), bar([0.5 * (w - s), 0.5 * (w + s)], [s, 1.0])],
        'Г' => vec![stem(), arm([0.0, s])],
        'F' => vec![stem(), arm([0.0, s]), arm(middle)],
        'E' => vec![stem(), arm([0.0, s]), arm(middle), arm(low)],
        'H' => vec![stem(), bar([s, w - s], middle), bar([w - s, w], [0.0, 1.0])],
        'П' => vec![stem(), bar([s, w - s], [0.0, s]), bar([w - s, w], [0.0, 1.0])],
        'Ш' => {
            let tooth = |x: f64| bar([x, x + s], [0.0, 1.0 - s]);
            vec![tooth(0.0), tooth(0.5 * (w - s)), tooth(w - s), bar([0.0, w], low)]
        }
        'V' => v(false),
        'A' => {
            // the bar between the inner edges of an upside-down V, whose left one runs from (w/2, 1 − fork) to (s, 1)
            let fork = (0.5 * w - s) / (0.5 * (w - s));
            let inner = |y: f64| s + (0.5 * w - s) * (1.0 - y) / fork;
            let [top, bottom] = [0.62, 0.62 + s];
            let bridge =
                vec![[inner(top), top], [w - inner(top), top], [w - inner(bottom), bottom], [inner(bottom), bottom]];
            [v(true), vec![bridge]].concat()
        }
        'Ё' => {
            let mut pieces = strokes('E')?;
            // the dots stand above the line
            pieces.push(bar([0.1, 0.1 + s], [-0.3, -0.3 + s]));
            pieces.push(bar([w - 0.1 - s, w - 0.1], [-0.3, -0.3 + s]));
            pieces
        }
        other => {
            let known: Vec<String> = LETTERS.chars().map(String::from).collect();
            return Err(unknown("letter", &other.to_string(), known.iter().map(String::as_str)));
        }
    };
    Ok(pieces)
}

impl Field for Glyphs {
    fn at(&self, x: f64, y: f64) -> f64 {
        let inside = |[bx, by]: &[[f64; 2]; 2]| (bx[0]..=bx[1]).contains(&x) && (by[0]..=by[1]).contains(&y);
        let sum: f64 = self.pieces.iter().filter(|(_, bounds)| inside(bounds)).map(|(piece, _)| piece.at(x, y)).sum();
        // where more than two pieces meet at a corner their halves would add up to more
        sum.min(1.0)
    }
}

impl ExactMean for Glyphs {
    fn mean(&self, x: [f64; 2], y: [f64; 2]) -> f64 {
        let apart = |[a, b]: [f64; 2], [c, d]: [f64; 2]| a.max(b) < c || a.min(b) > d;
        let near = self.pieces.iter().filter(|(_, [bx, by])| !apart(x, *bx) && !apart(y, *by));
        near.map(|(piece, _)| piece.mean(x, y)).sum::<f64>().min(1.0)
    }
}
