//! Two fields on top of each other.

use crate::field::spectrum::PlaneSpectrum;
use crate::field::{ExactMean, Field, FourierField};

/// `f + g` ↔ `F + G`. Exact means stay exact.
///
/// ```
/// use nyquist::prelude::*;
/// let two = Added(Disc::new([0.0, 0.0], 1.0)?, Disc::new([9.0, 0.0], 1.0)?);
/// assert_eq!((two.at(0.0, 0.0), two.at(9.0, 0.0), two.at(4.0, 0.0)), (1.0, 1.0, 0.0));
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Added<F, G>(pub F, pub G);

impl<F: Field, G: Field> Field for Added<F, G> {
    fn at(&self, x: f64, y: f64) -> f64 {
        self.0.at(x, y) + self.1.at(x, y)
    }
}

impl<F: ExactMean, G: ExactMean> ExactMean for Added<F, G> {
    fn mean(&self, x: [f64; 2], y: [f64; 2]) -> f64 {
        self.0.mean(x, y) + self.1.mean(x, y)
    }
}

impl<F: FourierField, G: FourierField> FourierField for Added<F, G> {
    fn spectrum(&self) -> PlaneSpectrum {
        self.0.spectrum().plus(&self.1.spectrum())
    }
}
