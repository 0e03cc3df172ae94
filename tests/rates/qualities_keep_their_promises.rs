//! Tones below the end of the pass-band come through, at their phase; tones above the lower Nyquist frequency do not; and in
//! between nothing lands anywhere else.

use crate::tones::{decibels, tone, without};
use nyquist::engine::fft::Butterflies;
use nyquist::engine::real::Real;
use nyquist::rate::{Converter, Quality, convert};

/// The pairs of rates: up, down, simple and not, and two that are no ratios of small numbers.
const PAIRS: [(f64, f64); 8] = [
    (44_100.0, 48_000.0),
    (48_000.0, 44_100.0),
    (96_000.0, 44_100.0),
    (8_000.0, 48_000.0),
    (48_000.0, 8_000.0),
    (44_100.0, 44_100.0 * std::f64::consts::FRAC_PI_3),
    (48_000.0, 48_000.0 / std::f64::consts::SQRT_2),
    (48_000.0, 48_000.0 / (3.0 * std::f64::consts::E)),
];

/// Samples of the lower rate, more than the longest filter reaches: about 1735, of `best` where the ratio is not one of whole
/// numbers.
const AWAY: f64 = 1_900.0;

/// The middle of a tone after conversion, away from its ends: (index, value).
fn converted(frequency: f64, from: f64, to: f64, quality: Quality) -> Vec<(usize, f64)> {
    let low = from.min(to);
    let samples = (8_000.0 * from / low) as usize;
    let record: Vec<f64> = (0..samples).map(|i| tone(frequency, from, i)).collect();
    let out = convert(&record, from, to, quality).expect("the pair of rates is possible");
    let away = (AWAY * to / low) as usize;
    let end = out.len() - away;
    out.into_iter().enumerate().take(end).skip(away).collect()
}

#[test]
fn tones_of_the_pass_band_come_through() {
    for (from, to) in PAIRS {
        for quality in Quality::ALL {
            let promise = quality.promise();
            let band = 0.5 * from.min(to) * promise.pass;
            // gain within the ripple, and images below the rejection
            let most = 10f64.powf(promise.ripple / 20.0) - 1.0 + 10f64.powf(-promise.rejection / 20.0);
            for part in [0.001, 0.1, 0.37, 0.5, 0.73, 0.9, 0.97, 0.99, 1.0] {
                let record = converted(part * band, from, to, quality);
                let worst = record.iter().map(|&(i, v)| (v - tone(part * band, to, i)).abs()).fold(0.0, f64::max);
                let said = decibels(worst);
                println!("{from} → {to:.0}, {quality}, pass at {part}: {said:.1} dB");
                assert!(worst <= most, "{from} → {to}, {quality}, {part}: {said:.1} dB");
            }
        }
    }
}

#[test]
fn tones_above_the_lower_nyquist_frequency_are_gone() {
    for (from, to) in PAIRS.into_iter().filter(|(from, to)| from > to) {
        for quality in Quality::ALL {
            let promise = quality.promise();
            for part in [0.0, 0.0003, 0.001, 0.004, 0.01, 0.1, 0.5, 0.9, 0.999] {
                let frequency = 0.5 * (to + part * (from - to));
                let record = converted(frequency, from, to, quality);
                let worst = record.iter().map(|(_, v)| v.abs()).fold(0.0, f64::max);
                let said = decibels(worst);
                println!("{from} → {to:.0}, {quality}, stop at {part}: {said:.1} dB");
                assert!(said <= -promise.rejection, "{from} → {to}, {quality}, {part}: {said:.1} dB");
            }
        }
    }
}

