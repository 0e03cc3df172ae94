//! V25 by conjugate gradients, beside the singular values of [`Irregular`] and the bound of Gröchenig.

use num_complex::Complex;
use nyquist::beyond::Weighted;
use nyquist::laws::frames::{jittered_cells, random_polynomial};
use nyquist::num::random::uniform;
use nyquist::prelude::*;
use nyquist::record::Recoverable;
use nyquist::sampled::harmonics::{MOST_ORDER, Places};

fn parts(positions: &[f64], period: f64) -> Places {
    Places::Anywhere(positions.iter().map(|x| x / period).collect())
}

fn distance(a: &TrigPolynomial, b: &TrigPolynomial) -> f64 {
    a.coefficients().iter().zip(b.coefficients()).map(|(a, b)| (a - b).norm()).fold(0.0, f64::max)
}

#[test]
fn exact_values_give_the_polynomial_that_singular_values_give() {
    let positions = jittered_cells(3, 256, 1.0);
    for (degree, band) in [(20, 20.0), (64, 64.0), (115, 115.0)] {
        let f = random_polynomial(5, 256.0, degree).unwrap();
        let values: Vec<f64> = positions.iter().map(|&x| f.at(x)).collect();
        let equations = Weighted::new(0.0..256.0, parts(&positions, 256.0), degree).unwrap();
        let condition = equations.condition(degree, 100.0).unwrap();
        let found = equations.fit(&values, degree).unwrap();
        let svd = Irregular::new(0.0..256.0, &positions, &values).unwrap().least_squares(band / 256.0, 100.0).unwrap();
        // normal equations square the condition number: κ²·ε of the values' own rounding, 2Kε·√(2K+1)·rms
        let degree = degree as f64;
        let rounding = f64::EPSILON * condition * condition * (2.0 * degree * (2.0 * degree + 1.0).sqrt()) * f.rms();
        assert!(distance(&f, &found) < rounding, "{degree}: {:e} {rounding:e}", distance(&f, &found));
        assert!(distance(svd.polynomial(), &found) < rounding);
    }
}

/// Squares of such values overflow or vanish; a power of two rounds nothing.
#[test]
fn values_of_any_size_are_restored() {
    let positions = jittered_cells(3, 64, 1.0);
    let f = random_polynomial(5, 64.0, 20).unwrap();
    let equations = Weighted::new(0.0..64.0, parts(&positions, 64.0), 20).unwrap();
    let fit = |size: f64| {
        let values: Vec<f64> = positions.iter().map(|&x| f.at(x) * size).collect();
        equations.fit(&values, 20).unwrap().coefficients().to_vec()
    };
    let plain = fit(1.0);
    for size in [600f64.exp2(), (-600f64).exp2()] {
        assert!(fit(size).iter().zip(&plain).all(|(large, one)| *large == one * size), "{size:e}");
    }
}

#[test]
fn the_condition_number_is_that_of_the_weighted_matrix_and_below_its_bound() {
    for (seed, width, degree) in [(1, 0.5, 10), (2, 0.5, 20), (3, 0.9, 15), (4, 0.2, 25)] {
        let positions = jittered_cells(seed, 64, width);
        let equations = Weighted::new(0.0..64.0, parts(&positions, 64.0), degree).unwrap();
        let condition = equations.condition(degree, 1e6).unwrap();
        // the same by singular values, of rows weighted by the roots of half the ways to both neighbours
        let samples = Irregular::new(0.0..64.0, &positions, &vec![0.0; 64]).unwrap();
        let mut matrix = samples.matrix(degree);
        for (i, mut row) in matrix.rows_mut().into_iter().enumerate() {
            let (before, after) = (positions[(i + 63) % 64], positions[(i + 1) % 64]);
            let way = (after - before).rem_euclid(64.0) / 64.0;
            row.mapv_inplace(|v| v * (0.5 * way).sqrt());
        }
        let known = nyquist::num::svd::Svd::of(&matrix).unwrap().condition();
        assert!((0.95..=1.0 + 1e-9).contains(&(condition / known)), "{condition} {known}");
        let gamma = 2.0 * samples.largest_gap() * degree as f64 / 64.0;
        if gamma < 1.0 {
            assert!(condition <= (1.0 + gamma) / (1.0 - gamma), "{condition} {gamma}");
        }
    }
}

