//! A field, brighter or darker.

use crate::error::{Result, finite};
use crate::field::spectrum::PlaneSpectrum;
use crate::field::{ExactMean, Field, FourierField};

/// `gain·f` ↔ `gain·F`. Exact means stay exact.
///
/// ```
/// use nyquist::prelude::*;
/// // a grating between black and white: ½ + ½cos
/// let wave = Added(Flat::new(0.5)?, Amplified::new(0.5, Grating::new([0.125, 0.0])?)?);
/// assert_eq!([wave.at(0.0, 0.0), wave.at(2.0, 0.0), wave.at(4.0, 0.0)], [1.0, 0.5, 0.0]);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Amplified<F> {
    gain: f64,
    field: F,
}

impl<F> Amplified<F> {
    /// `gain` times the field.
    ///
    /// # Errors
    /// A gain that is not finite.
    pub fn new(gain: f64, field: F) -> Result<Self> {
        Ok(Self { gain: finite("a gain", gain)?, field })
    }
}

impl<F: Field> Field for Amplified<F> {
    fn at(&self, x: f64, y: f64) -> f64 {
        self.gain * self.field.at(x, y)
    }
}

impl<F: ExactMean> ExactMean for Amplified<F> {
    fn mean(&self, x: [f64; 2], y: [f64; 2]) -> f64 {
        self.gain * self.field.mean(x, y)
    }
}

impl<F: FourierField> FourierField for Amplified<F> {
    fn spectrum(&self) -> PlaneSpectrum {
        let gain = self.gain;
        self.field.spectrum().times(move |_, _| gain.into())
    }
}
