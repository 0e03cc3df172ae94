//! The zone plate: every frequency in one picture.

use crate::error::{Result, positive};
use crate::field::{ExactMean, Field, rectangle};
use crate::num::cos_pi;
use crate::num::fresnel::fresnel;
use num_complex::Complex;

/// `f(x, y) = ½ + ½cos(π(x² + y²)/M)`: rings whose local frequency is `r/M`, pointing outwards.
///
/// Sampled at the integers it is exactly periodic with the period `M` in both directions if `M` is even, for
/// `(x + M)² − x² = 2Mx + M²`: every ghost centre at `(kM, lM)` is as sharp as the true one (V27).
///
/// Its mean over a rectangle is `½ + ½Re[I(x₀, x₁)·I(y₀, y₁)]` with `I(a, b)` the mean of `e^{iπt²/M}`, a difference of
/// Fresnel integrals; what rounding leaves is about `ε·(√M/Δ)·(8 + 4r²/M)`.
///
/// ```
/// use nyquist::prelude::*;
/// let plate = ZonePlate::new(64.0)?;
/// assert_eq!(plate.at(3.0, 5.0), plate.at(3.0 + 64.0, 5.0 - 128.0));
/// // the mean over a pixel at the ghost's place tells them apart
/// assert!(plate.mean([-0.5, 0.5], [-0.5, 0.5]) > 0.999 && plate.mean([63.5, 64.5], [-0.5, 0.5]) < 0.51);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ZonePlate {
    period: f64,
}

impl ZonePlate {
    /// The zone plate `M = period`, whose rings reach the frequency of one cycle per unit at the radius `M`.
    ///
    /// # Errors
    /// A period that is not positive and finite.
    pub fn new(period: f64) -> Result<Self> {
        Ok(Self { period: positive("the period of a zone plate", period)? })
    }

    /// `M`.
    pub fn period(&self) -> f64 {
        self.period
    }

    /// The mean of `e^{iπt²/M}` from `a` to `b`.
    fn chirp_mean(&self, [a, b]: [f64; 2]) -> Complex<f64> {
        let scale = (2.0 / self.period).sqrt();
        (fresnel(b * scale) - fresnel(a * scale)) / (scale * (b - a))
    }
}

impl Field for ZonePlate {
    fn at(&self, x: f64, y: f64) -> f64 {
        0.5 + 0.5 * cos_pi((x * x + y * y) / self.period)
    }
}

impl ExactMean for ZonePlate {
    fn mean(&self, x: [f64; 2], y: [f64; 2]) -> f64 {
        match rectangle(x, y) {
            Ok([x, y]) => 0.5 + 0.5 * (self.chirp_mean(x) * self.chirp_mean(y)).re,
            Err([x, y]) => self.at(x, y),
        }
    }
}
