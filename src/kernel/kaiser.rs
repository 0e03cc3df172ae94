//! The sinc under Kaiser's window: sharpness and leakage at the turn of one knob.
//!
//! | | |
//! | --- | --- |
//! | formula | `k(t) = sinc(t)·I₀(β√(1−(t/r)²))/I₀(β)` for `\|t\| < r` |
//! | response | `∫_{ν−½}^{ν+½} W(u) du`, `W(u) = 2r/I₀(β)·sinh(√(β²−(2πru)²))/√(β²−(2πru)²)`, by quadrature |
//! | parameters | the radius `r`, and `β`: 0 is the bare truncated sinc, 8 leaks −80 dB |
//! | use it | for sound, for figures that must separate aliasing before and after the samples (a radius of 15 to 30), for rate conversion |
//! | artefacts | Nyquist itself is at half gain, to within the leakage, and `β/(2πr)` wide to either side: what lies in there is damped below and leaks above |
//! | source | Kaiser, *Nonrecursive digital filter design using the I₀-sinh window function*, 1974; Oppenheim & Schafer |

use crate::error::{Result, within};
use crate::kernel::windowed;
use crate::kernel::{Claims, Kernel, MOST_RADIUS};
use crate::num::special::bessel_i0;
use crate::signal::Signal;
use std::f64::consts::PI;

/// A Kaiser-windowed sinc; see the [page](self).
///
/// ```
/// use nyquist::prelude::*;
/// let kaiser = Kaiser::new(8.0, 8.0)?;
/// assert_eq!((kaiser.at(0.0), kaiser.at(3.0)), (1.0, 0.0));
/// assert!((kaiser.response(0.5) - 0.5).abs() < 1e-4); // half gain at Nyquist
/// assert!(kaiser.response(0.8).abs() < 1e-4); // −80 dB beyond the transition
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Kaiser {
    radius: f64,
    beta: f64,
    peak: f64,
}

impl Kaiser {
    /// Radius in steps, and `β`.
    ///
    /// # Errors
    /// A radius outside `½..=4096`, a `β` outside `0..=100`, either not finite.
    pub fn new(radius: f64, beta: f64) -> Result<Self> {
        within("the radius of a Kaiser kernel", radius, 0.5, MOST_RADIUS)?;
        within("β of a Kaiser kernel", beta, 0.0, 100.0)?;
        Ok(Self { radius, beta, peak: bessel_i0(beta) })
    }

    /// Radius 4, β = 8.
    pub fn standard() -> Self {
        Self { radius: 4.0, beta: 8.0, peak: bessel_i0(8.0) }
    }

    /// The window's parameter.
    pub fn beta(&self) -> f64 {
        self.beta
    }
}

impl Signal for Kaiser {
    fn at(&self, t: f64) -> f64 {
        windowed::value(t, self.radius, |t| {
            let (near, far) = (self.radius - t.abs(), self.radius + t.abs());
            bessel_i0(self.beta * (near * far).max(0.0).sqrt() / self.radius) / self.peak
        })
    }
}

impl Kernel for Kaiser {
    fn name(&self) -> String {
        if *self == Self::standard() { "kaiser".into() } else { format!("kaiser:{},{}", self.radius, self.beta) }
    }
    fn radius(&self) -> f64 {
        self.radius
    }
    fn claims(&self) -> Claims {
        windowed::CLAIMS
    }
    /// By quadrature of the window's spectrum; absolute error below `10⁻¹⁴`.
    fn response(&self, nu: f64) -> f64 {
        windowed::response(nu, self.radius, |u| {
            let square = self.beta * self.beta - (2.0 * PI * self.radius * u).powi(2);
            let root = square.abs().sqrt();
            let shape = match root {
                0.0 => 1.0,
                _ if square > 0.0 => root.sinh() / root,
                _ => root.sin() / root,
            };
            2.0 * self.radius * shape / self.peak
        })
    }
}
