//! The transform of images against the direct sum over all pixels, for every small size; its conventions; and the
//! picture-and-spectrum pairs of the lecture (F43 to F46).

use num_complex::Complex;
use nyquist::prelude::*;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

fn noise(grid: Grid) -> Image {
    let values = (0..grid.len() as u64).map(|i| nyquist::num::random::normal(3, i, 0)).collect();
    Image::new(grid, values).expect("the arguments are valid")
}

#[test]
fn every_small_size_agrees_with_the_direct_sum() {
    for nx in 1..=9 {
        for ny in 1..=9 {
            let grid = Grid::cells(-0.7..2.3, nx, 1.1..4.0, ny).unwrap();
            let image = noise(grid);
            let bins = image_forward(&image);
            let bound = 64.0 * f64::EPSILON * (nx * ny) as f64;
            for ([u, v], value) in bins.grid().iter().zip(bins.values()) {
                let wave = |[x, y]: [f64; 2]| Complex::cis(-2.0 * PI * (u * x + v * y));
                let sum: Complex<f64> = grid.iter().zip(image.values()).map(|(p, f)| wave(p) * f).sum();
                assert!((sum * grid.pixel_area() - value).norm() <= bound, "{nx}×{ny} at {u},{v}");
            }
            let back = image_inverse(&bins);
            assert!(back.rmse(&image).unwrap() <= bound && back.grid() == grid);
        }
    }
}

#[test]
fn zero_frequency_stands_at_half_the_size_and_is_the_integral() {
    for (nx, ny) in [(4, 6), (5, 6), (4, 7), (1, 1)] {
        let image = noise(Grid::cells(0.0..2.0, nx, 0.0..3.0, ny).unwrap());
        let bins = image_forward(&image);
        assert_eq!(bins.grid().at(nx as i64 / 2, ny as i64 / 2), [0.0, 0.0]);
        let zero = bins.values()[[ny / 2, nx / 2]];
        assert!((zero.re - image.mean() * 6.0).abs() < 1e-13 && zero.im.abs() < 1e-13);
        assert_eq!(zero, bins.bin(0, 0));
    }
}

#[test]
fn one_row_transforms_like_samples() {
    for n in [7, 8] {
        let axis = Axis::cells(-1.0..2.5, n).unwrap();
        let values: Vec<f64> = (0..n as u64).map(|i| nyquist::num::random::normal(4, i, 0)).collect();
        let line = forward(&Samples::new(axis, values.clone()).unwrap());
        // a row one unit high, at y = 0
        let grid = Grid::new(axis, Axis::new(0.0, 1.0, 1).unwrap()).unwrap();
        let plane = image_forward(&Image::new(grid, values).unwrap());
        for (a, b) in line.values().iter().zip(plane.values()) {
            assert!((a - b).norm() < 1e-14);
        }
    }
}

#[test]
fn bins_that_are_not_hermitian_give_the_real_part() {
    let space = Grid::cells(-1.0..1.0, 6, 0.0..3.0, 5).unwrap();
    let random = |i: usize, d| nyquist::num::random::normal(5, i as u64, d);
    let bins = ImageBins::new(space, (0..30).map(|i| Complex::new(random(i, 0), random(i, 1))).collect()).unwrap();
    let image = image_inverse(&bins);
    for ([x, y], value) in space.iter().zip(image.values()) {
        let wave = |[u, v]: [f64; 2]| Complex::cis(2.0 * PI * (u * x + v * y));
        let sum: Complex<f64> = bins.grid().iter().zip(bins.values()).map(|(nu, f)| wave(nu) * f).sum();
        assert!((sum.re / space.area() - value).abs() < 1e-13);
    }
}

const N: usize = 128;

fn picture() -> Grid {
    Grid::centered(1.0, N, N).expect("the arguments are valid")
}

/// The bins whose magnitude is above a thousandth of the largest, with that magnitude.
fn peaks(field: &impl Field) -> Vec<([i64; 2], f64)> {
    let bins = image_forward(&Image::of(field, picture()));
    let largest = bins.values().iter().map(|v| v.norm()).fold(0.0, f64::max);
    let mut found = Vec::new();
    for l in -64..64 {
        for k in -64..64 {
            let size = bins.bin(k, l).norm();
            if size > 1e-3 * largest {
                found.push(([k, l], size));
            }
        }
    }
    found
}

