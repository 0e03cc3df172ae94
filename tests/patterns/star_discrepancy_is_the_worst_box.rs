//! The star discrepancy that the kinetic sweep finds is that of its definition: the worst box at the origin.

use nyquist::num::random::{bits, uniform};
use nyquist::pattern::catalog;
use nyquist::prelude::*;

/// All boxes whose sides go through points or the square's, closed and open: `O(N³)`, straight from the definition.
fn by_definition(points: &[[f64; 2]]) -> f64 {
    let n = points.len() as f64;
    let sides = |d: usize| points.iter().map(move |p| p[d]).chain([1.0]);
    let mut worst: f64 = 0.0;
    for x in sides(0) {
        for y in sides(1) {
            let closed = points.iter().filter(|p| p[0] <= x && p[1] <= y).count() as f64 / n;
            let open = points.iter().filter(|p| p[0] < x && p[1] < y).count() as f64 / n;
            worst = worst.max(closed - x * y).max(x * y - open);
        }
    }
    worst
}

#[test]
fn in_the_plane_for_every_pattern_and_for_points_that_share_coordinates() {
    for pattern in catalog::all(64).expect("a square power of two") {
        for seed in 0..5 {
            let points = pattern.points(seed);
            let (found, known) = (star_discrepancy(&points).expect("in the square"), by_definition(&points));
            assert!((found - known).abs() <= 4.0 * f64::EPSILON, "{}: {found} {known}", pattern.name());
        }
    }
    for set in 0..300u64 {
        let n = 1 + (bits(set, 0, 0) % 40) as usize;
        // few different coordinates, with zero and one among them, so that many points coincide
        let coordinate = |i: usize, d| (uniform(set, i as u64, d) * 6.0).floor() / 5.0;
        let points: Vec<[f64; 2]> = (0..n).map(|i| [coordinate(i, 1), coordinate(i, 2)]).collect();
        let (found, known) = (star_discrepancy(&points).expect("in the square"), by_definition(&points));
        assert!((found - known).abs() <= 4.0 * f64::EPSILON, "{points:?}: {found} {known}");
    }
}

#[test]
fn on_a_line() {
    for set in 0..100 {
        let points: Vec<f64> = (0..30).map(|i| uniform(set, i, 0)).collect();
        let n = points.len() as f64;
        let at = |x: f64| {
            let below = points.iter().filter(|p| **p < x).count() as f64 / n;
            let up_to = points.iter().filter(|p| **p <= x).count() as f64 / n;
            (x - below).max(up_to - x)
        };
        let known = points.iter().copied().chain([1.0]).map(at).fold(0.0, f64::max);
        assert!((star_discrepancy_line(&points).expect("on the line") - known).abs() <= 4.0 * f64::EPSILON);
    }
}

/// The table of the inventory's V18, measured elsewhere: by an `O(N² log N)` sweep in another language.
#[test]
fn the_patterns_have_the_discrepancies_that_were_measured_elsewhere() {
    let table: [(&str, [f64; 4]); 4] = [
        ("random", [0.284, 0.155, 0.075, 0.038]),
        ("jittered", [0.204, 0.082, 0.033, 0.014]),
        ("multi-jittered", [0.139, 0.051, 0.020, 0.0078]),
        ("n-rooks", [0.161, 0.077, 0.040, 0.024]),
    ];
    for (name, known) in table {
        for (n, known) in [16, 64, 256, 1024].into_iter().zip(known) {
            let pattern = catalog::by_name(name, n).expect("a known pattern");
            let found: Vec<f64> =
                (0..40).map(|seed| star_discrepancy(&pattern.points(seed)).expect("in the square")).collect();
            let mean = found.iter().sum::<f64>() / 40.0;
            let deviation = (found.iter().map(|d| (d - mean).powi(2)).sum::<f64>() / 39.0).sqrt();
            // of how many patterns the table is the mean is unknown: of one, at worst
            assert!((mean - known).abs() < 2.0 * deviation, "{name} {n}: {mean} {known} {deviation}");
        }
    }
    let digits: [(&str, [(f64, f64); 4]); 2] = [
        ("halton", [(0.201, 5e-4), (0.052, 5e-4), (0.0188, 5e-5), (0.0068, 5e-5)]),
        ("hammersley", [(0.172, 5e-4), (0.054, 5e-4), (0.0161, 5e-5), (0.0047, 5e-5)]),
    ];
    for (name, known) in digits {
        for (n, (known, half_digit)) in [16, 64, 256, 1024].into_iter().zip(known) {
            let points = catalog::by_name(name, n).expect("a known pattern").points(0);
            assert!(
                (star_discrepancy(&points).expect("in the square") - known).abs() < half_digit * 1.01,
                "{name} {n}"
            );
        }
    }
}

#[test]
fn bad_points_are_named() {
    assert!(matches!(star_discrepancy(&[]), Err(Error::TooFew { .. })));
    assert!(matches!(star_discrepancy(&[[0.5, f64::NAN]]), Err(Error::NotFiniteAt { index: 0, .. })));
    assert!(matches!(star_discrepancy(&[[0.5, 1.5]]), Err(Error::OutOfRange { value: 1.5, .. })));
    assert!(matches!(star_discrepancy_line(&[]), Err(Error::TooFew { .. })));
}
