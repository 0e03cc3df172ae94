//! Two interlaced combs, each at half the Nyquist rate.

use crate::axis::Axis;
use crate::error::{Error, Result, all_finite, finite};
use crate::num::{sin_pi, sinc};
use crate::signal::Signal;

/// Interlaced (bunched) sampling: two combs at `kT` and `kT + aT`, each of rate `B`, determine a signal of band `B = 1/T`
/// for every offset `0 < a < 1`, however small (V22):
///
/// `f(x) = Σ_k f(kT) ψ_a(x/T − k) + f(kT + aT) ψ_{−a}(x/T − k − a)`, `ψ_a(t) = sinc(t)·sin(π(a − t))/sin(πa)`.
///
/// `ψ_a` is one at zero, and zero at the other integers and at all `k + a`; it is `sin·sin/t`, hence of band 1. The price
/// of bunching is noise, see [`Interlaced::noise_gain`]. With `a = ½` it is uniform sampling at `2B`. Yen, *On nonuniform
/// sampling of bandwidth-limited signals*, 1956; Papoulis 1977.
///
/// ```
/// use nyquist::prelude::*;
/// // a band of 0.9, sampled in pairs 0.1 apart, one pair a unit
/// let f = from_fn(|x| nyquist::num::sinc(0.45 * x).powi(4));
/// let pairs = Interlaced::of(&f, Axis::nodes(-500.0..500.0, 1000)?, 0.1)?;
/// assert!((pairs.at(0.6) - f.at(0.6)).abs() < 1e-9);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Interlaced {
    axis: Axis,
    offset: f64,
    first: Vec<f64>,
    second: Vec<f64>,
}

impl Interlaced {
    /// Values at the positions of `axis`, and at those shifted by `offset` steps.
    ///
    /// # Errors
    /// An offset that is not strictly between 0 and 1; numbers of values that differ from the axis' positions; values
    /// that are not finite.
    pub fn new(axis: Axis, offset: f64, first: Vec<f64>, second: Vec<f64>) -> Result<Self> {
        check(offset)?;
        for (what, given) in [("values of the first comb", &first), ("values of the second comb", &second)] {
            if given.len() != axis.len() {
                return Err(Error::Length { what, expected: axis.len(), got: given.len() });
            }
            all_finite(what, given)?;
        }
        Ok(Self { axis, offset, first, second })
    }

    /// Interlaced samples of a signal.
    ///
    /// # Errors
    /// An offset that is not strictly between 0 and 1.
    pub fn of(signal: &impl Signal, axis: Axis, offset: f64) -> Result<Self> {
        check(offset)?;
        let shift = offset * axis.step();
        let (first, second) = axis.iter().map(|x| (signal.at(x), signal.at(x + shift))).unzip();
        Ok(Self { axis, offset, first, second })
    }

    /// The axis of the first comb.
    pub fn axis(&self) -> Axis {
        self.axis
    }

    /// By how many steps the second comb is shifted, `a`.
    pub fn offset(&self) -> f64 {
        self.offset
    }

    /// All positions and values, in order.
    pub fn points(&self) -> impl Iterator<Item = [f64; 2]> + '_ {
        let shift = self.offset * self.axis.step();
        let pairs = self.axis.iter().zip(self.first.iter().zip(&self.second));
        pairs.flat_map(move |(x, (&f, &g))| [[x, f], [x + shift, g]])
    }

    /// The band that they determine: the rate `1/T` of either comb.
    pub fn band(&self) -> f64 {
        self.axis.rate()
    }

    /// The mean power of the reconstruction's error where every sample has an independent error of power one:
    /// `1/sin²(πa)`, since `∫ψ_a² = ½/sin²(πa)` for either kernel. One for `a = ½`, and 1014 for `a = 0.01`.
    pub fn noise_gain(&self) -> f64 {
        sin_pi(self.offset).powi(2).recip()
    }

    /// The kernel `ψ_a(t)` of the first comb; that of the second is `ψ_{−a}`, which is `ψ_a(−t)`.
    ///
    /// ```
    /// use nyquist::beyond::Interlaced;
    /// let at = |t| Interlaced::kernel(t, 0.25);
    /// assert_eq!([at(0.0), at(1.0), at(0.25), at(-0.75)], [1.0, 0.0, 0.0, 0.0]);
    /// ```
    pub fn kernel(t: f64, offset: f64) -> f64 {
        sinc(t) * sin_pi(offset - t) / sin_pi(offset)
    }
}

fn check(offset: f64) -> Result<()> {
    finite("the offset of the second comb", offset)?;
    if offset > 0.0 && offset < 1.0 {
        return Ok(());
    }
    Err(Error::OutOfRange { what: "the offset of the second comb, in steps,", value: offset, low: 0.0, high: 1.0 })
}

impl Signal for Interlaced {
    fn at(&self, x: f64) -> f64 {
        let t = self.axis.index_of(x);
        let term = |(k, (f, g)): (usize, (&f64, &f64))| {
            let t = t - k as f64;
            f * Self::kernel(t, self.offset) + g * Self::kernel(t - self.offset, -self.offset)
        };
        self.first.iter().zip(&self.second).enumerate().map(term).sum()
    }
}
