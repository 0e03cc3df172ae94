//! `resolve` finds the least number of samples of a function, or says honestly that there is none.
//!
//! The oracle is outside the library: coefficients known in closed form (Poisson kernel, Jacobi–Anger), and the
//! function itself at places that the search never saw.

use nyquist::prelude::*;
use std::f64::consts::{PI, TAU};

fn resolved(f: impl Fn(f64) -> f64, interval: std::ops::Range<f64>, tolerance: f64) -> Resolved {
    match resolve(&from_fn(f), interval, tolerance).expect("a good interval") {
        Resolution::Resolved(resolved) => resolved,
        other => panic!("not resolved: {other:?}"),
    }
}

/// The largest difference at places that are multiples of √2 − 1, which the search does not use.
fn worst(f: impl Fn(f64) -> f64, g: &impl Signal, interval: std::ops::Range<f64>) -> f64 {
    let places = (0..5000)
        .map(|j| interval.start + (interval.end - interval.start) * (f64::from(j) * (2f64.sqrt() - 1.0)).fract());
    places.map(|x| (f(x) - g.at(x)).abs()).fold(0.0, f64::max)
}

#[test]
fn a_tone_of_200_cycles_needs_401_samples_and_not_8193() {
    let f = |x: f64| (400.0 * PI * x).sin();
    let tone = resolved(f, 0.0..1.0, 1e-12);
    assert_eq!((tone.polynomial().degree(), tone.samples().values().len()), (200, 401));
    assert_eq!((tone.band(), tone.nyquist_rate(), tone.ends()), (200.0, 400.0, Ends::Periodic));
    assert!(tone.samples().axis().rate() > tone.nyquist_rate());
    // twice the tolerance; the argument 400πx itself rounds by ε·400π
    assert!(worst(f, &tone, 0.0..1.0) <= 2e-12);
}

#[test]
fn the_band_of_a_poisson_kernel_is_where_its_geometric_tail_falls_below_the_tolerance() {
    // Σ r^|k| e^{2πikx} = (1 − r²)/(1 − 2r cos 2πx + r²): the tail beyond K is 2r^{K+1}/(1 − r)
    for r in [0.3f64, 0.5, 0.9, 0.99] {
        let f = |x: f64| (1.0 - r * r) / (1.0 - 2.0 * r * (TAU * x).cos() + r * r);
        let peak = (1.0 + r) / (1.0 - r);
        for tolerance in [1e-4, 1e-7, 1e-10] {
            let known = ((tolerance * peak * (1.0 - r) / 2.0).ln() / r.ln() - 1.0).ceil();
            let found = resolved(f, 0.0..1.0, tolerance).band();
            // one harmonic: by aliasing on the grid and by the tail beyond its last harmonic, which the sum cannot see
            assert!((found - known).abs() <= 1.0, "r = {r}, tolerance {tolerance}: {found}, {known}");
        }
    }
}

#[test]
fn a_frequency_modulated_tone_has_the_coefficients_of_jacobi_and_anger() {
    // cos(z sin 2πx) = Σ J_k(z) e^{2πikx} over even k; J_50(1) and its like vanish beyond rounding at once
    let f = |x: f64| (20.0 * (TAU * x).sin()).cos();
    let found = resolved(f, 0.0..1.0, 1e-13);
    // J_0(20) and J_2(20), Abramowitz & Stegun table 9.1
    assert!((found.polynomial().coefficients()[0].re - 0.167_024_664_340_583_15).abs() < 1e-14);
    assert!((found.polynomial().coefficients()[2].re + 0.160_341_351_922_998_14).abs() < 1e-14);
    assert!(worst(f, &found, 0.0..1.0) <= 2e-13);
}

#[test]
fn tones_that_vanish_or_alias_on_the_first_grids_are_not_taken_for_nothing() {
    for cycles in [64.0, 128.0, 129.0, 192.0, 4096.0, 5000.0, 131_072.0] {
        let f = move |x: f64| (TAU * cycles * x).sin();
        assert_eq!(resolved(f, 0.0..1.0, 1e-9).band(), cycles);
        let small = move |x: f64| (TAU * x).cos() + 1e-3 * (TAU * cycles * x).sin();
        assert_eq!(resolved(small, 0.0..1.0, 1e-9).band(), cycles);
    }
}

