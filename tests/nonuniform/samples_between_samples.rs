//! Samples of a period have values at any points, to the tolerance asked for, and far from the start as well as near it.

use crate::{numbers, positions, rounding};
use num_complex::Complex;
use nyquist::engine::nonuniform::{Nufft, PeriodicInterpolator};
use std::f64::consts::PI;

/// `Σ f_i D(x − i)` with the kernel of Dirichlet, `D(u) = sin(πu)/(n·tan(πu/n))` for even `n`, with a sine for odd `n`.
fn dirichlet(samples: &[f64], (whole, fraction): (i64, f64)) -> f64 {
    let n = samples.len() as i64;
    let (nearest, rest) = if fraction > 0.5 { (whole + 1, fraction - 1.0) } else { (whole, fraction) };
    let weight = |i: i64| {
        let steps = (nearest - i + n / 2).rem_euclid(n) - n / 2;
        if rest == 0.0 {
            return f64::from(steps == 0);
        }
        let sign = if steps % 2 == 0 { 1.0 } else { -1.0 };
        let angle = PI * (steps as f64 + rest) / n as f64;
        let below = if n % 2 == 0 { angle.tan() } else { angle.sin() };
        sign * (PI * rest).sin() / (n as f64 * below)
    };
    samples.iter().zip(0..).map(|(v, i)| v * weight(i)).sum()
}

#[test]
fn even_and_odd_records_have_the_values_of_their_dirichlet_sums() {
    for n in [1, 2, 3, 4, 5, 12, 37, 128, 1001, 3000] {
        let samples = numbers(1, n);
        let mut points = positions(2, 200, n);
        points.extend([(0, 0.0), (n as i64 - 1, 0.0), (n as i64 - 1, 1.0 - f64::EPSILON)]);
        // Σ|c_k| ≤ √n·√(Σ|c_k|²), which by Parseval is the root of the sum of the squares of the samples
        let size = samples.iter().map(|v| v * v).sum::<f64>().sqrt();
        for tolerance in [1e-2, 1e-6, 1e-12] {
            let between = PeriodicInterpolator::new(n, tolerance).unwrap();
            let found = between.values(&samples, &between.place(&points).unwrap()).unwrap();
            for (point, found) in points.iter().zip(found) {
                let error = (found - dirichlet(&samples, *point)).abs();
                // weights of the direct sum have a dozen roundings, fewer than a wave
                assert!(error <= (tolerance + rounding(1, n)) * size, "{n} {tolerance} {point:?}: {error}");
            }
        }
    }
}

#[test]
fn a_million_samples_keep_their_digits() {
    let n = 1_000_000;
    let samples = numbers(3, n);
    let mut points = positions(4, 200_000, n);
    points[0] = (n as i64 - 1, 0.123_456_789_012_345);
    let norm = |values: &[f64]| values.iter().map(|v| v * v).sum::<f64>().sqrt();
    for tolerance in [1e-6, 1e-12] {
        let between = PeriodicInterpolator::new(n, tolerance).unwrap();
        let found = between.values(&samples, &between.place(&points).unwrap()).unwrap();
        let known: Vec<f64> = points[..20].iter().map(|p| dirichlet(&samples, *p)).collect();
        let differences: Vec<f64> = found.iter().zip(&known).map(|(f, k)| f - k).collect();
        // the direct sums are rounded themselves
        let direct = 4.0 * f64::EPSILON * (n as f64).sqrt();
        assert!(norm(&differences) <= (tolerance + direct) * norm(&known), "{tolerance}");
    }
}

#[test]
fn single_precision_reaches_a_million_samples() {
    let n = 1_000_000;
    let samples: Vec<f32> = numbers(5, n).into_iter().map(|v| v as f32).collect();
    let exact: Vec<f64> = samples.iter().map(|&v| v.into()).collect();
    let points = positions(6, 1000, n);
    let between = PeriodicInterpolator::new(n, 1e-5).unwrap();
    let found = between.values(&samples, &between.place(&points).unwrap()).unwrap();
    for (point, found) in points[..10].iter().zip(found) {
        assert!((f64::from(found) - dirichlet(&exact, *point)).abs() < 1e-5);
    }
}

#[test]
fn one_value_from_a_grid_is_that_of_many() {
    let nufft = Nufft::<f64>::new(700, 3, 1e-11).unwrap();
    let modes: Vec<_> = numbers(7, 1402).chunks_exact(2).map(|c| Complex::new(c[0], c[1])).collect();
    let (grid, points) = (nufft.grid(&modes).unwrap(), positions(8, 300, 3));
    let (placed, mut values) = (nufft.place(&points).unwrap(), vec![0.0; 300]);
    nufft.values_from(&grid, &placed, &mut values).unwrap();
    assert_eq!(values, nufft.values(&modes, &placed).unwrap());
    for (point, value) in points.iter().zip(values) {
        assert_eq!(nufft.value(&grid, *point).unwrap().to_bits(), value.to_bits());
        assert_eq!(nufft.value(&grid, (point.0 - 30, point.1)).unwrap().to_bits(), value.to_bits());
    }
    assert!(nufft.value(&grid, f64::NAN).unwrap().is_nan() && nufft.value(&grid, f64::INFINITY).unwrap().is_nan());
    assert!(nufft.value(&grid[1..], 0.5).is_err());
}
