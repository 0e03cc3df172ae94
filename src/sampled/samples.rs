//! Samples: an axis and the values on it.

use crate::axis::Axis;
use crate::error::{Error, Result, all_finite};
use crate::signal::Signal;

/// A sampled signal: values on an [`Axis`].
///
/// ```
/// use nyquist::prelude::*;
/// let samples = Samples::of(&from_fn(|x| x * x), Axis::nodes(0.0..2.0, 4)?);
/// assert_eq!(samples.values(), [0.0, 0.25, 1.0, 2.25]);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Samples {
    axis: Axis,
    values: Vec<f64>,
}

impl Samples {
    /// Values on an axis.
    ///
    /// # Errors
    /// A number of values other than the axis has positions; values that are not finite.
    pub fn new(axis: Axis, values: Vec<f64>) -> Result<Self> {
        if values.len() != axis.len() {
            return Err(Error::Length { what: "samples on an axis", expected: axis.len(), got: values.len() });
        }
        all_finite("samples", &values)?;
        Ok(Self { axis, values })
    }

    /// The samples `f(x_i)` of a signal: the upper arrow of the square.
    pub fn of(signal: &impl Signal, axis: Axis) -> Self {
        Self { axis, values: axis.iter().map(|x| signal.at(x)).collect() }
    }

    /// Values that are known to fit and to be finite.
    pub(crate) fn trusted(axis: Axis, values: Vec<f64>) -> Self {
        debug_assert_eq!(axis.len(), values.len());
        Self { axis, values }
    }

    /// Where the samples are.
    pub fn axis(&self) -> Axis {
        self.axis
    }

    /// The values.
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// Positions and values, in order.
    pub fn points(&self) -> impl ExactSizeIterator<Item = [f64; 2]> + '_ {
        self.axis.iter().zip(&self.values).map(|(x, &v)| [x, v])
    }

    /// Every `n`-th sample, the first among them: the rate lowered without a filter, so that whatever stands above the
    /// new Nyquist frequency folds.
    ///
    /// ```
    /// use nyquist::prelude::*;
    /// let samples = Samples::new(Axis::new(0.0, 0.5, 5)?, vec![1.0, 2.0, 3.0, 4.0, 5.0])?;
    /// let half = samples.decimated(2)?;
    /// assert_eq!((half.axis().step(), half.values()), (1.0, &[1.0, 3.0, 5.0][..]));
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    /// An `n` of zero; a step that overflows.
    pub fn decimated(&self, n: usize) -> Result<Self> {
        if n == 0 {
            return Err(Error::TooFew { what: "samples to take one of", least: 1, got: 0 });
        }
        let values: Vec<f64> = self.values.iter().step_by(n).copied().collect();
        let axis = Axis::new(self.axis.start(), self.axis.step() * n as f64, values.len())?;
        Ok(Self { axis: axis.in_unit(self.axis.unit()), values })
    }
}
