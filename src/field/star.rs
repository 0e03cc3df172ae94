//! The Siemens star.

use crate::error::{Error, Result, finite};
use crate::field::clip::{Side, coverage};
use crate::field::{ExactMean, Field, rectangle};
use crate::num::{cos_pi, sin_pi};
use std::f64::consts::PI;

/// `n` white spokes of the angle `π/n` around a centre, black between, ½ on the edges: a pattern whose local frequency
/// `n/(2πr)` grows without a bound towards the middle, where every sampling fails.
///
/// One where `cos(nθ) > 0`, so that the first spoke lies along the x axis. Its mean is exact: each spoke is a wedge, and
/// the rectangle is clipped by its two edges.
///
/// ```
/// use nyquist::prelude::*;
/// let star = SiemensStar::new([0.0, 0.0], 18)?;
/// assert_eq!((star.at(1.0, 0.0), star.at(0.0, 0.0)), (1.0, 0.5));
/// assert!((star.mean([-1.0, 1.0], [-1.0, 1.0]) - 0.5).abs() < 1e-14); // half of it is white
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct SiemensStar {
    center: [f64; 2],
    spokes: usize,
    wedges: Vec<[Side; 2]>,
}

impl SiemensStar {
    /// The most spokes a star may have.
    pub const MOST: usize = 4096;

    /// A star with that many white spokes.
    ///
    /// # Errors
    /// A centre that is not finite; no spokes, or more than [`SiemensStar::MOST`].
    pub fn new(center: [f64; 2], spokes: usize) -> Result<Self> {
        for part in center {
            finite("the centre of a star", part)?;
        }
        if spokes == 0 {
            return Err(Error::TooFew { what: "spokes of a star", least: 1, got: 0 });
        }
        if spokes > Self::MOST {
            let (value, most) = (spokes as f64, Self::MOST as f64);
            return Err(Error::Overflow { what: "the number of a star's spokes", value, most });
        }
        let wedge = |k: usize| {
            // half turns: the spoke reaches from (2k − ½)/n to (2k + ½)/n
            let edge = |quarter: f64| (2.0 * k as f64 + quarter) / spokes as f64;
            let (first, last) = (edge(-0.5), edge(0.5));
            [
                Side { normal: [sin_pi(first), -cos_pi(first)], offset: 0.0 },
                Side { normal: [-sin_pi(last), cos_pi(last)], offset: 0.0 },
            ]
        };
        Ok(Self { center, spokes, wedges: (0..spokes).map(wedge).collect() })
    }
}

impl Field for SiemensStar {
    fn at(&self, x: f64, y: f64) -> f64 {
        let (x, y) = (x - self.center[0], y - self.center[1]);
        let wave = cos_pi(self.spokes as f64 * y.atan2(x) / PI);
        if (x == 0.0 && y == 0.0) || wave == 0.0 {
            0.5
        } else if wave > 0.0 {
            1.0
        } else {
            0.0
        }
    }
}

impl ExactMean for SiemensStar {
    fn mean(&self, x: [f64; 2], y: [f64; 2]) -> f64 {
        let [x, y] = match rectangle(x, y) {
            Ok(sides) => sides,
            Err([x, y]) => return self.at(x, y),
        };
        let local = [x.map(|x| x - self.center[0]), y.map(|y| y - self.center[1])];
        self.wedges.iter().map(|wedge| coverage(local, wedge)).sum()
    }
}
