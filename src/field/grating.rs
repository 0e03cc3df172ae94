//! A cosine wave over the plane.

use crate::error::{Result, finite, positive};
use crate::field::spectrum::{PlaneImpulse, PlaneSpectrum};
use crate::field::{ExactMean, Field, FourierField, rectangle};
use crate::num::{cos_pi, sin_pi, sinc};
use num_complex::Complex;
use std::f64::consts::PI;

/// `f(x, y) = cos(2π(ux + vy) + φ)` ↔ two lines of weight `½e^{±iφ}` at `±(u, v)`.
///
/// Its mean over a rectangle `a` wide and `b` high is its value in the middle times `sinc(ua)·sinc(vb)`, to rounding: the
/// transfer of a box, in both directions.
///
/// ```
/// use nyquist::prelude::*;
/// let fine = Grating::new([0.9, 0.0])?; // nine tenths of the sampling rate
/// let pixel = fine.mean([-0.5, 0.5], [-0.5, 0.5]);
/// assert!((pixel - nyquist::num::sinc(0.9)).abs() < 1e-15); // a box leaves 0.1093, not zero (E13)
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grating {
    frequency: [f64; 2],
    phase: f64,
}

impl Grating {
    /// `cos(2π(ux + vy))` for the frequency `(u, v)`.
    ///
    /// # Errors
    /// A frequency that is not finite.
    pub fn new(frequency: [f64; 2]) -> Result<Self> {
        Self::with_phase(frequency, 0.0)
    }

    /// `cos(2π(ux + vy) + phase)`, the phase in radians; `−π/2` makes it a sine.
    ///
    /// # Errors
    /// A frequency or a phase that is not finite.
    pub fn with_phase(frequency: [f64; 2], phase: f64) -> Result<Self> {
        for nu in frequency {
            finite("the frequency of a grating", nu)?;
        }
        Ok(Self { frequency, phase: finite("the phase of a grating", phase)? })
    }

    /// `frequency` cycles per unit in the direction `angle` (radians, from the x axis towards the y axis).
    ///
    /// ```
    /// use nyquist::prelude::*;
    /// let diagonal = Grating::at_angle(0.1, std::f64::consts::FRAC_PI_4)?;
    /// assert!((diagonal.at(5.0, 5.0) - diagonal.at(10.0, 0.0)).abs() < 1e-14); // one line of the wave
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    /// A frequency that is not positive and finite, an angle that is not finite.
    pub fn at_angle(frequency: f64, angle: f64) -> Result<Self> {
        positive("the frequency of a grating", frequency)?;
        finite("the angle of a grating", angle)?;
        Self::new([frequency * angle.cos(), frequency * angle.sin()])
    }

    /// The frequency `(u, v)` in cycles per unit.
    pub fn frequency(&self) -> [f64; 2] {
        self.frequency
    }

    /// The phase in radians.
    pub(super) fn phase(&self) -> f64 {
        self.phase
    }

    /// Half turns at a point.
    fn turns(&self, x: f64, y: f64) -> f64 {
        2.0 * (self.frequency[0] * x + self.frequency[1] * y)
    }
}

impl Field for Grating {
    fn at(&self, x: f64, y: f64) -> f64 {
        let turns = self.turns(x, y);
        // without a phase the zeros and peaks are exact
        if self.phase == 0.0 {
            cos_pi(turns)
        } else {
            cos_pi(turns) * self.phase.cos() - sin_pi(turns) * self.phase.sin()
        }
    }
}

impl ExactMean for Grating {
    fn mean(&self, x: [f64; 2], y: [f64; 2]) -> f64 {
        let middle = |[a, b]: [f64; 2]| 0.5 * (a + b);
        let value = self.at(middle(x), middle(y));
        let [u, v] = self.frequency;
        match rectangle(x, y) {
            Ok([x, y]) => value * sinc(u * (x[1] - x[0])) * sinc(v * (y[1] - y[0])),
            Err(_) => value,
        }
    }
}

impl FourierField for Grating {
    fn spectrum(&self) -> PlaneSpectrum {
        // a phase of ±π/2 makes purely imaginary weights
        let weight = 0.5 * Complex::new(cos_pi(self.phase / PI), sin_pi(self.phase / PI));
        let [u, v] = self.frequency;
        let lines = vec![PlaneImpulse::new([u, v], weight), PlaneImpulse::new([-u, -v], weight.conj())];
        PlaneSpectrum::build(None, lines)
    }
}
