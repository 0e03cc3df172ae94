//! Prefilters, supersampling and adaptive sampling against what theory says that they leave.

use nyquist::num::sinc;
use nyquist::prelude::*;
use std::f64::consts::PI;

/// The amplitude of a wave of `cycles` over the picture's width in its first row.
fn amplitude(image: &Image, cycles: i64) -> f64 {
    2.0 * image_forward(image).bin(cycles, 0).norm() / image.grid().area()
}

#[test]
fn one_regular_point_and_the_box_is_point_sampling() {
    let (board, grid) = (Checkerboard::lecture(64).unwrap(), Grid::pixels(64, 64).unwrap());
    let one = supersample(&board, grid, &Regular::<2>::new([1, 1]).unwrap(), &BoxKernel, 9).unwrap();
    assert_eq!(one, Image::of(&board, grid));
}

#[test]
fn equal_taps_have_the_transfer_of_dirichlet_which_comes_back_near_the_finer_rate() {
    // 3.9 cycles a pixel fall on a tenth: 0.985 of them with four taps, 0.025 with an exact area
    let grid = Grid::pixels(40, 1).unwrap();
    let grating = Grating::new([3.9, 0.0]).unwrap();
    let n = 4;
    let taps: Vec<Tap> = (0..n).map(|s| Tap { at: [(f64::from(s) + 0.5) / 4.0, 0.5], weight: 0.25 }).collect();
    let found = amplitude(&weighted(&grating, grid, &taps).unwrap(), 4);
    let transfer = (PI * 3.9).sin() / (4.0 * (PI * 3.9 / 4.0).sin());
    assert!((transfer + 0.984_64).abs() < 5e-6);
    assert!((found - transfer.abs()).abs() < 1e-12);
    let exact = amplitude(&Image::averaged(&grating, grid), 4);
    assert!((exact - 0.025_22).abs() < 5e-6);
}

#[test]
fn weights_that_do_not_add_up_to_one_are_refused() {
    let grid = Grid::pixels(2, 2).unwrap();
    let refused = |weights: &[f64]| {
        let taps: Vec<Tap> = weights.iter().map(|&weight| Tap { at: [0.5; 2], weight }).collect();
        weighted(&field_fn(|_, _| 1.0), grid, &taps).unwrap_err().to_string()
    };
    assert!(refused(&[0.5, 0.4]).contains("must lie between"));
    assert!(refused(&[0.5, f64::NAN]).contains("must be finite"));
    assert!(refused(&[]).contains("at least 1"));
}

#[test]
fn a_prefilter_has_the_response_of_its_kernel() {
    let (grid, parts) = (Grid::pixels(40, 1).unwrap(), 16);
    for cycles in [0.1, 0.4, 0.6, 0.9, 1.4, 3.9] {
        let grating = Grating::new([cycles, 0.0]).unwrap();
        let wave = i64::from((cycles * 40.0_f64).round() as i32);
        for kernel in [&Cubic::mitchell() as &dyn Kernel, &TentKernel, &GaussianKernel::pbrt2()] {
            let found = amplitude(&prefiltered(&grating, grid, kernel, parts).unwrap(), wave);
            // the documented sum, cut where sixty-four terms are left out of a response that falls with the square
            let p = parts as f64;
            let sign = |m: i32| if m % 2 == 0 { 1.0 } else { -1.0 };
            let sum = |nu: f64| (-64..=64).map(|m| sign(m) * kernel.response(nu + f64::from(m) * p)).sum::<f64>();
            let known = sinc(cycles / p) * sum(cycles) / sum(0.0);
            assert!((found - known.abs()).abs() < 1e-5, "{} at {cycles}: {found} {known}", kernel.name());
            // and the kernel's own to second order
            assert!(
                (found - (kernel.response(cycles) / kernel.response(0.0)).abs()).abs() < 4.0 * (cycles / p).powi(2)
            );
        }
    }
}

#[test]
fn adaptive_sampling_stays_within_its_budget_and_spends_it_on_edges() {
    let (disc, grid) = (Disc::new([8.1, 7.9], 5.3).unwrap(), Grid::pixels(16, 16).unwrap());
    let exact = Image::averaged(&disc, grid);
    for per_pixel in [4.0, 6.5, 10.0, 40.0] {
        let found = adaptive(&disc, grid, Budget { contrast: 0.0, per_pixel }, 3).unwrap();
        assert!(found.exhausted && found.taken as f64 <= per_pixel * 256.0);
        assert_eq!(found.samples.values().iter().sum::<f64>(), found.taken as f64);
    }
    let found = adaptive(&disc, grid, Budget { contrast: 0.01, per_pixel: 1e4 }, 3).unwrap();
    assert!(!found.exhausted && found.image.rmse(&exact).unwrap() < 0.005);
    // all beyond the first four stand in pixels that the edge crosses, or beside them
    for (pixel, [x, y]) in grid.iter().enumerate() {
        let from_edge = ((x - 8.1).hypot(y - 7.9) - 5.3).abs();
        assert!(found.samples.values()[pixel] == 4.0 || from_edge < 2.5);
    }
    // constant: nothing to look for
    let flat = adaptive(&field_fn(|_, _| 0.25), grid, Budget { contrast: 0.0, per_pixel: 100.0 }, 3).unwrap();
    assert!(flat.taken == 1024 && !flat.exhausted && flat.image.values().iter().all(|v| *v == 0.25));
}

#[test]
fn adaptive_pictures_are_the_same_for_any_number_of_threads() {
    let (disc, grid) = (Disc::new([15.3, 16.4], 11.7).unwrap(), Grid::pixels(33, 31).unwrap());
    let with = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        // once to the contrast, once until the budget ends in the middle of cells that are divided together
        let budgets = [(1e-3, 1e4), (0.0, 17.3)].map(|(contrast, per_pixel)| Budget { contrast, per_pixel });
        pool.install(|| budgets.map(|budget| adaptive(&disc, grid, budget, 5).unwrap()))
    };
    let [resolved, spent] = with(1);
    assert!(!resolved.exhausted && spent.exhausted && spent.taken as f64 > 17.3 * 33.0 * 31.0 - 12.0);
    assert_eq!([resolved, spent], with(3));
}

#[test]
fn what_lies_between_the_first_samples_is_never_found() {
    // a dot a fiftieth of a pixel wide: no seed of ten comes upon it, whatever the budget
    let (dot, grid) = (Disc::new([4.3, 4.6], 0.01).unwrap(), Grid::pixels(8, 8).unwrap());
    let missed = (0..10).filter(|&seed| {
        let found = adaptive(&dot, grid, Budget { contrast: 0.0, per_pixel: 1000.0 }, seed).unwrap();
        found.taken == 4 * 64 && found.image.values().iter().all(|v| *v == 0.0)
    });
    assert_eq!(missed.count(), 10);
    assert!(Image::averaged(&dot, grid).values().iter().any(|v| *v > 0.0));
}

#[test]
fn impossible_budgets_are_refused() {
    let (field, grid) = (field_fn(|_, _| 0.0), Grid::pixels(8, 8).unwrap());
    let refused = |contrast, per_pixel| adaptive(&field, grid, Budget { contrast, per_pixel }, 0).is_err();
    assert!(refused(f64::NAN, 16.0) && refused(-0.1, 16.0) && refused(0.1, 3.9));
    assert!(refused(0.1, f64::INFINITY) && refused(0.1, 1e12));
}
