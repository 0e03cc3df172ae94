//! A disc.

use crate::error::{Result, finite, positive};
use crate::field::half_plane::step;
use crate::field::{ExactMean, Field, rectangle};

/// One inside a circle, zero outside, ½ on it.
///
/// Its mean is the exact area of circle and rectangle in common: between the places where the circle crosses a side the
/// part is a trapezoid with a circular segment on top, and nothing is subtracted from nearly the same. What rounding
/// leaves is about `16ε·(1 + r/Δ)`.
///
/// ```
/// use nyquist::prelude::*;
/// let dot = Disc::new([0.0, 0.0], 0.3)?; // smaller than a pixel
/// let whole = dot.mean([-0.5, 0.5], [-0.5, 0.5]);
/// assert!((whole - std::f64::consts::PI * 0.09).abs() < 1e-15); // also the chance that one sample hits it
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Disc {
    center: [f64; 2],
    radius: f64,
}

impl Disc {
    /// The disc around `center`.
    ///
    /// # Errors
    /// A centre that is not finite, a radius that is not positive and finite.
    pub fn new(center: [f64; 2], radius: f64) -> Result<Self> {
        for part in center {
            finite("the centre of a disc", part)?;
        }
        Ok(Self { center, radius: positive("the radius of a disc", radius)? })
    }

    /// Half the chord at the distance `x` from the centre.
    fn half_chord(&self, x: f64) -> f64 {
        ((self.radius - x) * (self.radius + x)).max(0.0).sqrt()
    }

    /// The area between the upper arc from `a` to `b` and its chord.
    fn segment(&self, a: f64, b: f64) -> f64 {
        let chord = (b - a).hypot(self.half_chord(b) - self.half_chord(a));
        let angle = 2.0 * (0.5 * chord / self.radius).min(1.0).asin();
        0.5 * self.radius * self.radius * less_its_sine(angle)
    }

    /// The common area with a rectangle given from the centre.
    fn common(&self, [x0, x1]: [f64; 2], [y0, y1]: [f64; 2]) -> f64 {
        let r = self.radius;
        let (left, right) = (x0.max(-r), x1.min(r));
        if left >= right || y0 >= r || y1 <= -r {
            return 0.0;
        }
        let crossings = [y0, y1].map(|y| self.half_chord(y));
        let mut breaks = vec![left, right];
        for c in crossings {
            breaks.extend([-c, c].into_iter().filter(|b| left < *b && *b < right));
        }
        breaks.sort_by(f64::total_cmp);
        let piece = |a: f64, b: f64| {
            let middle = self.half_chord(0.5 * (a + b));
            let (top_is_arc, bottom_is_arc) = (middle < y1, -middle > y0);
            if middle <= y0 || -middle >= y1 {
                return 0.0;
            }
            let side = |is_arc: bool, x: f64, straight: f64| if is_arc { self.half_chord(x) } else { straight };
            // heights above and below the diameter: the lower arc is the upper one, mirrored
            let height = |x: f64| side(top_is_arc, x, y1) + side(bottom_is_arc, x, -y0);
            let arcs = f64::from(u8::from(top_is_arc) + u8::from(bottom_is_arc));
            let segments = if arcs > 0.0 { arcs * self.segment(a, b) } else { 0.0 };
            0.5 * (b - a) * (height(a) + height(b)) + segments
        };
        breaks.windows(2).map(|w| piece(w[0], w[1])).sum()
    }
}

/// `φ − sin φ`, by its series where the difference would cancel.
fn less_its_sine(angle: f64) -> f64 {
    if angle > 1.0 {
        return angle - angle.sin();
    }
    // φ³/3! − φ⁵/5! + …; the tenth term is below ε at 1
    let (mut term, mut sum) = (angle.powi(3) / 6.0, 0.0);
    for k in 2..12 {
        sum += term;
        let k = f64::from(2 * k);
        term *= -angle * angle / (k * (k + 1.0));
    }
    sum
}

impl Field for Disc {
    fn at(&self, x: f64, y: f64) -> f64 {
        step((x - self.center[0]).hypot(y - self.center[1]) - self.radius)
    }
}

impl ExactMean for Disc {
    fn mean(&self, x: [f64; 2], y: [f64; 2]) -> f64 {
        let [x, y] = match rectangle(x, y) {
            Ok(sides) => sides,
            Err([x, y]) => return self.at(x, y),
        };
        let area = self.common(x.map(|x| x - self.center[0]), y.map(|y| y - self.center[1]));
        (area / ((x[1] - x[0]) * (y[1] - y[0]))).min(1.0)
    }
}
