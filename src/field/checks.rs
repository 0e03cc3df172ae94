//! A checkerboard, seen from straight above.

use crate::error::{Result, positive};
use crate::field::{ExactMean, Field, rectangle};

/// Squares of the side `size`, black (0) where `⌊x/size⌋ + ⌊y/size⌋` is even and white (1) where it is odd.
///
/// A square owns its two lower edges, as half-open intervals do: a sample is black or white and never grey. (Other shapes
/// are ½ on their edges. Here it would be seen: in the lecture's perspective one sample in sixty hits an edge exactly, and
/// the error of point sampling would come out a seventh too small.)
///
/// `f = ½ − ½q(x)·q(y)` with the square wave `q`, so that the mean is a product of two means of square waves, each a
/// difference of their primitive, the triangle wave `Λ`: exact to `4ε·(size/Δ)`.
///
/// ```
/// use nyquist::prelude::*;
/// let checks = Checks::new(1.0)?;
/// assert_eq!([checks.at(0.5, 0.5), checks.at(1.5, 0.5), checks.at(1.0, 0.5)], [0.0, 1.0, 1.0]);
/// assert_eq!(checks.mean([0.5, 1.5], [0.0, 0.5]), 0.5);
/// assert_eq!(checks.mean([0.0, 2.0], [7.0, 7.5]), 0.5);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Checks {
    size: f64,
}

impl Checks {
    /// Squares of that side.
    ///
    /// # Errors
    /// A size that is not positive and finite.
    pub fn new(size: f64) -> Result<Self> {
        Ok(Self { size: positive("the size of a check", size)? })
    }

    /// The side of a square.
    pub fn size(&self) -> f64 {
        self.size
    }
}

/// The square wave of period 2: +1 on [0, 1), −1 on [1, 2).
pub(super) fn square_wave(t: f64) -> f64 {
    if period(t) < 1.0 { 1.0 } else { -1.0 }
}

/// Its primitive, the triangle wave: `t` on [0, 1], `2 − t` on [1, 2], of period 2.
pub(super) fn triangle_wave(t: f64) -> f64 {
    let rest = period(t);
    rest.min(2.0 - rest)
}

/// `t` modulo 2. Halving and doubling are exact, and so is the difference (Sterbenz) but for `t < 0` near zero.
fn period(t: f64) -> f64 {
    t - 2.0 * (0.5 * t).floor()
}

impl Field for Checks {
    fn at(&self, x: f64, y: f64) -> f64 {
        0.5 - 0.5 * square_wave(x / self.size) * square_wave(y / self.size)
    }
}

impl ExactMean for Checks {
    fn mean(&self, x: [f64; 2], y: [f64; 2]) -> f64 {
        let mean = |[a, b]: [f64; 2]| (triangle_wave(b) - triangle_wave(a)) / (b - a);
        match rectangle(x, y) {
            Ok(sides) => {
                let [x, y] = sides.map(|ends| ends.map(|t| t / self.size));
                0.5 - 0.5 * mean(x) * mean(y)
            }
            Err([x, y]) => self.at(x, y),
        }
    }
}
