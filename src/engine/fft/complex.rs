//! Transforms of complex numbers: the plain sums.

use crate::engine::fft::butterflies::Butterflies;
use crate::engine::fft::core::Core;
use crate::engine::fft::rows::{Conjugates, Numbers};
use crate::engine::real::Real;
use crate::error::{Error, Result};
use num_complex::Complex;

/// A plan for `n` complex numbers, in either direction.
///
/// `Send + Sync`: any number of threads may use one plan. It keeps the memory that its transforms need, once for every
/// call that runs at the same time, and allocates no more after the first. From 2¹⁷ numbers on a transform uses all threads
/// of the current pool (lengths that are multiples of 16, and those with a prime factor above 4096).
///
/// ```
/// use nyquist::engine::fft::Fft;
/// use num_complex::Complex;
/// let plan = Fft::<f64>::new(4)?;
/// let turn = [1.0, 0.0, -1.0, 0.0].map(|re| Complex::new(re, 0.0)); // cos(2πj/4)
/// let (mut spectrum, mut back) = ([Complex::ZERO; 4], [Complex::ZERO; 4]);
/// plan.forward(&turn, &mut spectrum)?;
/// assert_eq!(spectrum.map(|z| z.re), [0.0, 2.0, 0.0, 2.0]); // frequencies 0, 1, −2, −1
/// plan.inverse(&spectrum, &mut back)?;
/// assert_eq!(back, turn.map(|z| 4.0 * z)); // not divided by n
/// # Ok::<(), nyquist::error::Error>(())
/// ```
#[derive(Debug)]
pub struct Fft<T>(Core<T>);

impl<T: Real> Fft<T> {
    /// A plan as fast as this processor can.
    ///
    /// # Errors
    /// An `n` of zero.
    pub fn new(n: usize) -> Result<Self> {
        Self::with(n, Butterflies::Fastest)
    }

    /// A plan of chosen butterflies.
    ///
    /// # Errors
    /// An `n` of zero.
    pub fn with(n: usize, butterflies: Butterflies) -> Result<Self> {
        at_least_one(n)?;
        Ok(Self(Core::new(n, n, butterflies)))
    }

    /// `X_k = Σ_j x_j e^{−2πijk/n}` for `0 ≤ k < n`.
    ///
    /// # Errors
    /// Slices of another length than `n`.
    pub fn forward(&self, input: &[Complex<T>], output: &mut [Complex<T>]) -> Result<()> {
        same(self.0.len(), input.len())?;
        same(self.0.len(), output.len())?;
        self.0.run_to(&Numbers(input), output);
        Ok(())
    }

    /// `x_j = Σ_k X_k e^{+2πijk/n}`, not divided by `n`.
    ///
    /// # Errors
    /// Slices of another length than `n`.
    pub fn inverse(&self, input: &[Complex<T>], output: &mut [Complex<T>]) -> Result<()> {
        same(self.0.len(), input.len())?;
        same(self.0.len(), output.len())?;
        self.0.run_to(&Conjugates(input), output);
        output.iter_mut().for_each(|z| *z = z.conj());
        Ok(())
    }
}

/// A transform has at least one value.
pub(super) fn at_least_one(n: usize) -> Result<()> {
    if n == 0 { Err(Error::TooFew { what: "values to transform", least: 1, got: 0 }) } else { Ok(()) }
}

/// As many values as the plan was made for.
pub(super) fn same(expected: usize, got: usize) -> Result<()> {
    if got == expected { Ok(()) } else { Err(Error::Length { what: "values of a transform", expected, got }) }
}
