//! E36. Printed (in a popular book): "Nyquist frequency" for the least rate `2B`, and elsewhere a rate "greater than or
//! equal to" it. Right: the Nyquist *rate* is `2B`, the Nyquist *frequency* `f_s/2`; and equality is its own verdict.

use nyquist::prelude::*;
use std::f64::consts::TAU;

#[test]
fn printed_a_signal_of_band_2b_would_survive_a_rate_of_2b() {
    // whoever takes 2B = 8 for a Nyquist frequency, "the highest that survives", loses a tone at 5 < 8
    let (band, tone) = (4.0, 5.0);
    let rate = nyquist_rate(band);
    for k in 0..50 {
        let x = f64::from(k) / rate;
        assert!(((TAU * tone * x).cos() - (TAU * fold(tone, rate) * x).cos()).abs() < 1e-12);
    }
    assert_eq!(fold(tone, rate), 3.0);
    assert!(tone > nyquist_frequency(rate));
}

#[test]
fn right_the_two_are_inverse_to_each_other_and_not_the_same() {
    for band in [0.25, 1.0, 3.0, 22_050.0] {
        assert_eq!(nyquist_frequency(nyquist_rate(band)), band);
        assert_eq!(nyquist_rate(nyquist_frequency(band)), band);
        assert_eq!(nyquist_rate(band), 4.0 * nyquist_frequency(band));
    }
    let axis = Axis::new(0.0, 0.125, 10).expect("an axis");
    assert_eq!(axis.nyquist(), nyquist_frequency(axis.rate()));
}

#[test]
fn right_equality_is_not_enough_for_a_tone() {
    for band in [0.25, 1.0, 3.0] {
        let tone = Cosine::new(band).expect("a tone").spectrum();
        let verdict = |rate| Verdict::on(&tone, rate).expect("a rate");
        assert_eq!(verdict(nyquist_rate(band)), Verdict::Critical);
        assert!(verdict(1.01 * nyquist_rate(band)).recoverable());
        assert!(!verdict(nyquist_frequency(nyquist_rate(band))).recoverable()); // B itself as a rate
    }
}
