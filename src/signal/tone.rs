//! Sinusoids.

use crate::error::{Result, finite, positive};
use crate::num::{cos_pi, sin_pi};
use crate::signal::{Differentiable, FourierPair, Signal};
use crate::spectrum::{Impulse, Spectrum};
use num_complex::Complex;
use std::f64::consts::PI;

/// `f(x) = cos(2πνx + φ)` ↔ `½e^{iφ}·δ(· − ν) + ½e^{−iφ}·δ(· + ν)`: two lines of weight ½.
///
/// The lecture's table prints `cos x ↔ π(δ(½ − ω) + δ(½ + ω))`, which is the transform of `2π·cos(πx)`; in its own
/// convention `cos x` has lines of weight ½ at `±1/(2π)` (E01).
///
/// ```
/// use nyquist::prelude::*;
/// use std::f64::consts::PI;
/// let cos_x = Cosine::new(1.0 / (2.0 * PI))?;
/// assert!((cos_x.at(1.0) - 1f64.cos()).abs() < 1e-15);
/// assert_eq!(cos_x.spectrum().lines()[1], Impulse::new(0.15915494309189535, 0.5));
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cosine {
    frequency: f64,
    phase: f64,
}

impl Cosine {
    /// `cos(2π·frequency·x)`.
    ///
    /// # Errors
    /// A frequency that is not positive and finite; zero is [`Constant`](crate::signal::constant::Constant).
    pub fn new(frequency: f64) -> Result<Self> {
        Self::with_phase(frequency, 0.0)
    }

    /// `cos(2π·frequency·x + phase)`, the phase in radians.
    ///
    /// # Errors
    /// A frequency that is not positive and finite, a phase that is not finite.
    pub fn with_phase(frequency: f64, phase: f64) -> Result<Self> {
        let frequency = positive("the frequency of a tone", frequency)?;
        Ok(Self { frequency, phase: finite("the phase of a tone", phase)? })
    }

    fn turn(&self, x: f64) -> f64 {
        2.0 * self.frequency * x + self.phase / PI
    }
}

impl Signal for Cosine {
    fn at(&self, x: f64) -> f64 {
        cos_pi(self.turn(x))
    }
}

impl Differentiable for Cosine {
    fn slope(&self, x: f64) -> f64 {
        -2.0 * PI * self.frequency * sin_pi(self.turn(x))
    }
}

impl FourierPair for Cosine {
    fn spectrum(&self) -> Spectrum {
        let weight = 0.5 * Complex::cis(self.phase);
        Spectrum::zero()
            .plus_line(Impulse::new(self.frequency, weight))
            .plus_line(Impulse::new(-self.frequency, weight.conj()))
    }
}

/// `f(x) = sin(2πνx)` ↔ `−½i·δ(· − ν) + ½i·δ(· + ν)`; exactly zero at multiples of `1/(2ν)`.
///
/// ```
/// use nyquist::prelude::*;
/// let sine = Sine::new(1.5)?;
/// assert!((0..100).all(|k| sine.at(f64::from(k) / 3.0).abs() < 1e-13)); // critical samples see nothing (E08)
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sine {
    frequency: f64,
}

impl Sine {
    /// `sin(2π·frequency·x)`.
    ///
    /// # Errors
    /// A frequency that is not positive and finite.
    pub fn new(frequency: f64) -> Result<Self> {
        Ok(Self { frequency: positive("the frequency of a tone", frequency)? })
    }
}

impl Signal for Sine {
    fn at(&self, x: f64) -> f64 {
        sin_pi(2.0 * self.frequency * x)
    }
}

impl Differentiable for Sine {
    fn slope(&self, x: f64) -> f64 {
        2.0 * PI * self.frequency * cos_pi(2.0 * self.frequency * x)
    }
}

impl FourierPair for Sine {
    fn spectrum(&self) -> Spectrum {
        let half_i = Complex::new(0.0, 0.5);
        Spectrum::zero()
            .plus_line(Impulse::new(self.frequency, -half_i))
            .plus_line(Impulse::new(-self.frequency, half_i))
    }
}
