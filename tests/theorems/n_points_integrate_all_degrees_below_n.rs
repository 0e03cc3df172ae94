//! V12, V17: which points integrate what.

use nyquist::laws::integration::{equispaced_variance, spectral_variance, strata};
use nyquist::prelude::*;
use std::f64::consts::{PI, TAU};

/// The variance over offsets of the mean of 16 values of `√2 cos(2πjx)`, naively: 4096 offsets.
fn variance(j: u32) -> f64 {
    let mean = |offset: f64| {
        (0..16).map(|i| 2f64.sqrt() * (TAU * f64::from(j) * (f64::from(i) + offset) / 16.0).cos()).sum::<f64>() / 16.0
    };
    (0..4096).map(|o| mean(f64::from(o) / 4096.0).powi(2)).sum::<f64>() / 4096.0
}

#[test]
fn sixteen_points_with_a_random_offset_integrate_degrees_below_sixteen() {
    for (j, expected) in [(1, 0.0), (5, 0.0), (15, 0.0), (16, 1.0), (17, 0.0), (32, 1.0)] {
        assert!((variance(j) - expected).abs() < 1e-12, "{j}");
        let coefficients = (0..=j).map(|k| if k == j { 0.5f64.sqrt() } else { 0.0 }.into()).collect();
        let harmonic = TrigPolynomial::new(0.0..1.0, coefficients).expect("a harmonic");
        let [measured, theory] = equispaced_variance(&harmonic, 16);
        assert!((measured - expected).abs() < 1e-12 && (theory - expected).abs() < 1e-15);
    }
    // reconstruction of degree 15 would ask for 31 samples
    let fifteen = TrigPolynomial::new(0.0..1.0, vec![1.0.into(); 16]).expect("a sum");
    assert_eq!(2 * fifteen.degree() + 1, 31);
}

#[test]
fn independent_points_see_the_whole_power_at_one_nth() {
    let f = TrigPolynomial::new(0.0..1.0, vec![0.3.into(), 1.0.into(), 0.5.into()]).expect("a sum");
    // 2(1 + ¼)/n
    assert_eq!(spectral_variance(&f, |_| 1.0 / 10.0), 0.25);
}

#[test]
fn stratification_takes_away_the_variance_of_the_means() {
    // f = x: Var = 1/12; n strata of one point each leave 1/(12n³) (V15)
    for n in [1u32, 2, 4, 16] {
        let widths = vec![(1.0 / f64::from(n), 1); n as usize];
        let [random, stratified, means] = strata(&from_fn(|x| x), &[], &widths);
        let n = f64::from(n);
        assert!((random - 1.0 / (12.0 * n)).abs() < 1e-15);
        assert!((stratified - 1.0 / (12.0 * n.powi(3))).abs() < 1e-15);
        assert!((means - (1.0 - 1.0 / (n * n)) / 12.0).abs() < 1e-15);
    }
    // f = sin 2πx in two halves: the means ±2/π, the variance ½
    let [random, stratified, means] = strata(&from_fn(|x| (TAU * x).sin()), &[], &[(0.5, 1), (0.5, 1)]);
    assert!((random - 0.25).abs() < 1e-15 && (means - 4.0 / (PI * PI)).abs() < 1e-15);
    assert!((stratified - 0.5 * (0.5 - 4.0 / (PI * PI))).abs() < 1e-15);
    // an edge in one of four strata: p(1 − p)/16 with p = 0.2 there
    let [_, stratified, _] = strata(&from_fn(|x| f64::from(u8::from(x > 0.3))), &[0.3], &[(0.25, 1); 4]);
    assert!((stratified - 0.16 / 16.0).abs() < 1e-15);
}

#[test]
fn strata_out_of_proportion_can_hurt() {
    let [random, stratified, _] = strata(&from_fn(|x| x), &[], &[(0.9, 1), (0.1, 9)]);
    // 0.81·0.81/12 + 0.01·0.01/108
    assert!((stratified - (0.81 * 0.81 / 12.0 + 0.01 * 0.01 / 108.0)).abs() < 1e-15);
    assert!(stratified > 6.0 * random);
}
