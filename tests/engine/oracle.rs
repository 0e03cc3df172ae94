//! Direct sums, and what rounding may do to transforms.

use num_complex::Complex;
use nyquist::num::random::normal;
use nyquist::num::{cos_pi, sin_pi};

/// Normal random numbers.
pub(crate) fn noise(n: usize, dimension: u32) -> Vec<f64> {
    (0..n as u64).map(|i| normal(11, i, dimension)).collect()
}

pub(crate) fn complex_noise(n: usize) -> Vec<Complex<f64>> {
    noise(n, 0).into_iter().zip(noise(n, 1)).map(|(re, im)| Complex::new(re, im)).collect()
}

/// `Σ_j x_j e^{−2πijk/n}`, the turns reduced as whole numbers, the sum compensated (Neumaier 1974): right to a few
/// roundings of `‖x‖`, however many terms there are.
pub(crate) fn direct(values: &[Complex<f64>], k: usize) -> Complex<f64> {
    let n = values.len();
    let (mut sum, mut missed) = (Complex::ZERO, Complex::<f64>::ZERO);
    let two_sum = |a: f64, b: f64| {
        let s = a + b;
        (s, if a.abs() >= b.abs() { (a - s) + b } else { (b - s) + a })
    };
    for (j, z) in values.iter().enumerate() {
        let turns = 2.0 * ((j as u128 * k as u128) % n as u128) as f64 / n as f64;
        let term = z * Complex::new(cos_pi(turns), -sin_pi(turns));
        let ((re, more_re), (im, more_im)) = (two_sum(sum.re, term.re), two_sum(sum.im, term.im));
        (sum, missed) = (Complex::new(re, im), missed + Complex::new(more_re, more_im));
    }
    sum + missed
}

/// The root of the sum of squares.
pub(crate) fn size(values: impl IntoIterator<Item = Complex<f64>>) -> f64 {
    values.into_iter().map(|z| z.norm_sqr()).sum::<f64>().sqrt()
}

/// What rounding may do to a transform of `n` numbers, relative to its size in the 2-norm: `8ε·log₂n` (Higham 2002, theorem
/// 24.2), and for lengths with a prime factor above 31, which become convolutions, that of three transforms of up to `4n`
/// numbers one after another.
pub(crate) fn rounding(n: usize, epsilon: f64) -> f64 {
    let mut rest = n;
    for p in [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31] {
        while rest.is_multiple_of(p) {
            rest /= p;
        }
    }
    let levels = (n as f64).log2().max(1.0);
    if rest == 1 { 8.0 * epsilon * levels } else { 24.0 * epsilon * (levels + 2.0) }
}
