//! Two gratings, one through the other.

use crate::error::Result;
use crate::field::grating::Grating;
use crate::field::spectrum::PlaneSpectrum;
use crate::field::{ExactMean, Field, FourierField};

/// The product of two gratings, `cos A·cos B = ½cos(A + B) + ½cos(A − B)`: four lines of weight ¼ at the sums and
/// differences of the frequencies. The lecture's `sin(2πx/32)·sin(2πy/16)` is one.
///
/// It is also how two screens make moiré: the line at the difference may be slow where both gratings are fine.
///
/// ```
/// use nyquist::prelude::*;
/// let screens = Plaid::new(Grating::new([10.0, 0.0])?, Grating::new([9.0, 0.0])?)?;
/// let slow = screens.spectrum().lines().iter().filter(|l| l.at[0].abs() == 1.0).count();
/// assert_eq!(slow, 2); // the beat, at ±1
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plaid {
    factors: [Grating; 2],
    sum: Grating,
    difference: Grating,
}

impl Plaid {
    /// `f·g`.
    ///
    /// # Errors
    /// Frequencies whose sum overflows.
    pub fn new(f: Grating, g: Grating) -> Result<Self> {
        let ([a, b], [c, d]) = (f.frequency(), g.frequency());
        let sum = Grating::with_phase([a + c, b + d], f.phase() + g.phase())?;
        let difference = Grating::with_phase([a - c, b - d], f.phase() - g.phase())?;
        Ok(Self { factors: [f, g], sum, difference })
    }
}

impl Field for Plaid {
    fn at(&self, x: f64, y: f64) -> f64 {
        self.factors[0].at(x, y) * self.factors[1].at(x, y)
    }
}

impl ExactMean for Plaid {
    fn mean(&self, x: [f64; 2], y: [f64; 2]) -> f64 {
        0.5 * (self.sum.mean(x, y) + self.difference.mean(x, y))
    }
}

impl FourierField for Plaid {
    fn spectrum(&self) -> PlaneSpectrum {
        self.sum.spectrum().plus(&self.difference.spectrum()).times(|_, _| 0.5.into())
    }
}
