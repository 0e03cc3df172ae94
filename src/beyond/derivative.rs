//! Values and slopes at half the Nyquist rate.

use crate::axis::Axis;
use crate::error::{Error, Result, all_finite};
use crate::num::sinc;
use crate::signal::{Differentiable, Signal};

/// Derivative sampling: values *and slopes* at rate `B` determine a signal of band `B`, each at half the Nyquist rate
/// (V22):
///
/// `f(x) = Σ_k [f(kT) + (x − kT) f′(kT)] sinc²(x/T − k)`, `T = 1/B`.
///
/// The kernel `sinc²` is one at its node and zero at the others with zero slope at all of them, and `(x − kT) sinc²`
/// has slope one at its node. Both have the band `1/T`. Exact for infinitely many samples; those beyond a record are
/// missed by its tail. Jagerman and Fogel, *Some general aspects of the sampling theorem*, 1956; Papoulis, *Generalized
/// sampling expansion*, 1977.
///
/// ```
/// use nyquist::prelude::*;
/// // at rate 1 the values of a raised cosine of band 1 are 1 at zero and 0 elsewhere: those of sinc(x), which is 2/π at ½
/// let rc = RaisedCosine::new(1.0)?;
/// let samples = DerivativeSamples::of(&rc, Axis::centered(1.0, 2001)?);
/// assert!(samples.values().iter().filter(|v| v.abs() > 1e-15).count() == 1);
/// // the slopes tell the two apart
/// assert!((samples.at(0.5) - 0.5).abs() < 1e-9);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct DerivativeSamples {
    axis: Axis,
    values: Vec<f64>,
    slopes: Vec<f64>,
}

impl DerivativeSamples {
    /// Values and slopes on an axis.
    ///
    /// # Errors
    /// Numbers of them that differ from the axis' positions; ones that are not finite.
    pub fn new(axis: Axis, values: Vec<f64>, slopes: Vec<f64>) -> Result<Self> {
        for (what, given) in [("values on an axis", &values), ("slopes on an axis", &slopes)] {
            if given.len() != axis.len() {
                return Err(Error::Length { what, expected: axis.len(), got: given.len() });
            }
            all_finite(what, given)?;
        }
        Ok(Self { axis, values, slopes })
    }

    /// The values and slopes of a signal.
    pub fn of(signal: &impl Differentiable, axis: Axis) -> Self {
        let (values, slopes) = axis.iter().map(|x| (signal.at(x), signal.slope(x))).unzip();
        Self { axis, values, slopes }
    }

    /// Where they were taken.
    pub fn axis(&self) -> Axis {
        self.axis
    }

    /// The values `f(x_k)`.
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// The slopes `f′(x_k)`.
    pub fn slopes(&self) -> &[f64] {
        &self.slopes
    }

    /// The band that they determine: the whole rate, not half of it.
    pub fn band(&self) -> f64 {
        self.axis.rate()
    }
}

impl Signal for DerivativeSamples {
    fn at(&self, x: f64) -> f64 {
        let t = self.axis.index_of(x);
        let step = self.axis.step();
        let term = |(k, (value, slope)): (usize, (&f64, &f64))| {
            let t = t - k as f64;
            let kernel = sinc(t);
            (value + t * step * slope) * kernel * kernel
        };
        self.values.iter().zip(&self.slopes).enumerate().map(term).sum()
    }
}
