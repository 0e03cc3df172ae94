//! One dimension, every small length, against the direct sum.

use crate::oracle::{complex_noise, direct, noise, rounding, size};
use num_complex::Complex;
use nyquist::axis::Axis;
use nyquist::engine::fft::{Butterflies, Fft, PhysicalFft, PhysicalRealFft, RealFft};
use nyquist::error::Error;
use std::f64::consts::PI;

const BOTH: [Butterflies; 2] = [Butterflies::Scalar, Butterflies::Fastest];
const SINGLE: f64 = f32::EPSILON as f64;

#[test]
fn every_length_up_to_200_is_the_direct_sum() {
    for n in 1..=200 {
        let values = complex_noise(n);
        let sums: Vec<_> = (0..n).map(|k| direct(&values, k)).collect();
        let bound = rounding(n, f64::EPSILON) * size(sums.iter().copied());
        let single: Vec<_> = values.iter().map(|z| Complex::new(z.re as f32, z.im as f32)).collect();
        for butterflies in BOTH {
            let (plan, mut out) = (Fft::with(n, butterflies).unwrap(), vec![Complex::ZERO; n]);
            plan.forward(&values, &mut out).unwrap();
            assert!(size(out.iter().zip(&sums).map(|(a, b)| a - b)) <= bound, "{n} {butterflies:?}");
            let mut back = vec![Complex::ZERO; n];
            plan.inverse(&out, &mut back).unwrap();
            let errors = back.iter().zip(&values).map(|(a, b)| a / n as f64 - b);
            assert!(size(errors) <= 2.0 * rounding(n, f64::EPSILON) * size(values.iter().copied()), "{n} back");
            // in single precision the values are rounded, too
            let (plan, mut out) = (Fft::with(n, butterflies).unwrap(), vec![Complex::ZERO; n]);
            plan.forward(&single, &mut out).unwrap();
            let errors = out.iter().zip(&sums).map(|(a, b)| Complex::new(f64::from(a.re), f64::from(a.im)) - b);
            assert!(size(errors) <= (rounding(n, SINGLE) + SINGLE) * size(sums.iter().copied()), "{n} single");
        }
    }
}

#[test]
fn real_values_give_the_first_half_and_come_back() {
    for n in 1..=200 {
        let values = noise(n, 2);
        let whole: Vec<_> = values.iter().map(|&x| Complex::from(x)).collect();
        let sums: Vec<_> = (0..=n / 2).map(|k| direct(&whole, k)).collect();
        let norm = size(whole.iter().copied()) * (n as f64).sqrt();
        for butterflies in BOTH {
            let plan = RealFft::with(n, butterflies).unwrap();
            let (mut half, mut back) = (vec![Complex::ZERO; n / 2 + 1], vec![0.0; n]);
            plan.forward(&values, &mut half).unwrap();
            let errors = half.iter().zip(&sums).map(|(a, b)| a - b);
            assert!(size(errors) <= rounding(n, f64::EPSILON) * norm, "{n} {butterflies:?}");
            // imaginary parts that no real signal has are not looked at
            half[0].im = 7.0;
            if n % 2 == 0 {
                half[n / 2].im = -5.0;
            }
            plan.inverse(&half, &mut back).unwrap();
            let errors = back.iter().zip(&values).map(|(a, b)| Complex::from(a / n as f64 - b));
            assert!(size(errors) <= 2.0 * rounding(n, f64::EPSILON) * size(whole.iter().copied()), "{n} back");
        }
    }
}

#[test]
fn units_and_phases_are_those_of_the_integral() {
    // a record that starts far away; sums at its frequencies with positions that are exact in binary
    for n in 1..=64 {
        let axis = Axis::new(-331.25, 0.125, n).unwrap();
        let values = complex_noise(n);
        let real = noise(n, 0);
        let (mut bins, mut half) = (vec![Complex::ZERO; n], vec![Complex::ZERO; n / 2 + 1]);
        let plan = PhysicalFft::new(axis);
        plan.forward(&values, &mut bins).unwrap();
        PhysicalRealFft::new(axis).forward(&real, &mut half).unwrap();
        let steps = |j: usize| -2650 + j as i64;
        // ν_k x_j = k·(x_j/T)/n, reduced as whole numbers
        let wave = |k: i64, j: usize| Complex::cis(-2.0 * PI * (k * steps(j)).rem_euclid(n as i64) as f64 / n as f64);
        let bound =
            (rounding(n, f64::EPSILON) + 16.0 * f64::EPSILON) * size(values.iter().copied()) * (n as f64).sqrt();
        let error = |k: i64, got: Complex<f64>, value: &dyn Fn(usize) -> Complex<f64>| {
            (got / 0.125 - (0..n).map(|j| value(j) * wave(k, j)).sum::<Complex<f64>>()).norm()
        };
        for (p, z) in bins.iter().enumerate() {
            assert!(error(p as i64 - n as i64 / 2, *z, &|j| values[j]) <= bound, "{n} at {p}");
        }
        for (k, z) in half.iter().enumerate() {
            assert!(error(k as i64, *z, &|j| real[j].into()) <= bound, "{n} at {k}");
        }
        let mut back = vec![Complex::ZERO; n];
        plan.inverse(&bins, &mut back).unwrap();
        assert!(size(back.iter().zip(&values).map(|(a, b)| a - b)) <= 2.0 * bound, "{n} back");
    }
}

#[test]
fn steps_of_any_size_are_factors_and_no_more() {
    let values = complex_noise(512);
    let bins = |step: f64| {
        let mut bins = vec![Complex::ZERO; 512];
        PhysicalFft::new(Axis::new(3.0 * step, step, 512).unwrap()).forward(&values, &mut bins).unwrap();
        bins
    };
    // powers of two: nothing is rounded
    let known = bins(1.0);
    for exponent in [-1000, -500, 500, 1000] {
        let step = 2.0_f64.powi(exponent);
        assert!(bins(step).iter().zip(&known).all(|(got, known)| *got == known * step), "2^{exponent}");
    }
}

#[test]
fn lengths_that_do_not_fit_are_refused() {
    assert!(matches!(Fft::<f64>::new(0), Err(Error::TooFew { .. })));
    assert!(matches!(RealFft::<f32>::new(0), Err(Error::TooFew { .. })));
    let plan = RealFft::<f64>::new(6).unwrap();
    let (mut half, mut back) = (vec![Complex::ZERO; 4], vec![0.0; 6]);
    assert!(matches!(plan.forward(&[0.0; 5], &mut half), Err(Error::Length { expected: 6, got: 5, .. })));
    assert!(matches!(plan.forward(&[0.0; 6], &mut half[..3]), Err(Error::Length { expected: 4, got: 3, .. })));
    assert!(matches!(plan.inverse(&half[..3], &mut back), Err(Error::Length { expected: 4, got: 3, .. })));
}
