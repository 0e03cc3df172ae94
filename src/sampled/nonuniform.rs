//! The spectrum of weights at any positions.

use crate::num::{cos_pi, sin_pi};
use num_complex::Complex;

/// `Σ_k w_k e^{−2πimx_k/L}` for `0 ≤ m ≤ order`: the transform of impulses `[x_k, w_k]` at the harmonics of a record of
/// length `L`, by the direct sum in `O(n·order)`.
///
/// The plain sum, without a unit: what it should be divided by depends on what the impulses are. For negative `m` it is
/// the conjugate, weights being real. The waves are computed as powers; the rounding error of each is about `2mε` beyond
/// that of its argument. For many there are [`Places`](crate::sampled::harmonics::Places) and the engine's
/// [`Nufft`](crate::engine::nonuniform::Nufft), which are held against this sum.
///
/// ```
/// use nyquist::sampled::nonuniform::transform;
/// // four equally spaced impulses: a line at every fourth harmonic, and nothing between
/// let lines = transform(&[0.0, 1.0, 2.0, 3.0].map(|x| [x, 1.0]), 4.0, 5);
/// assert!([4.0, 0.0, 0.0, 0.0, 4.0, 0.0].iter().zip(&lines).all(|(known, line)| (line - known).norm() < 1e-14));
/// ```
pub fn transform(points: &[[f64; 2]], length: f64, order: usize) -> Vec<Complex<f64>> {
    let mut sums = vec![Complex::ZERO; order + 1];
    for [x, weight] in points {
        let turn = 2.0 * (x / length);
        let (wave, mut power) = (Complex::new(cos_pi(turn), -sin_pi(turn)), Complex::from(*weight));
        for sum in &mut sums {
            *sum += power;
            power *= wave;
        }
    }
    sums
}
