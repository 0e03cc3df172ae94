//! A field, turned.

use crate::error::{Result, finite};
use crate::field::spectrum::PlaneSpectrum;
use crate::field::{Field, FourierField};
use std::sync::Arc;

/// `f(R⁻¹(x, y))` ↔ `F(R⁻¹(u, v))`: a turn by an angle turns the spectrum by the same angle.
///
/// It has no exact mean: an axis-parallel rectangle is a slanted one for the field inside. Turn the shape instead (a
/// polygon's vertices, a grating's frequency), where it can be turned.
///
/// ```
/// use nyquist::prelude::*;
/// let upright = Rotated::new(std::f64::consts::FRAC_PI_2, Grating::new([0.25, 0.0])?)?;
/// assert!((upright.at(0.0, 2.0) + 1.0).abs() < 1e-15); // the wave runs along y now
/// let line = upright.spectrum().lines()[1].at;
/// assert!(line[0].abs() < 1e-16 && (line[1].abs() - 0.25).abs() < 1e-16);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rotated<F> {
    cos: f64,
    sin: f64,
    field: F,
}

impl<F> Rotated<F> {
    /// The field turned by `angle` around the origin (radians, from the x axis towards the y axis).
    ///
    /// # Errors
    /// An angle that is not finite.
    pub fn new(angle: f64, field: F) -> Result<Self> {
        let (sin, cos) = finite("an angle", angle)?.sin_cos();
        Ok(Self { cos, sin, field })
    }
}

impl<F: Field> Field for Rotated<F> {
    fn at(&self, x: f64, y: f64) -> f64 {
        self.field.at(self.cos * x + self.sin * y, self.cos * y - self.sin * x)
    }
}

impl<F: FourierField> FourierField for Rotated<F> {
    fn spectrum(&self) -> PlaneSpectrum {
        let (c, s) = (self.cos, self.sin);
        let back = Arc::new(move |[u, v]: [f64; 2]| [c * u + s * v, c * v - s * u]);
        let there = Arc::new(move |[u, v]: [f64; 2]| [c * u - s * v, c * v + s * u]);
        self.field.spectrum().mapped(back, there, 1.0)
    }
}
