//! Silhouettes: polygons of any shape.

use crate::error::{Error, Result, positive};
use crate::field::clip::{Side, area, clipped};
use crate::field::{ExactMean, Field, rectangle};

/// One inside a closed outline of straight pieces, zero outside, ½ on it. It may be dented, but must not cross itself:
/// that is not checked.
///
/// Its mean is the exact coverage: the outline is clipped by the four sides of the rectangle (Sutherland and Hodgman 1974;
/// where it falls apart, the pieces stay joined along a side, by bridges without an area). What rounding leaves is about
/// `4nε·(1 + extent/Δ)` for `n` vertices. Time in proportion to `n`, for a value and for a mean.
///
/// ```
/// use nyquist::field::outline::Outline;
/// use nyquist::prelude::*;
/// // an L: one half and a quarter of the square
/// let corner = [[0.0, 0.0], [1.0, 0.0], [1.0, 0.5], [0.5, 0.5], [0.5, 1.0], [0.0, 1.0]];
/// let l = Outline::new(&corner)?;
/// assert_eq!((l.at(0.25, 0.75), l.at(0.75, 0.75), l.at(0.5, 0.75)), (1.0, 0.0, 0.5));
/// assert_eq!(l.mean([0.0, 1.0], [0.0, 1.0]), 0.75);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Outline {
    vertices: Vec<[f64; 2]>,
}

impl Outline {
    /// The outline through these vertices, in either direction, closed from the last to the first.
    ///
    /// # Errors
    /// Fewer than three vertices, vertices that are not finite, no area.
    pub fn new(vertices: &[[f64; 2]]) -> Result<Self> {
        if vertices.len() < 3 {
            return Err(Error::TooFew { what: "vertices of an outline", least: 3, got: vertices.len() });
        }
        crate::error::all_finite("coordinates of an outline", vertices.as_flattened())?;
        let mut vertices = vertices.to_vec();
        let signed = area(&vertices);
        positive("the area of an outline", signed.abs())?;
        if signed < 0.0 {
            vertices.reverse();
        }
        Ok(Self { vertices })
    }

    /// The vertices, turning from the x axis towards the y axis.
    pub fn vertices(&self) -> &[[f64; 2]] {
        &self.vertices
    }

    /// The area inside.
    pub fn area(&self) -> f64 {
        area(&self.vertices)
    }

    /// How long it is.
    pub fn length(&self) -> f64 {
        self.sides().map(|[a, b]| (b[0] - a[0]).hypot(b[1] - a[1])).sum()
    }

    /// From each vertex to the next.
    fn sides(&self) -> impl Iterator<Item = [[f64; 2]; 2]> + '_ {
        let next = self.vertices.iter().cycle().skip(1);
        self.vertices.iter().zip(next).map(|(a, b)| [*a, *b])
    }
}

impl Field for Outline {
    fn at(&self, x: f64, y: f64) -> f64 {
        let mut inside = false;
        for [a, b] in self.sides() {
            let across = (b[0] - a[0]) * (y - a[1]) - (x - a[0]) * (b[1] - a[1]);
            let within = |p: f64, q: f64, v: f64| p.min(q) <= v && v <= p.max(q);
            if across == 0.0 && within(a[0], b[0], x) && within(a[1], b[1], y) {
                return 0.5;
            }
            // a ray to the right crosses the side
            if (a[1] > y) != (b[1] > y) && (across > 0.0) == (b[1] > a[1]) {
                inside = !inside;
            }
        }
        if inside { 1.0 } else { 0.0 }
    }
}

impl ExactMean for Outline {
    fn mean(&self, x: [f64; 2], y: [f64; 2]) -> f64 {
        let [[x0, x1], [y0, y1]] = match rectangle(x, y) {
            Ok(sides) => sides,
            Err([x, y]) => return self.at(x, y),
        };
        let (cx, cy) = (0.5 * (x0 + x1), 0.5 * (y0 + y1));
        let (w, h) = (0.5 * (x1 - x0), 0.5 * (y1 - y0));
        let mut part: Vec<[f64; 2]> = self.vertices.iter().map(|[x, y]| [x - cx, y - cy]).collect();
        for (normal, offset) in [([-1.0, 0.0], w), ([1.0, 0.0], w), ([0.0, -1.0], h), ([0.0, 1.0], h)] {
            part = clipped(&part, Side { normal, offset });
            if part.len() < 3 {
                return 0.0;
            }
        }
        (area(&part) / (4.0 * w * h)).clamp(0.0, 1.0)
    }
}
