//! The sinc under a Gaussian: for oversampled signals it converges exponentially in the number of samples used.
//!
//! | | |
//! | --- | --- |
//! | formula | `k(t) = sinc(t)·e^{−t²/2s²}` for `\|t\| < n` |
//! | response | `∫_{ν−½}^{ν+½} G(u) du`, `G` the spectrum of the truncated Gaussian, by quadrature |
//! | parameters | the radius `n` and the width `s`; for signals that fill the fraction `r` of the band below Nyquist, `s² = n/(π(1−r))` balances both errors |
//! | use it | to evaluate an oversampled signal to many digits at any place from few samples: the error is below `e^{−π(1−r)n/2}` |
//! | artefacts | none worth naming inside the band `r`; between `r` and Nyquist it damps |
//! | source | Qian, *On the regularized Whittaker–Kotel'nikov–Shannon sampling formula*, Proc. AMS 131, 2003; Kircheis, Potts & Tasche 2023 |

use crate::error::{Result, within};
use crate::kernel::windowed;
use crate::kernel::{Claims, Kernel, MOST_RADIUS};
use crate::num::faddeeva::faddeeva;
use crate::signal::Signal;
use num_complex::Complex;
use std::f64::consts::PI;

/// A Gaussian-regularised sinc; see the [page](self).
///
/// ```
/// use nyquist::prelude::*;
/// // a tone at half of Nyquist, evaluated between samples from 32 of them
/// let kernel = Regularised::for_band(16.0, 0.5)?;
/// let tone = from_fn(|x| (2.0 * std::f64::consts::PI * 0.25 * x).cos());
/// let samples = Samples::of(&tone, Axis::centered(1.0, 64)?);
/// let error = (reconstruct(&samples, kernel).at(0.3) - tone.at(0.3)).abs();
/// assert!(error < (-std::f64::consts::PI * 0.5 * 16.0 / 2.0).exp()); // 3.5e-6
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Regularised {
    radius: f64,
    width: f64,
}

impl Regularised {
    /// Radius `n` and standard deviation `width` of the Gaussian, in steps.
    ///
    /// # Errors
    /// A radius outside `½..=4096` or a width outside `1/64..=4096`, either not finite.
    pub fn new(radius: f64, width: f64) -> Result<Self> {
        within("the radius of a regularised sinc", radius, 0.5, MOST_RADIUS)?;
        within("the width of a regularised sinc", width, 1.0 / 64.0, MOST_RADIUS)?;
        Ok(Self { radius, width })
    }

    /// Radius `n`, and the best width `√(n/(π(1−r)))` for signals whose frequencies stay below the fraction `band = r` of
    /// Nyquist (Qian 2003).
    ///
    /// # Errors
    /// As [`Regularised::new`]; a band outside `0..=0.999`: at the full band nothing converges.
    pub fn for_band(radius: f64, band: f64) -> Result<Self> {
        within("the band of a regularised sinc, as a fraction of Nyquist", band, 0.0, 0.999)?;
        Self::new(radius, (radius / (PI * (1.0 - band))).sqrt())
    }

    /// Radius 8, for signals that fill half of the band.
    pub fn standard() -> Self {
        Self { radius: 8.0, width: (8.0 / (PI * 0.5)).sqrt() }
    }

    /// The standard deviation of the Gaussian, in steps.
    pub fn width(&self) -> f64 {
        self.width
    }
}

impl Signal for Regularised {
    fn at(&self, t: f64) -> f64 {
        windowed::value(t, self.radius, |t| (-0.5 * (t / self.width).powi(2)).exp())
    }
}

impl Kernel for Regularised {
    fn name(&self) -> String {
        match *self == Self::standard() {
            true => "regularised".into(),
            false => format!("regularised:{},{}", self.radius, self.width),
        }
    }
    fn radius(&self) -> f64 {
        self.radius
    }
    fn claims(&self) -> Claims {
        windowed::CLAIMS
    }
    /// By quadrature of the window's spectrum; absolute error below `10⁻¹⁴`.
    fn response(&self, nu: f64) -> f64 {
        let (s, n) = (self.width, self.radius);
        let edge = (-0.5 * (n / s).powi(2)).exp();
        let root = std::f64::consts::FRAC_1_SQRT_2 / s; // √α
        windowed::response(nu, n, |u| {
            let u = u.abs();
            let whole = (-2.0 * (PI * s * u).powi(2)).exp();
            let tails = Complex::cis(2.0 * PI * u * n) * faddeeva(Complex::new(PI * u / root, n * root));
            PI.sqrt() / root * (whole - edge * tails.re)
        })
    }
}
