//! Φ14: `I = Σ f·L / Σ f` over the samples within the kernel's reach, whoever computes it.

use nyquist::kernel::catalog;
use nyquist::num::random::uniform;
use nyquist::prelude::*;

fn scattered(count: usize) -> Vec<Sample<2>> {
    // over a frame of 40 × 70 and six pixels beyond
    let place = |i: usize, d, width| uniform(3, i as u64, d) * (width + 12.0) - 6.0;
    let light = |i: usize, d| uniform(3, i as u64, d) - 0.3;
    (0..count)
        .map(|i| Sample { at: [place(i, 0, 40.0), place(i, 1, 70.0)], light: [light(i, 2), light(i, 3)] })
        .collect()
}

/// The formula as it is written, every pixel over every sample.
fn by_the_formula(kernel: &dyn Kernel, grid: Grid, samples: &[Sample<2>]) -> Vec<[f64; 2]> {
    let pixel = |[x, y]: [f64; 2]| {
        let (mut sum, mut lights) = (0.0, [0.0; 2]);
        for sample in samples {
            let weight = kernel.at(x - sample.at[0]) * kernel.at(y - sample.at[1]);
            sum += weight;
            lights = [lights[0] + weight * sample.light[0], lights[1] + weight * sample.light[1]];
        }
        if sum == 0.0 { [0.0; 2] } else { lights.map(|l| l / sum) }
    };
    grid.iter().map(pixel).collect()
}

#[test]
fn a_film_is_the_formula_for_every_kernel() {
    let (grid, samples) = (Grid::pixels(40, 70).unwrap(), scattered(30_000));
    for name in ["box", "tent", "gaussian", "mitchell", "catmull-rom", "b-spline", "lanczos-3"] {
        let kernel = catalog::by_name(name).unwrap();
        let film = Film::new(grid, &*kernel).unwrap();
        let exposure = film.develop(&samples).unwrap();
        let known = by_the_formula(&*kernel, grid, &samples);
        // rounding of at most 36·8·3 products, whose amounts are below 1.3² each
        let rounding = 4.0 * f64::EPSILON * 864.0 * 1.7;
        for (i, known) in known.iter().enumerate() {
            for (plane, known) in exposure.planes().iter().zip(known) {
                let weight = exposure.weights().values()[i];
                assert!(((plane.values()[i] - known) * weight).abs() <= rounding, "{name}, pixel {i}");
            }
        }
    }
}

#[test]
fn the_bits_are_the_same_for_any_number_of_threads() {
    let film = Film::new(Grid::pixels(40, 70).unwrap(), GaussianKernel::pbrt2()).unwrap();
    let samples = scattered(5_000);
    let image = Image::of(&field_fn(|x, y| (x * y).sin()), Grid::pixels(50, 45).unwrap());
    let board = Checkerboard::lecture(40).unwrap();
    let results = [1, 2, 5].map(|threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| {
            let jittered = Jittered::<2>::new([3, 3]).unwrap();
            let picture = supersample(&board, Grid::pixels(40, 40).unwrap(), &jittered, &Cubic::mitchell(), 7).unwrap();
            let bins = image_forward(&image);
            (film.develop(&samples).unwrap(), picture, image_inverse(&bins), bins)
        })
    });
    assert!(results[0] == results[1] && results[0] == results[2]);
}

#[test]
fn a_sample_on_a_border_counts_one_half_on_either_side() {
    // the borders between bands of rows included
    let film = Film::new(Grid::pixels(1, 100).unwrap(), BoxKernel).unwrap();
    for y in 1..100 {
        let exposure = film.develop(&[Sample { at: [0.5, f64::from(y)], light: [1.0] }]).unwrap();
        let weights: Vec<f64> = exposure.weights().values().to_vec();
        let mut known = vec![0.0; 100];
        known[y as usize - 1] = 0.5;
        known[y as usize] = 0.5;
        assert_eq!(weights, known);
    }
}

#[test]
fn pixels_without_a_sample_are_black_and_counted() {
    let film = Film::new(Grid::pixels(4, 1).unwrap(), BoxKernel).unwrap();
    let exposure = film.develop(&[Sample { at: [1.5, 0.5], light: [0.25] }]).unwrap();
    assert_eq!(exposure.image().values(), [0.0, 0.25, 0.0, 0.0]);
    assert_eq!(exposure.unlit(), 3);
}

#[test]
fn what_cannot_be_developed_is_refused() {
    let grid = Grid::pixels(2, 2).unwrap();
    assert!(Film::new(grid, Ideal).unwrap_err().to_string().contains("infinite radius"));
    let film = Film::new(grid, TentKernel).unwrap();
    let good = Sample { at: [0.5; 2], light: [1.0] };
    let place = Sample { at: [f64::NAN, 0.0], ..good };
    let light = Sample { light: [f64::INFINITY], ..good };
    let error = |samples: &[Sample<1>]| film.develop(samples).unwrap_err().to_string();
    assert_eq!(error(&[good, place]), "places of samples must be finite, but number 1 (counted from 0) is NaN");
    assert_eq!(error(&[good, good, light]), "lights of samples must be finite, but number 2 (counted from 0) is inf");
    // none at all is a dark film, far ones as well
    assert_eq!(film.develop::<1>(&[]).unwrap().unlit(), 4);
    assert_eq!(film.develop(&[Sample { at: [1e300, -1e300], light: [1.0] }]).unwrap().unlit(), 4);
}
