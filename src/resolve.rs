//! How many samples a function needs, found out by sampling it.

use crate::axis::Axis;
use crate::error::{Error, Result, within};
use crate::num::{cos_pi, sin_pi};
use crate::sampled::Samples;
use crate::sampled::dft::{dft, inverse_dft};
use crate::signal::trigonometric::{TrigPolynomial, rising};
use crate::signal::{FourierPair, Signal};
use crate::spectrum::Spectrum;
use num_complex::Complex;
use std::f64::consts::PI;
use std::ops::Range;

/// The grid to begin with.
const LEAST: usize = 128;
/// The finest grid that [`resolve`] tries.
const MOST: usize = 1 << 20;
/// How many points off the grid a result is tried at. A Fibonacci number: so many multiples of the golden ratio leave
/// no gap wider than `φ²/√5/610 = 0.0019` of the interval.
const FRESH: u32 = 610;
/// Over which part of the interval at either end a pulse must have decayed.
const MARGIN: usize = 16;

/// What [`resolve`] found.
#[derive(Debug, Clone, PartialEq)]
pub enum Resolution {
    /// The function is band-limited to the tolerance: here it is.
    Resolved(Resolved),
    /// The ends of the interval do not meet: the function is neither periodic on it nor has it decayed, so that its
    /// periodic continuation jumps and no rate suffices.
    Open {
        /// `|f(b) − f(a)|`.
        jump: f64,
    },
    /// The spectrum has not dropped to the tolerance: a jump, a kink, a singularity, or noise.
    Unresolved {
        /// How many samples the finest grid had.
        samples: usize,
        /// What is left in the upper half of its spectrum: the sum `Σ|c_k|` over `|k| > n/4`, relative to the largest
        /// value; this tolerance it would have met.
        level: f64,
    },
}

/// How a resolved function continues beyond its interval.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ends {
    /// Periodically.
    Periodic,
    /// With nothing: over the outer sixteenth of the interval at either end it is below the tolerance.
    Decayed,
}

/// A function known by the least number of samples that determine it: again a [`Signal`], now with a spectrum.
#[derive(Debug, Clone, PartialEq)]
pub struct Resolved {
    polynomial: TrigPolynomial,
    samples: Samples,
    ends: Ends,
    scale: f64,
    deviation: f64,
}

/// Samples `signal` on ever finer grids of the half-open `interval` until its spectrum has dropped to `tolerance` (of
/// its largest value), and returns it as the shortest trigonometric polynomial that is that near to it; or says why
/// there is none.
///
/// What is accepted. On a grid of `n` points let `c_k` be the discrete Fourier coefficients. The band ends at the least
/// `K` with `Σ_{|k| > K} |c_k| ≤ tolerance·max|f|`, where coefficients below the rounding of `f` itself (of its values
/// and of its argument) count as zero. It is accepted if `K ≤ n/4`, so that half of the spectrum is a plateau of
/// nothing, and if the polynomial agrees with `f` within twice the tolerance, plus four times the rounding of `f`, at 610
/// fresh points at irrational places. Where that rounding itself exceeds the tolerance (far from zero the argument has
/// lost the digits that matter) the function is not resolved, and the level says to what.
/// The plateau makes sure that a jump of `h` is never resolved at a tolerance below `0.22 h/max|f|` (its coefficients
/// are `h/2π|k|`, and `Σ_{n/4 < |k| ≤ n/2}` of those is `(h/π) ln 2`); the fresh points, that a tone above the grid's
/// Nyquist frequency is not taken for its alias, nor a tone that vanishes on the grid for nothing. A spike narrower
/// than 0.2 % of the interval can fall through both: no finite number of samples excludes it.
///
/// The idea of a plateau is chebfun's (Aurentz and Trefethen, *Chopping a Chebyshev series*, 2017); the criterion is
/// not: an absolute sum, because the sum bounds the error made by cutting there.
///
/// A function that decays within the interval is a pulse; [`Ends`] says how it was understood. The values at the
/// interval's two ends must agree to the tolerance.
///
/// ```
/// use nyquist::prelude::*;
/// // sin(400πx) is 200 cycles: 401 samples, and not one more
/// let fast = from_fn(|x: f64| (400.0 * std::f64::consts::PI * x).sin());
/// let Resolution::Resolved(fast) = resolve(&fast, 0.0..1.0, 1e-12)? else { panic!() };
/// assert_eq!((fast.band(), fast.samples().values().len()), (200.0, 401));
/// // a jump never is resolved
/// let step = from_fn(|x: f64| f64::from(x < 0.3));
/// assert!(matches!(resolve_up_to(&step, 0.0..1.0, 1e-3, 4096)?, Resolution::Open { .. }));
/// let pulse = from_fn(|x: f64| f64::from((x - 0.5).abs() < 0.3));
/// assert!(matches!(resolve_up_to(&pulse, 0.0..1.0, 1e-3, 4096)?, Resolution::Unresolved { samples: 4096, .. }));
/// # Ok::<(), Error>(())
/// ```
///
/// # Errors
/// An interval that is not finite and rising; a tolerance outside `16ε ..= 0.1`; values of the function that are not
/// finite.
pub fn resolve(signal: &impl Signal, interval: Range<f64>, tolerance: f64) -> Result<Resolution> {
    resolve_up_to(signal, interval, tolerance, MOST)
}

