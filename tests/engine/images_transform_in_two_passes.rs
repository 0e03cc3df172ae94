//! Images against the direct sum, in both precisions and on any number of threads.

use crate::oracle::{noise, rounding, size};
use num_complex::Complex;
use nyquist::engine::fft::PlaneFft;
use nyquist::error::Error;
use nyquist::grid::Grid;
use std::f64::consts::PI;

fn grid(nx: usize, ny: usize) -> Grid {
    Grid::cells(-0.7..2.3, nx, 1.1..4.0, ny).expect("the arguments are valid")
}

#[test]
fn spectra_and_power_spectra_are_the_direct_sums() {
    let small =
        [(1, 1), (1, 6), (5, 1), (2, 2), (7, 9), (8, 9), (9, 8), (16, 20), (33, 12), (35, 37), (64, 33), (70, 18)];
    // columns side by side: odd and even heights, one stage and several, one group of columns and several
    let abreast = [(32, 2), (32, 7), (64, 24), (96, 15), (32, 48), (32, 70)];
    for (nx, ny) in small.into_iter().chain(abreast) {
        let grid = grid(nx, ny);
        let image = noise(nx * ny, 6);
        let plan = PlaneFft::new(grid);
        let (mut power, mut bins) = (vec![0.0; image.len()], vec![Complex::ZERO; image.len()]);
        plan.power(&image, &mut power).unwrap();
        plan.forward(&image, &mut bins).unwrap();
        let norm = size(image.iter().map(|&x| x.into())) * ((nx * ny) as f64).sqrt() * grid.pixel_area();
        // the oracle's angles 2πν·x of so many turns at most are right to ten roundings (frequency, position, product, sum
        // and π), its sum of nx·ny terms errs as a random walk does; units and phases of the transform as `Turns` says, on
        // both axes
        let turns = 0.5 * (2.3 / grid.x().step() + 4.0 / grid.y().step());
        let oracle = (10.0 * PI * turns + ((nx * ny) as f64).sqrt()) * f64::EPSILON;
        let planned = rounding(nx, f64::EPSILON) + rounding(ny, f64::EPSILON) + 32.0 * f64::EPSILON;
        let bound = (planned + oracle) * norm;
        for (i, [u, v]) in grid.dual().iter().enumerate() {
            let wave = |[x, y]: [f64; 2]| Complex::cis(-2.0 * PI * (u * x + v * y));
            let sum: Complex<f64> = grid.iter().zip(&image).map(|(p, f)| wave(p) * f).sum();
            let exact = sum * grid.pixel_area();
            assert!((exact - bins[i]).norm() <= bound, "{nx}×{ny} at {u},{v}");
            let allowed = (2.0 * exact.norm() + bound) * bound / grid.area();
            assert!((exact.norm_sqr() / grid.area() - power[i]).abs() <= allowed, "{nx}×{ny} at {u},{v}: power");
        }
        let mut back = vec![0.0; image.len()];
        plan.inverse(&bins, &mut back).unwrap();
        let error = size(back.iter().zip(&image).map(|(a, b)| Complex::from(a - b)));
        assert!(error * grid.pixel_area() * ((nx * ny) as f64).sqrt() <= 2.0 * bound, "{nx}×{ny} back");
    }
}

#[test]
fn single_precision_errs_by_its_own_rounding() {
    let grid = grid(200, 150);
    let image = noise(grid.len(), 7);
    let single: Vec<f32> = image.iter().map(|&x| x as f32).collect();
    let (mut exact, mut power) = (vec![0.0; image.len()], vec![0.0; image.len()]);
    PlaneFft::new(grid).power(&image, &mut exact).unwrap();
    PlaneFft::new(grid).power(&single, &mut power).unwrap();
    let error: f64 = exact.iter().zip(&power).map(|(a, b)| (a - f64::from(*b)).abs()).sum();
    let epsilon = f64::from(f32::EPSILON);
    // |a² − b²| ≤ (2|a| + |a − b|)·|a − b|, summed by Cauchy and Schwarz
    let relative = rounding(200, epsilon) + rounding(150, epsilon) + 8.0 * epsilon;
    assert!(error <= (2.0 + relative) * relative * exact.iter().sum::<f64>());
}

#[test]
fn the_bits_are_those_of_any_number_of_threads() {
    for (width, height) in [(210, 131), (320, 96)] {
        same_on_any_number_of_threads(grid(width, height));
    }
}

fn same_on_any_number_of_threads(grid: Grid) {
    let image = noise(grid.len(), 8);
    let all = || {
        let plan = PlaneFft::new(grid);
        let (mut power, mut bins) = (vec![0.0; image.len()], vec![Complex::ZERO; image.len()]);
        let mut back = power.clone();
        plan.power(&image, &mut power).expect("the sizes agree");
        plan.forward(&image, &mut bins).expect("the sizes agree");
        plan.inverse(&bins, &mut back).expect("the sizes agree");
        (power, bins, back)
    };
    let on = |count: usize| {
        rayon::ThreadPoolBuilder::new().num_threads(count).build().expect("threads can be had").install(all)
    };
    let one = on(1);
    assert!([2, 3].into_iter().all(|count| on(count) == one));
}

#[test]
fn images_of_another_size_are_refused() {
    let plan = PlaneFft::<f64>::new(grid(3, 2));
    let mut out = [0.0; 6];
    assert!(matches!(plan.power(&[0.0; 5], &mut out), Err(Error::Length { expected: 6, got: 5, .. })));
    assert!(matches!(plan.power(&[0.0; 6], &mut out[..4]), Err(Error::Length { expected: 6, got: 4, .. })));
}
