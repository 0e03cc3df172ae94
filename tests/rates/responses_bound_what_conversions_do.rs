//! What a response says of a tone, a conversion does: exactly below the lower Nyquist frequency, at most beyond.

use crate::tones::{decibels, fitted, tone};
use nyquist::rate::{Quality, Response, convert};

const PAIRS: [(f64, f64); 4] =
    [(48_000.0, 16_000.0), (96_000.0, 44_100.0), (48_000.0, 48_000.0 / std::f64::consts::SQRT_2), (8_000.0, 48_000.0)];

/// The middle of a converted tone, away from its ends by more than the longest filter.
fn converted(frequency: f64, from: f64, to: f64, quality: Quality) -> Vec<(usize, f64)> {
    let low = from.min(to);
    let record: Vec<f64> = (0..(12_000.0 * from / low) as usize).map(|i| tone(frequency, from, i)).collect();
    let out = convert(&record, from, to, quality).expect("the pair of rates is possible");
    let away = (3_000.0 * to / low) as usize;
    let end = out.len() - away;
    out.into_iter().enumerate().take(end).skip(away).collect()
}

#[test]
fn tones_beyond_the_lower_nyquist_frequency_come_out_weaker_than_said() {
    for (from, to) in PAIRS.into_iter().filter(|(from, to)| from > to) {
        for quality in Quality::ALL {
            let response = Response::new(from, to, quality).unwrap();
            for part in [1.0001, 1.003, 1.01, 1.03, 1.1, 1.3, 1.7, 2.0, 2.13, 2.9] {
                let frequency = 0.5 * to * part;
                if frequency >= 0.5 * from {
                    continue;
                }
                let worst = converted(frequency, from, to, quality).iter().map(|(_, v)| v.abs()).fold(0.0, f64::max);
                let (said, found) = (response.gain(frequency), worst);
                println!("{from} → {to:.0}, {quality}, {part}: {:.1} ≤ {:.1} dB", decibels(found), decibels(said));
                assert!(found <= said, "{from} → {to}, {quality}, {part}");
                // and the promise is what it says at most
                assert!(decibels(said) < -quality.promise().rejection);
            }
        }
    }
}

#[test]
fn tones_below_it_come_out_as_strong_as_said() {
    for (from, to) in PAIRS {
        for quality in Quality::ALL {
            let response = Response::new(from, to, quality).unwrap();
            let nyquist = 0.5 * from.min(to);
            // the design errs in the transition by less than its ripple: the samples of the filter repeat its spectrum
            let ripple = 10f64.powf(-quality.promise().rejection / 20.0);
            for part in [0.1, 0.5, 0.9, 0.92, 0.95, 0.97, 0.985, 0.995, 0.999] {
                let frequency = part * nyquist;
                let [a, b] = fitted(&converted(frequency, from, to, quality), frequency, to);
                let (said, found) = (response.gain(frequency), a.hypot(b));
                println!("{from} → {to:.0}, {quality}, {part}: {:e}", found - said);
                assert!((found - said).abs() <= 2.0 * ripple, "{from} → {to}, {quality}, {part}: {found} ≠ {said}");
            }
        }
    }
}

#[test]
fn equal_rates_change_nothing() {
    let response = Response::new(48_000.0, 48_000.0, Quality::Fast).unwrap();
    assert_eq!([0.0, 12_345.0, 23_999.0].map(|f| response.gain(f)), [1.0; 3]);
    assert!(Response::new(48_000.0, 1.0, Quality::Fast).is_err());
    assert!(Response::new(48_000.0, f64::NAN, Quality::Fast).is_err());
}
