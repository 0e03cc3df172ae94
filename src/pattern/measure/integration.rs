//! How fast means over points converge.

use crate::error::{Error, Result, positive};
use crate::pattern::Pattern;
use crate::pattern::measure::periodogram::pattern_seed;

/// The mean square of the errors of means over points.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Errors {
    /// The number of points, its mean where patterns differ.
    pub points: f64,
    /// The mean of the squared errors: the variance, where means are unbiased.
    pub mean_square: f64,
    /// The standard deviation of `mean_square`, as the trials show it.
    pub deviation: f64,
}

/// The error of `(1/N)Σf(x_i)` against `∫f`, over `trials` patterns.
///
/// `problem(seed)` gives the integrand of one trial and its integral: the same one for all, or one at random, such as an
/// edge somewhere.
///
/// ```
/// use nyquist::prelude::*;
/// use nyquist::pattern::measure::integration::errors;
/// // independent points: Var f/N
/// let found = errors(&Random::new(100)?, 1, 2000, |_| (|p: [f64; 2]| p[0], 0.5))?;
/// assert!((found.mean_square - 1.0 / 1200.0).abs() < 4.0 * found.deviation);
/// # Ok::<(), Error>(())
/// ```
///
/// # Errors
/// Fewer than two trials would show no deviation.
pub fn errors<const D: usize, F: Fn([f64; D]) -> f64>(
    pattern: &dyn Pattern<D>,
    seed: u64,
    trials: u32,
    problem: impl Fn(u64) -> (F, f64),
) -> Result<Errors> {
    if trials < 2 {
        return Err(Error::TooFew { what: "trials", least: 2, got: trials as usize });
    }
    let (mut count, mut mean, mut squares) = (0.0, 0.0, 0.0);
    for trial in 0..trials {
        let seed = pattern_seed(seed, trial);
        let (f, integral) = problem(seed);
        let points = pattern.points(seed);
        count += points.len() as f64;
        let n = points.len() as f64;
        let square = (points.into_iter().map(f).sum::<f64>() / n - integral).powi(2);
        // Welford's recurrence
        let difference = square - mean;
        mean += difference / f64::from(trial + 1);
        squares += difference * (square - mean);
    }
    let trials = f64::from(trials);
    let deviation = (squares / (trials * (trials - 1.0))).sqrt();
    Ok(Errors { points: count / trials, mean_square: mean, deviation })
}

/// A power law `mean_square = constant·N^exponent`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rate {
    /// The exponent.
    pub exponent: f64,
    /// Its standard deviation, from those of the measurements.
    pub deviation: f64,
    /// The factor.
    pub constant: f64,
}

/// The power law that fits measurements at several `N` best: least squares of the logarithms, each with the weight of its
/// relative deviation.
///
/// # Errors
/// Fewer than two measurements; mean squares or deviations that are not positive; only one number of points.
pub fn rate(measured: &[Errors]) -> Result<Rate> {
    if measured.len() < 2 {
        return Err(Error::TooFew { what: "measurements of a rate", least: 2, got: measured.len() });
    }
    let mut rows = Vec::with_capacity(measured.len());
    for m in measured {
        let value = positive("a mean square error", m.mean_square)?;
        let relative = positive("the deviation of a mean square error", m.deviation)? / value;
        rows.push((relative.powi(-2), positive("the number of points", m.points)?.ln(), value.ln()));
    }
    let weight: f64 = rows.iter().map(|r| r.0).sum();
    let mean = |pick: fn(&(f64, f64, f64)) -> f64| rows.iter().map(|r| r.0 * pick(r)).sum::<f64>() / weight;
    let (x, y) = (mean(|r| r.1), mean(|r| r.2));
    let spread = positive("the spread of the numbers of points", rows.iter().map(|r| r.0 * (r.1 - x).powi(2)).sum())?;
    let exponent = rows.iter().map(|r| r.0 * (r.1 - x) * (r.2 - y)).sum::<f64>() / spread;
    Ok(Rate { exponent, deviation: spread.powf(-0.5), constant: (y - exponent * x).exp() })
}
