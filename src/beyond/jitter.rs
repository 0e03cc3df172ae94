//! Combs whose spikes are displaced at random, and their power spectra.

use crate::error::{Error, Result, positive};
use crate::num::random::{bits, normal, uniform};
use crate::num::{cos_pi, sin_pi, sinc};
use crate::spectrum::{Impulse, Spectrum};
use num_complex::Complex;
use std::f64::consts::PI;

/// How the spikes of a comb are displaced; widths are in units of the step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Jitter {
    /// Not at all.
    None,
    /// Uniformly, within `width` steps around the spike; 1 is the whole cell.
    Uniform {
        /// The width `a` in steps.
        width: f64,
    },
    /// Normally.
    Gaussian {
        /// The standard deviation in steps.
        sigma: f64,
    },
    /// Positions that know nothing of the comb: uniform over the whole record.
    Independent,
}

/// A comb with displaced spikes: `T Σ_k δ(x − kT − ξ_k)`, the `ξ_k` independent and of one distribution with
/// characteristic function `φ(ν) = E e^{−2πiνξ}`.
///
/// Its power spectrum is `P(ν) = T[1 − |φ(ν)|²] + |φ(ν)|² Σ_k δ(ν − k/T)` (V10): the lines of the regular comb lose
/// `1 − |φ|²` of their weight, and a floor of noise takes it over. With jitter over the whole cell `φ = sinc(Tν)`, every
/// line but the one at zero is gone, and the floor starts as `(πTν)²T/3`. Frequencies here are in cycles per unit and
/// the sinc has its zeros at `k/T`; a popular book prints `sinc(Tω/2)` in angular units beside formulas in cycles
/// (E32). Balakrishnan 1962; Leneman 1966; Dippé and Wold, *Antialiasing through stochastic sampling*, 1985.
///
/// ```
/// use nyquist::prelude::*;
/// let comb = JitteredComb::new(1.0, Jitter::Uniform { width: 1.0 })?;
/// // the floor at the Nyquist frequency, at its zero, and no lines left but the one at zero
/// let floor = 1.0 - (2.0 / std::f64::consts::PI).powi(2); // 0.5947
/// assert!((comb.noise(0.5) - floor).abs() < 1e-15 && comb.noise(0.0) == 0.0);
/// assert_eq!(comb.power_spectrum(3)?.lines().len(), 1);
/// // positions are a pure function of the seed and the index
/// assert_eq!(comb.positions(7, 3)[..2], comb.positions(7, 2));
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct JitteredComb {
    step: f64,
    jitter: Jitter,
}

impl JitteredComb {
    /// The comb of that step with that jitter.
    ///
    /// # Errors
    /// A step, width or deviation that is not positive and finite.
    pub fn new(step: f64, jitter: Jitter) -> Result<Self> {
        positive("the step of a comb", step)?;
        match jitter {
            Jitter::Uniform { width } => positive("the width of the jitter", width)?,
            Jitter::Gaussian { sigma } => positive("the deviation of the jitter", sigma)?,
            Jitter::None | Jitter::Independent => 1.0,
        };
        Ok(Self { step, jitter })
    }

    /// The step `T`.
    pub fn step(&self) -> f64 {
        self.step
    }

    /// The jitter.
    pub fn jitter(&self) -> Jitter {
        self.jitter
    }

    /// The positions of spikes `0..n`, in the order of their indices, which need not be rising: a pure function of seed
    /// and index (and of `n` for [`Jitter::Independent`], whose positions fill `[0, nT)`).
    pub fn positions(&self, seed: u64, n: usize) -> Vec<f64> {
        let position = |k: u64| match self.jitter {
            Jitter::None => k as f64,
            Jitter::Uniform { width } => k as f64 + width * (uniform(seed, k, 0) - 0.5),
            Jitter::Gaussian { sigma } => k as f64 + sigma * normal(seed, k, 0),
            Jitter::Independent => n as f64 * uniform(seed, k, 0),
        };
        (0..n as u64).map(|k| self.step * position(k)).collect()
    }