/// [`resolve`] with a given finest grid instead of 2²⁰ points; rounded up to a power of two, and to 128 at least.
///
/// # Errors
/// As [`resolve`]; a grid of more than 2²⁶ points.
pub fn resolve_up_to(signal: &impl Signal, interval: Range<f64>, tolerance: f64, most: usize) -> Result<Resolution> {
    let (start, period) = rising("the start of the interval", "the end of the interval", &interval)?;
    within("the tolerance", tolerance, 16.0 * f64::EPSILON, 0.1)?;
    let limit = 1 << 26;
    if most > limit {
        let what = "the number of samples to try";
        return Err(Error::Overflow { what, value: most as f64, most: limit as f64 });
    }
    let most = most.max(LEAST).next_power_of_two();
    let reach = interval.start.abs().max(interval.end.abs());
    let search = Search { signal, start, period, reach, tolerance };

    let fresh = (1..=FRESH).map(|j| search.value((f64::from(j) * GOLDEN).fract())).collect::<Result<Vec<_>>>()?;
    let jump = (search.value(1.0)? - search.value(0.0)?).abs();
    let mut values = (0..LEAST).map(|j| search.value(j as f64 / LEAST as f64)).collect::<Result<Vec<_>>>()?;
    loop {
        let n = values.len();
        let scale = values.iter().chain(&fresh).fold(0.0, |scale: f64, v| scale.max(v.abs()));
        // no function that `most` samples resolve can change more than this between x and its neighbouring number
        let argument = f64::EPSILON * reach * PI * most as f64 / period * scale;
        if jump > tolerance * scale + argument {
            return Ok(Resolution::Open { jump });
        }
        let coefficients = half_spectrum(&values)?;
        let rounding = search.rounding(&coefficients, scale, n);
        let kept = chop(&coefficients, tolerance * scale, 3.0 * rounding / (n as f64).sqrt());
        if 4 * kept <= n {
            if rounding > tolerance * scale {
                // the argument's own rounding hides what the tolerance asks for: a finer grid would not show it either
                return Ok(Resolution::Unresolved { samples: n, level: rounding / scale });
            }
            let polynomial = TrigPolynomial::new(interval.clone(), coefficients[..=kept].to_vec())?;
            let deviation = search.deviation(&polynomial, &fresh);
            if deviation <= 2.0 * tolerance * scale + 4.0 * rounding {
                let ends = search.ends(&values, scale);
                return Resolved::new(polynomial, ends, scale, deviation).map(Resolution::Resolved);
            }
        }
        if 2 * n > most {
            let left: f64 = coefficients[n / 4 + 1..].iter().map(|c| 2.0 * c.norm()).sum();
            return Ok(Resolution::Unresolved { samples: n, level: left / scale });
        }
        values = search.refined(&values)?;
    }
}

/// `(√5 − 1)/2`: of all numbers the one whose multiples avoid all simple fractions best.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

struct Search<'a, S> {
    signal: &'a S,
    start: f64,
    period: f64,
    reach: f64,
    tolerance: f64,
}

impl<S: Signal> Search<'_, S> {
    /// `f` at the fraction `u` of the interval.
    fn value(&self, u: f64) -> Result<f64> {
        let value = self.signal.at(self.start + self.period * u);
        crate::error::finite("a value of the function to resolve", value)
    }

    /// The values on the grid twice as fine.
    fn refined(&self, values: &[f64]) -> Result<Vec<f64>> {
        let n = 2 * values.len();
        let mut finer = Vec::with_capacity(n);
        for (j, &value) in values.iter().enumerate() {
            finer.extend([value, self.value((2 * j + 1) as f64 / n as f64)?]);
        }
        Ok(finer)
    }

    /// How far rounding moves a value: `ε·log₂n` of the largest by the transform, and `ε·|x|·max|f′|` by the rounding
    /// of the argument, with `max|f′| ≤ Σ 2π|k|/L·|c_k|`.
    fn rounding(&self, coefficients: &[Complex<f64>], scale: f64, n: usize) -> f64 {
        let slope: f64 = coefficients.iter().enumerate().map(|(k, c)| 2.0 * k as f64 * c.norm()).sum();
        f64::EPSILON * (f64::from(n.ilog2()) * scale + self.reach * 2.0 * PI / self.period * slope)
    }

    /// The largest difference at the fresh points.
    fn deviation(&self, polynomial: &TrigPolynomial, fresh: &[f64]) -> f64 {
        let difference = |(j, value): (u32, &f64)| {
            // the turn of the fraction itself, so that only f suffers from the rounding of its argument
            let u = 2.0 * (f64::from(j) * GOLDEN).fract();
            (polynomial.at_turn(Complex::new(cos_pi(u), sin_pi(u))) - value).abs()
        };
        (1..).zip(fresh).map(difference).fold(0.0, f64::max)
    }

    fn ends(&self, values: &[f64], scale: f64) -> Ends {
        let margin = values.len() / MARGIN;
        let outer = values[..margin].iter().chain(&values[values.len() - margin..]);
        let decayed = outer.fold(0.0, |most: f64, v| most.max(v.abs())) <= self.tolerance * scale;
        if decayed { Ends::Decayed } else { Ends::Periodic }
    }
}

