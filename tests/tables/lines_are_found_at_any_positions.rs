//! Lines are found where they are, with amplitude and phase, whatever the positions; and none where there are none.

use nyquist::inspect::table::{Findings, LeastSquaresSpectrum, Look, inspect};
use nyquist::num::random::{normal, uniform};
use nyquist::record::Sampling;
use nyquist::sampled::window::Window;
use std::f64::consts::PI;

type Tone = (f64, f64, f64);

fn value(tones: &[Tone], t: f64) -> f64 {
    tones.iter().map(|(nu, a, phase)| a * (2.0 * PI * nu * t + phase).cos()).sum()
}

fn look(times: &[f64], values: impl Fn(f64) -> f64) -> Findings {
    let sampling = Sampling::of(times, &vec![0.0; times.len()]).expect("positions");
    let values: Vec<f64> = sampling.positions().iter().map(|&t| values(t)).collect();
    inspect(&sampling, &values, Look::default()).expect("a record")
}

/// Every kind of positions over ten units of time, about a hundred in each.
fn positions() -> Vec<(&'static str, Vec<f64>)> {
    let regular = |k: u64| 0.01 * k as f64;
    let mut random: Vec<f64> = (0..1000).map(|k| 10.0 * uniform(4, k, 0)).collect();
    random.sort_by(f64::total_cmp);
    vec![
        ("uniform", (0..1000).map(regular).collect()),
        ("gaps", (0..1000).filter(|k| uniform(1, *k, 0) > 0.15).map(regular).collect()),
        ("outage", (0..1000).filter(|k| !(300..450).contains(k)).map(regular).collect()),
        ("jittered", (0..1000).map(|k| regular(k) + 0.004 * uniform(2, k, 0)).collect()),
        ("random", random),
    ]
}

#[test]
fn tones_are_found_with_frequency_amplitude_and_phase() {
    // none of them on a multiple of 1/10, a hundredth between the strongest and the weakest
    let tones = [(3.137, 2.0, 0.4), (17.77, 0.5, -2.0), (31.41, 0.1, 1.5), (44.04, 0.02, 3.0)];
    for (kind, times) in positions() {
        let start = times[0];
        let found = look(&times, |t| 5.0 + value(&tones, t));
        assert_eq!(found.lines.len(), 4, "{kind}: {:?}", found.lines);
        for (line, (frequency, amplitude, phase)) in found.lines.iter().zip(tones) {
            // all of the signal is lines: what limits them is where rounds of fitting end, 10⁻¹² of a turn, and what
            // each of them amplifies of the others' errors
            let known = (2.0 * PI * frequency * start + phase).rem_euclid(2.0 * PI);
            let turned = (line.phase.rem_euclid(2.0 * PI) - known + PI).rem_euclid(2.0 * PI) - PI;
            assert!((line.frequency - frequency).abs() < 1e-8, "{kind}: {line:?} {frequency}");
            assert!((line.amplitude / amplitude - 1.0).abs() < 1e-7, "{kind}: {line:?} {amplitude}");
            assert!(turned.abs() < 1e-6, "{kind}: {line:?} {known}");
        }
        assert!(found.rest < 1e-7, "{kind}: {}", found.rest);
    }
}

#[test]
fn in_noise_a_line_has_its_amplitude_to_the_statistical_error() {
    let sigma = 0.3;
    for (kind, times) in positions() {
        let n = times.len() as f64;
        let sampling = Sampling::of(&times, &vec![0.0; times.len()]).unwrap();
        let noisy = |i: usize| value(&[(12.345, 1.0, 0.7)], sampling.positions()[i]) + sigma * normal(9, i as u64, 0);
        let values: Vec<f64> = (0..times.len()).map(noisy).collect();
        let found = inspect(&sampling, &values, Look::default()).unwrap();
        assert_eq!(found.lines.len(), 1, "{kind}: {:?}", found.lines);
        let line = found.lines[0];
        // Rife and Boorstyn 1974: σ_A = σ√(2/n), σ_ν = √6·σ/(π·A·√n·L); Hann's window takes a half more; four deviations
        let (of_amplitude, of_frequency) = (sigma * (2.0 / n).sqrt(), 6f64.sqrt() * sigma / (PI * n.sqrt() * 10.0));
        assert!((line.amplitude - 1.0).abs() < 6.0 * of_amplitude, "{kind}: {line:?}");
        assert!((line.frequency - 12.345).abs() < 6.0 * of_frequency, "{kind}: {line:?}");
        assert!((found.rest / sigma - 1.0).abs() < 4.0 / (2.0 * n).sqrt(), "{kind}: {}", found.rest);
    }
}