    /// The characteristic function `φ(ν)` of the displacement, real since all of them are symmetric.
    pub fn characteristic(&self, nu: f64) -> f64 {
        let cycles = self.step * nu;
        match self.jitter {
            Jitter::None => 1.0,
            Jitter::Uniform { width } => sinc(width * cycles),
            Jitter::Gaussian { sigma } => (-2.0 * (PI * sigma * cycles).powi(2)).exp(),
            Jitter::Independent => f64::from(nu == 0.0),
        }
    }

    /// The floor `T[1 − φ(ν)²]` of the power spectrum.
    pub fn noise(&self, nu: f64) -> f64 {
        self.step * (1.0 - self.characteristic(nu).powi(2))
    }

    /// The power spectrum `P(ν)`: the floor as a density, and the lines `φ(k/T)²` for `|k| ≤ order`, those of weight
    /// zero left out.
    ///
    /// # Errors
    /// [`Error::Overflow`] for more than a million lines.
    pub fn power_spectrum(&self, order: u32) -> Result<Spectrum> {
        const MOST: u32 = 1_000_000;
        if order > MOST {
            let what = "the number of lines of a comb";
            return Err(Error::Overflow { what, value: order.into(), most: MOST.into() });
        }
        let line = |k: i64| {
            let at = k as f64 / self.step;
            // k itself, not step·(k/step): at whole numbers the sinc must be exactly zero
            let phi = Self { step: 1.0, ..*self }.characteristic(k as f64);
            Impulse::new(at, phi * phi)
        };
        let lines = (-i64::from(order)..=i64::from(order)).map(line).filter(|l| l.weight != Complex::ZERO);
        let comb = *self;
        let floor = Spectrum::decaying(f64::INFINITY, move |nu| comb.noise(nu).into());
        Ok(floor.plus(&Spectrum::of_lines(lines)?))
    }

    /// The periodogram `(T/n)|Σ_k e^{−2πiνx_k}|²` of `n` spikes at the frequencies `ν = m/(nT)`, `0 ≤ m ≤ n·order`,
    /// averaged over `patterns` patterns: pairs of frequency and power.
    ///
    /// Its expectation at these frequencies is [`JitteredComb::noise`], without leakage; at the multiples of `1/T` the
    /// line's weight stands on top, as a spike `nT` high and one bin `1/(nT)` wide. Away from the lines one pattern's
    /// power is about exponentially distributed, so that the mean over `R` patterns deviates by `P/√R`.
    ///
    /// ```
    /// use nyquist::prelude::*;
    /// let comb = JitteredComb::new(1.0, Jitter::Uniform { width: 1.0 })?;
    /// let [nu, power] = comb.mean_periodogram(1, 64, 1000, 1)[32];
    /// assert_eq!(nu, 0.5);
    /// assert!((power - comb.noise(0.5)).abs() < 4.0 * comb.noise(0.5) / 1000f64.sqrt());
    /// # Ok::<(), Error>(())
    /// ```
    pub fn mean_periodogram(&self, seed: u64, n: usize, patterns: u32, order: usize) -> Vec<[f64; 2]> {
        let span = n as f64 * self.step;
        let mut sums = vec![0.0; n * order + 1];
        let mut waves: Vec<Complex<f64>> = vec![Complex::ZERO; sums.len()];
        for pattern in 0..patterns {
            waves.fill(Complex::ZERO);
            for x in self.positions(Self::pattern_seed(seed, pattern), n) {
                let turn = 2.0 * (x / span);
                let (z, mut power) = (Complex::new(cos_pi(turn), -sin_pi(turn)), Complex::from(1.0));
                for wave in &mut waves {
                    *wave += power;
                    power *= z;
                }
            }
            sums.iter_mut().zip(&waves).for_each(|(sum, wave)| *sum += wave.norm_sqr());
        }
        let gain = self.step / (n as f64 * f64::from(patterns));
        sums.iter().zip(0..).map(|(sum, m)| [f64::from(m) / span, sum * gain]).collect()
    }

    /// The seed of one of many patterns.
    pub fn pattern_seed(seed: u64, pattern: u32) -> u64 {
        bits(seed, pattern.into(), u32::MAX)
    }
}
