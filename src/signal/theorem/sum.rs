//! Linearity, the other half.

use crate::signal::{Differentiable, FourierPair, Signal};
use crate::spectrum::Spectrum;

/// `f + g` ↔ `F + G`.
///
/// ```
/// use nyquist::prelude::*;
/// let both = Sum(Constant::new(1.0)?, Cosine::new(2.0)?);
/// assert_eq!(both.spectrum().lines().iter().map(|l| l.at).collect::<Vec<_>>(), [-2.0, 0.0, 2.0]);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sum<F, G>(pub F, pub G);

impl<F: Signal, G: Signal> Signal for Sum<F, G> {
    fn at(&self, x: f64) -> f64 {
        self.0.at(x) + self.1.at(x)
    }
}

impl<F: Differentiable, G: Differentiable> Differentiable for Sum<F, G> {
    fn slope(&self, x: f64) -> f64 {
        self.0.slope(x) + self.1.slope(x)
    }
}

impl<F: FourierPair, G: FourierPair> FourierPair for Sum<F, G> {
    fn spectrum(&self) -> Spectrum {
        self.0.spectrum().plus(&self.1.spectrum())
    }
}
