//! E01, E02: two rows of the lecture's table of transforms, as printed and as they should be. The oracle is a plain sum
//! that knows nothing of the library.

use nyquist::laws::poisson::comb_pairing;
use nyquist::prelude::*;
use std::f64::consts::PI;

/// `∫ f(x)·e^{−π(x/40)²}·cos(2πνx) dx` of an even function by a plain sum; the window has faded to 1e-21 at ±160, and the
/// step of 1/8 folds nothing below frequency 4.
fn windowed(f: impl Fn(f64) -> f64, nu: f64) -> f64 {
    let step = 0.125;
    let at = |i: i32| step * f64::from(i);
    let term = |x: f64| f(x) * (-PI * (x / 40.0) * (x / 40.0)).exp() * (2.0 * PI * nu * x).cos() * step;
    (-1280..=1280).map(at).map(term).sum()
}

/// Where the transform peaks at positive frequencies, and the area under it there.
fn peak_and_area(f: impl Fn(f64) -> f64) -> (f64, f64) {
    let fine = 0.0005;
    let points: Vec<(f64, f64)> = (1..2000).map(|k| fine * f64::from(k)).map(|nu| (nu, windowed(&f, nu))).collect();
    let top = points.iter().copied().fold((0.0, 0.0), |a, b| if b.1 > a.1 { b } else { a });
    (top.0, fine * points.iter().map(|p| p.1).sum::<f64>())
}

#[test]
fn e01_cos_x_has_lines_of_weight_one_half_at_one_over_two_pi() {
    let (place, area) = peak_and_area(f64::cos);
    // half a step of the grid; the window smears the line over 1/40, so all of it is inside 0…1
    assert!((place - 0.5 / PI).abs() <= 0.00025 + 1e-12, "{place}");
    assert!((area - 0.5).abs() < 1e-9, "{area}");
    let lines = Cosine::new(0.5 / PI).unwrap().spectrum().lines().to_vec();
    assert_eq!(lines, [Impulse::new(-0.5 / PI, 0.5), Impulse::new(0.5 / PI, 0.5)]);
}

#[test]
fn e01_the_printed_lines_belong_to_another_function() {
    // printed: π at ±½. There cos x has nothing …
    assert!(windowed(f64::cos, 0.5).abs() < 1e-12);
    // … and what those lines make is 2π·cos πx
    let printed = Spectrum::of_lines([Impulse::new(-0.5, PI), Impulse::new(0.5, PI)]).unwrap();
    for i in 0..40 {
        let x = 0.17 * f64::from(i);
        let made = printed.inverse_at(x).unwrap().re;
        assert!((made - 2.0 * PI * (PI * x).cos()).abs() < 1e-13);
    }
    let (place, area) = peak_and_area(|x| (PI * x).cos());
    assert!((place - 0.5).abs() < 1e-12 && (area - 0.5).abs() < 1e-9); // even cos πx weighs ½ there, not π
    // what was meant: π[δ(1 − 2πν) + δ(1 + 2πν)], and δ(1 − 2πν) = δ(ν − 1/2π)/2π
    let meant = Spectrum::of_lines([Impulse::new(-1.0, PI), Impulse::new(1.0, PI)]).unwrap();
    let weights: Vec<f64> = meant.lines().iter().map(|l| l.weight.re / (2.0 * PI)).collect();
    assert_eq!(weights, [0.5, 0.5]);
}

#[test]
fn e02_the_combs_lines_weigh_one_for_every_step() {
    let test = Gaussian::new(0.6).unwrap();
    for step in [0.5, 1.0, 1.7, 2.5] {
        assert!(comb_pairing(&test, step, 60, 1.0).unwrap().holds(), "T = {step}");
    }
    // by hand: T·Σφ(iT) and ΣΦ(k/T) of φ = e^{−π(x/0.6)²}
    let phi = |x: f64| (-PI * (x / 0.6) * (x / 0.6)).exp();
    let transform = |nu: f64| 0.6 * (-PI * (0.6 * nu) * (0.6 * nu)).exp();
    let sum = |f: &dyn Fn(f64) -> f64, step: f64| (-60..=60).map(|i| f(step * f64::from(i))).sum::<f64>();
    for step in [0.5, 1.0, 1.7, 2.5] {
        assert!((step * sum(&phi, step) - sum(&transform, 1.0 / step)).abs() < 1e-14, "T = {step}");
    }
}

#[test]
fn e02_with_the_printed_weight_only_the_step_one_agrees() {
    let test = Gaussian::new(0.6).unwrap();
    for step in [0.5, 1.7, 2.5] {
        let printed = comb_pairing(&test, step, 60, 1.0 / step).unwrap();
        assert!(!printed.holds() && printed.measured > 0.1, "T = {step}: {printed:?}");
    }
    assert!(comb_pairing(&test, 1.0, 60, 1.0).unwrap().holds());
    // the comb's mean is 1, so its line at zero must weigh 1; printed is 1/T
    let comb = Comb::new(0.5).unwrap();
    let one = Constant::new(1.0).unwrap();
    let mean: f64 = comb.times(&one, 0..=999).iter().map(|i| i.weight.re).sum::<f64>() / 500.0;
    assert_eq!((mean, comb.line(0).weight.re), (1.0, 1.0));
}
