//! Gröchenig's iteration with thousands of samples goes through transforms, and is the same iteration.

use nyquist::beyond::Irregular;
use nyquist::laws::frames::random_polynomial;
use nyquist::num::random::uniform;
use nyquist::prelude::*;

#[test]
fn every_step_makes_the_error_smaller_by_what_is_promised() {
    let (n, degree) = (3000, 600); // 1.8·10⁶ products, more than are summed directly
    let f = random_polynomial(5, n as f64, degree).unwrap();
    let positions: Vec<f64> = (0..n).map(|i| i as f64 + 0.5 * uniform(2, i as u64, 0)).collect();
    let samples = Irregular::of(&f, 0.0..n as f64, &positions).unwrap();
    let band = degree as f64 / n as f64;
    let factor = samples.contraction(band).unwrap();
    assert!(factor < 0.6, "{factor}");
    let left = |steps: usize| {
        let found = samples.iterate(band, steps).unwrap();
        let squares = found.coefficients().iter().zip(f.coefficients()).map(|(a, b)| (a - b).norm_sqr());
        squares.enumerate().map(|(k, s)| if k == 0 { s } else { 2.0 * s }).sum::<f64>().sqrt()
    };
    let size = f.rms();
    // two transforms a step, each off by 10⁻¹³ of a sum of sizes, which is at most √(2K + 1) of the root mean square
    let rounding = 2e-13 * (2.0 * degree as f64 + 1.0).sqrt() * size / (1.0 - factor);
    for steps in [1, 5, 20] {
        let bound = size * factor.powi(steps as i32) + rounding;
        assert!(left(steps) <= bound, "{steps}: {} of {bound}", left(steps));
    }
}

#[test]
fn the_fast_way_and_the_slow_one_are_the_same_iteration() {
    let (n, degree) = (800, 200); // few enough for direct sums
    let f = random_polynomial(6, n as f64, degree).unwrap();
    let positions: Vec<f64> = (0..n).map(|i| i as f64 + 0.4 * uniform(3, i as u64, 0)).collect();
    let values: Vec<f64> = positions.iter().map(|x| f.at(*x)).collect();
    let one = Irregular::new(0.0..n as f64, &positions, &values).unwrap();
    // three periods of it are one period of three times as many samples and three times the degree
    let thrice = |i: usize| positions[i % n] + (i / n * n) as f64;
    let long: Vec<f64> = (0..3 * n).map(thrice).collect();
    let long_values: Vec<f64> = (0..3 * n).map(|i| values[i % n]).collect();
    let three = Irregular::new(0.0..3.0 * n as f64, &long, &long_values).unwrap();
    let (slow, fast) = (one.iterate(0.25, 3).unwrap(), three.iterate(0.25, 3).unwrap());
    let size: f64 = f.coefficients().iter().map(|c| 2.0 * c.norm()).sum();
    for (k, c) in fast.coefficients().iter().enumerate() {
        let known = if k % 3 == 0 { slow.coefficients()[k / 3] } else { 0.0.into() };
        // three steps of two transforms of 10⁻¹³ each, and turns of up to 2Kε in the slow one
        assert!((c - known).norm() < (6e-13 + 6.0 * 2.0 * degree as f64 * f64::EPSILON) * size, "{k}");
    }
}
