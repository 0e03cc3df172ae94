//! A thin line: what falls between samples.

use crate::error::{Result, finite, positive};
use crate::field::polygon::ConvexPolygon;
use crate::field::{ExactMean, Field};

/// One on a straight line from one point to another that is `width` wide, zero elsewhere; its ends are cut square.
///
/// Thinner than the distance of the samples, it breaks into pieces or is missed altogether; its mean is still exact
/// («маленькие объекты» of slide «Проблемы сэмплирования в компьютерной графике»).
///
/// ```
/// use nyquist::prelude::*;
/// let wire = ThinLine::new([0.0, 0.5], [10.0, 0.5], 0.1)?;
/// assert_eq!(wire.at(5.0, 0.0), 0.0); // a sample misses it
/// assert!((wire.mean([4.0, 5.0], [0.0, 1.0]) - 0.1).abs() < 1e-15); // a pixel does not
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct ThinLine {
    outline: ConvexPolygon,
}

impl ThinLine {
    /// The line between two points.
    ///
    /// # Errors
    /// Points that are not finite or coincide, a width that is not positive and finite.
    pub fn new(from: [f64; 2], to: [f64; 2], width: f64) -> Result<Self> {
        for part in [from[0], from[1], to[0], to[1]] {
            finite("an end of a line", part)?;
        }
        positive("the width of a line", width)?;
        let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
        let length = positive("the length of a line", dx.hypot(dy))?;
        let (nx, ny) = (-dy / length * 0.5 * width, dx / length * 0.5 * width);
        let corner = |p: [f64; 2], sign: f64| [p[0] + sign * nx, p[1] + sign * ny];
        let corners = [corner(from, -1.0), corner(to, -1.0), corner(to, 1.0), corner(from, 1.0)];
        Ok(Self { outline: ConvexPolygon::new(&corners)? })
    }

    /// The rectangle that the line is.
    pub fn outline(&self) -> &ConvexPolygon {
        &self.outline
    }
}

impl Field for ThinLine {
    fn at(&self, x: f64, y: f64) -> f64 {
        self.outline.at(x, y)
    }
}

impl ExactMean for ThinLine {
    fn mean(&self, x: [f64; 2], y: [f64; 2]) -> f64 {
        self.outline.mean(x, y)
    }
}
