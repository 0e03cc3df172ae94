//! Non-uniform transforms: sentences as names, direct sums as oracles.

mod bad_input_is_named;
mod bits_do_not_depend_on_threads;
mod harmonics_of_the_line;
mod harmonics_of_the_plane;
mod many_irregular_samples_are_iterated;
mod samples_between_samples;

use num_complex::Complex;
use nyquist::num::random::{below, bits, uniform};

/// Positions anywhere in a period of so many units, as (whole, fraction).
fn positions(seed: u64, n: usize, period: usize) -> Vec<(i64, f64)> {
    let place = |i: u64| (below(bits(seed, i, 7), period as u64) as i64, uniform(seed, i, 1));
    (0..n as u64).map(place).collect()
}

/// Numbers between −1 and 1.
fn numbers(seed: u64, n: usize) -> Vec<f64> {
    (0..n as u64).map(|i| 2.0 * uniform(seed, i, 2) - 1.0).collect()
}

/// `e^{−2πikx/period}`, whatever the degree, to `8πε + ε < 27ε`: products and remainders are exact; two sums below two
/// periods, their quotient and the angle are rounded.
fn wave(k: i64, (whole, fraction): (i64, f64), period: usize) -> Complex<f64> {
    let product = k as f64 * fraction;
    let lost = (k as f64).mul_add(fraction, -product);
    let turns = (k * whole).rem_euclid(period as i64) as f64 + product % period as f64 + lost;
    Complex::cis(-std::f64::consts::TAU * (turns / period as f64).fract())
}

/// How far direct sums in `f64` of products with so many waves may be off, and transforms beside their tolerance, as a
/// part of the sum of all sizes: each wave by `27ε`, sums of `n` numbers by `ε√n` or so, transforms by some `10⁻¹⁵`. (A pair
/// is placed to `ε/2` of a unit, which in periods of one unit turns harmonic `k` by `πkε`: points average it out.)
fn rounding(waves: usize, n: usize) -> f64 {
    f64::EPSILON * (27.0 * waves as f64 + (n as f64).sqrt() + 5.0)
}

/// The root of the mean square of the differences, as a part of that of the numbers.
fn relative(found: impl IntoIterator<Item = Complex<f64>>, known: &[Complex<f64>]) -> f64 {
    let squares: f64 = found.into_iter().zip(known).map(|(f, k)| (f - k).norm_sqr()).sum();
    (squares / known.iter().map(Complex::norm_sqr).sum::<f64>()).sqrt()
}
