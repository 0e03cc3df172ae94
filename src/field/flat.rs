//! The same everywhere.

use crate::error::{Result, finite};
use crate::field::spectrum::{PlaneImpulse, PlaneSpectrum};
use crate::field::{ExactMean, Field, FourierField};
use num_complex::Complex;

/// `f(x, y) = value` ↔ `value·δ(u)·δ(v)`: the first of the lecture's picture-and-spectrum pairs.
///
/// ```
/// use nyquist::prelude::*;
/// let grey = Flat::new(0.5)?;
/// assert_eq!((grey.at(3.0, 4.0), grey.mean([0.0, 9.0], [0.0, 1.0])), (0.5, 0.5));
/// assert_eq!(grey.spectrum().lines(), [PlaneImpulse::new([0.0, 0.0], 0.5)]);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Flat {
    value: f64,
}

impl Flat {
    /// `value` everywhere.
    ///
    /// # Errors
    /// A value that is not finite.
    pub fn new(value: f64) -> Result<Self> {
        Ok(Self { value: finite("the value of a flat field", value)? })
    }
}

impl Field for Flat {
    fn at(&self, _: f64, _: f64) -> f64 {
        self.value
    }
}

impl ExactMean for Flat {
    fn mean(&self, _: [f64; 2], _: [f64; 2]) -> f64 {
        self.value
    }
}

impl FourierField for Flat {
    fn spectrum(&self) -> PlaneSpectrum {
        PlaneSpectrum::build(None, vec![PlaneImpulse { at: [0.0, 0.0], weight: Complex::from(self.value) }])
    }
}
