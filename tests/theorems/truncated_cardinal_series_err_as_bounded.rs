//! V09: what the samples left out can do.

use nyquist::laws::truncation::{regularised_tone, sinc_energy_beyond, truncated_energy, truncated_tone};
use nyquist::prelude::*;
use std::f64::consts::PI;

/// The series of `|k| ≤ n` by hand.
fn series(f: impl Fn(f64) -> f64, weight: impl Fn(f64) -> f64, n: i32, x: f64) -> f64 {
    (-n..=n).map(f64::from).map(|k| f(k) * weight(x - k)).sum()
}

fn sinc(t: f64) -> f64 {
    if t == 0.0 { 1.0 } else { (PI * t).sin() / (PI * t) }
}

#[test]
fn a_tone_errs_by_no_more_than_abels_bound_and_by_half_of_it_at_worst() {
    let mut worst = 0.0f64;
    for nu in [0.1, 0.3, 0.45, 0.49] {
        for n in [8, 32, 128] {
            for i in 0..200 {
                let x = (f64::from(i) / 100.0 - 1.0) * 0.95 * f64::from(n);
                let tone = |x: f64| (2.0 * PI * nu * x).cos();
                let error = (series(tone, sinc, n, x) - tone(x)).abs();
                let next = f64::from(n) + 1.0;
                let bound =
                    (PI * x).sin().abs() / (PI * (PI * nu).cos()) * (1.0 / (next - x.abs()) + 1.0 / (next + x.abs()));
                assert!(error <= bound + 1e-13, "ν = {nu}, N = {n}, x = {x}");
                if bound > 1e-9 {
                    worst = worst.max(error / bound);
                }
            }
        }
    }
    assert!((0.45..0.75).contains(&worst), "{worst}");
}

#[test]
fn at_nyquist_itself_no_number_of_terms_helps() {
    // the bound's factor 1/cos πν is infinite; a sine there has samples zero, and the error is the sine
    let tone = |x: f64| (PI * x).sin();
    for n in [8, 128, 2048] {
        assert!((series(tone, sinc, n, 0.5) - 1.0).abs() > 0.99);
    }
    assert!(!truncated_tone(0.6, 0.7, 64, &[0.3, 0.5, 1.7]).unwrap().holds(), "above Nyquist the bound is not for it");
}

#[test]
fn the_energy_bound_holds_for_a_signal_of_finite_energy() {
    // sinc² of half the band: f(k) falls like k⁻²; the energy left out by summing far
    let f = |x: f64| 0.5 * sinc(0.5 * x).powi(2);
    for n in [8, 32] {
        let beyond: f64 = (n + 1..200_000).rev().map(|k| 2.0 * f(f64::from(k)).powi(2)).sum();
        for i in 0..60 {
            let x = (f64::from(i) / 30.0 - 1.0) * 0.9 * f64::from(n);
            let error = (series(f, sinc, n, x) - f(x)).abs();
            let reach = 1.0 / (f64::from(n) - x.abs()) + 1.0 / (f64::from(n) + x.abs());
            assert!(error <= (PI * x).sin().abs() / PI * reach.sqrt() * beyond.sqrt() + 1e-13, "N = {n}, x = {x}");
        }
        assert!(truncated_energy(&SincSquared::new(0.5).unwrap(), n as usize, &[0.5, 3.3, 0.8 * f64::from(n)]).holds());
    }
}

#[test]
fn under_a_gaussian_a_few_samples_give_many_digits() {
    for (n, measured_before) in [(8, 4.2e-4), (16, 5.5e-7), (24, 8.4e-10)] {
        let s2 = f64::from(n) / (PI * 0.5);
        let weight = |t: f64| if t.abs() < f64::from(n) { sinc(t) * (-0.5 * t * t / s2).exp() } else { 0.0 };
        let tone = |x: f64| (2.0 * PI * 0.25 * x + 0.7).cos();
        let error = (0..=40)
            .map(|i| f64::from(i) / 40.0)
            .map(|x| (series(tone, weight, n + 2, x) - tone(x)).abs())
            .fold(0.0, f64::max);
        assert!(error < (-PI * 0.5 * f64::from(n) / 2.0).exp(), "n = {n}: {error:e}");
        assert!(error < 3.0 * measured_before && error > measured_before / 30.0, "n = {n}: {error:e}");
        let law = regularised_tone(f64::from(n), 0.5, 0.25, &[0.1, 0.5]).unwrap();
        assert!(law.holds() && law.bound < (-PI * 0.5 * f64::from(n) / 2.0).exp());
        // the bare sinc with as many samples
        let bare = (0..=40)
            .map(|i| f64::from(i) / 40.0)
            .map(|x| (series(tone, sinc, n, x) - tone(x)).abs())
            .fold(0.0, f64::max);
        assert!(bare > 30.0 * error, "n = {n}: {bare:e}");
    }
}

#[test]
fn a_percent_of_the_sincs_energy_lies_beyond_eight_steps() {
    for (n, energy) in [(1, 0.0972), (2, 0.0501), (8, 0.0127)] {
        let h = 1e-4;
        let inside: f64 = (0..n * 10_000).map(|i| sinc(h * (f64::from(i) + 0.5)).powi(2)).sum::<f64>() * h;
        assert!((1.0 - 2.0 * inside - energy).abs() < 5e-5, "N = {n}");
        assert!((1.0 / (PI * PI * f64::from(n)) - energy).abs() < 0.06 * energy);
        assert!(sinc_energy_beyond(n as u32).iter().all(Residual::holds));
    }
}
