//! Averages instead of reconstructions: which points integrate what, and how well (V12, V17).

use crate::beyond::jitter::{Jitter, JitteredComb};
use crate::error::{Result, positive};
use crate::laws::Law;
use crate::laws::frames::random_polynomial;
use crate::laws::jitter::deviations;
use crate::num::quadrature::integrate_pieces;
use crate::num::random::uniform;
use crate::num::sinc;
use crate::residual::Residual;
use crate::signal::Signal;
use crate::signal::trigonometric::TrigPolynomial;
use crate::text::Text;
use num_complex::Complex;

/// `Σ_{j ≠ 0} |c_j|² P_s(j)`: the variance that the spectrum of a point set makes of the spectrum of a periodic
/// function, for sets that a random shift leaves the same in law (Durand 2011; Pilleboue et al. 2015; V12).
pub fn spectral_variance(f: &TrigPolynomial, points: impl Fn(usize) -> f64) -> f64 {
    (1..=f.degree()).map(|j| 2.0 * f.coefficients()[j].norm_sqr() * points(j)).sum()
}

/// The mean of `n` equispaced points with a random offset: its variance is that of the harmonics which are multiples of
/// `n`, and of no others. So `n` points integrate every trigonometric polynomial of degree below `n` exactly: half the
/// rate that reconstruction needs (V12).
///
/// Measured: the difference between the variance over all offsets and `Σ_{n | j} |c_j|²`; the former is itself a mean of
/// a trigonometric polynomial of degree `2K/n` in the offset, taken exactly from more offsets than that.
///
/// ```
/// use nyquist::laws::integration::equispaced_variance;
/// use nyquist::prelude::*;
/// let harmonic = |j: usize| TrigPolynomial::new(0.0..1.0, (0..=j).map(|k| f64::from(u8::from(k == j)).into()).collect());
/// let variance = |j| Ok::<_, Error>(equispaced_variance(&harmonic(j)?, 16));
/// assert!([1, 5, 15].into_iter().all(|j| variance(j).is_ok_and(|[v, _]| v < 1e-28)));
/// assert!((variance(16)?[0] - 2.0).abs() < 1e-13); // all of its power
/// # Ok::<(), Error>(())
/// ```
pub fn equispaced_variance(f: &TrigPolynomial, n: usize) -> [f64; 2] {
    let lines = |j: usize| f64::from(u8::from(j.is_multiple_of(n)));
    let offsets = 2 * f.degree() / n + 2;
    let step = f.period() / n as f64;
    let mean = |o: usize| {
        let shift = o as f64 / offsets as f64;
        (0..n).map(|i| f.at(f.start() + (i as f64 + shift) * step)).sum::<f64>() / n as f64
    };
    let variance = (0..offsets).map(|o| (mean(o) - f.coefficients()[0].re).powi(2)).sum::<f64>() / offsets as f64;
    [variance, spectral_variance(f, lines)]
}

/// The two numbers of [`equispaced_variance`] agree.
///
/// Allowed: with `e = 2Kε·√(2K + 1)·rms` the rounding of a value by Horner's rule, and `d = Σ_{n | j} 2|c_j|` the largest
/// deviation of a mean, `2de + e²`.
pub fn equispaced(f: &TrigPolynomial, n: usize) -> Residual {
    let [variance, expected] = equispaced_variance(f, n);
    let degree = f.degree() as f64;
    let value = 2.0 * degree * f64::EPSILON * (2.0 * degree + 1.0).sqrt() * f.rms();
    let deviation: f64 = (n..=f.degree()).step_by(n).map(|j| 2.0 * f.coefficients()[j].norm()).sum();
    Residual::near(
        "equispaced points: only multiples of n are left",
        variance,
        expected,
        2.0 * deviation * value + value * value,
    )
}

