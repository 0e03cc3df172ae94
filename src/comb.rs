//! The Dirac comb: sampling as a product.

use crate::axis::Axis;
use crate::error::{Error, Result, finite, positive};
use crate::num::{cos_pi, sin_pi};
use crate::sampled::Samples;
use crate::signal::Signal;
use crate::spectrum::{Impulse, Spectrum};
use num_complex::Complex;
use std::ops::RangeInclusive;

/// The Dirac comb `Ш_T(x) = T Σ_i δ(x − iT)`, possibly shifted: weights, never tall samples.
///
/// With the factor `T` in front its mean is 1, and its transform is the comb of weight 1: `Σ_k δ(ν − k/T)`. (The
/// lecture's table prints `(1/T) Σ δ(ω − k/T)`, which is right only for `T = 1`, E02.)
///
/// ```
/// use nyquist::prelude::*;
/// let comb = Comb::new(0.5)?;
/// let weights: Vec<_> = comb.times(&Constant::new(3.0)?, 0..=2).iter().map(|i| (i.at, i.weight.re)).collect();
/// assert_eq!(weights, [(0.0, 1.5), (0.5, 1.5), (1.0, 1.5)]); // T·f(iT)
/// assert_eq!(comb.line(3), Impulse::new(6.0, 1.0)); // k/T, weight 1
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Comb {
    step: f64,
    offset: f64,
}

impl Comb {
    /// Impulses at the multiples of `step`.
    ///
    /// # Errors
    /// A step that is not positive and finite.
    pub fn new(step: f64) -> Result<Self> {
        Ok(Self { step: positive("the step of a comb", step)?, offset: 0.0 })
    }

    /// The comb moved to the right by `offset`.
    ///
    /// # Errors
    /// An offset that is not finite.
    pub fn shifted(self, offset: f64) -> Result<Self> {
        Ok(Self { offset: self.offset + finite("the offset of a comb", offset)?, ..self })
    }

    /// The distance between impulses, `T`.
    pub fn step(&self) -> f64 {
        self.step
    }

    /// Impulses per unit, `1/T`.
    pub fn rate(&self) -> f64 {
        1.0 / self.step
    }

    /// The axis of the impulses with numbers `from` to `to`.
    ///
    /// # Errors
    /// No numbers in the range, or too many.
    pub fn axis(&self, numbers: RangeInclusive<i64>) -> Result<Axis> {
        let (from, to) = numbers.into_inner();
        if to < from {
            return Err(Error::TooFew { what: "impulses of a comb", least: 1, got: 0 });
        }
        let len = usize::try_from(to.abs_diff(from)).unwrap_or(usize::MAX).saturating_add(1);
        Axis::new(self.offset + from as f64 * self.step, self.step, len)
    }

    /// `Ш_T·f`: impulses of weight `T·f(iT)` for the given numbers `i`; none for an empty range.
    pub fn times(&self, signal: &impl Signal, numbers: RangeInclusive<i64>) -> Vec<Impulse> {
        let at = |i: i64| self.offset + i as f64 * self.step;
        numbers.map(|i| Impulse::new(at(i), self.step * signal.at(at(i)))).collect()
    }

    /// The line `k` of its transform: at `k/T`, of weight 1, turned by the comb's offset.
    pub fn line(&self, k: i64) -> Impulse {
        let nu = k as f64 / self.step;
        let turns = 2.0 * k as f64 * (self.offset / self.step);
        Impulse::new(nu, Complex::new(cos_pi(turns), -sin_pi(turns)))
    }

    /// The lines `−order … order` of its transform; at most 2²⁰ to either side.
    pub fn spectrum(&self, order: usize) -> Spectrum {
        let order = order.min(1 << 20) as i64;
        Spectrum::from_lines((-order..=order).map(|k| self.line(k)).collect())
    }
}

/// The samples whose weights are `T` times these values: [`Comb::times`] without the factor, on an axis.
///
/// # Errors
/// No numbers in the range, or too many.
pub fn sample(signal: &impl Signal, comb: Comb, numbers: RangeInclusive<i64>) -> Result<Samples> {
    Ok(Samples::of(signal, comb.axis(numbers)?))
}