#[test]
fn noise_has_no_lines_and_a_constant_nothing_at_all() {
    for seed in 0..20 {
        for (kind, times) in positions() {
            let sampling = Sampling::of(&times, &vec![0.0; times.len()]).unwrap();
            let values: Vec<f64> = (0..times.len() as u64).map(|i| normal(100 + seed, i, 0)).collect();
            let found = inspect(&sampling, &values, Look::default()).unwrap();
            assert!(found.lines.is_empty(), "{kind} {seed}: {:?}", found.lines);
        }
    }
    for (_, times) in positions() {
        let found = look(&times, |_| 0.1);
        assert!(found.lines.is_empty() && found.rms < 1e-15 && (found.mean - 0.1).abs() < 1e-15);
    }
}

#[test]
fn a_trend_is_no_line() {
    for (kind, times) in positions() {
        let found = look(&times, |t| 3.0 * t + 0.2 * (2.0 * PI * 20.2 * t).cos());
        assert_eq!(found.lines.len(), 1, "{kind}: {:?}", found.lines);
        assert!((found.lines[0].frequency - 20.2).abs() < 1e-3, "{kind}: {:?}", found.lines);
    }
}

#[test]
fn equally_spaced_samples_have_the_amplitudes_of_the_windowed_transform() {
    let times: Vec<f64> = (0..256).map(|k| f64::from(k) / 64.0).collect();
    let values: Vec<f64> = (0..256).map(|k| normal(3, k, 0)).collect();
    let sampling = Sampling::of(&times, &[0.0; 256]).unwrap();
    for window in [Window::Rectangular, Window::Hann, Window::Blackman] {
        let spectrum = LeastSquaresSpectrum::of(&sampling, &values, window, None).unwrap();
        let weights = window.values(256);
        let sum: f64 = weights.iter().sum();
        let mean = values.iter().zip(&weights).map(|(v, w)| v * w).sum::<f64>() / sum;
        let amplitude = |k: usize| {
            let angle = |j: usize| 2.0 * PI * (j * k % 256) as f64 / 256.0;
            let part =
                |f: fn(f64) -> f64| -> f64 { (0..256).map(|j| weights[j] * (values[j] - mean) * f(angle(j))).sum() };
            2.0 / sum * part(f64::cos).hypot(part(f64::sin))
        };
        // but for the ends, where a wave under the window overlaps with its mirror image
        for (i, [frequency, a]) in spectrum.amplitudes().enumerate().take(124).skip(5) {
            assert_eq!(frequency, (i + 1) as f64 / 4.0);
            assert!((a - amplitude(i + 1)).abs() < 1e-13, "{window:?} {frequency}: {a} {}", amplitude(i + 1));
        }
        // power densities have the mean of the noise's, 1/32 for unit variance over 32 frequencies: 124 exponential numbers
        let mean = spectrum.densities().map(|[_, p]| p).sum::<f64>() / 128.0;
        assert!((32.0 * mean - 1.0).abs() < 4.0 / (128f64 / 2.0).sqrt(), "{window:?}: {mean}");
    }
}

#[test]
fn positions_that_return_make_lines_alike() {
    // ten samples in the first tenth of every day, for 60 days
    let times: Vec<f64> = (0..600).map(|i| f64::from(i / 10) + 0.01 * f64::from(i % 10)).collect();
    let sampling = Sampling::of(&times, &[0.0; 600]).unwrap();
    let found = inspect(&sampling, &vec![0.0; 600], Look { up_to: Some(5.0), ..Look::default() }).unwrap();
    let daily = found.likenesses.iter().find(|l| (l.shift - 1.0).abs() < 0.02).expect("once a day");
    // |W| of ten pulses a hundredth apart: sin(0.1π)/(10 sin(0.01π)) = 0.98 at once a day
    assert!((daily.height - (0.1 * PI).sin() / (10.0 * (0.01 * PI).sin())).abs() < 0.01, "{daily:?}");
    let (_, uniform) = positions().remove(0);
    assert!(look(&uniform, |_| 0.0).likenesses.is_empty());
    let (_, random) = positions().pop().unwrap();
    assert!(look(&random, |_| 0.0).likenesses.is_empty());
}
