//! Continuous signals, and those among them whose Fourier transform is known in closed form.

pub mod boxcar;
pub mod chirp;
pub mod constant;
pub mod decay;
pub mod gaussian;
pub mod lecture;
pub mod raised_cosine;
pub mod series;
pub mod sinc;
pub mod spline;
pub mod tent;
pub mod theorem;
pub mod tone;
pub mod trigonometric;

use crate::spectrum::Spectrum;

/// A continuous signal: real, total (every finite `x` has a value) and pure. At a jump its value is the mean of both
/// sides.
///
/// ```
/// use nyquist::signal::{Signal, from_fn};
/// let ramp = from_fn(|x| 2.0 * x);
/// assert_eq!(ramp.at(1.5), 3.0);
/// ```
pub trait Signal {
    /// The value at `x`.
    fn at(&self, x: f64) -> f64;
}

impl<S: Signal + ?Sized> Signal for &S {
    fn at(&self, x: f64) -> f64 {
        (**self).at(x)
    }
}

impl<S: Signal + ?Sized> Signal for Box<S> {
    fn at(&self, x: f64) -> f64 {
        (**self).at(x)
    }
}

/// A signal whose transform `F(ν) = ∫ f(x) e^{−2πiνx} dx` is known in closed form.
pub trait FourierPair: Signal {
    /// The transform.
    fn spectrum(&self) -> Spectrum;
}

impl<S: FourierPair + ?Sized> FourierPair for &S {
    fn spectrum(&self) -> Spectrum {
        (**self).spectrum()
    }
}

impl<S: FourierPair + ?Sized> FourierPair for Box<S> {
    fn spectrum(&self) -> Spectrum {
        (**self).spectrum()
    }
}

/// A signal whose derivative is known in closed form.
pub trait Differentiable: Signal {
    /// `f′(x)`.
    fn slope(&self, x: f64) -> f64;
}

impl<S: Differentiable + ?Sized> Differentiable for &S {
    fn slope(&self, x: f64) -> f64 {
        (**self).slope(x)
    }
}

/// A signal made from a closure.
#[derive(Debug, Clone, Copy)]
pub struct FromFn<F>(F);

impl<F: Fn(f64) -> f64> Signal for FromFn<F> {
    fn at(&self, x: f64) -> f64 {
        (self.0)(x)
    }
}

/// The signal `x ↦ f(x)`.
///
/// A blanket implementation over closures would break the inference of their argument types and conflict with the one
/// for references, hence this function.
pub fn from_fn<F: Fn(f64) -> f64>(f: F) -> FromFn<F> {
    FromFn(f)
}
