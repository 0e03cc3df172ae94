//! The Gaussian.

use crate::error::{Result, positive};
use crate::signal::{Differentiable, FourierPair, Signal};
use crate::spectrum::Spectrum;
use std::f64::consts::PI;

/// The Gaussian `f(x) = h·e^{−π(x/w)²}` ↔ `F(ν) = h·w·e^{−π(wν)²}`; with `h = w = 1` it is its own transform.
///
/// Second row of the lecture's table. Its amplitudes satisfy `σ_x·σ_ν = 1/(2π)`, its intensities `1/(4π)`: the
/// uncertainty bound. Never exactly zero, but below `f64` rounding of its peak beyond `extent = 3.39/w`.
///
/// ```
/// use nyquist::prelude::*;
/// let gaussian = Gaussian::new(1.0)?;
/// assert_eq!(gaussian.at(0.7), gaussian.spectrum().density(0.7).re);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gaussian {
    height: f64,
    width: f64,
}

impl Gaussian {
    /// `e^{−π(x/w)²}`: height 1, area `w`.
    ///
    /// # Errors
    /// A width that is not positive and finite.
    pub fn new(width: f64) -> Result<Self> {
        Ok(Self { height: 1.0, width: positive("the width of a Gaussian", width)? })
    }

    /// `e^{−x²/(2σ²)}`: height 1, standard deviation σ; `w = σ√(2π)`.
    ///
    /// # Errors
    /// A deviation that is not positive and finite.
    pub fn with_deviation(sigma: f64) -> Result<Self> {
        Self::new(positive("the deviation of a Gaussian", sigma)? * (2.0 * PI).sqrt())
    }

    /// The Gaussian whose spectrum is `e^{−aν²}`: `f(x) = √(π/a)·e^{−π²x²/a}`. The lecture's replica figure uses
    /// `a = 50`, its overlap figure `a = 8`, both with replicas one apart.
    ///
    /// ```
    /// use nyquist::prelude::*;
    /// let overlapping = Gaussian::with_spectrum(8.0)?.spectrum();
    /// assert!((overlapping.density(0.5).re - (-2.0f64).exp()).abs() < 1e-15);
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    /// A rate of decay that is not positive and finite.
    pub fn with_spectrum(a: f64) -> Result<Self> {
        let width = (positive("the decay of a Gaussian spectrum", a)? / PI).sqrt();
        Ok(Self { height: 1.0 / width, width })
    }
}

impl Signal for Gaussian {
    fn at(&self, x: f64) -> f64 {
        self.height * (-PI * (x / self.width).powi(2)).exp()
    }
}

impl Differentiable for Gaussian {
    fn slope(&self, x: f64) -> f64 {
        -2.0 * PI * x / (self.width * self.width) * self.at(x)
    }
}

impl FourierPair for Gaussian {
    fn spectrum(&self) -> Spectrum {
        let Self { height, width } = *self;
        // e^{−π(wν)²} = 2^{−53} at wν = √(53 ln 2 / π)
        let extent = (53.0 * 2f64.ln() / PI).sqrt() / width;
        Spectrum::decaying(extent, move |nu| (height * width * (-PI * (width * nu).powi(2)).exp()).into())
    }
}
