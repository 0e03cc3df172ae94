//! Convex polygons.

use crate::error::{Error, Result, positive};
use crate::field::clip::{Side, area, coverage};
use crate::field::{ExactMean, Field, rectangle};

/// One inside a convex polygon, zero outside, ½ on its boundary.
///
/// Its mean is the exact coverage (clipping by one side after another): prefiltering *is* possible for polygons,
/// contrary to the slide that rules it out for all of image synthesis (E14).
///
/// ```
/// use nyquist::prelude::*;
/// let triangle = ConvexPolygon::new(&[[0.0, 0.0], [2.0, 0.0], [0.0, 2.0]])?;
/// assert_eq!(triangle.mean([0.0, 2.0], [0.0, 2.0]), 0.5);
/// assert_eq!(triangle.mean([1.0, 2.0], [0.0, 1.0]), 0.5);
/// let dart = ConvexPolygon::new(&[[0.0, 0.0], [4.0, 0.0], [1.0, 1.0], [0.0, 4.0]]);
/// assert!(matches!(dart, Err(Error::Unsupported(_)))); // dented
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct ConvexPolygon {
    vertices: Vec<[f64; 2]>,
    sides: Vec<Side>,
}

impl ConvexPolygon {
    /// The polygon with these vertices, in either direction.
    ///
    /// # Errors
    /// Fewer than three vertices, vertices that are not finite, two neighbours at one place, no area, a dent, or more
    /// than one turn around (a star).
    pub fn new(vertices: &[[f64; 2]]) -> Result<Self> {
        let n = vertices.len();
        if n < 3 {
            return Err(Error::TooFew { what: "vertices of a polygon", least: 3, got: n });
        }
        if let Some(index) = vertices.iter().position(|p| !p[0].is_finite() || !p[1].is_finite()) {
            let value = if vertices[index][0].is_finite() { vertices[index][1] } else { vertices[index][0] };
            return Err(Error::NotFiniteAt { what: "the vertices of a polygon", index, value });
        }
        let mut vertices = vertices.to_vec();
        let signed = area(&vertices);
        positive("the area of a polygon", signed.abs())?;
        if signed < 0.0 {
            vertices.reverse();
        }
        let mut turned = 0.0;
        let mut sides = Vec::with_capacity(n);
        for i in 0..n {
            let [a, b, c] = [vertices[i], vertices[(i + 1) % n], vertices[(i + 2) % n]];
            let ([ux, uy], [vx, vy]) = ([b[0] - a[0], b[1] - a[1]], [c[0] - b[0], c[1] - b[1]]);
            let length = positive("the length of a polygon's side", ux.hypot(uy))?;
            let (cross, dot) = (ux * vy - uy * vx, ux * vx + uy * vy);
            // a corner of 180° may be rounded to either side of straight
            let straight = 8.0 * f64::EPSILON * (ux.abs() + uy.abs()) * (vx.abs() + vy.abs());
            if cross < -straight || (cross <= straight && dot < 0.0) {
                return Err(Error::Unsupported("a polygon that is not convex"));
            }
            turned += cross.atan2(dot);
            let normal = [uy / length, -ux / length];
            sides.push(Side { normal, offset: normal[0] * a[0] + normal[1] * a[1] });
        }
        // the turns of a convex polygon add up to one; those of a star to more
        if turned > 3.0 * std::f64::consts::PI {
            return Err(Error::Unsupported("a polygon that winds around more than once"));
        }
        Ok(Self { vertices, sides })
    }

    /// The vertices, turning from the x axis towards the y axis.
    pub fn vertices(&self) -> &[[f64; 2]] {
        &self.vertices
    }

    /// The area inside.
    pub fn area(&self) -> f64 {
        area(&self.vertices)
    }
}

impl Field for ConvexPolygon {
    fn at(&self, x: f64, y: f64) -> f64 {
        let farthest = self.sides.iter().map(|side| side.outside([x, y])).fold(f64::NEG_INFINITY, f64::max);
        super::half_plane::step(farthest)
    }
}

impl ExactMean for ConvexPolygon {
    fn mean(&self, x: [f64; 2], y: [f64; 2]) -> f64 {
        match rectangle(x, y) {
            Ok(sides) => coverage(sides, &self.sides),
            Err([x, y]) => self.at(x, y),
        }
    }
}