#[test]
fn a_grid_with_holes_is_the_same_said_as_a_grid() {
    let nodes: Vec<usize> = (0..200).filter(|k| k % 13 != 4).collect();
    let f = random_polynomial(6, 200.0, 60).unwrap();
    let values: Vec<f64> = nodes.iter().map(|&k| f.at(k as f64)).collect();
    let grid = Places::Grid { nodes: 200, taken: nodes.clone() };
    let anywhere = Places::Anywhere(nodes.iter().map(|&k| k as f64 / 200.0).collect());
    let [a, b] = [grid, anywhere].map(|places| Weighted::new(0.0..200.0, places, 60).unwrap());
    let condition = a.condition(60, 1e3).unwrap();
    assert!((condition / b.condition(60, 1e3).unwrap() - 1.0).abs() < 1e-6);
    let bound = 121.0 * f64::EPSILON * condition * condition * 121f64.sqrt() * f.rms();
    assert!(distance(&f, &a.fit(&values, 60).unwrap()) < bound);
    assert!(distance(&f, &b.fit(&values, 60).unwrap()) < bound);
}

#[test]
fn ten_thousand_irregular_samples_in_a_moment() {
    let n = 10_000;
    let positions: Vec<f64> = (0..n).map(|k| k as f64 + uniform(7, k, 0)).collect();
    let f = random_polynomial(8, n as f64, 4_000).unwrap();
    let values: Vec<f64> = positions.iter().map(|&x| f.at(x)).collect();
    let recoverable = Recoverable::new(&positions, None, Edge::Wrap, None, 1e3).unwrap();
    // the record's own period is not quite that of the polynomial: what is left at the ends is not
    assert!(recoverable.band() > 0.4 && recoverable.condition() < 100.0);
    let equations = Weighted::new(0.0..n as f64, parts(&positions, n as f64), 4_000).unwrap();
    let found = equations.fit(&values, 4_000).unwrap();
    let condition = equations.condition(4_000, 1e3).unwrap();
    let bound = f64::EPSILON * condition * condition * 8_000.0 * 8_001f64.sqrt() * f.rms();
    assert!(distance(&f, &found) < bound, "{:e} {bound:e}", distance(&f, &found));
}

#[test]
fn a_record_and_its_reflection_need_cosines_alone() {
    let n = 900u32;
    let half: Vec<f64> = (0..n).map(|k| (f64::from(k) + 0.7 * uniform(11, k.into(), 0)) / f64::from(2 * n)).collect();
    let places: Vec<f64> = half.iter().copied().chain(half.iter().rev().map(|u| 1.0 - u)).collect();
    let degree = 700;
    let even = random_polynomial(12, 1.0, degree).unwrap();
    let cosines = even.coefficients().iter().map(|c| Complex::from(c.re)).collect();
    let even = TrigPolynomial::new(0.0..1.0, cosines).unwrap();
    let values: Vec<f64> = places.iter().map(|&u| even.at(u)).collect();
    let general = Weighted::new(0.0..1.0, Places::Anywhere(places), degree).unwrap();
    let condition = general.condition(degree, 100.0).unwrap();
    let cosines = general.clone().even();
    // the even signals are some of all, so that κ of theirs is at most κ of all; either is found from below, and to 0.95 at
    // least, as the tests beside singular values have it
    let of_cosines = cosines.condition(degree, 100.0).unwrap();
    assert!(0.95 * of_cosines <= condition, "{of_cosines} {condition}");
    let (all, few) = (general.fit(&values, degree).unwrap(), cosines.fit(&values, degree).unwrap());
    let bound = f64::EPSILON * condition * condition * 1400.0 * 1401f64.sqrt() * even.rms();
    assert!(distance(&even, &all) < bound && distance(&even, &few) < bound);
    assert!(few.coefficients().iter().all(|c| c.im == 0.0));
}

