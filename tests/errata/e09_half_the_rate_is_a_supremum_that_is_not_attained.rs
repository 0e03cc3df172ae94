//! E09. Printed: with samples at rate B "the maximal frequency that can be reproduced is B/2". Right: B/2 is a supremum.
//! Every frequency below it can be reproduced, itself it cannot.

use nyquist::prelude::*;
use std::f64::consts::{PI, TAU};

#[test]
fn printed_two_different_tones_at_half_the_rate_have_the_same_samples() {
    // cos(πk + 60°) and ½cos(πk)
    for k in 0..100 {
        let x = f64::from(k);
        assert!(((PI * x + PI / 3.0).cos() - 0.5 * (PI * x).cos()).abs() < 1e-12);
    }
    assert_eq!(Verdict::of(0.5, true, 1.0), Ok(Verdict::Critical));
}

#[test]
fn right_any_tone_below_it_is_reproduced_with_its_phase() {
    // a period of n = 2K + 1 samples holds frequencies up to K/n, which tends to ½
    for degree in [1u32, 5, 50, 200] {
        let n = 2 * degree + 1;
        let (nu, phase) = (f64::from(degree) / f64::from(n), 0.7);
        let tone = from_fn(|x: f64| (TAU * nu * x + phase).cos());
        let positions: Vec<f64> = (0..n).map(f64::from).collect();
        let samples = Irregular::of(&tone, 0.0..f64::from(n), &positions).expect("distinct positions");
        let recovery = samples.least_squares(nu, 1.0 + 1e-9).expect("equispaced samples are orthogonal");
        let coefficient = recovery.polynomial().coefficients()[degree as usize];
        // amplitude ½ and phase 0.7, to the rounding of the arguments
        let rounding = 4.0 * f64::EPSILON * TAU * f64::from(n);
        assert!((coefficient.norm() - 0.5).abs() < rounding && (coefficient.arg() - phase).abs() < 2.0 * rounding);
        assert!(nu < nyquist_frequency(1.0) && Verdict::of(nu, true, 1.0).expect("a rate").recoverable());
    }
}

#[test]
fn right_at_half_the_rate_there_are_fewer_samples_than_unknowns() {
    // n = 2K samples a period put K/n exactly at half the rate: 2K + 1 coefficients, one too many
    let positions: Vec<f64> = (0..20).map(f64::from).collect();
    let samples = Irregular::new(0.0..20.0, &positions, &[0.0; 20]).expect("distinct positions");
    let refused = samples.least_squares(0.5, f64::INFINITY);
    assert!(matches!(refused, Err(Error::OutOfRange { value: 0.5, high: 0.45, .. })), "{refused:?}");
}
