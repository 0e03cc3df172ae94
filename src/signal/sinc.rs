//! The sinc and its square.

use crate::error::{Result, positive};
use crate::num::{self, sinc_slope};
use crate::signal::{Differentiable, FourierPair, Signal};
use crate::spectrum::{Spectrum, low_pass};

/// `f(x) = sinc(rx)` ↔ the box `F(ν) = 1/r` for `|ν| < r/2`, half of it at the edges.
///
/// What one sample at rate `r` becomes under ideal reconstruction. Band-limited to `r/2`; in space it decays only like
/// `1/x`, so that truncating it to `|x| ≤ N/r` loses `≈ 1/(π²N)` of its energy.
///
/// ```
/// use nyquist::prelude::*;
/// let f = Sinc::new(2.0)?;
/// assert_eq!((f.at(0.0), f.at(0.5), f.spectrum().band()), (1.0, 0.0, 1.0));
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sinc {
    rate: f64,
}

impl Sinc {
    /// `sinc(rate·x)`: zero at all nonzero multiples of `1/rate`.
    ///
    /// # Errors
    /// A rate that is not positive and finite.
    pub fn new(rate: f64) -> Result<Self> {
        Ok(Self { rate: positive("the rate of a sinc", rate)? })
    }
}

impl Signal for Sinc {
    fn at(&self, x: f64) -> f64 {
        num::sinc(self.rate * x)
    }
}

impl Differentiable for Sinc {
    fn slope(&self, x: f64) -> f64 {
        self.rate * sinc_slope(self.rate * x)
    }
}

impl FourierPair for Sinc {
    fn spectrum(&self) -> Spectrum {
        let rate = self.rate;
        Spectrum::density_of(0.5 * rate, move |nu| (low_pass(nu, 0.5 * rate) / rate).into())
    }
}

/// `f(x) = sinc²(rx)` ↔ the tent `F(ν) = max(0, 1 − |ν|/r)/r`, band-limited to `r`.
///
/// ```
/// use nyquist::prelude::*;
/// let spectrum = SincSquared::new(2.0)?.spectrum();
/// assert_eq!((spectrum.density(0.0).re, spectrum.density(1.0).re, spectrum.band()), (0.5, 0.25, 2.0));
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SincSquared {
    rate: f64,
}

impl SincSquared {
    /// `sinc²(rate·x)`.
    ///
    /// # Errors
    /// A rate that is not positive and finite.
    pub fn new(rate: f64) -> Result<Self> {
        Ok(Self { rate: positive("the rate of a sinc²", rate)? })
    }
}

impl Signal for SincSquared {
    fn at(&self, x: f64) -> f64 {
        num::sinc(self.rate * x).powi(2)
    }
}

impl Differentiable for SincSquared {
    fn slope(&self, x: f64) -> f64 {
        2.0 * self.rate * num::sinc(self.rate * x) * sinc_slope(self.rate * x)
    }
}

impl FourierPair for SincSquared {
    fn spectrum(&self) -> Spectrum {
        let rate = self.rate;
        Spectrum::density_of(rate, move |nu| ((1.0 - nu.abs() / rate).max(0.0) / rate).into())
    }
}
