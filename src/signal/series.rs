//! Fourier series: partial sums of the square, saw and triangle waves.

use crate::error::{Error, Result, positive};
use crate::num::sin_pi;
use crate::signal::{FourierPair, Signal};
use crate::spectrum::{Impulse, Spectrum};
use num_complex::Complex;
use std::f64::consts::PI;

/// The waves of the series, all odd, of amplitude 1 and period 1.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Wave {
    /// +1 in the first half period, −1 in the second: `(4/π) Σ sin(2π(2k−1)x)/(2k−1)`.
    Square,
    /// `2x` up to the jump at ½: `(2/π) Σ (−1)^{k+1} sin(2πkx)/k`.
    Saw,
    /// `4x` up to the corner at ¼: `(8/π²) Σ (−1)^{k+1} sin(2π(2k−1)x)/(2k−1)²`.
    Triangle,
}

impl Wave {
    /// Harmonic number and amplitude of the `k`-th nonzero term, `k ≥ 1`.
    ///
    /// ```
    /// use nyquist::signal::series::Wave;
    /// assert_eq!(Wave::Square.term(8), (15, 4.0 / (15.0 * std::f64::consts::PI)));
    /// ```
    pub fn term(self, k: u32) -> (u32, f64) {
        let sign = if k % 2 == 1 { 1.0 } else { -1.0 };
        match self {
            Self::Square => (2 * k - 1, 4.0 / (PI * f64::from(2 * k - 1))),
            Self::Saw => (k, sign * 2.0 / (PI * f64::from(k))),
            Self::Triangle => (2 * k - 1, sign * 8.0 / (PI * f64::from(2 * k - 1)).powi(2)),
        }
    }
}

impl Signal for Wave {
    /// The wave itself; at a jump the mean of both sides, zero.
    fn at(&self, x: f64) -> f64 {
        let phase = x - x.round(); // −½ … ½
        match self {
            Self::Square if phase == 0.0 || phase.abs() == 0.5 => 0.0,
            Self::Square => phase.signum(),
            Self::Saw if phase.abs() == 0.5 => 0.0,
            Self::Saw => 2.0 * phase,
            Self::Triangle => phase.signum() * (1.0 - (4.0 * phase.abs() - 1.0).abs()),
        }
    }
}

/// The first `terms` nonzero terms of a wave's Fourier series, with fundamental frequency `frequency`.
///
/// The lecture's slide shows 1, 2, 3 and 8 terms of the square wave and labels them "f + 3f + 5f …": the amplitudes
/// `1/(2k−1)` and the factor `4/π` belong there, or the sum is no square wave (E16). The partial sums overshoot the
/// jump by 8.949 % of its size however many terms there are (Wilbraham 1848, Gibbs 1899).
///
/// ```
/// use nyquist::prelude::*;
/// let eight = PartialSum::new(Wave::Square, 8, 1.0)?;
/// assert!((eight.at(1.0 / 32.0) - 1.180284).abs() < 1e-6);
/// assert_eq!(eight.spectrum().band(), 15.0);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PartialSum {
    wave: Wave,
    terms: u32,
    frequency: f64,
}

impl PartialSum {
    /// The first `terms` nonzero terms.
    ///
    /// # Errors
    /// No terms, or a frequency that is not positive and finite.
    pub fn new(wave: Wave, terms: u32, frequency: f64) -> Result<Self> {
        if terms == 0 {
            return Err(Error::TooFew { what: "terms of a Fourier series", least: 1, got: 0 });
        }
        Ok(Self { wave, terms, frequency: positive("the frequency of a wave", frequency)? })
    }

    fn terms(&self) -> impl Iterator<Item = (f64, f64)> + '_ {
        (1..=self.terms).map(|k| {
            let (harmonic, amplitude) = self.wave.term(k);
            (f64::from(harmonic) * self.frequency, amplitude)
        })
    }
}

impl Signal for PartialSum {
    fn at(&self, x: f64) -> f64 {
        self.terms().map(|(frequency, amplitude)| amplitude * sin_pi(2.0 * frequency * x)).sum()
    }
}

impl FourierPair for PartialSum {
    fn spectrum(&self) -> Spectrum {
        let pair = |(frequency, amplitude): (f64, f64)| {
            let weight = Complex::new(0.0, 0.5 * amplitude);
            [Impulse::new(frequency, -weight), Impulse::new(-frequency, weight)]
        };
        Spectrum::from_lines(self.terms().flat_map(pair).collect())
    }
}
