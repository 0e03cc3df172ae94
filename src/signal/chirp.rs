//! The linear chirp.

use crate::error::{Result, positive};
use crate::num::cos_pi;
use crate::signal::{Differentiable, FourierPair, Signal};
use crate::spectrum::Spectrum;
use std::f64::consts::PI;

/// `f(x) = cos(πax²)` ↔ `F(ν) = cos(πν²/a − π/4)/√a`: its local frequency is `a·|x|`.
///
/// The transform of `e^{iπax²}` is `e^{iπ/4}·e^{−iπν²/a}/√a` (a Fresnel integral); this is its real part, both sides
/// being even. Neither side decays: a chirp is not band-limited, whatever the rate it is sampled at.
///
/// ```
/// use nyquist::prelude::*;
/// let chirp = Chirp::new(1.0)?;
/// let there = chirp.spectrum().density(1.2).re;
/// // with a = 1 the transform is the chirp turned by an eighth of a period
/// assert!((there - (std::f64::consts::PI * (1.44 - 0.25)).cos()).abs() < 1e-15);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Chirp {
    rate: f64,
}

impl Chirp {
    /// `cos(π·rate·x²)`: the local frequency rises by `rate` for every unit of `x`.
    ///
    /// # Errors
    /// A rate that is not positive and finite.
    pub fn new(rate: f64) -> Result<Self> {
        Ok(Self { rate: positive("the rate of a chirp", rate)? })
    }
}

impl Signal for Chirp {
    fn at(&self, x: f64) -> f64 {
        cos_pi(self.rate * x * x)
    }
}

impl Differentiable for Chirp {
    fn slope(&self, x: f64) -> f64 {
        -2.0 * PI * self.rate * x * crate::num::sin_pi(self.rate * x * x)
    }
}

impl FourierPair for Chirp {
    fn spectrum(&self) -> Spectrum {
        let a = self.rate;
        Spectrum::decaying(f64::INFINITY, move |nu| (cos_pi(nu * nu / a - 0.25) / a.sqrt()).into())
    }
}
