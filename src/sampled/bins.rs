//! Bins: the discrete spectrum of samples.

use crate::axis::Axis;
use crate::error::{Error, Result, positive};
use crate::spectrum::low_pass;
use num_complex::Complex;

/// Samples of a spectrum: `F(ν_k)` at the frequencies of [`Bins::axis`], which rise and have zero at index `n/2`.
///
/// Bins keep the axis of the samples that they came from, in space: the frequency axis is its [dual](Axis::dual), so
/// the two can never disagree, and the way back is known.
#[derive(Debug, Clone, PartialEq)]
pub struct Bins {
    space: Axis,
    values: Vec<Complex<f64>>,
}

impl Bins {
    /// Values of the spectrum of samples on `space`.
    ///
    /// # Errors
    /// A number of values other than the axis has positions; values that are not finite.
    pub fn new(space: Axis, values: Vec<Complex<f64>>) -> Result<Self> {
        if values.len() != space.len() {
            return Err(Error::Length { what: "bins on an axis", expected: space.len(), got: values.len() });
        }
        match values.iter().position(|v| !v.is_finite()) {
            Some(index) => Err(Error::NotFiniteAt { what: "bins", index, value: values[index].norm() }),
            None => Ok(Self { space, values }),
        }
    }

    /// Values that are known to fit.
    pub(crate) fn trusted(space: Axis, values: Vec<Complex<f64>>) -> Self {
        debug_assert_eq!(space.len(), values.len());
        Self { space, values }
    }

    /// The values alone.
    pub(crate) fn into_values(self) -> Vec<Complex<f64>> {
        self.values
    }

    /// The axis of the samples in space.
    pub fn space(&self) -> Axis {
        self.space
    }

    /// The frequencies of the bins.
    pub fn axis(&self) -> Axis {
        self.space.dual()
    }

    /// The values `F(ν_k)`.
    pub fn values(&self) -> &[Complex<f64>] {
        &self.values
    }

    /// Frequencies and magnitudes `|F(ν_k)|`, in order.
    pub fn magnitudes(&self) -> impl ExactSizeIterator<Item = [f64; 2]> + '_ {
        self.axis().iter().zip(&self.values).map(|(nu, v)| [nu, v.norm()])
    }

    /// The bin nearest to frequency `nu`, modulo the sampling rate.
    ///
    /// ```
    /// use nyquist::prelude::*;
    /// let bins = forward(&Samples::of(&Cosine::new(2.0)?, Axis::nodes(0.0..1.0, 8)?));
    /// assert!((bins.near(2.0).re - 0.5).abs() < 1e-15); // the line's weight times the record's length
    /// # Ok::<(), Error>(())
    /// ```
    pub fn near(&self, nu: f64) -> Complex<f64> {
        let k = self.axis().index_of(nu).round() as i64;
        self.values[k.rem_euclid(self.values.len() as i64) as usize]
    }

    /// The bins after the ideal low-pass: kept below `cutoff`, halved exactly at it, zero above. With [`inverse`] it is
    /// the digital prefilter that a lower rate asks for; the record is taken to be periodic.
    ///
    /// ```
    /// use nyquist::prelude::*;
    /// let both = Sum(Cosine::new(1.0)?, Cosine::new(3.0)?);
    /// let axis = Axis::nodes(0.0..1.0, 16)?;
    /// let low = inverse(&forward(&Samples::of(&both, axis)).low_passed(2.0)?);
    /// let slow = Samples::of(&Cosine::new(1.0)?, axis);
    /// assert!(low.values().iter().zip(slow.values()).all(|(a, b)| (a - b).abs() < 1e-15));
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// [`inverse`]: crate::sampled::dft::inverse
    ///
    /// # Errors
    /// A cut-off that is not positive and finite.
    pub fn low_passed(&self, cutoff: f64) -> Result<Self> {
        positive("the cut-off frequency", cutoff)?;
        let passed = self.axis().iter().zip(&self.values).map(|(nu, v)| v * low_pass(nu, cutoff));
        Ok(Self::trusted(self.space, passed.collect()))
    }
}