/// The variance of a mean over points on `[0, 1)`, measured in `trials` patterns of `n` points and compared with what
/// is `expected`; the true mean of `f` is `mean`.
///
/// `points(seed)` makes one pattern. Allowed: [`deviations`] times the standard deviation of the mean of the squared
/// errors, as the squares themselves show it, and the rounding `ε·n` of a mean of values of size `scale`.
///
/// # Errors
/// Fewer than two trials would show no deviation.
pub fn variance_of_means(
    f: &impl Signal,
    mean: f64,
    points: impl Fn(u64) -> Vec<f64>,
    trials: u32,
    expected: f64,
) -> Result<Residual> {
    positive("the number of trials less one", f64::from(trials) - 1.0)?;
    let mut scale: f64 = 0.0;
    let mut count = 0;
    let squares: Vec<f64> = (0..trials)
        .map(|trial| {
            let values: Vec<f64> = points(JitteredComb::pattern_seed(17, trial)).iter().map(|&x| f.at(x)).collect();
            scale = values.iter().fold(scale, |s, v| s.max(v.abs()));
            count = values.len();
            (values.iter().sum::<f64>() / values.len() as f64 - mean).powi(2)
        })
        .collect();
    let trials = f64::from(trials);
    let variance = squares.iter().sum::<f64>() / trials;
    let spread = squares.iter().map(|s| (s - variance).powi(2)).sum::<f64>() / (trials - 1.0);
    let rounding = f64::EPSILON * count as f64 * scale;
    let bound = deviations(1) * (spread / trials).sqrt() + 2.0 * rounding * variance.sqrt() + rounding * rounding;
    Ok(Residual::near("variance of a mean over a pattern", variance, expected, bound))
}

/// The positions of a comb of `n` spikes on `[0, 1)`: in the middles of its cells, wrapped around; with a random shift
/// of the whole pattern if `shifted`.
pub fn pattern(jitter: Jitter, n: usize, shifted: bool, seed: u64) -> Result<Vec<f64>> {
    let comb = JitteredComb::new(1.0 / n as f64, jitter)?;
    let shift = if shifted { uniform(seed, n as u64, 7) } else { 0.5 / n as f64 };
    Ok(comb.positions(seed, n).into_iter().map(|x| (x + shift).rem_euclid(1.0)).collect())
}

/// The variances of the means of `f` over `[0, 1)`, once by independent points and once by strata: `[Var_random,
/// Var_strat, Var(stratum means)]`, by quadrature.
///
/// `strata` are widths and numbers of points; the widths must add up to one. The stratified estimate weighs every
/// stratum's mean by its width: `Var_strat = Σ w²σ²/n`. `breaks` are the rising places where `f` is not smooth.
pub fn strata(f: &impl Signal, breaks: &[f64], strata: &[(f64, u32)]) -> [f64; 3] {
    let moments = |a: f64, b: f64| {
        let mut pieces = vec![a];
        pieces.extend(breaks.iter().copied().filter(|x| (a..b).contains(x) && *x > a));
        pieces.push(b);
        let power = |k: i32| integrate_pieces(|x| f.at(x).powi(k), &pieces, 1e-16).value / (b - a);
        let mean = power(1);
        (mean, (power(2) - mean * mean).max(0.0))
    };
    let (mean, variance) = moments(0.0, 1.0);
    let total: u32 = strata.iter().map(|s| s.1).sum();
    let (mut start, mut stratified, mut means) = (0.0, 0.0, 0.0);
    for &(width, count) in strata {
        let (stratum_mean, stratum_variance) = moments(start, (start + width).min(1.0));
        start += width;
        stratified += width * width * stratum_variance / f64::from(count);
        means += width * (stratum_mean - mean).powi(2);
    }
    [variance / f64::from(total), stratified, means]
}

/// Stratification never hurts, if every stratum gets points in proportion to its width (V17):
/// `Var_strat = Var_random − (1/N)·Var(stratum means) ≤ Var_random`.
///
/// Two residuals: the identity, and the excess of `Var_strat` over `Var_random`. Allowed: the error of the quadratures,
/// `10⁻¹⁶` each where `f` is smooth between the breaks, and the cancellation in `E f² − (E f)²`, 16ε of `max f² ≤ peak²`
/// in each of the strata.
pub fn stratification(f: &impl Signal, breaks: &[f64], peak: f64, widths: &[(f64, u32)]) -> [Residual; 2] {
    let [random, stratified, means] = strata(f, breaks, widths);
    let total: u32 = widths.iter().map(|s| s.1).sum();
    let bound = 16.0 * f64::EPSILON * peak * peak * widths.len() as f64;
    let expected = random - means / f64::from(total);
    [
        Residual::near("Var strat = Var random − Var(stratum means)/N", stratified, expected, bound),
        Residual::at_most("stratification never hurts", (stratified - random).max(0.0), bound),
    ]
}