#[test]
fn what_is_not_determined_is_refused_with_the_numbers() {
    let positions: Vec<f64> = (0..64).filter(|k| !(20..40).contains(k)).map(f64::from).collect();
    let recover = |band: f64| Recoverable::new(&positions, None, Edge::Wrap, Some(band), 1e4).map(|r| r.condition());
    // Landau: 44 samples of 64 cells
    assert!(matches!(recover(0.4), Err(Error::OutOfRange { value: 0.4, .. })));
    // fewer coefficients than samples, but none of them in a third of the period
    assert!(matches!(recover(0.3), Err(Error::IllConditioned { most: 1e4, .. })));
    // Gröchenig: below one over twice the gap of 21
    assert!(recover(0.02).unwrap() < (1.0 + 0.84) / (1.0 - 0.84));
    let few = Recoverable::new(&[0.0], None, Edge::Wrap, None, 1e4);
    assert!(matches!(few, Err(Error::TooFew { .. })));
    let edge = Recoverable::new(&positions, None, Edge::Zero, None, 1e4);
    assert!(matches!(edge, Err(Error::Unsupported(_))));
    let order = |places: &[f64]| Weighted::new(0.0..1.0, Places::Anywhere(places.to_vec()), 0).map(|_| ());
    assert!(matches!(order(&[0.5, 0.5]), Err(Error::NotPositive { .. })));
    assert!(matches!(order(&[0.5, 1.0]), Err(Error::OutOfRange { .. })));
    assert!(matches!(order(&[f64::NAN]), Err(Error::NotFiniteAt { .. })));
    let equations = Weighted::new(0.0..1.0, Places::Anywhere(vec![0.0, 0.3, 0.6]), 1).unwrap();
    assert!(matches!(equations.fit(&[0.0; 2], 1), Err(Error::Length { .. })));
    assert!(matches!(equations.fit(&[0.0; 3], 2), Err(Error::OutOfRange { .. })));
    let sum = Places::Anywhere(vec![0.0; 100]).harmonics(&[0.0; 100], MOST_ORDER + 1);
    assert!(matches!(sum, Err(Error::Overflow { .. })));
}

#[test]
fn a_large_condition_number_is_that_of_singular_values_or_said_to_be_beyond_telling() {
    // random places of fifty cells, whose weighted matrix is as bad as its band is high
    let mut positions: Vec<f64> = (0..50).map(|k| 50.0 * uniform(9, k, 0)).collect();
    positions.sort_by(f64::total_cmp);
    let (mut told, mut beyond) = (0, 0);
    for degree in 4..=24 {
        let equations = Weighted::new(0.0..50.0, parts(&positions, 50.0), degree).unwrap();
        let samples = Irregular::new(0.0..50.0, &positions, &[0.0; 50]).unwrap();
        let mut matrix = samples.matrix(degree);
        for (mut row, weight) in matrix.rows_mut().into_iter().zip(equations.weights()) {
            row.mapv_inplace(|v| v * weight.sqrt());
        }
        let known = nyquist::num::svd::Svd::of(&matrix).unwrap().condition();
        let limit = 1.0 / ((2 * degree + 1) as f64 * f64::EPSILON).sqrt();
        match equations.condition(degree, 1e15) {
            // the smallest eigenvalue is off by nε of the greatest, as a part of itself by (κ/limit)²
            Ok(condition) => {
                let slack = 0.05 + (known / limit).powi(2);
                assert!((condition / known - 1.0).abs() < slack, "{degree}: {condition:e} {known:e}");
                told += usize::from(condition > 1e3);
                // and values of the polynomial itself have an answer
                assert!(equations.fit(&[1.0; 50], degree).is_ok(), "{degree}");
            }
            Err(Error::IllConditioned { most, .. }) => {
                assert!(known > 0.2 * limit && most == limit, "{degree}: {known:e} {most:e}");
                beyond += 1;
            }
            Err(other) => panic!("{other}"),
        }
        if known > 40.0 {
            let refused = equations.condition(degree, 20.0);
            assert!(matches!(refused, Err(Error::IllConditioned { most: 20.0, .. })), "{refused:?}");
        }
    }
    assert!(told > 0 && beyond > 0, "{told} {beyond}");
}
