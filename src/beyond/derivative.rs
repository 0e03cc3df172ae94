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
/// use std::f64::consts::TAU;
/// // a tone at 0.45, sampled once a unit, and another one, with the same samples: the slopes tell them apart
/// let tone = TrigPolynomial::new(0.0..20.0, { let mut c = vec![0.0.into(); 10]; c[9] = 0.5.into(); c })?;
/// let alias = TrigPolynomial::new(0.0..20.0, { let mut c = vec![0.0.into(); 12]; c[11] = 0.5.into(); c })?;
/// let axis = Axis::nodes(-2000.0..2000.0, 4000)?;
/// let (tone, alias) = (DerivativeSamples::of(&tone, axis), DerivativeSamples::of(&alias, axis));
/// assert!((tone.values()[7] - alias.values()[7]).abs() < 1e-12);
/// // the terms beyond ±2000 decay as 1/x²·x, and alternate
/// assert!((tone.at(0.5) - (0.45 * 0.5 * TAU).cos()).abs() < 1e-3);
/// assert!((alias.at(0.5) - (0.55 * 0.5 * TAU).cos()).abs() < 1e-3);
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