/// The power spectrum of `n` jittered points on `[0, 1)` at harmonic `j`, with `Σ P(j) = …/n`: `(1 − sinc²(j/n))/n`.
fn jittered_power(n: usize) -> impl Fn(usize) -> f64 {
    move |j| (1.0 - sinc(j as f64 / n as f64).powi(2)) / n as f64
}

fn harmonic(j: usize) -> TrigPolynomial {
    let coefficients = (0..=j).map(|k| Complex::from(if k == j { 0.5 } else { 0.0 })).collect();
    TrigPolynomial::new(0.0..1.0, coefficients).expect("the coefficients are finite")
}

fn sampled_with(jitter: Jitter) -> Residual {
    let f = random_polynomial(4, 1.0, 12).expect("the period is positive");
    let points = |seed| pattern(jitter, 8, true, seed).expect("eight points");
    let expected = spectral_variance(&f, jittered_power(8));
    variance_of_means(&f, f.coefficients()[0].re, points, 4000, expected).expect("thousands of trials")
}

fn stratified_with(jitter: Jitter) -> Residual {
    let f = random_polynomial(4, 1.0, 12).expect("the period is positive");
    let points = |seed| pattern(jitter, 8, false, seed).expect("eight points");
    let [_, stratified, _] = strata(&f, &[], &[(0.125, 1); 8]);
    variance_of_means(&f, f.coefficients()[0].re, points, 4000, stratified).expect("thousands of trials")
}

/// The laws of this theme.
pub static LAWS: &[Law] = &[
    Law {
        name: "spectral-variance",
        inventory: &["V12"],
        says: &Text::fixed(
            "The variance of a mean is the product of two spectra, ΣP_{f}(j)P_{s}(j); n equispaced points integrate all degrees below n exactly",
            "Дисперсия среднего есть произведение двух спектров, ΣP_{f}(j)P_{s}(j); n равноотстоящих точек точно интегрируют все степени ниже n",
        ),
        holds: || {
            let random = random_polynomial(9, 2.0, 50).expect("the period is positive");
            let mut all: Vec<Residual> = [1, 5, 15, 16, 32].map(|j| equispaced(&harmonic(j), 16)).into();
            all.extend([equispaced(&random, 16), equispaced(&random, 7), sampled_with(CELL)]);
            all
        },
        // independent points have a white spectrum, not that of jitter
        breaks: || vec![sampled_with(Jitter::Independent)],
    },
    Law {
        name: "stratification",
        inventory: &["V17"],
        says: &Text::fixed(
            "Strata with points in proportion to their size never make a mean worse",
            "Страты с числом точек пропорционально размеру никогда не ухудшают среднее",
        ),
        holds: || {
            let polynomial = random_polynomial(4, 1.0, 12).expect("the period is positive");
            let step = crate::signal::from_fn(|x| f64::from(u8::from(x > 0.3)));
            let peak = polynomial.coefficients().iter().map(|c| 2.0 * c.norm()).sum();
            let mut all: Vec<Residual> = stratification(&polynomial, &[], peak, &[(0.125, 1); 8]).into();
            all.extend(stratification(&polynomial, &[], peak, &[(0.25, 2), (0.5, 4), (0.25, 2)]));
            all.extend(stratification(&step, &[0.3], 1.0, &[(0.25, 1); 4]));
            all.push(stratified_with(CELL));
            all
        },
        breaks: || {
            // one point for nine tenths of the interval, nine for the rest
            let ramp = crate::signal::from_fn(|x| x);
            let mut all: Vec<Residual> = stratification(&ramp, &[], 1.0, &[(0.9, 1), (0.1, 9)]).into();
            all.push(stratified_with(Jitter::Independent));
            all
        },
    },
];

const CELL: Jitter = Jitter::Uniform { width: 1.0 };
