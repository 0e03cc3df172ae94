//! V23: band-pass sampling. The band (21, 24) at 8.2 and 10, where 9.0, 7.5 and 6.5 fail.

use nyquist::prelude::*;
use std::f64::consts::PI;

fn sinc(t: f64) -> f64 {
    if t == 0.0 { 1.0 } else { (PI * t).sin() / (PI * t) }
}

/// `sinc²(1.25x)` has band 1.25; on a carrier at 22.5 it fills (21.25, 23.75).
fn signal(x: f64) -> f64 {
    sinc(1.25 * x).powi(2) * (45.0 * PI * x).cos()
}

fn error(rate: f64) -> f64 {
    let samples = Samples::of(&from_fn(signal), Axis::centered(1.0 / rate, 16_001).expect("an axis"));
    let restored = BandPass::new(samples, 21.0..24.0).expect("a band");
    (-60..60).map(|i| 0.0317 * f64::from(i)).map(|x| (restored.at(x) - signal(x)).abs()).fold(0.0, f64::max)
}

#[test]
fn it_works_in_the_allowed_intervals_and_only_there() {
    let rates = bandpass_rates(21.0, 24.0).expect("a band");
    for (rate, n) in [(8.2, Some(6)), (10.0, Some(5)), (6.9, Some(7)), (9.0, None), (7.5, None), (6.5, None)] {
        assert_eq!(rates.iter().find(|r| r.contains(rate)).map(|r| r.n), n);
        // |f| ≤ (1.25πkT)⁻² and |k| ≤ 2/(πk): what is left out on both sides is at most 0.0413 f_s²/(2·8000²), and
        // hardly more for places within two units of the middle
        if n.is_some() {
            assert!(error(rate) < 0.05 * (rate / 8000.0).powi(2), "{rate}: {}", error(rate));
        } else {
            assert!(error(rate) > 0.5, "{rate}: {}", error(rate));
        }
    }
}

#[test]
fn the_intervals_are_those_in_which_no_two_copies_overlap() {
    // the oracle: shift the two bands by all multiples of the rate and look
    let overlaps = |low: f64, high: f64, rate: f64| {
        let hit = |a: f64, b: f64| a < high - 1e-9 && b > low + 1e-9;
        (1..200).any(|k| {
            let shift = f64::from(k) * rate;
            hit(low + shift, high + shift) || hit(shift - high, shift - low) || hit(low - shift, high - shift)
        })
    };
    for (low, high) in [(21.0, 24.0), (1.0, 2.0), (0.0, 1.0), (3.0, 3.7), (10.0, 10.9)] {
        let rates = bandpass_rates(low, high).expect("a band");
        for i in 1..2000 {
            let rate = f64::from(i) * 0.0253;
            let allowed = rates.iter().any(|r| r.contains(rate));
            assert_eq!(allowed, !overlaps(low, high, rate), "({low}, {high}) at {rate}");
        }
    }
}

#[test]
fn even_intervals_mirror_the_band() {
    for interval in bandpass_rates(21.0, 24.0).expect("a band").iter().skip(1) {
        let rate = 0.5 * (interval.low + interval.high);
        let (low, high) = (fold(21.0, rate), fold(24.0, rate));
        assert_eq!(interval.inverted(), low > high);
    }
}

#[test]
fn a_low_band_is_ordinary_sampling() {
    let rates = bandpass_rates(0.0, 5.0).expect("a band");
    assert_eq!(rates.len(), 1);
    assert_eq!((rates[0].n, rates[0].low, rates[0].high), (1, 10.0, f64::INFINITY));
    let samples = Samples::new(Axis::new(0.0, 0.1, 1).expect("an axis"), vec![1.0]).expect("a sample");
    let kernel = BandPass::new(samples, 0.0..5.0).expect("a band");
    assert!((kernel.at(0.037) - sinc(0.37)).abs() < 1e-15);
    assert_eq!((kernel.response(4.9), kernel.response(5.0), kernel.response(5.1)), (0.1, 0.05, 0.0));
}
