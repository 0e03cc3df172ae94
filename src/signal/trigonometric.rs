//! Trigonometric polynomials: the band-limited signals of a period.

use crate::error::{Error, Result, finite, positive};
use crate::num::{cos_pi, sin_pi};
use crate::signal::{Differentiable, FourierPair, Signal};
use crate::spectrum::{Impulse, Spectrum};
use num_complex::Complex;
use std::f64::consts::PI;
use std::ops::Range;

/// `p(x) = Σ_{|k| ≤ K} c_k e^{2πik(x − a)/L}` with `c_{−k} = c̄_k`: a real signal of period `L` whose band is `K/L`, the
/// finite-dimensional cousin of the band-limited signals. It has `2K + 1` real coefficients, so that as many samples
/// determine it.
///
/// Evaluated by Horner's rule in `e^{2πi(x − a)/L}`, which lies on the unit circle: the rounding error is at most about
/// `2Kε·Σ|c_k|` beyond that of the argument.
///
/// ```
/// use num_complex::Complex;
/// use nyquist::prelude::*;
/// // 1 + 2 cos(2π(x − ½)/4): a constant and a line of weight 1 on either side
/// let p = TrigPolynomial::new(0.5..4.5, vec![Complex::from(1.0), Complex::from(1.0)])?;
/// assert_eq!((p.at(0.5), p.at(2.5), p.at(1.5 + 400.0)), (3.0, -1.0, 1.0));
/// assert_eq!((p.degree(), p.band()), (1, 0.25));
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct TrigPolynomial {
    start: f64,
    period: f64,
    coefficients: Vec<Complex<f64>>,
}

impl TrigPolynomial {
    /// The polynomial with coefficients `c_0, c_1, …, c_K`; the imaginary part of `c_0` must be zero.
    ///
    /// # Errors
    /// A range that is not finite and rising, no coefficients, or coefficients that are not finite.
    pub fn new(period: Range<f64>, coefficients: Vec<Complex<f64>>) -> Result<Self> {
        let (start, length) = rising("the start of a period", "the end of a period", &period)?;
        let Some(mean) = coefficients.first() else {
            return Err(Error::TooFew { what: "coefficients of a trigonometric polynomial", least: 1, got: 0 });
        };
        if mean.im != 0.0 {
            let what = "the imaginary part of the mean of a real signal";
            return Err(Error::OutOfRange { what, value: mean.im, low: 0.0, high: 0.0 });
        }
        match coefficients.iter().position(|c| !c.is_finite()) {
            Some(index) => {
                let what = "the coefficients of a trigonometric polynomial";
                Err(Error::NotFiniteAt { what, index, value: coefficients[index].norm() })
            }
            None => Ok(Self { start, period: length, coefficients }),
        }
    }

    /// From real coefficients in the orthonormal basis `1, √2 cos(2πu), √2 sin(2πu), √2 cos(4πu), …` with
    /// `u = (x − a)/L`: an odd number of them.
    pub(crate) fn of_real(start: f64, period: f64, real: &[f64]) -> Self {
        let half = std::f64::consts::FRAC_1_SQRT_2;
        let mut coefficients = vec![Complex::from(real[0])];
        coefficients.extend(real[1..].chunks_exact(2).map(|c| Complex::new(c[0] * half, -c[1] * half)));
        Self { start, period, coefficients }
    }

    /// The coefficients `c_0, …, c_K`; those of negative index are their conjugates.
    pub fn coefficients(&self) -> &[Complex<f64>] {
        &self.coefficients
    }

    /// The highest harmonic, `K`.
    pub fn degree(&self) -> usize {
        self.coefficients.len() - 1
    }

    /// The start of the period, `a`.
    pub fn start(&self) -> f64 {
        self.start
    }

    /// The length of the period, `L`.
    pub fn period(&self) -> f64 {
        self.period
    }

    /// The band limit `K/L`.
    pub fn band(&self) -> f64 {
        self.degree() as f64 / self.period
    }

    /// The root mean square over a period, by Parseval `√(Σ|c_k|²)`.
    pub fn rms(&self) -> f64 {
        let upper: f64 = self.coefficients[1..].iter().map(Complex::norm_sqr).sum();
        (self.coefficients[0].norm_sqr() + 2.0 * upper).sqrt()
    }

    /// The value where `e^{2πi(x − a)/L} = z`.
    pub(crate) fn at_turn(&self, z: Complex<f64>) -> f64 {
        horner(self.coefficients[1..].iter().copied(), self.coefficients[0].re, z)
    }

    /// `e^{2πi(x − a)/L}`.
    fn turn(&self, x: f64) -> Complex<f64> {
        let u = 2.0 * ((x - self.start) / self.period);
        Complex::new(cos_pi(u), sin_pi(u))
    }
}

/// `Re(c_0 + 2 Σ_{k ≥ 1} c_k z^k)`
fn horner(coefficients: impl DoubleEndedIterator<Item = Complex<f64>>, mean: f64, z: Complex<f64>) -> f64 {
    let upper: Complex<f64> = coefficients.rev().fold(Complex::ZERO, |sum, c| sum * z + c);
    mean + 2.0 * (upper * z).re
}

impl Signal for TrigPolynomial {
    fn at(&self, x: f64) -> f64 {
        self.at_turn(self.turn(x))
    }
}

impl Differentiable for TrigPolynomial {
    fn slope(&self, x: f64) -> f64 {
        let unit = Complex::new(0.0, 2.0 * PI / self.period);
        let derived = (1..self.coefficients.len()).map(|k| self.coefficients[k] * unit * k as f64);
        horner(derived, 0.0, self.turn(x))
    }
}

impl FourierPair for TrigPolynomial {
    fn spectrum(&self) -> Spectrum {
        let line = |k: i64| {
            let c = self.coefficients[k.unsigned_abs() as usize];
            let at = k as f64 / self.period;
            let shift = Complex::cis(-2.0 * PI * (at * self.start).rem_euclid(1.0));
            Impulse::new(at, if k < 0 { c.conj() } else { c } * shift)
        };
        let degree = self.degree() as i64;
        Spectrum::of_lines((-degree..=degree).map(line)).expect("finite coefficients make finite lines")
    }
}

/// The start and the length of a finite rising range.
pub(crate) fn rising(from: &'static str, to: &'static str, range: &Range<f64>) -> Result<(f64, f64)> {
    finite(from, range.start)?;
    finite(to, range.end)?;
    let length = positive("the length of a range", range.end - range.start)?;
    Ok((range.start, length))
}
