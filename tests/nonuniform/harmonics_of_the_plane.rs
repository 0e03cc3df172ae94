//! Spectra of points and values of harmonics in the plane are the sums they stand for, to the tolerance asked for.

use crate::{numbers, positions, relative, rounding, wave};
use num_complex::Complex;
use nyquist::engine::nonuniform::PlaneNufft;
use nyquist::pattern::Pattern;
use nyquist::pattern::measure::periodogram::Periodogram;
use nyquist::pattern::random::Random;

type Point = [(i64, f64); 2];

fn points(seed: u64, n: usize, [x, y]: [usize; 2]) -> Vec<Point> {
    positions(seed, n, x).into_iter().zip(positions(seed + 100, n, y)).map(|(x, y)| [x, y]).collect()
}

fn product([u, v]: [i64; 2], [x, y]: Point, periods: [usize; 2]) -> Complex<f64> {
    wave(u, x, periods[0]) * wave(v, y, periods[1])
}

#[test]
fn spectra_and_values_are_their_sums() {
    for (degrees, periods, n) in
        [([0, 0], [1, 1], 3), ([3, 9], [1, 1], 50), ([24, 10], [50, 1], 200), ([40, 41], [100, 90], 300)]
    {
        let [top_u, top_v] = degrees.map(|d| d as i64);
        let harmonics: Vec<[i64; 2]> = (0..=top_u).flat_map(|u| (-top_v..=top_v).map(move |v| [u, v])).collect();
        let (places, weights) = (points(1, n, periods), numbers(2, n));
        let sum = |h: &[i64; 2]| places.iter().zip(&weights).map(|(p, w)| product(*h, *p, periods) * w).sum();
        let known: Vec<Complex<f64>> = harmonics.iter().map(sum).collect();
        let total: f64 = weights.iter().map(|w| w.abs()).sum();

        let modes: Vec<Complex<f64>> =
            numbers(3, 2 * harmonics.len()).chunks_exact(2).map(|c| Complex::new(c[0], c[1])).collect();
        let value = |p: &Point| -> f64 {
            let term = |(h, c): (&[i64; 2], &Complex<f64>)| {
                let twice = if h[0] > 0 { 2.0 } else { 1.0 };
                twice * (c * product(*h, *p, periods).conj()).re
            };
            harmonics.iter().zip(&modes).map(term).sum()
        };
        let values: Vec<f64> = places.iter().map(value).collect();
        let size: f64 = modes.iter().map(|c| 2.0 * c.norm()).sum();
        for tolerance in [1e-1, 1e-3, 1e-6, 1e-10, 1e-13] {
            let nufft = PlaneNufft::<f64>::new(degrees, periods, tolerance).unwrap();
            assert_eq!(nufft.modes(), harmonics.len());
            let placed = nufft.place(&places).unwrap();
            let found = nufft.spectrum(&placed, &weights).unwrap();
            let worst = found.iter().zip(&known).map(|(f, k)| (f - k).norm()).fold(0.0, f64::max);
            assert!(worst <= (tolerance + rounding(2, n)) * total, "{degrees:?} {tolerance}: {worst}");
            assert!(relative(found, &known) <= tolerance + 10.0 * rounding(2, n));
            let found = nufft.values(&modes, &placed).unwrap();
            let worst = found.iter().zip(&values).map(|(f, k)| (f - k).abs()).fold(0.0, f64::max);
            assert!(worst <= (tolerance + rounding(2, modes.len())) * size, "{degrees:?} {tolerance}: {worst}");
        }
    }
}

#[test]
fn single_precision_keeps_its_tolerance() {
    let (degrees, periods, n) = ([30, 20], [1, 1], 500);
    let places = points(4, n, periods);
    let nufft = PlaneNufft::<f32>::new(degrees, periods, 1e-5).unwrap();
    let found = nufft.spectrum(&nufft.place(&places).unwrap(), &vec![1.0; n]).unwrap();
    for h in [[0, 0], [1, -1], [30, 20], [17, -20]] {
        let known: Complex<f64> = places.iter().map(|p| product(h, *p, periods)).sum();
        let found = found[(h[0] * 41 + h[1] + 20) as usize];
        assert!((Complex::new(f64::from(found.re), f64::from(found.im)) - known).norm() < 1e-5 * n as f64);
    }
}

#[test]
fn periodograms_of_many_points_are_the_sums_they_stand_for() {
    let points = Random::new(20_000).unwrap().points(3);
    let n = points.len() as f64;
    let found = Periodogram::of(&points, 200).unwrap(); // 8·10⁸ products
    for [u, v] in [[0, 0], [1, 0], [-1, 0], [0, 200], [-200, 137], [200, -200]] {
        let sum: Complex<f64> = points.iter().map(|[x, y]| product([u, v], [(0, *x), (0, *y)], [1, 1])).sum();
        let power = sum.norm_sqr() / n;
        let error = (1e-12 + rounding(2, points.len())) * n; // of the sum
        assert!((found.at(u, v) - power).abs() < 2.0 * error * (power / n).sqrt() + error * error / n);
        assert_eq!(found.at(u, v), found.at(-u, -v));
    }
}
