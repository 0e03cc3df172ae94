//! E12, V25. Printed: irregular samples "will not help to restore the signal exactly". Right: known irregular positions
//! do; what fails is to treat them as if they were regular.

use nyquist::laws::frames::{jittered_cells, random_polynomial};
use nyquist::prelude::*;
use std::f64::consts::PI;

fn worst_coefficient(a: &TrigPolynomial, b: &TrigPolynomial) -> f64 {
    a.coefficients().iter().zip(b.coefficients()).map(|(a, b)| (a - b).norm()).fold(0.0, f64::max)
}

#[test]
fn printed_a_sinc_series_through_displaced_samples_is_wrong() {
    // a tone far below half the rate, sampled at jittered positions and restored as if at the middles of the cells
    let sinc = |t: f64| if t == 0.0 { 1.0 } else { (PI * t).sin() / (PI * t) };
    let f = |x: f64| (2.0 * PI * x / 16.0).cos();
    let restored = |x: f64| -> f64 {
        jittered_cells(5, 256, 1.0).iter().zip(0..).map(|(&at, k)| f(at) * sinc(x - f64::from(k) - 0.5)).sum()
    };
    let worst = (0..100).map(|i| 100.0 + 0.3 * f64::from(i)).map(|x| (restored(x) - f(x)).abs()).fold(0.0, f64::max);
    assert!(worst > 0.1, "{worst}");
}

#[test]
fn right_256_positions_restore_nine_tenths_of_the_nyquist_frequency() {
    for seed in 0..4 {
        let f = random_polynomial(seed, 256.0, 115).expect("a period");
        let samples = Irregular::of(&f, 0.0..256.0, &jittered_cells(100 + seed, 256, 1.0)).expect("distinct");
        assert!(samples.largest_gap() < 2.0 && samples.density() == 1.0);
        let recovery = samples.least_squares(0.45, 20.0).expect("a condition number of about ten");
        assert_eq!(recovery.polynomial().degree(), 115);
        // least squares multiply the rounding of the values, 2Kε√(2K+1)·rms, by the condition number at most
        let rounding = recovery.condition() * 230.0 * f64::EPSILON * 231f64.sqrt() * f.rms();
        assert!((5.0..15.0).contains(&recovery.condition()), "{}", recovery.condition());
        assert!(worst_coefficient(&f, recovery.polynomial()) < rounding.min(2e-13));
    }
}

#[test]
fn right_half_of_it_is_as_good_as_regular() {
    for seed in 0..4 {
        let f = random_polynomial(seed, 256.0, 64).expect("a period");
        let samples = Irregular::of(&f, 0.0..256.0, &jittered_cells(100 + seed, 256, 1.0)).expect("distinct");
        let condition = samples.least_squares(0.25, 10.0).expect("a small condition number").condition();
        assert!((1.5..2.0).contains(&condition), "{condition}");
        // Feichtinger, Gröchenig, Strohmer 1995 bound κ by (1 + 2Bδ)/(1 − 2Bδ) for weighted equations: 39 for δ = 1.9
    }
}

#[test]
fn the_iteration_contracts_as_its_theorem_says_and_in_fact_faster() {
    let f = random_polynomial(2, 64.0, 16).expect("a period");
    let samples = Irregular::of(&f, 0.0..64.0, &jittered_cells(9, 64, 0.5)).expect("distinct");
    let factor = samples.contraction(0.25).expect("gaps below 1.5");
    assert_eq!(factor, 2.0 * samples.largest_gap() * 16.0 / 64.0);
    for steps in [0, 1, 2, 5, 10] {
        let p = samples.iterate(0.25, steps).expect("gaps below 1.5");
        // in the root mean square, by Parseval, computed here
        let left: f64 = (0..=16)
            .map(|k| (f.coefficients()[k] - p.coefficients()[k]).norm_sqr() * if k == 0 { 1.0 } else { 2.0 })
            .sum::<f64>()
            .sqrt();
        assert!(left <= factor.powi(steps as i32) * f.rms());
    }
}

#[test]
fn what_cannot_be_recovered_is_refused_with_the_numbers() {
    let f = random_polynomial(2, 64.0, 10).expect("a period");
    let samples = Irregular::of(&f, 0.0..64.0, &jittered_cells(9, 64, 1.0)).expect("distinct");
    // Landau: no density below 2B
    assert!(matches!(samples.least_squares(0.51, 1e9), Err(Error::OutOfRange { value: 0.51, .. })));
    // all samples in the first half of the period: a gap of 32
    let crowded: Vec<f64> = jittered_cells(9, 64, 1.0).iter().map(|x| 0.5 * x).collect();
    let crowded = Irregular::of(&f, 0.0..64.0, &crowded).expect("distinct");
    assert!(matches!(crowded.least_squares(0.2, 1e3), Err(Error::IllConditioned { most: 1e3, .. })));
    assert!(matches!(crowded.iterate(0.2, 3), Err(Error::OutOfRange { .. })));
    // positions
    assert!(matches!(Irregular::new(0.0..4.0, &[1.0, 2.0, 1.0], &[0.0; 3]), Err(Error::NotPositive { .. })));
    assert!(matches!(Irregular::new(0.0..4.0, &[1.0, 4.0], &[0.0; 2]), Err(Error::OutOfRange { value: 4.0, .. })));
    assert!(matches!(Irregular::new(0.0..4.0, &[1.0], &[0.0; 2]), Err(Error::Length { expected: 1, got: 2, .. })));
    assert!(matches!(Irregular::new(0.0..4.0, &[], &[]), Err(Error::TooFew { .. })));
    assert!(matches!(Irregular::new(0.0..4.0, &[f64::NAN], &[0.0]), Err(Error::NotFiniteAt { .. })));
    assert!(matches!(Irregular::new(4.0..0.0, &[1.0], &[0.0]), Err(Error::NotPositive { .. })));
}
