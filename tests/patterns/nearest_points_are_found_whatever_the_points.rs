//! The distance of the two nearest points, in the plane and on the torus, against all pairs.

use nyquist::num::random::uniform;
use nyquist::pattern::catalog;
use nyquist::prelude::*;

fn all_pairs(points: &[[f64; 2]], torus: bool) -> f64 {
    let apart = |a: f64, b: f64| if torus { (a - b).abs().min(1.0 - (a - b).abs()) } else { (a - b).abs() };
    let mut least = f64::INFINITY;
    for (i, p) in points.iter().enumerate() {
        for q in &points[..i] {
            least = least.min(apart(p[0], q[0]).hypot(apart(p[1], q[1])));
        }
    }
    least
}

fn check(points: &[[f64; 2]]) {
    for (found, torus) in [(min_distance(points), false), (min_distance_torus(points), true)] {
        let (found, known) = (found.expect("points in the square"), all_pairs(points, torus));
        assert!((found - known).abs() <= 4.0 * f64::EPSILON, "{found} {known} {torus}");
    }
}

#[test]
fn for_every_pattern() {
    for pattern in catalog::all(256).expect("a square power of two") {
        check(&pattern.points(3));
    }
}

#[test]
fn for_clusters_lines_corners_and_duplicates() {
    let random = |set: u64, i: u64, d| uniform(set, i, d);
    for set in 0..50u64 {
        let n = 2 + set;
        let cluster: Vec<[f64; 2]> =
            (0..n).map(|i| [0.3 + 1e-3 * random(set, i, 0), 0.7 + 1e-3 * random(set, i, 1)]).collect();
        let line: Vec<[f64; 2]> = (0..n).map(|i| [0.5, random(set, i, 0)]).collect();
        let corners: Vec<[f64; 2]> =
            (0..n).map(|i| [0, 1].map(|d| (0.98 + 0.04 * random(set, i, d)).rem_euclid(1.0))).collect();
        [cluster, line, corners].iter().for_each(|points| check(points));
    }
    check(&[[0.25, 0.5], [0.75, 0.5], [0.25, 0.5]]);
    check(&[[0.0, 0.0], [1.0, 1.0]]); // one place on the torus
    assert_eq!(min_distance_torus(&[[0.5, 0.5]]).expect("a point"), f64::INFINITY);
}
