//! The similarity theorem.

use crate::error::{Result, positive};
use crate::signal::{Differentiable, FourierPair, Signal};
use crate::spectrum::Spectrum;

/// `f(x/c)` ↔ `c·F(cν)`, `c > 0`: what is wide in space is narrow and tall in frequency. Lines move and keep their
/// weight, since `c·δ(cν − ν₀) = δ(ν − ν₀/c)`.
///
/// ```
/// use nyquist::prelude::*;
/// let slow = Stretched::new(4.0, Cosine::new(2.0)?)?;
/// assert_eq!(slow.spectrum().lines()[1], Impulse::new(0.5, 0.5));
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stretched<S> {
    by: f64,
    signal: S,
}

impl<S> Stretched<S> {
    /// The signal made `by` times as wide.
    ///
    /// # Errors
    /// A factor that is not positive and finite.
    pub fn new(by: f64, signal: S) -> Result<Self> {
        Ok(Self { by: positive("a stretch", by)?, signal })
    }
}

impl<S: Signal> Signal for Stretched<S> {
    fn at(&self, x: f64) -> f64 {
        self.signal.at(x / self.by)
    }
}

impl<S: Differentiable> Differentiable for Stretched<S> {
    fn slope(&self, x: f64) -> f64 {
        self.signal.slope(x / self.by) / self.by
    }
}

impl<S: FourierPair> FourierPair for Stretched<S> {
    fn spectrum(&self) -> Spectrum {
        self.signal.spectrum().stretched(self.by)
    }
}
