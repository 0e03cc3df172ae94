//! What the figures of regular, random and jittered samples share (slides «Стохастический суперсэмплинг»).
//!
//! In all of them the step is one: frequencies are in cycles per step, the rate is 1 and Nyquist ½. The power of `n` points
//! is `(1/n)|Σ e^{−2πiνx}|²` at the harmonics `ν = m/n` of their record.

use crate::figure::common::space;
use crate::figure::{Layer, Meaning, Panel, Scale};
use crate::sampled::nonuniform::transform;
use crate::text;
use crate::text::Text;

/// How many patterns a mean is taken over.
pub(super) const PATTERNS: u32 = 2000;
/// How many standard errors a mean may be off. Six: 2·10⁻⁹ for one normal number, so 10⁻⁵ for all bins and all seeds
/// that a figure offers.
pub(super) const DEVIATIONS: f64 = 6.0;

pub(super) static SEED: Text = Text::fixed("seed of the random numbers", "начальное число генератора");

/// The powers of impulses at the harmonics `0..=order·n` of a record of `n` steps.
pub(super) fn powers(points: &[[f64; 2]], n: usize, order: usize) -> Vec<f64> {
    transform(points, n as f64, order * n).iter().map(|sum| sum.norm_sqr() / n as f64).collect()
}

/// A mean over patterns, and its standard error.
#[derive(Debug, Clone, Copy)]
pub(super) struct Mean {
    pub(super) value: f64,
    pub(super) error: f64,
}

/// The means of many numbers over [`PATTERNS`] patterns.
pub(super) fn averaged(mut numbers: impl FnMut(u32) -> Vec<f64>) -> Vec<Mean> {
    let mut sums: Vec<[f64; 2]> = Vec::new();
    for pattern in 0..PATTERNS {
        let numbers = numbers(pattern);
        sums.resize(numbers.len(), [0.0; 2]);
        for (sum, v) in sums.iter_mut().zip(numbers) {
            sum[0] += v;
            sum[1] += v * v;
        }
    }
    let n = f64::from(PATTERNS);
    let mean = |[sum, squares]: [f64; 2]| {
        let value = sum / n;
        Mean { value, error: ((squares / n - value * value).max(0.0) / (n - 1.0)).sqrt() }
    };
    sums.into_iter().map(mean).collect()
}

/// How many standard errors the worst of the means is off; a mean without any spread must agree to rounding.
pub(super) fn worst_deviation(means: impl IntoIterator<Item = (Mean, f64)>) -> f64 {
    let deviation = |(mean, expected): (Mean, f64)| {
        let rounding = 1e-12 * expected.abs().max(1.0); // of the sums in `averaged`, 2000·ε
        (mean.value - expected).abs() / (mean.error + rounding)
    };
    means.into_iter().map(deviation).fold(0.0, f64::max)
}

/// Powers at `ν = m/n` for positive and negative `m`; they are even.
pub(super) fn both_sides(powers: &[f64], n: usize) -> Vec<[f64; 2]> {
    let last = powers.len() as i64 - 1;
    (-last..=last).map(|m| [m as f64 / n as f64, powers[m.unsigned_abs() as usize]]).collect()
}

/// The comb's impulses of weight one at those positions.
pub(super) fn impulses(name: &'static str, title: Text, positions: &[f64]) -> Panel {
    let end = positions.len() as f64;
    Panel::new(name, title, space(-0.5, end), Scale::linear(text!("weight", "вес"), 0.0, 1.25)).with(Layer::arrows(
        "positions",
        Meaning::Samples,
        positions.iter().map(|&x| [x, 1.0]),
    ))
}
