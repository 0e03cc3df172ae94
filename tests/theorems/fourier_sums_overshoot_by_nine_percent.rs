//! V01, Wilbraham and Gibbs: the partial sums of a square wave peak at (2/π)·Si(π), whatever their number.

use nyquist::laws::gibbs::{fourier_dip, fourier_peak, wilbraham_gibbs};
use nyquist::prelude::*;
use std::f64::consts::PI;

fn by_hand(terms: u32, x: f64) -> f64 {
    (1..=terms).map(|k| f64::from(2 * k - 1)).map(|h| 4.0 / (PI * h) * (2.0 * PI * h * x).sin()).sum()
}

#[test]
fn the_four_stages_of_the_slide_peak_where_the_inventory_says() {
    for (terms, peak) in [(1, 1.273_240), (2, 1.200_422), (3, 1.188_357), (8, 1.180_284)] {
        let sum = PartialSum::new(Wave::Square, terms, 1.0).unwrap();
        let x = 0.25 / f64::from(terms);
        assert!((sum.at(x) - peak).abs() < 5e-7 && (by_hand(terms, x) - peak).abs() < 5e-7);
        // the derivative 4·sin(4πNx)/sin(2πx) vanishes there: neighbours are lower
        assert!(sum.at(x * 0.999) < sum.at(x) && sum.at(x * 1.001) < sum.at(x));
        assert!(fourier_peak(&sum, terms).holds());
    }
}

#[test]
fn many_terms_come_no_nearer_to_one() {
    assert!((wilbraham_gibbs() - 1.178_979_744_472_167).abs() < 4.0 * f64::EPSILON);
    for terms in [100, 1000, 10_000] {
        let peak = by_hand(terms, 0.25 / f64::from(terms));
        assert!(peak > 1.178_979 && peak < 1.179_01, "{terms} terms: {peak}");
    }
    // the next minimum, (2/π)·Si(2π)
    assert!((by_hand(10_000, 0.5e-4) - 0.902_823).abs() < 1e-6);
    assert!(fourier_dip(&from_fn(|x| by_hand(1000, x)), 1000).holds());
}

#[test]
fn the_mean_square_error_falls_all_the_same() {
    // ½·Σ of the squared amplitudes left out, the slide's four stages
    for (terms, error) in [(1, 0.189_43), (2, 0.099_37), (3, 0.066_94), (8, 0.025_30)] {
        let kept: f64 = (1..=terms).map(|k| f64::from(2 * k - 1)).map(|h| 0.5 * (4.0 / (PI * h)).powi(2)).sum();
        assert!((1.0 - kept - error).abs() < 5e-6);
        let n = 4096;
        let difference = |i: i32| {
            let x = (f64::from(i) + 0.5) / f64::from(n);
            (PartialSum::new(Wave::Square, terms, 1.0).unwrap().at(x) - Wave::Square.at(x)).powi(2)
        };
        // the midpoint rule, exact for the smooth part; both jumps lie between its places
        let measured = (0..n).map(difference).sum::<f64>() / f64::from(n);
        assert!((measured - error).abs() < 1e-4, "{terms} terms: {measured}");
    }
}
