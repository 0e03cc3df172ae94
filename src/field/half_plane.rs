//! A straight edge.

use crate::error::{Result, finite, positive};
use crate::field::clip::{Side, coverage};
use crate::field::{ExactMean, Field, rectangle};

/// One on one side of a straight line, zero on the other, ½ on it: the edge that staircases are made of.
///
/// Its mean is the exact coverage: the rectangle is clipped by the line.
///
/// ```
/// use nyquist::prelude::*;
/// let edge = HalfPlane::through([0.0, 0.25], 0.0)?; // everything above y = ¼ (towards smaller y)
/// assert_eq!([edge.at(7.0, 0.0), edge.at(7.0, 0.25), edge.at(7.0, 1.0)], [1.0, 0.5, 0.0]);
/// assert_eq!(edge.mean([7.0, 8.0], [0.0, 1.0]), 0.25);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HalfPlane {
    side: Side,
}

impl HalfPlane {
    /// One where `normal·(x, y) < offset`.
    ///
    /// # Errors
    /// A normal or an offset that is not finite, a normal of length zero.
    pub fn new(normal: [f64; 2], offset: f64) -> Result<Self> {
        for part in normal {
            finite("the normal of a half-plane", part)?;
        }
        finite("the offset of a half-plane", offset)?;
        let length = positive("the length of a half-plane's normal", normal[0].hypot(normal[1]))?;
        let offset = finite("the offset of a half-plane", offset / length)?;
        Ok(Self { side: Side { normal: normal.map(|part| part / length), offset } })
    }

    /// The edge through `point` that runs in the direction `angle` (radians, from the x axis towards the y axis); one on
    /// its right hand side, seen along that direction with the y axis pointing up.
    ///
    /// # Errors
    /// Numbers that are not finite.
    pub fn through(point: [f64; 2], angle: f64) -> Result<Self> {
        finite("the angle of an edge", angle)?;
        let normal = [-angle.sin(), angle.cos()];
        Self::new(normal, normal[0] * point[0] + normal[1] * point[1])
    }
}

impl Field for HalfPlane {
    fn at(&self, x: f64, y: f64) -> f64 {
        step(self.side.outside([x, y]))
    }
}

/// One below zero, ½ at zero, zero above.
pub(super) fn step(outside: f64) -> f64 {
    if outside < 0.0 {
        1.0
    } else if outside == 0.0 {
        0.5
    } else {
        0.0
    }
}

impl ExactMean for HalfPlane {
    fn mean(&self, x: [f64; 2], y: [f64; 2]) -> f64 {
        match rectangle(x, y) {
            Ok(sides) => coverage(sides, &[self.side]),
            Err([x, y]) => self.at(x, y),
        }
    }
}
