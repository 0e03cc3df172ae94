//! The derivative theorem.

use crate::signal::{Differentiable, FourierPair, Signal};
use crate::spectrum::Spectrum;
use num_complex::Complex;
use std::f64::consts::PI;

/// `f′` ↔ `2πiν·F(ν)`: differentiating amplifies high frequencies in proportion.
///
/// ```
/// use nyquist::prelude::*;
/// let slope = Derivative(Sine::new(1.0)?);
/// assert_eq!(slope.at(0.0), 2.0 * std::f64::consts::PI);
/// assert!((slope.spectrum().lines()[1].weight.re - std::f64::consts::PI).abs() < 1e-15);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Derivative<S>(pub S);

impl<S: Differentiable> Signal for Derivative<S> {
    fn at(&self, x: f64) -> f64 {
        self.0.slope(x)
    }
}

impl<S: Differentiable + FourierPair> FourierPair for Derivative<S> {
    fn spectrum(&self) -> Spectrum {
        self.0.spectrum().times(|nu| Complex::new(0.0, 2.0 * PI * nu))
    }
}
