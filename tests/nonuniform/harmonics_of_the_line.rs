//! Spectra of points and values of harmonics on the line are the sums they stand for, to the tolerance asked for.

use crate::{numbers, positions, relative, rounding, wave};
use num_complex::Complex;
use nyquist::engine::nonuniform::Nufft;
use nyquist::sampled::harmonics::Places;

const TOLERANCES: [f64; 6] = [1e-1, 1e-3, 1e-6, 1e-9, 1e-12, 1e-13];

fn spectrum(points: &[(i64, f64)], weights: &[f64], degree: usize, period: usize) -> Vec<Complex<f64>> {
    let sum = |k: i64| points.iter().zip(weights).map(|(p, w)| wave(k, *p, period) * w).sum();
    (0..=degree as i64).map(sum).collect()
}

fn value(modes: &[Complex<f64>], point: (i64, f64), period: usize) -> f64 {
    let upper = (1..modes.len()).map(|k| 2.0 * (modes[k] * wave(k as i64, point, period).conj()).re);
    modes[0].re + upper.sum::<f64>()
}

#[test]
fn spectra_of_points_are_their_sums() {
    for (degree, period, n) in [(0, 1, 3), (1, 7, 40), (6, 1, 1), (100, 1, 700), (313, 1000, 500), (2500, 5000, 300)] {
        let (points, weights) = (positions(1, n, period), numbers(2, n));
        let known = spectrum(&points, &weights, degree, period);
        let size: f64 = weights.iter().map(|w| w.abs()).sum();
        for tolerance in TOLERANCES {
            let nufft = Nufft::<f64>::new(degree, period, tolerance).unwrap();
            let found = nufft.spectrum(&nufft.place(&points).unwrap(), &weights).unwrap();
            assert_eq!(found.len(), degree + 1);
            let worst = found.iter().zip(&known).map(|(f, k)| (f - k).norm()).fold(0.0, f64::max);
            assert!(worst <= (tolerance + rounding(1, n)) * size, "{degree} {n} {tolerance}: {worst}");
            assert!(relative(found, &known) <= tolerance + 10.0 * rounding(1, n), "{degree} {n} {tolerance}");
        }
    }
}

#[test]
fn values_at_points_are_their_sums() {
    for (degree, period, n) in [(0, 1, 3), (1, 7, 40), (6, 1, 1), (100, 1, 700), (313, 1000, 500), (2500, 5000, 300)] {
        let points = positions(3, n, period);
        let modes: Vec<_> =
            numbers(4, 2 * degree + 2).chunks_exact(2).map(|pair| Complex::new(pair[0], pair[1])).collect();
        let known: Vec<f64> = points.iter().map(|p| value(&modes, *p, period)).collect();
        let size = modes[0].re.abs() + modes[1..].iter().map(|c| 2.0 * c.norm()).sum::<f64>();
        for tolerance in TOLERANCES {
            let nufft = Nufft::<f64>::new(degree, period, tolerance).unwrap();
            let found = nufft.values(&modes, &nufft.place(&points).unwrap()).unwrap();
            let worst = found.iter().zip(&known).map(|(f, k)| (f - k).abs()).fold(0.0, f64::max);
            assert!(worst <= (tolerance + rounding(1, degree)) * size, "{degree} {n} {tolerance}: {worst}");
        }
    }
}

#[test]
fn single_precision_keeps_its_tolerance_at_positions_that_it_could_not_hold() {
    let (degree, period, n) = (20_000, 1_000_000, 400);
    let (points, weights) = (positions(5, n, period), numbers(6, n));
    let single: Vec<f32> = weights.iter().map(|&w| w as f32).collect();
    let exact: Vec<f64> = single.iter().map(|&w| w.into()).collect();
    let known = spectrum(&points, &exact, degree, period);
    for tolerance in [1e-2, 1e-4, 1e-5] {
        let nufft = Nufft::<f32>::new(degree, period, tolerance).unwrap();
        let placed = nufft.place(&points).unwrap();
        let found = nufft.spectrum(&placed, &single).unwrap();
        let found = found.into_iter().map(|f| Complex::new(f64::from(f.re), f64::from(f.im)));
        assert!(relative(found, &known) < tolerance);
    }
}

