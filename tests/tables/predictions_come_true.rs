//! What a check says would alias is found in samples that are taken at the new rate: where it says, as strong, and at the
//! phase it says. The samples are taken from the closed form, and from the table by interpolation.

use nyquist::inspect::table::{Findings, Look, Prediction, inspect};
use nyquist::num::random::uniform;
use nyquist::prelude::*;
use nyquist::record::{Interpolator, Sampling, Wanted};
use std::f64::consts::PI;

const TONES: [(f64, f64, f64); 4] = [(4.1, 1.0, 0.3), (13.7, 0.5, -1.0), (29.3, 0.2, 2.0), (37.9, 0.05, 0.9)];

fn signal(t: f64) -> f64 {
    TONES.iter().map(|(nu, a, phase)| a * (2.0 * PI * nu * t + phase).cos()).sum()
}

fn kinds() -> Vec<(&'static str, Vec<f64>)> {
    let regular = |k: u64| 0.01 * k as f64;
    vec![
        ("uniform", (0..3000).map(regular).collect()),
        ("gaps", (0..3000).filter(|k| k % 19 != 7).map(regular).collect()),
        ("jittered", (0..3000).map(|k| regular(k) + 0.002 * uniform(5, k, 0)).collect()),
    ]
}

/// Amplitude and phase at a frequency, of samples at `k/rate`: by least squares over cosine and sine of all aliases at once,
/// solved here by normal equations.
fn measured(samples: &[f64], rate: f64, frequencies: &[f64]) -> Vec<(f64, f64)> {
    let basis = |k: usize, i: usize| {
        let turns = 2.0 * PI * (frequencies[i / 2] * k as f64 / rate).rem_euclid(1.0);
        if i.is_multiple_of(2) { turns.cos() } else { turns.sin() }
    };
    let m = 2 * frequencies.len();
    let mut rows: Vec<Vec<f64>> = vec![vec![0.0; m + 1]; m];
    for (k, v) in samples.iter().enumerate() {
        for (i, row) in rows.iter_mut().enumerate() {
            row.iter_mut().take(m).enumerate().for_each(|(j, sum)| *sum += basis(k, i) * basis(k, j));
            row[m] += basis(k, i) * v;
        }
    }
    for i in 0..m {
        for j in i + 1..m {
            let factor = rows[j][i] / rows[i][i];
            let above = rows[i].clone();
            rows[j].iter_mut().zip(&above).skip(i).for_each(|(value, upper)| *value -= factor * upper);
        }
    }
    let mut x = vec![0.0; m];
    for i in (0..m).rev() {
        let known: f64 = (i + 1..m).map(|j| rows[i][j] * x[j]).sum();
        x[i] = (rows[i][m] - known) / rows[i][i];
    }
    x.chunks(2).map(|c| (c[0].hypot(c[1]), (-c[1]).atan2(c[0]))).collect()
}

fn aliases_of(found: &Findings, prediction: &Prediction<'_>, rate: f64) -> Vec<(f64, f64, f64)> {
    // all lines, also those that stay: they are in the samples as well
    let stays = found.lines.iter().filter(|line| line.frequency < 0.5 * rate);
    let stays = stays.map(|line| (line.frequency, line.amplitude, line.phase));
    let folds = prediction.landings.iter();
    stays.chain(folds.map(|l| (l.alias.frequency(), l.line.amplitude, l.phase(0.0)))).collect()
}

#[test]
fn aliases_are_found_where_they_were_predicted() {
    for (kind, times) in kinds() {
        let sampling = Sampling::of(&times, &vec![0.0; times.len()]).unwrap();
        let values: Vec<f64> = sampling.positions().iter().map(|&t| signal(t)).collect();
        let found = inspect(&sampling, &values, Look::default()).unwrap();
        assert_eq!(found.lines.len(), 4, "{kind}");
        let between = Interpolator::new(&sampling, Wanted { band: Some(40.0), ..Wanted::default() }).unwrap();
        let interpolated = between.of(&sampling, &values).unwrap();
        let start = sampling.positions()[0];
        for (rate, folding) in [(60.0, 1), (50.0, 2), (23.0, 3), (100.0 / 7.0, 3)] {
            let prediction = Prediction::new(&found, rate).unwrap();
            assert_eq!(prediction.landings.len(), folding, "{kind} {rate}");
            let predicted = aliases_of(&found, &prediction, rate);
            let frequencies: Vec<f64> = predicted.iter().map(|p| p.0).collect();
            let n = (29.0 * rate) as usize;
            // the closed form at the new rate; frequencies are found to 10⁻⁸ and amplitudes to 10⁻⁷ (as the test of lines
            // has it), so that a line turns by 2·10⁻⁶ in 29 units of time
            let exact: Vec<f64> = (0..n).map(|k| signal(start + k as f64 / rate)).collect();
            for ((amplitude, phase), (nu, a, phi)) in measured(&exact, rate, &frequencies).into_iter().zip(&predicted) {
                let turned = (phase - phi + PI).rem_euclid(2.0 * PI) - PI;
                assert!(
                    (amplitude / a - 1.0).abs() < 1e-6 && turned.abs() < 1e-5,
                    "{kind} {rate} {nu}: {amplitude} {a} {turned}"
                );
            }
            // the table, interpolated: not within half a second of its ends, where values depend on the edge
            let first = (0.5 * rate).ceil() as usize;
            let taken: Vec<f64> = (first..n - first).map(|k| interpolated.at(start + k as f64 / rate)).collect();
            let there = measured(&taken, rate, &frequencies);
            for ((amplitude, _), (nu, a, _)) in there.into_iter().zip(&predicted) {
                // kernels err by 10⁻⁹ of all amplitudes there, least squares by what the kink of the mirror leaves: 10⁻³
                let most = if kind == "uniform" { 1e-7 } else { 2e-3 };
                assert!((amplitude - a).abs() < most, "{kind} {rate} {nu}: {amplitude} {a}");
            }
        }
    }
}

#[test]
fn the_ratio_is_that_of_the_energies() {
    let (_, times) = kinds().remove(0);
    let sampling = Sampling::of(&times, &vec![0.0; times.len()]).unwrap();
    let values: Vec<f64> = sampling.positions().iter().map(|&t| signal(t)).collect();
    let found = inspect(&sampling, &values, Look::default()).unwrap();
    let at_50 = Prediction::new(&found, 50.0).unwrap();
    let (stays, folds) = (1.0 + 0.25, 0.04 + 0.0025);
    assert!((at_50.signal_to_alias() - 10.0 * f64::log10(stays / folds)).abs() < 1e-6);
    assert!(at_50.aliased_rest() < 1e-12);
    // the rate for a tolerance is the least that keeps it: at it the line folds, above it nothing does
    let rate = at_50.rate_for(20.0).unwrap();
    assert!((rate - 2.0 * 29.3).abs() < 1e-6);
    assert!(Prediction::new(&found, rate * 0.999).unwrap().signal_to_alias() < 20.0);
    assert!(Prediction::new(&found, rate * 1.001).unwrap().signal_to_alias() > 20.0);
    assert_eq!(Prediction::new(&found, 80.0).unwrap().landings.len(), 0);
    for rate in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(Prediction::new(&found, rate).is_err());
    }
}
