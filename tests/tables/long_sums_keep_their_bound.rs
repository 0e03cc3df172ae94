//! Sums over irregular places, by powers of waves and, where they are long, over a grid; beside them the sums term by term.

use nyquist::num::random::{normal, uniform};
use nyquist::num::{cos_pi, sin_pi};
use nyquist::sampled::harmonics::Places;
use std::f64::consts::PI;

#[test]
fn sums_are_those_of_their_terms() {
    // the first by powers, the others over a grid
    for (count, order) in [(40, 6_000), (2, 400_000), (700, 5_000), (3_000, 3_000)] {
        let places = |seed: u64| (0..count).map(|j| uniform(seed, j, 0)).collect::<Vec<f64>>();
        // anywhere, crowded at both ends of the period, and all at one place
        let crowded = places(2).iter().map(|u| (1e-4 * (u - 0.5)).rem_euclid(1.0)).collect();
        for parts in [places(1), crowded, vec![0.731; count as usize]] {
            let weights: Vec<f64> = (0..count).map(|j| normal(3, j, 0)).collect();
            let found = Places::Anywhere(parts.clone()).harmonics(&weights, order).unwrap();
            let sum: f64 = weights.iter().map(|w| w.abs()).sum();
            let bound = if count == 40 { 1e3 * f64::EPSILON } else { 1e-13 };
            for m in (0..=order).step_by(order / 97) {
                let (mut re, mut im) = (0.0, 0.0);
                for (part, weight) in parts.iter().zip(&weights) {
                    let turns = 2.0 * (m as f64 * part).rem_euclid(1.0);
                    re += weight * cos_pi(turns);
                    im -= weight * sin_pi(turns);
                }
                // the argument is rounded here and there, and the terms are added
                let rounding = (4.0 * PI * m as f64 + count as f64) * f64::EPSILON;
                let off = (found[m].re - re).hypot(found[m].im - im);
                assert!(off <= (bound + rounding) * sum, "{count} {order} {m}: {off:e} {:e}", (bound + rounding) * sum);
            }
        }
    }
}

#[test]
fn two_hundred_thousand_places_are_no_matter() {
    // a direct sum would have 4·10¹⁰ products
    let n = 200_000;
    let parts: Vec<f64> = (0..n).map(|j| (j as f64 + uniform(4, j, 0)) / n as f64).collect();
    let weights: Vec<f64> =
        parts.iter().map(|u| 2.0 * cos_pi(2.0 * (60_000.0 * u).rem_euclid(1.0)) / n as f64).collect();
    let found = Places::Anywhere(parts).harmonics(&weights, n as usize).unwrap();
    // random places within cells: 1 but for a spread of a few 1/√n
    assert!((found[60_000].re - 1.0).abs() < 6.0 / (n as f64).sqrt());
    assert!(found[20_000].norm() < 12.0 / (n as f64).sqrt());
}