/// The coefficients `c_0, …, c_{n/2 − 1}`; the one at `n/2`, which belongs half to `−n/2`, is left out as its halves
/// cannot be told from each other, and counts for the last.
fn half_spectrum(values: &[f64]) -> Result<Vec<Complex<f64>>> {
    let n = values.len();
    let mut coefficients = dft(values)?;
    coefficients.truncate(n / 2 + 1);
    coefficients.iter_mut().for_each(|c| *c /= n as f64);
    coefficients[n / 2] *= 0.5;
    coefficients[0].im = 0.0;
    Ok(coefficients)
}

/// The least `K` for which the coefficients beyond it that are above the `floor` add up to no more than `allowed`.
fn chop(coefficients: &[Complex<f64>], allowed: f64, floor: f64) -> usize {
    let mut left = 0.0;
    for (k, c) in coefficients.iter().enumerate().skip(1).rev() {
        let size = c.norm();
        left += if size > floor { 2.0 * size } else { 0.0 };
        if left > allowed {
            return k;
        }
    }
    0
}

impl Resolved {
    fn new(polynomial: TrigPolynomial, ends: Ends, scale: f64, deviation: f64) -> Result<Self> {
        let count = 2 * polynomial.degree() + 1;
        let start = polynomial.start();
        let axis = Axis::nodes(start..start + polynomial.period(), count)?;
        let upper = &polynomial.coefficients()[1..];
        let mirrored = upper.iter().rev().map(Complex::conj);
        let scaled: Vec<Complex<f64>> =
            polynomial.coefficients().iter().copied().chain(mirrored).map(|c| c * count as f64).collect();
        let samples = Samples::new(axis, inverse_dft(&scaled)?)?;
        Ok(Self { polynomial, samples, ends, scale, deviation })
    }

    /// The band limit `B = K/L`, with a line at it.
    pub fn band(&self) -> f64 {
        self.polynomial.band()
    }

    /// The rate `2B` that samples must exceed; the least that do so and divide the interval are [`Resolved::samples`].
    pub fn nyquist_rate(&self) -> f64 {
        crate::nyquist::nyquist_rate(self.band())
    }

    /// The `2K + 1` samples that determine it.
    pub fn samples(&self) -> &Samples {
        &self.samples
    }

    /// It as a trigonometric polynomial on the interval.
    pub fn polynomial(&self) -> &TrigPolynomial {
        &self.polynomial
    }

    /// How it continues beyond the interval. An interval alone cannot tell a pulse from a train of pulses: where
    /// nothing is left near the ends it is taken for a pulse.
    pub fn ends(&self) -> Ends {
        self.ends
    }

    /// The largest `|f|` seen, which the tolerance was relative to.
    pub fn scale(&self) -> f64 {
        self.scale
    }

    /// The largest difference from the function at 610 points off every grid.
    pub fn deviation(&self) -> f64 {
        self.deviation
    }
}

impl Signal for Resolved {
    /// The value of the trigonometric polynomial; outside the interval zero where the ends have
    /// [decayed](Ends::Decayed).
    fn at(&self, x: f64) -> f64 {
        let t = x - self.polynomial.start();
        match self.ends {
            Ends::Decayed if t < 0.0 || t >= self.polynomial.period() => 0.0,
            _ => self.polynomial.at(x),
        }
    }
}

impl FourierPair for Resolved {
    /// Lines at the harmonics of the interval; or, for a pulse (where the ends have [decayed](Ends::Decayed)), the
    /// transform of its one period: a density that is `L c_k` at the harmonics and is interpolated between them.
    fn spectrum(&self) -> Spectrum {
        match self.ends {
            Ends::Periodic => self.polynomial.spectrum(),
            Ends::Decayed => pulse_spectrum(&self.polynomial),
        }
    }
}

/// The transform of one period: a line of weight `w` at `k/L` becomes `w L sinc(νL − k)`, with the phase of the
/// interval's middle. Beyond the band their sum is what is left of the pulse at the ends, below the tolerance; it is cut.
fn pulse_spectrum(polynomial: &TrigPolynomial) -> Spectrum {
    let lines = polynomial.spectrum();
    let (length, middle) = (polynomial.period(), polynomial.start() + 0.5 * polynomial.period());
    let density = move |nu: f64| {
        let term = |line: &crate::spectrum::Impulse| {
            let off = nu - line.at;
            line.weight * (length * crate::num::sinc(off * length)) * Complex::cis(-2.0 * PI * off * middle)
        };
        lines.lines().iter().map(term).sum()
    };
    Spectrum::density_of(polynomial.band(), density)
}
