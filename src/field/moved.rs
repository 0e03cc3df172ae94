//! A field somewhere else.

use crate::error::{Result, finite};
use crate::field::spectrum::PlaneSpectrum;
use crate::field::{ExactMean, Field, FourierField};

/// `f(x − x₀, y − y₀)` ↔ `e^{−2πi(ux₀ + vy₀)}·F(u, v)`: a shift turns the phases. Exact means stay exact.
///
/// ```
/// use nyquist::prelude::*;
/// let moved = Moved::new([10.0, 0.0], Disc::new([0.0, 0.0], 1.0)?)?;
/// assert_eq!(moved.at(10.0, 0.0), 1.0);
/// assert!((moved.mean([9.0, 10.0], [-1.0, 1.0]) - std::f64::consts::FRAC_PI_4).abs() < 1e-15);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Moved<F> {
    by: [f64; 2],
    field: F,
}

impl<F> Moved<F> {
    /// The field moved by `by`.
    ///
    /// # Errors
    /// A shift that is not finite.
    pub fn new(by: [f64; 2], field: F) -> Result<Self> {
        for part in by {
            finite("a shift", part)?;
        }
        Ok(Self { by, field })
    }
}

impl<F: Field> Field for Moved<F> {
    fn at(&self, x: f64, y: f64) -> f64 {
        self.field.at(x - self.by[0], y - self.by[1])
    }
}

impl<F: ExactMean> ExactMean for Moved<F> {
    fn mean(&self, x: [f64; 2], y: [f64; 2]) -> f64 {
        self.field.mean(x.map(|x| x - self.by[0]), y.map(|y| y - self.by[1]))
    }
}

impl<F: FourierField> FourierField for Moved<F> {
    fn spectrum(&self) -> PlaneSpectrum {
        self.field.spectrum().turned(self.by)
    }
}
