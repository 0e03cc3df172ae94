//! Linearity, the one half.

use crate::error::{Result, finite};
use crate::signal::{Differentiable, FourierPair, Signal};
use crate::spectrum::Spectrum;

/// `c·f(x)` ↔ `c·F(ν)`.
///
/// ```
/// use nyquist::prelude::*;
/// let louder = Scaled::new(3.0, Gaussian::new(1.0)?)?;
/// assert_eq!((louder.at(0.0), louder.spectrum().density(0.0).re), (3.0, 3.0));
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scaled<S> {
    gain: f64,
    signal: S,
}

impl<S> Scaled<S> {
    /// `gain·signal`.
    ///
    /// # Errors
    /// A gain that is not finite.
    pub fn new(gain: f64, signal: S) -> Result<Self> {
        Ok(Self { gain: finite("a gain", gain)?, signal })
    }
}

impl<S: Signal> Signal for Scaled<S> {
    fn at(&self, x: f64) -> f64 {
        self.gain * self.signal.at(x)
    }
}

impl<S: Differentiable> Differentiable for Scaled<S> {
    fn slope(&self, x: f64) -> f64 {
        self.gain * self.signal.slope(x)
    }
}

impl<S: FourierPair> FourierPair for Scaled<S> {
    fn spectrum(&self) -> Spectrum {
        self.signal.spectrum().scaled(self.gain)
    }
}
