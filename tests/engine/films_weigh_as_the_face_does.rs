//! The engine's films against the film of the library's face, which evaluates the kernel itself.

use nyquist::engine::film;
use nyquist::kernel::catalog;
use nyquist::num::random::uniform;
use nyquist::prelude::*;

const SIZE: [usize; 2] = [150, 70];

/// Samples over the frame and six pixels beyond, at places that `f32` has.
fn scattered(count: usize) -> Vec<Sample<2>> {
    let place = |i: usize, d: u32| (uniform(5, i as u64, d) * (SIZE[d as usize] as f64 + 12.0) - 6.0) as f32;
    let light = |i: usize, d| f64::from((uniform(5, i as u64, d) - 0.3) as f32);
    (0..count)
        .map(|i| Sample { at: [place(i, 0), place(i, 1)].map(f64::from), light: [light(i, 2), light(i, 3)] })
        .collect()
}

fn single(sample: &Sample<2>) -> film::Sample<f32, 2> {
    film::Sample { at: sample.at.map(|c| c as f32), light: sample.light.map(|l| l as f32) }
}

fn double(sample: &Sample<2>) -> film::Sample<f64, 2> {
    film::Sample { at: sample.at, light: sample.light }
}

/// The sums of both films, pixel by pixel: `Σf`, and `Σf·L` for two colours.
fn sums<T: Copy + Into<f64>>(exposure: &film::Exposure<T, 2>) -> Vec<[f64; 3]> {
    let pixel = |i: usize| {
        let weight: f64 = exposure.weights[i].into();
        let [a, b] = [0, 1].map(|c| weight * exposure.planes[c][i].into());
        [weight, a, b]
    };
    (0..exposure.weights.len()).map(pixel).collect()
}

#[test]
fn every_kernel_is_itself_to_rounding() {
    let samples = scattered(40_000);
    let grid = Grid::pixels(SIZE[0], SIZE[1]).unwrap();
    for name in ["tent", "gaussian", "mitchell", "catmull-rom", "b-spline", "lanczos-3"] {
        let kernel = catalog::by_name(name).unwrap();
        let face = Film::new(grid, &*kernel).unwrap().develop(&samples).unwrap();
        let weights = face.weights().values();
        let known = |i: usize| {
            [weights[i], weights[i] * face.planes()[0].values()[i], weights[i] * face.planes()[1].values()[i]]
        };
        // at most 36·12 samples reach a pixel; a weight is off by the polynomials' error and by what the rounding of
        // its place (half an ulp of 150 and of the reach beyond it) does to the steepest kernel, of slope 2; sums round
        // once a term, and the quotient and the product here three times
        let most = kernel.at(0.0);
        let allowed = |epsilon: f64, error: f64| {
            let weight = 2.0 * (error * most + 2.0 * 256.0 * epsilon) * most;
            432.0 * (weight + 216.0 * epsilon * most * most)
        };
        let check = |found: Vec<[f64; 3]>, allowed: f64| {
            for (i, found) in found.iter().enumerate() {
                for (found, known) in found.iter().zip(known(i)) {
                    assert!((found - known).abs() <= allowed, "{name}, pixel {i}: {found} is not {known} to {allowed}");
                }
            }
        };
        let wide = film::Film::<f64>::new(SIZE, kernel.radius(), |t| kernel.at(t)).unwrap();
        assert!(wide.error() <= 16.0 * f64::EPSILON, "{name}: {}", wide.error());
        let found = wide.develop(&samples.iter().map(double).collect::<Vec<_>>()).unwrap();
        check(sums(&found), allowed(f64::EPSILON, wide.error()));
        let narrow = film::Film::<f32>::new(SIZE, kernel.radius(), |t| kernel.at(t)).unwrap();
        assert!(narrow.error() <= 16.0 * f64::from(f32::EPSILON), "{name}: {}", narrow.error());
        let found = narrow.develop(&samples.iter().map(single).collect::<Vec<_>>()).unwrap();
        check(sums(&found), allowed(f64::from(f32::EPSILON), narrow.error()));
    }
}

#[test]
fn the_bits_are_the_same_for_any_number_of_threads() {
    let film = film::Film::<f32>::new(SIZE, 2.0, |t| Cubic::mitchell().at(t)).unwrap();
    // more than a block
    let samples: Vec<_> = scattered(100_000).iter().map(single).collect();
    let results = [1, 2, 5].map(|threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| film.develop(&samples).unwrap())
    });
    assert!(results[0] == results[1] && results[0] == results[2]);
}

#[test]
fn a_box_counts_what_is_in_the_pixel() {
    let film = film::Film::<f64>::new([3, 1], 0.5, |_| 1.0).unwrap();
    let sample = |x: f64, light| film::Sample { at: [x, 0.5], light: [light] };
    let exposure = film.develop(&[sample(0.2, 1.0), sample(0.7, 3.0), sample(2.5, 5.0), sample(-0.2, 9.0)]).unwrap();
    assert_eq!((exposure.weights, exposure.planes), (vec![2.0, 0.0, 1.0], [vec![2.0, 0.0, 5.0]]));
}

#[test]
fn what_cannot_be_developed_is_refused() {
    let new =
        |size, radius, kernel: fn(f64) -> f64| film::Film::<f32>::new(size, radius, kernel).map_err(|e| e.to_string());
    assert!(new([0, 3], 2.0, |_| 1.0).unwrap_err().contains("pixels of a film"));
    assert!(new([1 << 40, 1 << 40], 2.0, |_| 1.0).unwrap_err().contains("the number of pixels of a film"));
    assert!(new([2, 2], 1.3, |_| 1.0).unwrap_err().contains("radius is not"));
    assert!(new([2, 2], f64::NAN, |_| 1.0).unwrap_err().contains("radius is not"));
    // a corner between two pixels, and no number
    assert!(new([2, 2], 2.0, |t| (1.3 - t.abs()).max(0.0)).unwrap_err().contains("not smooth between pixels"));
    assert!(new([2, 2], 2.0, |_| f64::NAN).unwrap_err().contains("not smooth between pixels"));
    let film = new([2, 2], 1.0, |t| 1.0 - t.abs()).unwrap();
    let good = film::Sample { at: [0.5f32; 2], light: [1.0] };
    // beyond the blocks that are sorted together, and not in the first of the next ones
    let mut samples = vec![good; 1_200_000];
    samples[1_100_001].at[1] = f32::NAN;
    let error = film.develop(&samples).unwrap_err().to_string();
    assert_eq!(error, "places of samples must be finite, but number 1100001 (counted from 0) is NaN");
    samples[20].light[0] = f32::INFINITY;
    let error = film.develop(&samples).unwrap_err().to_string();
    assert_eq!(error, "lights of samples must be finite, but number 20 (counted from 0) is inf");
    // none at all is a dark film, far ones as well
    assert_eq!(film.develop::<1>(&[]).unwrap().weights, [0.0; 4]);
    assert_eq!(film.develop(&[film::Sample { at: [1e30, -1e30], light: [1.0] }]).unwrap().weights, [0.0; 4]);
}
