//! The periodogram by recurrences and matrix products is the plain sum of exponentials.

use nyquist::pattern::catalog;
use nyquist::pattern::measure::periodogram::pattern_seed;
use nyquist::pattern::measure::radial::rings;
use nyquist::prelude::*;
use std::f64::consts::TAU;

fn plain(points: &[[f64; 2]], u: i64, v: i64) -> f64 {
    let (mut re, mut im) = (0.0, 0.0);
    for [x, y] in points {
        let (s, c) = (TAU * (u as f64 * x + v as f64 * y)).sin_cos();
        (re, im) = (re + c, im + s);
    }
    (re * re + im * im) / points.len() as f64
}

#[test]
fn at_every_frequency_for_every_pattern() {
    for pattern in catalog::all(64).expect("a square power of two") {
        let points = pattern.points(2);
        let found = Periodogram::of(&points, 9).expect("points in the square");
        for u in -9..=9 {
            for v in -9..=9 {
                // each phasor is off by less than 2π·18ε in the plain sum and 4·10ε in the other
                let n = points.len() as f64;
                let known = plain(&points, u, v);
                let phasor = 200.0 * f64::EPSILON;
                let bound = 2.0 * n * phasor * known.sqrt() + n * phasor * phasor;
                assert!((found.at(u, v) - known).abs() <= bound, "{} at {u} {v}", pattern.name());
            }
        }
        assert!(found.at(10, 0).is_nan());
    }
}

#[test]
fn batches_that_are_not_full_and_means_over_patterns_that_differ() {
    for n in [1, 2, 7, 8, 9, 17] {
        let points: Vec<[f64; 2]> = Random::new(n).expect("points").points(n as u64);
        let found = Periodogram::of(&points, 3).expect("points in the square");
        assert!((found.at(2, -3) - plain(&points, 2, -3)).abs() < 1e3 * f64::EPSILON);
        assert!((found.at(0, 0) - n as f64).abs() < 1e3 * f64::EPSILON);
    }
    let pattern = PoissonDisk::new(0.1).expect("a radius");
    let sets: Vec<_> = (0..5).map(|p| pattern.points(pattern_seed(4, p))).collect();
    let mean = Periodogram::mean(&pattern, 4, 5, 6).expect("five patterns");
    let known = sets.iter().map(|points| plain(points, -4, 5)).sum::<f64>() / 5.0;
    assert!((mean.at(-4, 5) - known).abs() < 1e4 * f64::EPSILON);
    assert_eq!(mean.points(), sets.iter().map(Vec::len).sum::<usize>() as f64 / 5.0);
}

#[test]
fn independent_points_have_an_exponential_spectrum() {
    // the mean 1, and a standard deviation that is as large
    let powers: Vec<f64> = (0..40)
        .flat_map(|seed| {
            let one = Periodogram::mean(&Random::new(500).expect("points"), seed, 1, 10).expect("a pattern");
            one.half().map(|(_, power)| power).collect::<Vec<_>>()
        })
        .collect();
    let n = powers.len() as f64;
    let mean = powers.iter().sum::<f64>() / n;
    let deviation = (powers.iter().map(|p| (p - mean).powi(2)).sum::<f64>() / n).sqrt();
    // the mean deviates by 1/√n; the variance, whose fourth central moment is 9, by √8/√n, and so the deviation by √2/√n
    assert!((mean - 1.0).abs() < 4.0 / n.sqrt());
    assert!((deviation - 1.0).abs() < 4.0 * 2f64.sqrt() / n.sqrt());
    let above = powers.iter().filter(|p| **p > 3.0).count() as f64 / n;
    let known = (-3f64).exp();
    assert!((above - known).abs() < 4.0 * (known / n).sqrt());
}

#[test]
fn blue_noise_has_a_ring_and_the_same_power_in_all_directions() {
    for (name, ring) in [("poisson-disk", 1.6), ("blue-noise", 1.25)] {
        let pattern = catalog::by_name(name, 1024).expect("a known name");
        let found = Periodogram::mean(&*pattern, 1, 20, 64).expect("patterns");
        let rings = rings(&found, 2.0).expect("a width");
        let highest = rings.iter().max_by(|a, b| a.power.total_cmp(&b.power)).expect("rings");
        let at = highest.frequency / found.points().sqrt();
        assert!(highest.power > ring && (1.05..1.25).contains(&at), "{name}: {highest:?} at {at}");
        if name == "poisson-disk" {
            // isotropic: the variance of 20 means of exponential numbers is 1/20, and itself deviates by √(2/bins) or so
            for r in rings.iter().skip(3) {
                let deviation = (2.0 / r.bins as f64).sqrt() * 1.2;
                assert!((20.0 * r.anisotropy - 1.0).abs() < 4.0 * deviation, "{r:?}");
            }
        }
    }
    let lines = Periodogram::of(&Regular::new([32, 32]).expect("cells").points(0), 64).expect("points");
    let anisotropic = rings(&lines, 2.0).expect("a width").into_iter().map(|r| r.anisotropy).fold(0.0, f64::max);
    assert!(anisotropic > 50.0);
}

#[test]
fn bad_input_is_named() {
    let points = [[0.5, 0.5]];
    assert!(matches!(Periodogram::of(&[], 4), Err(Error::TooFew { .. })));
    assert!(matches!(Periodogram::of(&points, 5000), Err(Error::Overflow { .. })));
    assert!(matches!(Periodogram::of(&[[0.5, -0.5]], 4), Err(Error::OutOfRange { .. })));
    assert!(matches!(Periodogram::mean(&Random::new(4).expect("points"), 1, 0, 4), Err(Error::TooFew { .. })));
    assert!(rings(&Periodogram::of(&points, 4).expect("a point"), 0.0).is_err());
}
