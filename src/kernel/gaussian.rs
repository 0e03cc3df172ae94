//! The truncated Gaussian, lowered so that it ends at zero: no ringing, ever, at the price of blur.
//!
//! | | |
//! | --- | --- |
//! | formula | `k(t) = (e^{−αt²} − e^{−αr²})/A` for `\|t\| < r`, with `α = 1/2σ²` and `A = √(π/α)·erf(r√α) − 2r·e^{−αr²}`, so that `∫ k = 1` |
//! | response | `{√(π/α)·[e^{−π²ν²/α} − e^{−αr²}·Re(e^{2πiνr} w(πν/√α + i·r√α))] − 2r·e^{−αr²}·sinc(2rν)}/A`, `w` the Faddeeva function |
//! | parameters | the standard deviation `σ` (or `α`) and the radius `r`, in steps |
//! | use it | for pixels, where ringing is worse than blur; for spots of phosphor |
//! | artefacts | blur: 0.29 of a tone at Nyquist is left; ripple of ±1.4 % (`r = 2`) or ±2.1 % (`r = 1.5`) on a constant, unless the weights are divided by their sum, as a film does |
//! | source | pbrt-2 `filters/gaussian.h` (α = 2, r = 2), pbrt-4 `filters.h` (σ = ½, r = 1.5): the same curve, cut off at different radii |
//!
//! Both editions of pbrt leave `A` out and divide by the sum of the weights later; here the kernel is of unit gain by
//! itself, so that [`reconstruct`](crate::reconstruct::reconstruct), which does not divide, keeps the mean.

use crate::error::{Result, within};
use crate::kernel::{Claims, Kernel, MOST_RADIUS};
use crate::num::faddeeva::faddeeva;
use crate::num::sinc;
use crate::signal::Signal;
use num_complex::Complex;
use std::f64::consts::PI;

/// A truncated Gaussian of unit gain; see the [page](self).
///
/// ```
/// use nyquist::prelude::*;
/// let gaussian = GaussianKernel::pbrt2();
/// assert!((gaussian.response(0.5) - 0.2915).abs() < 5e-5);
/// // the value before normalisation is the formula of the book
/// assert!((gaussian.at(0.5) * gaussian.area() - ((-0.5f64).exp() - (-8.0f64).exp())).abs() < 1e-15);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GaussianKernel {
    sigma: f64,
    radius: f64,
    alpha: f64,
    area: f64,
}

impl GaussianKernel {
    /// Standard deviation `sigma` and `radius`, in steps.
    ///
    /// # Errors
    /// A `sigma` that is not finite or outside `1/64 ..= 4096`, a radius outside `sigma/2 ..= 4096`: narrower ones are
    /// no Gaussians but parabolas, and their area would be lost to cancellation.
    pub fn new(sigma: f64, radius: f64) -> Result<Self> {
        within("the standard deviation of a Gaussian kernel", sigma, 1.0 / 64.0, MOST_RADIUS)?;
        within("the radius of a Gaussian kernel", radius, 0.5 * sigma, MOST_RADIUS)?;
        Ok(Self::known(sigma, radius))
    }

    fn known(sigma: f64, radius: f64) -> Self {
        let raw = Self { sigma, radius, alpha: 0.5 / (sigma * sigma), area: 1.0 };
        Self { area: raw.response(0.0), ..raw }
    }

    /// `e^{−αt²} − e^{−αr²}` of unit gain, in the parameters of pbrt-2.
    ///
    /// # Errors
    /// As [`GaussianKernel::new`], for `σ = 1/√(2α)`.
    pub fn from_alpha(alpha: f64, radius: f64) -> Result<Self> {
        Self::new((0.5 / alpha).sqrt(), radius)
    }

    /// `α = 2`, radius 2: the default of pbrt-2, the lecture's source.
    pub fn pbrt2() -> Self {
        Self::known(0.5, 2.0)
    }

    /// `σ = ½`, radius 1.5: the default of pbrt-4.
    pub fn pbrt4() -> Self {
        Self::known(0.5, 1.5)
    }

    /// The standard deviation of the Gaussian before it is truncated, in steps.
    pub fn sigma(&self) -> f64 {
        self.sigma
    }

    /// `A = ∫ (e^{−αt²} − e^{−αr²}) dt`, by which the book's formula has been divided.
    pub fn area(&self) -> f64 {
        self.area
    }
}

impl Signal for GaussianKernel {
    fn at(&self, t: f64) -> f64 {
        let t = t.abs();
        if t >= self.radius {
            return 0.0;
        }
        // e^{−αt²}·(1 − e^{−α(r²−t²)}), which does not cancel near the edge
        let below = self.alpha * (self.radius - t) * (self.radius + t);
        -(-self.alpha * t * t).exp() * (-below).exp_m1() / self.area
    }
}

impl Kernel for GaussianKernel {
    fn name(&self) -> String {
        match (*self == Self::pbrt4(), *self == Self::pbrt2()) {
            (true, _) => "gaussian".into(),
            (_, true) => "gaussian-pbrt2".into(),
            _ => format!("gaussian:{},{}", self.sigma, self.radius),
        }
    }
    fn radius(&self) -> f64 {
        self.radius
    }
    fn claims(&self) -> Claims {
        Claims {
            interpolating: false,
            unit_gain: true,
            reproduces_constants: false,
            reproduces_lines: false,
            nonnegative: true,
        }
    }
    fn response(&self, nu: f64) -> f64 {
        let (nu, r, root) = (nu.abs(), self.radius, self.alpha.sqrt());
        let edge = (-self.alpha * r * r).exp();
        let whole = (-(PI * nu / root).powi(2)).exp();
        let tails = Complex::cis(2.0 * PI * nu * r) * faddeeva(Complex::new(PI * nu / root, r * root));
        (PI.sqrt() / root * (whole - edge * tails.re) - 2.0 * r * edge * sinc(2.0 * r * nu)) / self.area
    }
}
