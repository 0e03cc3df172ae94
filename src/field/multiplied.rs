//! One field through another.

use crate::field::Field;
use crate::signal::Signal;

/// `f·g`: a mask, a shadow, a screen in front of a screen. Its mean is not the product of the means; the product of two
/// gratings, whose mean is known, is a [`Plaid`](crate::field::plaid::Plaid).
///
/// ```
/// use nyquist::prelude::*;
/// let half_moon = Multiplied(Disc::new([0.0, 0.0], 1.0)?, HalfPlane::new([1.0, 0.0], 0.0)?);
/// assert_eq!((half_moon.at(-0.5, 0.0), half_moon.at(0.5, 0.0)), (1.0, 0.0));
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Multiplied<F, G>(pub F, pub G);

impl<F: Field, G: Field> Field for Multiplied<F, G> {
    fn at(&self, x: f64, y: f64) -> f64 {
        self.0.at(x, y) * self.1.at(x, y)
    }
}

/// `f(x)·g(y)`: a signal across times a signal down.
///
/// Separable things are two things of one dimension: the spectrum is
/// [`PlaneSpectrum::separable`](crate::field::spectrum::PlaneSpectrum::separable), and the transform of an image can be
/// computed along one axis after the other for the same reason.
///
/// ```
/// use nyquist::prelude::*;
/// let pillar = Separable(Boxcar::new(2.0)?, Tent::new(1.0)?);
/// assert_eq!((pillar.at(0.5, 0.5), pillar.at(1.5, 0.0)), (0.5, 0.0));
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Separable<F, G>(pub F, pub G);

impl<F: Signal, G: Signal> Field for Separable<F, G> {
    fn at(&self, x: f64, y: f64) -> f64 {
        self.0.at(x) * self.1.at(y)
    }
}