#[test]
fn the_gratings_of_the_lecture_have_the_lines_that_it_shows() {
    let sine = |u: f64, v: f64| Grating::with_phase([u, v], -FRAC_PI_2).unwrap();
    let near = |found: &[([i64; 2], f64)], places: &[[i64; 2]], size: f64| {
        let at: Vec<[i64; 2]> = found.iter().map(|(at, _)| *at).collect();
        assert_eq!(at, places);
        assert!(found.iter().all(|(_, s)| (s / size - 1.0).abs() < 1e-12), "{found:?}");
    };
    let all = (N * N) as f64;
    near(&peaks(&Flat::new(1.0).unwrap()), &[[0, 0]], all);
    near(&peaks(&sine(1.0 / 32.0, 0.0)), &[[-4, 0], [4, 0]], all / 2.0);
    near(&peaks(&sine(1.0 / 16.0, 0.0)), &[[-8, 0], [8, 0]], all / 2.0);
    near(&peaks(&sine(0.0, 1.0 / 16.0)), &[[0, -8], [0, 8]], all / 2.0);
    let plaid = Plaid::new(sine(1.0 / 32.0, 0.0), sine(0.0, 1.0 / 16.0)).unwrap();
    near(&peaks(&plaid), &[[-4, -8], [4, -8], [-4, 8], [4, 8]], all / 4.0);
    // the closed form says the same
    let lines = plaid.spectrum();
    assert_eq!(lines.lines().len(), 4);
    assert!(lines.lines().iter().all(|l| (l.weight.norm() - 0.25).abs() < 1e-16));
}

#[test]
fn the_gaussians_of_the_lecture_are_wide_where_their_spectra_are_narrow() {
    let bins = |field: &dyn Field| image_forward(&Image::of(&field, picture()));
    let round = bins(&GaussianSpot::round(16.0).unwrap());
    // what is cut off at the sides of the picture is e^{−16}: 10⁻⁷
    assert!(((round.bin(1, 0) / round.bin(0, 0)).re - 0.85709).abs() < 1e-5);
    assert!((round.bin(0, 0).re / (PI * 256.0) - 1.0).abs() < 1e-7);
    // width of the amplitude, from its second moment along u: σ_x σ_u = 1/(2π)
    let sigma = |bins: &ImageBins, along_u: bool| {
        let moment = |power: i32| {
            let sum = bins.grid().iter().zip(bins.values());
            sum.map(|([u, v], f)| (if along_u { u } else { v }).powi(power) * f.re).sum::<f64>()
        };
        (moment(2) / moment(0)).sqrt()
    };
    let sigma_x = |radius: f64| radius / 2f64.sqrt();
    assert!((sigma(&round, true) * sigma_x(16.0) * 2.0 * PI - 1.0).abs() < 1e-4);
    let oblong = bins(&GaussianSpot::new([32.0, 16.0]).unwrap());
    assert!(sigma(&oblong, true) < 0.6 * sigma(&oblong, false)); // wide in x, narrow in u
    // turned by 45° the picture and the spectrum are turned alike: the axes of the spectrum are the diagonals
    let turned = bins(&GaussianSpot::turned([24.0, 12.0], FRAC_PI_4).unwrap());
    let (long, short) = (turned.bin(3, -3).norm(), turned.bin(3, 3).norm());
    assert!(long > 2.0 * short, "{long} {short}");
    assert!((turned.bin(3, -3) - turned.bin(-3, 3)).norm() < 1e-9);
}

#[test]
fn bad_grids_and_values_are_refused_by_name() {
    assert!(matches!(Grid::pixels(0, 5), Err(Error::TooFew { .. })));
    assert!(matches!(Grid::pixels(1 << 20, 1 << 20), Err(Error::Overflow { .. })));
    assert!(matches!(Grid::pixels(usize::MAX, 2), Err(Error::Overflow { .. })));
    let grid = Grid::pixels(2, 2).unwrap();
    assert!(matches!(Image::new(grid, vec![0.0; 3]), Err(Error::Length { expected: 4, got: 3, .. })));
    assert!(matches!(Image::new(grid, vec![0.0, f64::NAN, 0.0, 0.0]), Err(Error::NotFiniteAt { index: 1, .. })));
    assert!(matches!(ImageBins::new(grid, vec![Complex::ZERO; 5]), Err(Error::Length { .. })));
    let other = Image::new(Grid::pixels(2, 1).unwrap(), vec![0.0; 2]).unwrap();
    let image = Image::new(grid, vec![0.0; 4]).unwrap();
    assert!(matches!(image.rmse(&other), Err(Error::Length { .. })));
    assert!(matches!(Rgb::new([image.clone(), image.clone(), other]), Err(Error::Length { .. })));
    let view = image_forward(&image);
    assert!(view.log_magnitude(-80.0).unwrap().values().iter().all(|v| *v == 0.0)); // nothing anywhere
    assert!(view.log_magnitude(0.0).is_err() && view.log_magnitude(f64::NAN).is_err());
}
