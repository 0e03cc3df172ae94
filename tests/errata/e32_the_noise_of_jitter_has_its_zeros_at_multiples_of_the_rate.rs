//! E32, V10. Printed (in a popular book): the power spectrum of jitter with `sinc(Tω/2)`, an unnormalised sinc in angular
//! units, beside formulas in cycles. Right in cycles: `P(ν) = T[1 − sinc²(Tν)] + δ(ν)`.
//!
//! The oracle: periodograms of patterns made here, with this file's own random numbers.

use nyquist::prelude::*;
use std::f64::consts::{PI, TAU};

/// The minimal standard generator of Park and Miller, 1988.
struct Lehmer(u64);

impl Lehmer {
    fn next(&mut self) -> f64 {
        self.0 = self.0 * 48_271 % 2_147_483_647;
        self.0 as f64 / 2_147_483_647.0
    }
}

const SPIKES: u32 = 64;
const PATTERNS: u32 = 2000;

/// The mean of `(1/n)|Σ e^{−2πiνx_k}|²` over patterns of unit step.
fn measured(nu: f64, mut position: impl FnMut(f64) -> f64) -> f64 {
    let mut sum = 0.0;
    for _ in 0..PATTERNS {
        let (mut re, mut im) = (0.0, 0.0);
        for k in 0..SPIKES {
            let x = position(f64::from(k));
            re += (TAU * nu * x).cos();
            im -= (TAU * nu * x).sin();
        }
        sum += (re * re + im * im) / f64::from(SPIKES);
    }
    sum / f64::from(PATTERNS)
}

/// Four standard deviations of a mean over the patterns; one pattern deviates by at most `√2·P` (at ν = ½, where the
/// squares of the phasors add up), and the correction for finitely many spikes.
fn four_sigma(power: f64) -> f64 {
    4.0 * (2.0 * power * power + 4.0 * power / f64::from(SPIKES)).sqrt() / f64::from(PATTERNS).sqrt()
}

fn cell_jitter(nu: f64) -> f64 {
    let mut random = Lehmer(2011);
    measured(nu, |k| k + random.next() - 0.5)
}

#[test]
fn printed_the_floor_at_the_nyquist_frequency_would_be_a_fiftieth() {
    let x: f64 = 0.5 * 0.5; // Tω/2 at ω = ½
    let printed = 1.0 - (x.sin() / x).powi(2);
    assert!((printed - 0.021).abs() < 5e-4);
    assert!((cell_jitter(0.5) - printed).abs() > 20.0 * four_sigma(printed));
}

#[test]
fn right_it_is_0_595_and_the_library_says_so() {
    let comb = JitteredComb::new(1.0, Jitter::Uniform { width: 1.0 }).expect("a comb");
    assert!((comb.noise(0.5) - 0.595).abs() < 5e-4);
    // at multiples of 1/64 a periodogram of 64 spikes has no leakage
    for nu in [1.0 / 64.0, 0.125, 0.25, 0.5, 0.75, 1.0, 1.5, 2.0] {
        let expected = comb.noise(nu);
        assert!((cell_jitter(nu) - expected).abs() < four_sigma(expected), "{nu}: {} {expected}", cell_jitter(nu));
    }
    // the values of the inventory (F39), on one axis of a square grid
    for (nu, power) in [(0.25, 0.1894), (0.5, 0.5947), (1.0, 1.0)] {
        assert!((comb.noise(nu) - power).abs() < 5e-5);
    }
}

#[test]
fn the_zeros_of_the_sinc_are_at_the_rate_and_its_multiples() {
    for step in [0.25, 1.0, 3.0] {
        let comb = JitteredComb::new(step, Jitter::Uniform { width: 1.0 }).expect("a comb");
        for k in 1..5 {
            assert!((comb.noise(f64::from(k) / step) - step).abs() < 1e-15 * step); // the floor is full there
        }
        assert_eq!(comb.power_spectrum(5).expect("eleven lines").lines().len(), 1); // and the lines are gone
        let nu = 0.01 / step;
        let start = (PI * step * nu).powi(2) * step / 3.0; // near zero; the next term is (πTν)⁴·2/45
        assert!((comb.noise(nu) / start - 1.0).abs() < 0.5 * (PI * step * nu).powi(2));
    }
}

#[test]
fn other_kinds_of_jitter_leave_other_lines() {
    let comb = |jitter| JitteredComb::new(1.0, jitter).expect("a comb");
    let line = |c: &JitteredComb| {
        let spectrum = c.power_spectrum(1).expect("three lines");
        spectrum.lines().iter().find(|l| l.at == 1.0).map_or(0.0, |l| l.weight.re)
    };
    // half a cell: sinc²(½) = (2/π)² = 0.4053 of the first line is left
    let half = comb(Jitter::Uniform { width: 0.5 });
    assert!((line(&half) - 4.0 / (PI * PI)).abs() < 1e-15);
    let mut random = Lehmer(7);
    let found = measured(1.0, |k| k + 0.5 * (random.next() - 0.5));
    let expected = half.noise(1.0) + line(&half) * f64::from(SPIKES);
    // line and noise beat: 2√(line·n·P) more
    let beat = 8.0 * (line(&half) * f64::from(SPIKES) * half.noise(1.0) / f64::from(PATTERNS)).sqrt();
    assert!((found - expected).abs() < four_sigma(half.noise(1.0)) + beat, "{found} {expected}");
    assert!((line(&comb(Jitter::Gaussian { sigma: 0.2 })) - (-4.0 * PI * PI * 0.04f64).exp()).abs() < 1e-15);
    assert_eq!((line(&comb(Jitter::None)), line(&comb(Jitter::Independent))), (1.0, 0.0));
    // independent positions are white, not blue (E11)
    let mut random = Lehmer(9);
    let white = measured(0.125, |_| f64::from(SPIKES) * random.next());
    assert!((white - 1.0).abs() < four_sigma(1.0));
    assert_eq!(comb(Jitter::Independent).noise(0.125), 1.0);
}

#[test]
fn positions_are_a_function_of_seed_and_index_and_bad_jitter_is_refused() {
    let comb = JitteredComb::new(0.5, Jitter::Gaussian { sigma: 0.1 }).expect("a comb");
    assert_eq!(comb.positions(3, 100)[..40], comb.positions(3, 40));
    assert_ne!(comb.positions(3, 2), comb.positions(4, 2));
    let step = |step, jitter| JitteredComb::new(step, jitter);
    assert!(matches!(step(0.0, Jitter::None), Err(Error::NotPositive { what: "the step of a comb", .. })));
    assert!(matches!(step(1.0, Jitter::Uniform { width: -1.0 }), Err(Error::NotPositive { .. })));
    assert!(matches!(step(1.0, Jitter::Gaussian { sigma: f64::NAN }), Err(Error::NotFinite { .. })));
}
