//! E07. Printed: "if T is not large enough, the copies overlap". Right: they overlap when T is not *small* enough.
//!
//! The oracle: the relative error energy of RC(1), `F = cos²(πν/2)` on `|ν| < 1`, by summing copies and integrating
//! here; its values are those of the inventory (F29), recomputed there with an independent script.

use nyquist::prelude::*;
use std::f64::consts::{FRAC_PI_2, PI};

fn spectrum(nu: f64) -> f64 {
    if nu.abs() < 1.0 { (FRAC_PI_2 * nu).cos().powi(2) } else { 0.0 }
}

/// `∫|F̃ − F|² / ∫F²`, where `F̃` is the sum of all copies within the Nyquist frequency and nothing beyond, by the
/// midpoint rule with 4800 points a unit (edges of the integrand fall between them; the error is below 10⁻⁷).
fn relative_error_energy(step: f64) -> f64 {
    let cells = 4800;
    let error = |i: i32| {
        let nu = (f64::from(i) + 0.5) / f64::from(cells);
        let copies = |nu: f64| (-9..=9).map(|k| spectrum(nu - f64::from(k) / step)).sum::<f64>();
        let restored = if nu < 0.5 / step { copies(nu) } else { 0.0 };
        (restored - spectrum(nu)).powi(2)
    };
    2.0 * (0..3 * cells).map(error).sum::<f64>() / f64::from(cells) / 0.75
}

#[test]
fn printed_a_small_step_would_overlap_and_it_does_not() {
    for step in [0.1, 0.4, 0.5] {
        assert!(relative_error_energy(step) < 1e-30);
        assert!(
            Verdict::on(&RaisedCosine::new(1.0).expect("a band").spectrum(), 1.0 / step).expect("a rate").recoverable()
        );
    }
}

#[test]
fn right_a_large_step_overlaps_the_more_the_larger_it_is() {
    let known = [(0.6, 0.000_808), (0.8, 0.040_81), (1.0, 0.151_17), (1.25, 0.335)];
    let rc = RaisedCosine::new(1.0).expect("a band");
    for (step, energy) in known {
        let digits = if step > 1.1 { 5e-4 } else { 5e-6 };
        assert!((relative_error_energy(step) - energy).abs() < digits, "{step}: {}", relative_error_energy(step));
        let verdict = Verdict::on(&rc.spectrum(), 1.0 / step).expect("a rate");
        let Verdict::Aliased { overlap: [from, to] } = verdict else { panic!("{verdict:?}") };
        assert!((from - (1.0 / step - 1.0).max(0.0)).abs() < 1e-15 && to == 1.0);
    }
}

#[test]
fn the_overlap_is_where_more_than_one_copy_stands() {
    // F26: RC(1) at T = 0.8 overlaps on 0.25 < |ν| < 1
    assert_eq!(Verdict::of(1.0, false, 1.25), Ok(Verdict::Aliased { overlap: [0.25, 1.0] }));
    for i in 0..200 {
        let nu = (f64::from(i) + 0.5) / 200.0;
        let copies = (-3..=3).filter(|&k| spectrum(nu - 1.25 * f64::from(k)) > 0.0).count();
        assert_eq!(copies > 1, nu > 0.25);
    }
}

#[test]
fn in_space_the_sinc_series_fails_at_the_large_step_only() {
    // RC(1) itself: sinc(2x)/(1 − 4x²), naively summed
    let sinc = |t: f64| if t == 0.0 { 1.0 } else { (PI * t).sin() / (PI * t) };
    let f = |x: f64| {
        let edge = 1.0 - 4.0 * x * x;
        if edge.abs() < 1e-9 { 0.5 } else { sinc(2.0 * x) / edge }
    };
    let restored = |x: f64, step: f64| -> f64 {
        (-4000..=4000).map(|k| f(f64::from(k) * step) * sinc(x / step - f64::from(k))).sum()
    };
    let worst = |step| {
        (0..40).map(|i| 0.05 * f64::from(i) + 0.013).map(|x| (restored(x, step) - f(x)).abs()).fold(0.0, f64::max)
    };
    assert!(worst(0.4) < 1e-11 && worst(0.5) < 1e-13, "{} {}", worst(0.4), worst(0.5));
    assert!(worst(0.8) > 0.09 && worst(0.8) <= 0.1618); // V08: 0.0943, at most 2∫|F| beyond
}
