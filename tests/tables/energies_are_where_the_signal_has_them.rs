//! The occupied band, of lines, of broad spectra, and of noise.

use nyquist::inspect::table::{Findings, Look, inspect};
use nyquist::num::random::{normal, uniform};
use nyquist::record::Sampling;
use std::f64::consts::PI;

fn look(times: &[f64], values: &[f64]) -> Findings {
    let sampling = Sampling::of(times, &vec![0.0; times.len()]).expect("positions");
    inspect(&sampling, values, Look::default()).expect("a record")
}

fn kinds() -> Vec<(&'static str, Vec<f64>)> {
    let regular = |k: u64| 0.01 * k as f64;
    vec![
        ("uniform", (0..2000).map(regular).collect()),
        ("gaps", (0..2000).filter(|k| k % 17 != 5).map(regular).collect()),
        ("jittered", (0..2000).map(|k| regular(k) + 0.003 * uniform(2, k, 0)).collect()),
        ("cells", (0..2000).map(|k| regular(k) + 0.01 * uniform(3, k, 0)).collect()),
    ]
}

#[test]
fn lines_are_counted_where_they_stand() {
    // energies 1 : 10⁻² : 10⁻³, of which no multiple of 1/20 is a frequency
    let tones = [(3.03, 1.0), (20.22, 0.1), (40.41, 0.1f64.powf(1.5))];
    for (kind, times) in kinds() {
        let value = |t: &f64| tones.iter().map(|(nu, a)| a * (2.0 * PI * nu * t).cos()).sum::<f64>();
        let found = look(&times, &times.iter().map(value).collect::<Vec<_>>());
        let occupied = [0.98, 0.99, 0.999, 0.9999].map(|part| found.energy.occupied(part).unwrap());
        // 1/1.011 = 0.9891, 1.01/1.011 = 0.99901
        for (band, known) in occupied.into_iter().zip([3.03, 20.22, 20.22, 40.41]) {
            assert!((band - known).abs() < 1e-6, "{kind}: {occupied:?}");
        }
        let total: f64 = tones.iter().map(|(_, a)| 0.5 * a * a).sum();
        assert!((found.energy.total() / total - 1.0).abs() < 1e-6, "{kind}");
    }
}

#[test]
fn broad_spectra_have_the_band_of_their_closed_form() {
    // a Gaussian pulse e^{−t²/2s²}: its energy density is e^{−4π²s²ν²}, so that a part erf(2πsν) lies below ν
    let s = 0.05;
    for (kind, times) in kinds() {
        let found = look(&times, &times.iter().map(|t| (-0.5 * ((t - 10.0) / s).powi(2)).exp()).collect::<Vec<_>>());
        // 0.99 at 2πsν = 1.821386; and the pulse without its mean is the pulse to its share of the record
        let known = 1.821_386 / (2.0 * PI * s);
        let band = found.energy.occupied(0.99).expect("resolved");
        // resolved to some bins of 1/20, and Hann's window smears by as many
        assert!((band - known).abs() < 0.15, "{kind}: {band} {known}");
        assert!(found.lines.is_empty(), "{kind}: {:?}", found.lines);
    }
}

#[test]
fn noise_fills_the_band_evenly() {
    for (kind, times) in kinds() {
        let values: Vec<f64> = (0..times.len() as u64).map(|k| normal(7, k, 0)).collect();
        let found = look(&times, &values);
        // up to what least squares resolve; the rest is said to be unresolved
        let top = if found.energy.band().is_finite() { found.energy.band() } else { 50.0 };
        let half = found.energy.above(0.5 * top) - found.energy.unresolved();
        let share = half / (found.energy.total() - found.energy.unresolved());
        // a few hundred independent bins; least squares amplify noise at some frequencies more than at others
        assert!((share - 0.5).abs() < 0.1, "{kind}: {share}");
        assert!(found.lines.is_empty(), "{kind}: {:?}", found.lines);
        let (total, square) = (found.energy.total(), found.rms.powi(2));
        assert!((total / square - 1.0).abs() < 1e-9, "{kind}: {total} {square}");
    }
    let (_, uniform) = kinds().remove(0);
    let values: Vec<f64> = (0..2000).map(|k| normal(8, k, 0)).collect();
    let found = look(&uniform, &values);
    assert_eq!((found.energy.unresolved(), found.energy.band()), (0.0, 50.0));
    assert!(found.energy.occupied(0.99).is_some_and(|band| band > 48.0));
}

#[test]
fn a_constant_has_no_band() {
    let (_, times) = kinds().remove(2);
    let found = look(&times, &vec![2.5; times.len()]);
    assert_eq!((found.energy.total(), found.energy.occupied(0.9999), found.energy.above(0.0)), (0.0, Some(0.0), 0.0));
}