#[test]
fn a_narrow_pulse_is_found_and_recognised_as_a_pulse() {
    for sigma in [0.02f64, 1e-3, 2e-4] {
        let f = move |x: f64| (-0.5 * ((x - 0.37) / sigma).powi(2)).exp();
        let pulse = resolved(f, 0.0..1.0, 1e-12);
        assert_eq!(pulse.ends(), Ends::Decayed);
        assert_eq!(pulse.at(1.37), 0.0);
        let (found, rounding) = (worst(f, &pulse, 0.0..1.0), f64::EPSILON * 0.61 / sigma); // of the argument: ε·max|f′|
        assert!(found <= 2e-12 + 4.0 * rounding, "{sigma}: {found}");
        // its transform is known: σ√(2π) e^{−2π²σ²ν²}, with the phase of its place
        let spectrum = pulse.spectrum();
        for nu in [0.0, 1.3, 0.1 / sigma] {
            let known = sigma * TAU.sqrt() * (-2.0 * (PI * sigma * nu).powi(2)).exp();
            assert!((spectrum.density(nu).norm() - known).abs() <= 2e-12);
        }
        // the band: the tail erfc(√2πσB) is 10⁻¹² at √2πσB = 5.042 (erfc⁻¹, DLMF 7.17); where the argument's rounding
        // ε/σ nears the tolerance, coefficients below it count as nothing, and the band comes out shorter
        let known = 5.042 / (2f64.sqrt() * PI * sigma);
        assert!((0.95 * known..known + 1.0).contains(&pulse.band()), "{} {known}", pulse.band());
    }
}

#[test]
fn constants_and_nothing_at_all_need_one_sample() {
    assert_eq!(resolved(|_| 3.0, -2.0..5.0, 1e-14).samples().values(), [3.0]);
    assert_eq!(resolved(|_| 0.0, -2.0..5.0, 1e-14).samples().values(), [0.0]);
}

#[test]
fn jumps_kinks_and_noise_never_are() {
    let unresolved = |f: fn(f64) -> f64, tolerance| match resolve_up_to(&from_fn(f), 0.0..1.0, tolerance, 1 << 16)
        .expect("a good interval")
    {
        Resolution::Unresolved { samples, level } => assert!(samples == 1 << 16 && level > tolerance),
        other => panic!("{other:?}"),
    };
    for tolerance in [0.1, 1e-2, 1e-4, 1e-8] {
        unresolved(|x| if (x - 0.4).abs() < 0.2 { 1.0 } else { 0.0 }, tolerance); // at simple fractions
        unresolved(|x| (x - 0.4).signum() * (TAU * x).sin() + (x * 6.0).floor() % 2.0, tolerance);
    }
    unresolved(|x| (PI * x).sin().abs(), 1e-8); // a kink: coefficients fall as 1/k²
    // noise, faded in and out
    unresolved(|x| (PI * x).sin() * nyquist::num::random::uniform(x.to_bits(), 0, 0), 1e-2);
}

#[test]
fn ends_that_do_not_meet_are_told_at_once() {
    let asked = std::cell::Cell::new(0);
    let f = from_fn(|x: f64| {
        asked.set(asked.get() + 1);
        x.exp()
    });
    let Resolution::Open { jump } = resolve(&f, 0.0..1.0, 1e-10).expect("a good interval") else { panic!() };
    assert!((jump - (1f64.exp() - 1.0)).abs() < 1e-15);
    assert!(asked.get() < 1000);
}

#[test]
fn bad_input_is_named() {
    let f = from_fn(|x: f64| x.sin());
    assert!(matches!(resolve(&f, 1.0..0.0, 1e-9), Err(Error::NotPositive { .. })));
    assert!(matches!(resolve(&f, 0.0..f64::NAN, 1e-9), Err(Error::NotFinite { .. })));
    assert!(matches!(resolve(&f, 0.0..1.0, 1e-20), Err(Error::OutOfRange { what: "the tolerance", .. })));
    assert!(matches!(resolve(&from_fn(|x: f64| 1.0 / x), 0.0..1.0, 1e-9), Err(Error::NotFinite { .. })));
}

#[test]
fn far_from_zero_a_function_is_not_called_resolved_where_its_argument_has_lost_the_digits() {
    // a faint fast tone beside a slow one, on an interval far out: the spacing of numbers near s hides it
    for s in [1e6f64, 1e9, 1e11, 1e15] {
        let turn = 2.0 * PI;
        let f = from_fn(move |x: f64| (turn * (x - s)).sin() + 1e-6 * (50.0 * turn * (x - s)).sin());
        match resolve(&f, s..s + 1.0, 1e-10).expect("the interval rises and the tolerance is within its range") {
            Resolution::Resolved(r) => assert!(r.band() == 50.0 && s < 1e6, "{s:e}: band {}", r.band()),
            Resolution::Unresolved { level, .. } => assert!(level > 1e-10, "{s:e}: {level:e}"),
            Resolution::Open { jump } => assert!(jump > 1e-10, "{s:e}: {jump:e}"),
        }
    }
}
