//! The shift theorem.

use crate::error::{Result, finite};
use crate::num::{cos_pi, sin_pi};
use crate::signal::{Differentiable, FourierPair, Signal};
use crate::spectrum::Spectrum;
use num_complex::Complex;

/// `f(x − x₀)` ↔ `e^{−2πiνx₀}·F(ν)`: a shift turns the phases and leaves the magnitudes.
///
/// ```
/// use nyquist::prelude::*;
/// let late = Shifted::new(0.25, Gaussian::new(1.0)?)?;
/// let turned = late.spectrum().density(1.0);
/// assert_eq!((late.at(0.25), turned.re), (1.0, 0.0)); // a quarter of a period: −i
/// assert!(turned.im < 0.0);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shifted<S> {
    by: f64,
    signal: S,
}

impl<S> Shifted<S> {
    /// The signal moved to the right by `by`.
    ///
    /// # Errors
    /// A shift that is not finite.
    pub fn new(by: f64, signal: S) -> Result<Self> {
        Ok(Self { by: finite("a shift", by)?, signal })
    }
}

impl<S: Signal> Signal for Shifted<S> {
    fn at(&self, x: f64) -> f64 {
        self.signal.at(x - self.by)
    }
}

impl<S: Differentiable> Differentiable for Shifted<S> {
    fn slope(&self, x: f64) -> f64 {
        self.signal.slope(x - self.by)
    }
}

impl<S: FourierPair> FourierPair for Shifted<S> {
    fn spectrum(&self) -> Spectrum {
        let by = self.by;
        let turn = move |nu: f64| Complex::new(cos_pi(2.0 * nu * by), -sin_pi(2.0 * nu * by));
        self.signal.spectrum().times(turn)
    }
}
