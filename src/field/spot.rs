//! Gaussian spots.

use crate::error::{Result, finite, positive};
use crate::field::spectrum::PlaneSpectrum;
use crate::field::{ExactMean, Field, FourierField, rectangle};
use crate::num::erf::gaussian_mean;
use crate::num::quadrature::{even_breaks, integrate_pieces};
use num_complex::Complex;
use std::f64::consts::PI;

/// `f(x, y) = e^{−x′²/a² − y′²/b²}` ↔ `πab·e^{−π²(a²u′² + b²v′²)}`, the primes for coordinates turned by an angle: round,
/// elongated and turned Gaussians (slides «Spatial and Frequency Domain», «More Examples»).
///
/// What is wide in space is narrow in frequency, `σ_x·σ_u = 1/(2π)`, and a turn turns both.
///
/// The mean over a rectangle is a product of two differences of error functions where the axes of the spot are those of
/// the plane, with the rounding `8ε·(a/Δx + b/Δy)`. Of a turned spot the inner integral is one, and the outer is computed
/// by quadrature to `10⁻¹⁴`.
///
/// ```
/// use nyquist::prelude::*;
/// let spot = GaussianSpot::round(16.0)?;
/// let ratio = spot.spectrum().density(1.0 / 128.0, 0.0) / spot.spectrum().density(0.0, 0.0);
/// assert!((ratio.re - 0.85709).abs() < 1e-5); // bin 1 over bin 0 of a picture 128 wide
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GaussianSpot {
    radii: [f64; 2],
    angle: f64,
}

impl GaussianSpot {
    /// `e^{−r²/radius²}`.
    ///
    /// # Errors
    /// A radius that is not positive and finite.
    pub fn round(radius: f64) -> Result<Self> {
        Self::turned([radius, radius], 0.0)
    }

    /// `e^{−x²/a² − y²/b²}` for the radii `[a, b]`.
    ///
    /// # Errors
    /// A radius that is not positive and finite.
    pub fn new(radii: [f64; 2]) -> Result<Self> {
        Self::turned(radii, 0.0)
    }

    /// The same, turned by `angle` (radians, from the x axis towards the y axis).
    ///
    /// # Errors
    /// A radius that is not positive and finite, an angle that is not finite.
    pub fn turned(radii: [f64; 2], angle: f64) -> Result<Self> {
        for radius in radii {
            positive("the radius of a Gaussian spot", radius)?;
        }
        Ok(Self { radii, angle: finite("the angle of a Gaussian spot", angle)? })
    }

    fn own(&self, x: f64, y: f64) -> [f64; 2] {
        let (s, c) = self.angle.sin_cos();
        [c * x + s * y, c * y - s * x]
    }

    /// `∫ f(x, y) dx / (x₁ − x₀)` along a row: a Gaussian of `x` again, with the square completed.
    fn row_mean(&self, [x0, x1]: [f64; 2], y: f64) -> f64 {
        let (s, c) = self.angle.sin_cos();
        let [p, q] = self.radii.map(|r| 1.0 / (r * r));
        // the exponent is −(αx² + 2βxy + γy²) = −α(x + βy/α)² − (γ − β²/α)y², and αγ − β² = pq
        let (alpha, beta) = (c * c * p + s * s * q, c * s * (p - q));
        let root = alpha.sqrt();
        let place = |x: f64| root * (x + beta / alpha * y);
        gaussian_mean(place(x0), place(x1)) * (-p * q / alpha * y * y).exp()
    }
}

impl Field for GaussianSpot {
    fn at(&self, x: f64, y: f64) -> f64 {
        let ([x, y], [a, b]) = (self.own(x, y), self.radii);
        (-(x / a) * (x / a) - (y / b) * (y / b)).exp()
    }
}

impl ExactMean for GaussianSpot {
    fn mean(&self, x: [f64; 2], y: [f64; 2]) -> f64 {
        let [x, y] = match rectangle(x, y) {
            Ok(sides) => sides,
            Err([x, y]) => return self.at(x, y),
        };
        let [a, b] = self.radii;
        if self.angle == 0.0 || a == b {
            return gaussian_mean(x[0] / a, x[1] / a) * gaussian_mean(y[0] / b, y[1] / b);
        }
        // beyond 6.2 radii e^{−r²} is below 10⁻¹⁶
        let reach = 6.2 * a.max(b);
        let (low, high) = (y[0].max(-reach), y[1].min(reach));
        if low >= high {
            return 0.0;
        }
        let breaks = even_breaks(low, high, 0.5 * a.min(b));
        integrate_pieces(|y| self.row_mean(x, y), &breaks, 1e-15 * (y[1] - y[0])).value / (y[1] - y[0])
    }
}

impl FourierField for GaussianSpot {
    fn spectrum(&self) -> PlaneSpectrum {
        let spot = *self;
        PlaneSpectrum::density_of(move |u, v| {
            let ([u, v], [a, b]) = (spot.own(u, v), spot.radii);
            Complex::from(PI * a * b * (-(PI * a * u) * (PI * a * u) - (PI * b * v) * (PI * b * v)).exp())
        })
    }
}
