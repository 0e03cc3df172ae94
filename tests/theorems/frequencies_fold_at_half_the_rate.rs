//! Sampling folds the frequency axis at half the rate; cosines keep their sign, sines lose it in every second fold.
//!
//! The oracle is the samples themselves, computed here.

use nyquist::num::random::uniform;
use nyquist::prelude::*;
use std::f64::consts::TAU;

/// What the argument `2πνk` of a cosine rounds by.
fn rounding(nu: f64, k: f64) -> f64 {
    4.0 * f64::EPSILON * (TAU * (nu * k).abs() + 1.0)
}

#[test]
fn a_tone_and_its_alias_have_the_same_samples() {
    for trial in 0..200 {
        let (nu, rate) = (20.0 * uniform(1, trial, 0) - 10.0, 0.5 + 3.0 * uniform(1, trial, 1));
        let (phase, alias) = (TAU * uniform(1, trial, 2), Alias::of(nu, rate).expect("a positive rate"));
        assert!((0.0..=0.5 * rate).contains(&alias.frequency()));
        let sign = if alias.conjugated() { -1.0 } else { 1.0 };
        for k in 0..50 {
            let x = f64::from(k) / rate;
            let seen = (TAU * alias.frequency() * x + sign * phase).cos();
            assert!(((TAU * nu * x + phase).cos() - seen).abs() <= rounding(nu, x), "{nu} at {rate}");
        }
    }
}

#[test]
fn the_sine_at_nine_tenths_of_the_rate_comes_back_upside_down() {
    let alias = Alias::of(0.9, 1.0).expect("a positive rate");
    assert!(alias.conjugated() && (alias.frequency() - 0.1).abs() < f64::EPSILON);
    for k in 0..100 {
        let x = f64::from(k);
        assert!(((TAU * 0.9 * x).cos() - (TAU * 0.1 * x).cos()).abs() <= rounding(1.0, x));
        assert!(((TAU * 0.9 * x).sin() + (TAU * 0.1 * x).sin()).abs() <= rounding(1.0, x));
    }
}

#[test]
fn a_grid_that_misses_the_origin_turns_the_phase() {
    for (nu, start) in [(0.9, 0.5), (1.3, 0.25), (-2.2, 0.4), (0.2, 0.7)] {
        let alias = Alias::of(nu, 1.0).expect("a positive rate");
        for k in 0..20 {
            let x = start + f64::from(k);
            let seen = TAU * (alias.phase(start) + alias.signed() * x);
            assert!(((TAU * nu * x).cos() - seen.cos()).abs() <= rounding(nu, x));
            assert!(((TAU * nu * x).sin() - seen.sin()).abs() <= rounding(nu, x));
        }
    }
}

#[test]
fn folding_is_even_periodic_and_exact() {
    for i in 0..100 {
        let nu = f64::from(i) / 16.0; // numbers that need no rounding
        assert_eq!(fold(nu, 2.0), fold(-nu, 2.0));
        assert_eq!(fold(nu, 2.0), fold(nu + 2.0 * 1e9, 2.0));
        assert_eq!(fold(nu, 2.0), (nu - 2.0 * (nu / 2.0).round()).abs());
        assert_eq!(fold(nu, 2.0), Alias::of(nu, 2.0).expect("a positive rate").frequency());
    }
}

#[test]
fn the_spokes_of_a_wheel_turn_backwards() {
    // 8 spokes, 2.9 turns a second, 24 frames a second: 23.2 Hz are seen as −0.8 Hz, a tenth of a turn backwards
    let alias = Alias::of(8.0 * 2.9, 24.0).expect("a positive rate");
    assert!((alias.signed() + 0.8).abs() < 1e-14 && (alias.signed() / 8.0 + 0.1).abs() < 1e-14);
}

#[test]
fn landings_agree_with_folding() {
    for piece in landings(3.7, 1.0).expect("a positive band") {
        for (from, to) in piece.from.iter().zip(piece.to) {
            assert!((fold(*from, 1.0) - to).abs() <= 4.0 * f64::EPSILON * from.abs());
        }
        let (from, to) = (0.5 * (piece.from[0] + piece.from[1]), 0.5 * (piece.to[0] + piece.to[1]));
        assert!((fold(from, 1.0) - to).abs() < 4.0 * f64::EPSILON * from);
    }
}

#[test]
fn bad_rates_and_bands_are_named() {
    assert_eq!(Alias::of(1.0, 0.0), Err(Error::NotPositive { what: "the sampling rate", value: 0.0 }));
    assert!(Alias::of(f64::NAN, 1.0).is_err() && landings(0.0, 1.0).is_err() && landings(1e9, 1e-9).is_err());
    assert!(fold(1.0, -1.0).is_nan() && fold(1.0, f64::INFINITY).is_nan() && fold(f64::NAN, 1.0).is_nan());
    assert!(Verdict::of(-1.0, false, 1.0).is_err() && Verdict::of(f64::NAN, false, 1.0).is_err());
    assert!(bandpass_rates(3.0, 2.0).is_err() && bandpass_rates(-1.0, 2.0).is_err());
}
