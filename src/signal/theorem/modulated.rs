//! The modulation theorem.

use crate::error::{Result, positive};
use crate::num::cos_pi;
use crate::signal::{FourierPair, Signal};
use crate::spectrum::Spectrum;

/// `f(x)·cos(2πν₀x)` ↔ `½F(ν − ν₀) + ½F(ν + ν₀)`: half the spectrum to either side.
///
/// ```
/// use nyquist::prelude::*;
/// let burst = Modulated::new(5.0, Gaussian::new(1.0)?)?;
/// assert_eq!(burst.spectrum().density(5.0).re, 0.5);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Modulated<S> {
    carrier: f64,
    signal: S,
}

impl<S> Modulated<S> {
    /// The signal times a cosine of frequency `carrier`.
    ///
    /// # Errors
    /// A frequency that is not positive and finite.
    pub fn new(carrier: f64, signal: S) -> Result<Self> {
        Ok(Self { carrier: positive("a carrier frequency", carrier)?, signal })
    }
}

impl<S: Signal> Signal for Modulated<S> {
    fn at(&self, x: f64) -> f64 {
        self.signal.at(x) * cos_pi(2.0 * self.carrier * x)
    }
}

impl<S: FourierPair> FourierPair for Modulated<S> {
    fn spectrum(&self) -> Spectrum {
        let half = self.signal.spectrum().scaled(0.5);
        half.translated(self.carrier).plus(&half.translated(-self.carrier))
    }
}
