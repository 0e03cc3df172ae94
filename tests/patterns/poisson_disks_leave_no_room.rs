//! A maximal Poisson disk pattern against all pairs and against exact gaps: no circle through two or three points that
//! could take another.

use nyquist::prelude::*;

fn apart(a: [f64; 2], b: [f64; 2], torus: bool) -> f64 {
    let along = |d: usize| {
        let plain = (a[d] - b[d]).abs();
        if torus { plain.min(1.0 - plain) } else { plain }
    };
    along(0).hypot(along(1))
}

/// The places where another point would fit if anywhere: crossings of two circles of the radius around points, since an
/// uncovered region has such a corner (or one at the edge of a square that is no torus).
fn corners(points: &[[f64; 2]], radius: f64, torus: bool) -> Vec<[f64; 2]> {
    let images: Vec<[f64; 2]> = if torus {
        let shifts = [-1.0, 0.0, 1.0];
        shifts
            .iter()
            .flat_map(|u| shifts.iter().flat_map(move |v| points.iter().map(move |p| [p[0] + u, p[1] + v])))
            .collect()
    } else {
        points.to_vec()
    };
    let mut all = Vec::new();
    for a in &images {
        for b in &images {
            let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
            let squared = dx * dx + dy * dy;
            if squared > 0.0 && squared < 4.0 * radius * radius {
                let height = (radius * radius / squared - 0.25).sqrt();
                all.push([a[0] + 0.5 * dx - height * dy, a[1] + 0.5 * dy + height * dx]);
            }
        }
        if !torus {
            for (d, edge) in [(0, 0.0), (0, 1.0), (1, 0.0), (1, 1.0)] {
                let squared = radius * radius - (edge - a[d]) * (edge - a[d]);
                for half in [squared.max(0.0).sqrt(), -squared.max(0.0).sqrt()] {
                    let mut corner = *a;
                    (corner[d], corner[1 - d]) = (edge, a[1 - d] + half);
                    all.push(corner);
                }
            }
        }
    }
    if !torus {
        all.extend([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]]);
    }
    all.into_iter().filter(|c| c.iter().all(|x| (0.0..=1.0).contains(x))).collect()
}

#[test]
fn no_two_nearer_than_the_radius_and_no_corner_of_a_gap_uncovered() {
    for (radius, torus) in [(0.05, true), (0.05, false), (0.13, true), (0.13, false), (0.4, true), (0.5, false)] {
        for seed in 0..6 {
            let pattern = PoissonDisk::new(radius).expect("a radius");
            let points = if torus { pattern } else { pattern.bounded() }.points(seed);
            for (i, p) in points.iter().enumerate() {
                assert!(points[..i].iter().all(|q| apart(*p, *q, torus) >= radius - 4.0 * f64::EPSILON));
            }
            for corner in corners(&points, radius, torus) {
                let nearest = points.iter().map(|p| apart(*p, corner, torus)).fold(f64::INFINITY, f64::min);
                // rounding of the crossing; cells are quartered until they are below 10⁻⁶ of the radius
                assert!(nearest <= radius * (1.0 + 1e-5), "{radius} {torus}: {corner:?} is {nearest} away");
            }
        }
    }
}

#[test]
fn about_as_many_points_as_asked_for() {
    for count in [16, 100, 1000, 10_000] {
        let pattern = PoissonDisk::with_about(count).expect("enough points");
        let found = pattern.points(4).len() as f64;
        // the number has the variance 0.06 N, and at least about that of a few points
        assert!((found - count as f64).abs() <= 4.0 * (0.062 * count as f64).sqrt().max(1.0), "{count}: {found}");
        assert_eq!(pattern.count(), None);
    }
}

#[test]
fn the_first_points_are_uniform_darts() {
    // the first dart of 4000 patterns, in 64 cells: χ² with 63 degrees of freedom
    let pattern = PoissonDisk::new(0.2).expect("a radius");
    let mut counts = [0usize; 64];
    for seed in 0..4000 {
        let [x, y] = pattern.points(seed)[0];
        counts[(8.0 * x) as usize + 8 * ((8.0 * y) as usize)] += 1;
    }
    let chi: f64 = counts.iter().map(|&c| (c as f64 - 62.5).powi(2) / 62.5).sum();
    assert!((chi - 63.0).abs() < 4.0 * 126f64.sqrt(), "{chi}");
}
