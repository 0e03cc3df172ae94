//! The raised cosine: the band-limited signal that most figures use.

use crate::error::{Result, positive};
use crate::num::{sinc, sinc_slope};
use crate::signal::{Differentiable, FourierPair, Signal};
use crate::spectrum::Spectrum;
use std::f64::consts::PI;

/// RC(B): `F(ν) = cos²(πν/2B)` for `|ν| < B`, else 0 ↔ `f(x) = B·sinc(2Bx)/(1 − (2Bx)²)`.
///
/// Smooth at the band limit (`F(±B) = F′(±B) = 0`), so that it decays like `x⁻³` and short records show it whole.
/// `f(0) = B`, `f(±1/2B) = B/2`, energy `3B/4`.
///
/// ```
/// use nyquist::prelude::*;
/// let f = RaisedCosine::new(2.0)?;
/// assert_eq!((f.at(0.0), f.at(0.25), f.spectrum().density(2.0).re), (2.0, 1.0, 0.0));
/// assert!((f.spectrum().energy(-2.0, 2.0) - 1.5).abs() < 1e-14);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RaisedCosine {
    band: f64,
}

impl RaisedCosine {
    /// RC(band).
    ///
    /// # Errors
    /// A band that is not positive and finite.
    pub fn new(band: f64) -> Result<Self> {
        Ok(Self { band: positive("the band of a raised cosine", band)? })
    }

    /// The band limit `B`.
    pub fn band(&self) -> f64 {
        self.band
    }
}

impl Signal for RaisedCosine {
    fn at(&self, x: f64) -> f64 {
        let u = (2.0 * self.band * x).abs();
        // sin πu = sin π(1−u): where 1−u is small, divide it out instead of dividing by it
        let value = if u < 0.5 { sinc(u) / (1.0 - u * u) } else { sinc(1.0 - u) / (u * (1.0 + u)) };
        self.band * value
    }
}

impl Differentiable for RaisedCosine {
    fn slope(&self, x: f64) -> f64 {
        // cos² = ½ + ½cos: f = B·[sinc u + ½sinc(u−1) + ½sinc(u+1)]
        let u = 2.0 * self.band * x;
        2.0 * self.band.powi(2) * (sinc_slope(u) + 0.5 * (sinc_slope(u - 1.0) + sinc_slope(u + 1.0)))
    }
}

impl FourierPair for RaisedCosine {
    fn spectrum(&self) -> Spectrum {
        let band = self.band;
        Spectrum::density_of(band, move |nu| {
            let value = if nu.abs() < band { (0.5 * PI * nu / band).cos().powi(2) } else { 0.0 };
            value.into()
        })
    }
}
