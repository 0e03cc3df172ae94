//! E30, E31: two drawings of the source that are not what they say, and what the figures here draw instead.

use nyquist::figure::{Figure, catalog};
use nyquist::laws::alias::leaked_spectrum;
use nyquist::prelude::*;

fn figure(id: &str) -> Figure {
    catalog::by_name(id).and_then(|entry| entry.figure()).expect("a figure of the catalogue")
}

/// The drawn value at `x`, which must be a point of the layer.
fn drawn(figure: &Figure, panel: &str, layer: &str, x: f64) -> f64 {
    let layer = figure.panel(panel).and_then(|p| p.layer(layer)).expect("a layer of the figure");
    layer.points().iter().find(|p| (p[0] - x).abs() < 1e-9).expect("a drawn point")[1]
}

#[test]
fn e30_what_the_low_pass_leaves_is_the_sum_of_the_copies() {
    let spectrum = Gaussian::with_spectrum(8.0).unwrap().spectrum();
    let kept = leaked_spectrum(&spectrum, 1.0).unwrap();
    // at the place where the source's path was measured
    assert!((kept.density(0.408_57).re - 0.323_96).abs() < 5e-6);
    let figure = figure("f28-leak");
    for nu in [-0.475, -0.25, 0.0, 0.4] {
        let (sum, single) = (drawn(&figure, "spectrum", "kept", nu), drawn(&figure, "spectrum", "signal", nu));
        let by_hand: f64 = (-4..=4).map(|k| (-8.0 * (nu - f64::from(k)).powi(2)).exp()).sum();
        assert!((sum - by_hand).abs() < 1e-15 && sum > single);
    }
    assert!((drawn(&figure, "space", "reconstruction", 0.5) - 0.476_01).abs() < 5e-6);
    assert!((drawn(&figure, "space", "signal", 0.5) - 0.460_34).abs() < 5e-6);
    // the samples are kept
    assert!((drawn(&figure, "space", "reconstruction", 0.0) - drawn(&figure, "space", "signal", 0.0)).abs() < 1e-13);
}

#[test]
fn e30_the_printed_copy_cut_off_loses_the_samples() {
    let f = Gaussian::with_spectrum(8.0).unwrap();
    let printed = f.spectrum().low_passed(0.5).unwrap();
    assert!((printed.density(0.408_57).re - 0.263_04).abs() < 5e-6); // the path: 0.26320
    // a reconstruction goes through the samples; this function misses them, by what was cut off
    for x in [0.0, 1.0] {
        assert!((printed.inverse_at(x).unwrap().re - f.at(x)).abs() > 0.01, "x = {x}");
    }
    let kept = leaked_spectrum(&f.spectrum(), 1.0).unwrap();
    for x in [0.0, 1.0, 2.0] {
        assert!((kept.inverse_at(x).unwrap().re - f.at(x)).abs() < 1e-13, "x = {x}");
    }
}

/// The largest `|F|` of a function under a window wide enough for its oscillations, and where: by FFT.
fn strongest(f: impl Fn(f64) -> f64) -> f64 {
    let windowed = from_fn(|x| f(x) * (-(x / 4.0) * (x / 4.0)).exp());
    let bins = forward(&Samples::of(&windowed, Axis::centered(1.0 / 32.0, 2048).expect("the arguments are valid")));
    let top = |a: [f64; 2], b: [f64; 2]| if b[1] > a[1] { b } else { a };
    bins.magnitudes().filter(|p| p[0] >= 0.0).fold([0.0, 0.0], top)[0]
}

#[test]
fn e31_the_printed_oscillation_has_frequencies_that_the_printed_spectrum_does_not() {
    // printed: half-period 0.134 of a tick, starting at a minimum; its spectrum ends at √2
    let half_period = 0.134;
    let oscillation = strongest(|x| -(std::f64::consts::PI * x / half_period).cos());
    assert!(oscillation > 2.0 * HighBump.spectrum().band(), "{oscillation}");
    assert_eq!(HighBump.spectrum().density(oscillation).norm(), 0.0);
    // a spectrum that is nowhere negative has its greatest value at 0, not a minimum
    assert!((1..4000).all(|i| HighBump.at(0.001 * f64::from(i)) < HighBump.at(0.0)));
}

#[test]
fn e31_the_pair_of_the_figures_is_a_true_one() {
    // by a plain Riemann sum of the printed spectrum, 1 − ν⁸/16 up to √2
    let n = 20_000;
    let step = 2f64.sqrt() / f64::from(n);
    let by_hand = |x: f64| -> f64 {
        let term = |nu: f64| 2.0 * step * (1.0 - nu.powi(8) / 16.0) * (2.0 * std::f64::consts::PI * nu * x).cos();
        (0..n).map(|i| step * (f64::from(i) + 0.5)).map(term).sum()
    };
    let figure = figure("f09-functions");
    for x in [0.2, 0.56, 1.0, 2.4, 4.0] {
        let near = |p: &&[f64; 2]| (p[0] - x).abs();
        let points = figure.panel("high").and_then(|p| p.layer("inverse")).expect("the dots").points();
        let dot = points.iter().min_by(|a, b| near(a).total_cmp(&near(b))).expect("dots");
        // the midpoint rule errs by h²/24·√2·max|(F·cos)″| < 2·10⁻⁶
        assert!((dot[1] - by_hand(dot[0])).abs() < 2e-6, "{dot:?}");
    }
    // its half-period far out is 1/(2√2) = 0.3536
    let zero = |mut low: f64, mut high: f64| {
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if HighBump.at(low) * HighBump.at(middle) <= 0.0 { high = middle } else { low = middle }
        }
        low
    };
    let crossings: Vec<f64> = (0..4000)
        .map(|i| 20.0 + 0.001 * f64::from(i))
        .filter(|x| HighBump.at(*x) * HighBump.at(x + 0.001) < 0.0)
        .map(|x| zero(x, x + 0.001))
        .collect();
    let mean = (crossings[crossings.len() - 1] - crossings[0]) / (crossings.len() - 1) as f64;
    assert!((mean - 0.125f64.sqrt()).abs() < 1e-4, "{mean}");
}