#[test]
fn a_transform_and_its_adjoint_agree_on_products() {
    // ⟨A c, w⟩ = ⟨c, A* w⟩ for the sums over grids themselves, whatever the tolerance: only rounding is between them
    for tolerance in [1e-2, 1e-7, 1e-12] {
        let (degree, n) = (700, 3000);
        let nufft = Nufft::<f64>::new(degree, 1, tolerance).unwrap();
        let points = nufft.place(&positions(7, n, 1)).unwrap();
        let weights = numbers(8, n);
        let modes: Vec<_> =
            numbers(9, 2 * degree + 2).chunks_exact(2).map(|pair| Complex::new(pair[0], pair[1])).collect();
        let values = nufft.values(&modes, &points).unwrap();
        let spectrum = nufft.spectrum(&points, &weights).unwrap();
        let left: f64 = values.iter().zip(&weights).map(|(v, w)| v * w).sum();
        let product =
            |k: usize| if k == 0 { modes[0].re * spectrum[0].re } else { 2.0 * (modes[k] * spectrum[k].conj()).re };
        let right: f64 = (0..=degree).map(product).sum();
        // a value is off by εΣ|c| times the gains that undo the window, below 16; weights of either sign add up √n of that
        let size = modes.iter().map(|c| 2.0 * c.norm()).sum::<f64>() * (n as f64).sqrt();
        assert!((left - right).abs() < f64::EPSILON * 16.0 * size, "{left} {right}");
    }
}

#[test]
fn many_points_of_many_bins_are_right_where_it_is_looked() {
    let (degree, period, n) = (40_000, 90_000, 300_000);
    let (points, weights) = (positions(10, n, period), numbers(11, n));
    let nufft = Nufft::<f64>::new(degree, period, 1e-10).unwrap();
    let placed = nufft.place(&points).unwrap();
    let found = nufft.spectrum(&placed, &weights).unwrap();
    let size: f64 = weights.iter().map(|w| w.abs()).sum();
    for k in [0, 1, 17, 20_000, 39_999, 40_000] {
        let known: Complex<f64> = points.iter().zip(&weights).map(|(p, w)| wave(k, *p, period) * w).sum();
        assert!((found[k as usize] - known).norm() < (1e-10 + rounding(1, n)) * size);
    }
    let values = nufft.values(&found, &placed).unwrap();
    for i in [0, 1, 131_071, 131_072, 299_999] {
        let size: f64 = found.iter().map(|c| 2.0 * c.norm()).sum();
        assert!((values[i] - value(&found, points[i], period)).abs() < (1e-10 + rounding(1, degree)) * size);
    }
}

#[test]
fn positions_go_around_the_period() {
    let nufft = Nufft::<f64>::new(40, 3, 1e-12).unwrap();
    let at = |points: &[f64]| nufft.spectrum(&nufft.place(points).unwrap(), &vec![1.0; points.len()]).unwrap();
    assert_eq!(at(&[0.25, 2.5]), at(&[3.25, -0.5]));
    assert_eq!(at(&[0.0]), at(&[-0.0]));
    assert_eq!(at(&[0.0]), at(&[3.0]));
    let pairs =
        |points: &[(i64, f64)]| nufft.spectrum(&nufft.place(points).unwrap(), &vec![1.0; points.len()]).unwrap();
    assert_eq!(pairs(&[(0, 0.25), (2, 0.5)]), at(&[0.25, 2.5]));
    assert_eq!(pairs(&[(-3, 0.25), (5, -2.5)]), at(&[0.25, 2.5]));
    // a hair before the end is as good as zero, and as any other place
    let hair = at(&[-1e-300])[40] - at(&[0.0])[40];
    assert!(hair.norm() < 1e-11);
}

#[test]
fn places_beyond_what_is_summed_directly_have_the_same_harmonics() {
    let (n, order) = (30_000, 1000);
    let (parts, weights) = (positions(12, n, 1), numbers(13, n));
    let places = Places::Anywhere(parts.iter().map(|p| p.1).collect());
    let found = places.harmonics(&weights, order).unwrap();
    let size: f64 = weights.iter().map(|w| w.abs()).sum();
    for k in [0, 1, 500, 1000] {
        let known: Complex<f64> = parts.iter().zip(&weights).map(|(p, w)| wave(k as i64, *p, 1) * w).sum();
        assert!((found[k] - known).norm() < (1e-13 + rounding(1, n)) * size);
    }
    let holed = Places::Anywhere([vec![f64::NAN], vec![0.5; n]].concat());
    assert!(holed.harmonics(&vec![1.0; n + 1], order).is_err());
}