#[test]
fn tones_of_the_transition_are_weaker_and_leave_no_images() {
    for (from, to) in PAIRS {
        for quality in Quality::ALL {
            let promise = quality.promise();
            let nyquist = 0.5 * from.min(to);
            for part in [0.1, 0.3, 0.5, 0.7, 0.9, 0.98] {
                let frequency = nyquist * (promise.pass + part * (1.0 - promise.pass));
                let record = converted(frequency, from, to, quality);
                let said = decibels(without(&record, frequency, to));
                println!("{from} → {to:.0}, {quality}, transition at {part}: {said:.1} dB");
                assert!(said <= -promise.rejection, "{from} → {to}, {quality}, {part}: {said:.1} dB");
            }
        }
    }
}

#[test]
fn many_tones_at_once_keep_the_sum_of_their_promises() {
    for (from, to) in PAIRS {
        let quality = Quality::Best;
        let promise = quality.promise();
        let band = 0.5 * from.min(to) * promise.pass;
        let low = from.min(to);
        let tones: Vec<f64> = (0..60).map(|k| band * (f64::from(k) + 0.63) / 60.0).collect();
        let sum = |rate: f64, i: usize| tones.iter().map(|&f| tone(f, rate, i)).sum::<f64>() / 60.0;
        let record: Vec<f64> = (0..(8_000.0 * from / low) as usize).map(|i| sum(from, i)).collect();
        let out = convert(&record, from, to, quality).expect("the pair of rates is possible");
        let away = (AWAY * to / low) as usize;
        let worst = (away..out.len() - away).map(|i| (out[i] - sum(to, i)).abs()).fold(0.0, f64::max);
        println!("{from} → {to:.0}: {:.1} dB", decibels(worst));
        assert!(decibels(worst) <= -promise.rejection, "{from} → {to}: {:.1} dB", decibels(worst));
    }
}

/// A record by the fastest butterflies.
fn fastest<T: Real>(record: &[T], from: f64, to: f64) -> Vec<T> {
    let mut converter =
        Converter::with(from, to, 1, Quality::Best, Butterflies::Fastest).expect("the pair is possible");
    let mut out = vec![T::zero(); converter.ratio().frames(record.len() as u64) as usize];
    converter.whole(record, &mut out).expect("the length is right");
    out
}

/// The root of the mean square of the difference, over that of a tone of amplitude one.
fn difference(a: impl Iterator<Item = f64>, b: impl Iterator<Item = f64>) -> f64 {
    let squares: Vec<f64> = a.zip(b).map(|(a, b)| (a - b) * (a - b)).collect();
    (2.0 * squares.iter().sum::<f64>() / squares.len() as f64).sqrt()
}

#[test]
fn numbers_of_32_bits_leave_less_than_130_decibels() {
    for (from, to) in PAIRS {
        let low = from.min(to);
        let away = (AWAY * to / low) as usize;
        for part in [0.001, 0.3, 0.7, 0.97] {
            let frequency = 0.5 * low * part;
            let record: Vec<f32> =
                (0..(8_000.0 * from / low) as usize).map(|i| tone(frequency, from, i) as f32).collect();
            let out = fastest(&record, from, to);
            let middle = out[away..out.len() - away].iter().map(|&v| f64::from(v));
            let said = decibels(difference(middle, (away..).map(|i| tone(frequency, to, i))));
            println!("{from} → {to:.0}, {part}: {said:.1} dB");
            assert!(said < -130.0, "{from} → {to}, {part}: {said:.1} dB");
        }
    }
}

#[test]
fn the_fastest_butterflies_differ_by_their_rounding() {
    for (from, to) in PAIRS {
        let low = from.min(to);
        let record: Vec<f64> = (0..(8_000.0 * from / low) as usize).map(|i| tone(0.3 * low, from, i)).collect();
        let fast = fastest(&record, from, to);
        let plain = convert(&record, from, to, Quality::Best).unwrap();
        let apart = difference(fast.into_iter(), plain.into_iter());
        // windows have at most 2²⁰ values
        assert!(apart <= 32.0 * f64::EPSILON * 20.0, "{from} → {to}: {apart:e}");
    }
}
