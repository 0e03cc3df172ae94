//! E33. Printed (in a popular book): the power spectrum of a product is the convolution of the power spectra, so that
//! copies add in power. Right: copies of a deterministic signal add in amplitude; only under a comb with a random shift
//! do powers add, in the mean.
//!
//! The counter-example: tones of 0.3 and 0.7, sampled at 1.

use nyquist::prelude::*;
use std::f64::consts::TAU;

fn value(x: f64) -> f64 {
    (TAU * 0.3 * x).cos() + (TAU * 0.7 * x).cos()
}

/// The mean square of 1000 samples at `k + shift`: whole numbers of periods.
fn power(shift: f64) -> f64 {
    (0..1000).map(|k| value(f64::from(k) + shift).powi(2)).sum::<f64>() / 1000.0
}

#[test]
fn printed_the_powers_would_add_to_one() {
    let separate = |nu: f64| (0..1000).map(|k| (TAU * nu * f64::from(k)).cos().powi(2)).sum::<f64>() / 1000.0;
    assert!((separate(0.3) + separate(0.7) - 1.0).abs() < 1e-12);
    assert!((power(0.0) - 1.0).abs() > 0.99);
}

#[test]
fn right_the_amplitudes_add_and_the_power_is_two() {
    assert!((power(0.0) - 2.0).abs() < 1e-12);
    // the library: the copies of the spectrum put both tones on one line, of weight ½ + ½
    let both = Sum(Cosine::new(0.3).expect("a tone"), Cosine::new(0.7).expect("a tone"));
    let lines = both.spectrum().replicated(1.0, 2).expect("a rate");
    let near: Vec<f64> = lines.lines().iter().filter(|l| (l.at - 0.3).abs() < 1e-12).map(|l| l.weight.re).collect();
    assert!((near.iter().sum::<f64>() - 1.0).abs() < 1e-15);
    assert!((2.0 * near.iter().sum::<f64>().powi(2) - power(0.0)).abs() < 1e-12);
    // because 0.7 folds onto 0.3
    assert!((fold(0.7, 1.0) - 0.3).abs() < 1e-15);
}

#[test]
fn right_with_a_random_shift_the_powers_add_in_the_mean() {
    // the two tones beat with one period a unit of shift: eight equal shifts are the mean over all of them
    let mean = (0..8).map(|s| power(f64::from(s) / 8.0)).sum::<f64>() / 8.0;
    assert!((mean - 1.0).abs() < 1e-12);
    // and no single shift need give it: 1 + cos(2π·shift)
    for s in 0..8 {
        let shift = f64::from(s) / 8.0;
        assert!((power(shift) - 1.0 - (TAU * shift).cos()).abs() < 1e-12);
    }
}
