//! E08. Printed: a rate of "at least 2B" restores every signal of band B. Right: more than 2B where the spectrum has a
//! line at B; equality suffices where it has none.

use nyquist::prelude::*;
use std::f64::consts::{FRAC_PI_2, PI};

const BAND: f64 = 3.0;

fn samples(phase: f64) -> Vec<f64> {
    (0..1000).map(|k| (2.0 * PI * BAND * f64::from(k) / (2.0 * BAND) + phase).cos()).collect()
}

#[test]
fn printed_the_sine_at_the_band_limit_has_no_samples_at_all() {
    // the argument πk is the result of four roundings, ε·πk each at most
    assert!(samples(-FRAC_PI_2).iter().zip(0..).all(|(v, k)| v.abs() <= 4.0 * f64::EPSILON * PI * f64::from(k + 1)));
    // the library's own sine is exact there
    let sine = Sine::new(BAND).expect("a frequency");
    let axis = Axis::new(0.0, 0.5 / BAND, 1000).expect("an axis");
    assert!(Samples::of(&sine, axis).values().iter().all(|v| v.abs() <= f64::EPSILON * PI * 1000.0));
    assert_eq!(Verdict::on(&sine.spectrum(), 2.0 * BAND), Ok(Verdict::Critical));
}

#[test]
fn printed_amplitude_and_phase_cannot_be_told_apart() {
    for i in 0..=12 {
        let phase = f64::from(i) * PI / 12.0;
        // what the samples say of the amplitude: their projection on (−1)^k
        let values = samples(phase);
        let amplitude = values.iter().zip(0..).map(|(v, k)| if k % 2 == 0 { *v } else { -v }).sum::<f64>() / 1000.0;
        assert!((amplitude - phase.cos()).abs() < 1e-12, "{phase}");
        // a cosine of that amplitude has the same samples
        let other: Vec<f64> = samples(0.0).iter().map(|v| v * phase.cos()).collect();
        assert!(values.iter().zip(&other).all(|(a, b)| (a - b).abs() < 1e-12));
    }
}

#[test]
fn right_more_than_twice_the_band_tells_them_apart() {
    // the samples of cosine and sine span a plane: their Gram determinant is that of independent vectors
    for rate in [2.05 * BAND, 2.5 * BAND] {
        let wave = |phase: f64| (0..1000).map(move |k| (2.0 * PI * BAND * f64::from(k) / rate + phase).cos());
        let product = |a: f64, b: f64| wave(a).zip(wave(b)).map(|(x, y)| x * y).sum::<f64>() / 1000.0;
        let (cc, ss, cs) = (product(0.0, 0.0), product(-FRAC_PI_2, -FRAC_PI_2), product(0.0, -FRAC_PI_2));
        assert!((cc * ss - cs * cs - 0.25).abs() < 0.01);
        assert!(Verdict::of(BAND, true, rate).expect("a rate").recoverable());
    }
}

#[test]
fn right_equality_suffices_for_a_density() {
    // RC(1) at T = ½ has three samples that are not zero: 1 at 0, ½ at ±½; their sinc series is RC(1)
    let rc = RaisedCosine::new(1.0).expect("a band");
    assert_eq!(Verdict::on(&rc.spectrum(), 2.0), Ok(Verdict::Recoverable { margin: 0.0 }));
    let sinc = |t: f64| if t == 0.0 { 1.0 } else { (PI * t).sin() / (PI * t) };
    for i in -200..=200 {
        let x = 0.0173 * f64::from(i);
        let series = sinc(2.0 * x) + 0.5 * sinc(2.0 * x - 1.0) + 0.5 * sinc(2.0 * x + 1.0);
        assert!((series - rc.at(x)).abs() <= 4e-15, "{x}: {:e}", series - rc.at(x));
    }
}

#[test]
fn a_rate_that_comes_as_one_over_a_step_still_counts_as_equal() {
    for i in 1..1000 {
        let band = f64::from(i) * 0.0137;
        let step = 1.0 / (2.0 * band);
        assert_eq!(Verdict::of(band, true, 1.0 / step), Ok(Verdict::Critical));
        assert!(matches!(Verdict::of(band, true, 1.0 / step * 1.000_001), Ok(Verdict::Recoverable { .. })));
        assert!(matches!(Verdict::of(band, true, 1.0 / step * 0.999_999), Ok(Verdict::Aliased { .. })));
    }
}

#[test]
fn a_signal_that_is_not_band_limited_is_aliased_at_every_rate() {
    let verdict = Verdict::on(&Boxcar::new(1.0).expect("a width").spectrum(), 1e6).expect("a rate");
    assert_eq!(verdict, Verdict::Aliased { overlap: [0.0, f64::INFINITY] });
}
