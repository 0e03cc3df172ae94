//! The closed form of the checkerboard's pixels (F36) against an oracle that clips every square as a polygon, the errors
//! of point and uniform sampling against it (F35, F36), and what happens at the horizon.

use nyquist::prelude::*;

const SIZE: usize = 128;

fn board() -> Checkerboard {
    Checkerboard::lecture(SIZE).expect("the arguments are valid")
}

fn exact() -> Image {
    Image::averaged(&board(), Grid::pixels(SIZE, SIZE).expect("the arguments are valid"))
}

/// Every pixel the mean of `n`×`n` regular samples.
fn supersampled(n: usize) -> Image {
    let size = SIZE as f64;
    let fine =
        Image::of(&board(), Grid::cells(0.0..size, SIZE * n, 0.0..size, SIZE * n).expect("the arguments are valid"));
    let mean = |i: usize, j: usize| {
        let samples = (0..n * n).map(|k| fine.at(i * n + k % n, j * n + k / n));
        samples.sum::<f64>() / (n * n) as f64
    };
    let pixels = (0..SIZE * SIZE).map(|k| mean(k % SIZE, k / SIZE)).collect();
    Image::new(Grid::pixels(SIZE, SIZE).expect("the arguments are valid"), pixels).expect("the arguments are valid")
}

/// The root mean square difference over the rows `rows`.
fn rmse(a: &Image, b: &Image, rows: std::ops::Range<usize>) -> f64 {
    let n = rows.len() * SIZE;
    let square = |j: usize| (0..SIZE).map(|i| (a.at(i, j) - b.at(i, j)).powi(2)).sum::<f64>();
    (rows.map(square).sum::<f64>() / n as f64).sqrt()
}

/// The area of the white squares that a pixel sees: each square of the floor is a quadrilateral in the picture, clipped by
/// the pixel. Nothing in common with the closed form but the camera.
fn by_polygons([x, y]: [[f64; 2]; 2]) -> f64 {
    // u = (x − 64)/y, v = 64/y
    let picture = |u: f64, v: f64| [64.0 + 64.0 * u / v, 64.0 / v];
    let (near, far) = ((64.0 / y[1]).floor() as i64, (64.0 / y[0]).ceil() as i64);
    let mut white = 0.0;
    for v in near.max(1)..far.max(near.max(1) + 1) {
        let ends = [v as f64, (v + 1) as f64];
        let u = |x: f64, v: f64| (x - 64.0) * v / 64.0;
        let all = [u(x[0], ends[0]), u(x[0], ends[1]), u(x[1], ends[0]), u(x[1], ends[1])];
        let low = all.into_iter().fold(f64::INFINITY, f64::min).floor() as i64;
        let high = all.into_iter().fold(f64::NEG_INFINITY, f64::max).ceil() as i64;
        for w in low..high {
            if (w + v).rem_euclid(2) == 1 {
                let (a, b) = (w as f64, (w + 1) as f64);
                let corners = [picture(a, ends[0]), picture(b, ends[0]), picture(b, ends[1]), picture(a, ends[1])];
                white += ConvexPolygon::new(&corners).expect("the arguments are valid").mean(x, y);
            }
        }
    }
    white
}

#[test]
fn the_closed_form_is_the_clipped_area_of_the_squares() {
    // below the first square nearer than v = 1 nothing is asked: y < 64
    let image = exact();
    for j in [2usize, 3, 5, 7, 10, 15, 16, 21, 31, 40, 62] {
        for i in [0usize, 1, 17, 40, 63, 64, 90, 127] {
            let cell = [[i as f64, i as f64 + 1.0], [j as f64, j as f64 + 1.0]];
            let known = by_polygons(cell);
            // some 64 squares a pixel, each clipped to 4ε·(1 + 128)
            assert!((image.at(i, j) - known).abs() < 64.0 * 4.0 * 129.0 * f64::EPSILON, "{i},{j}: {known}");
        }
    }
}

#[test]
fn one_sample_errs_by_0_1284_and_sixteen_regular_ones_by_0_0395() {
    let (exact, point, uniform) = (exact(), supersampled(1), supersampled(4));
    assert_eq!(format!("{:.4}", rmse(&point, &exact, 1..SIZE)), "0.1284");
    assert_eq!(format!("{:.4}", rmse(&uniform, &exact, 1..SIZE)), "0.0395");
    assert_eq!(format!("{:.4}", rmse(&supersampled(2), &exact, 1..SIZE)), "0.0720");
    assert_eq!(format!("{:.4}", rmse(&uniform, &exact, 1..11)), "0.1325"); // the far rows alone
}

#[test]
fn sixteen_regular_samples_see_a_pattern_near_the_horizon_that_exact_area_does_not() {
    let (exact, uniform) = (exact(), supersampled(4));
    let grey = exact.map(|_| 0.5);
    let contrast = |image: &Image, j: usize| rmse(image, &grey, j..j + 1);
    // at row f·√(h/2fn) = 2.83 the squares pass at n = 4 a pixel, the rate of the samples
    for j in [1, 2] {
        assert!(contrast(&uniform, j) > 2.0 * contrast(&exact, j), "{j}");
        assert!(contrast(&exact, j) < 0.1 && contrast(&uniform, j) > 0.15, "{j}");
    }
    // far below both see the squares alike
    assert!((contrast(&uniform, 100) / contrast(&exact, 100) - 1.0).abs() < 0.01);
}

#[test]
fn brute_force_of_1500_squared_samples_agrees_within_its_own_error() {
    let board = board();
    for [i, j] in [[10.0, 30.0], [90.0, 12.0], [3.0, 7.0]] {
        let cell = [[i, i + 1.0], [j, j + 1.0]];
        let lines = nyquist::laws::coverage::edges_of_checkerboard(&board, cell);
        let residual = nyquist::laws::coverage::mean_by_counting(&board, cell, 1500, lines, 0.0).unwrap();
        assert!(residual.holds() && residual.measured < 3e-4, "{residual:?}");
    }
}

#[test]
fn at_the_horizon_the_mean_says_what_it_leaves_out() {
    let board = board();
    for x in [0.0, 20.0, 64.0, 127.0] {
        let row = |from: f64, to: f64| board.mean([x, x + 1.0], [from, to]) * (to - from);
        let left_out = board.mean_error([x, x + 1.0], [0.0, 1.0]);
        assert!(left_out > 0.0 && left_out < 4e-7, "{left_out}");
        assert_eq!(board.mean_error([x, x + 1.0], [0.01, 1.0]), 0.0);
        // two parts that meet below the horizon are the whole
        let parts = row(0.0, 0.1) + row(0.1, 1.0);
        assert!((row(0.0, 1.0) - parts).abs() <= 2.0 * left_out + 1e-12);
    }
    // above the horizon there is the sky, and half and half across it
    assert_eq!(board.mean([3.0, 4.0], [-2.0, -1.0]), 0.5);
    let across = board.mean([3.0, 4.0], [-1.0, 1.0]);
    let below = board.mean([3.0, 4.0], [0.0, 1.0]);
    assert!((across - 0.5 * (0.5 + below)).abs() < 1e-12);
    // and all is total: a pixel far away, a pixel across the middle, a pixel as high as the picture
    for (x, y) in [([1e6, 1e6 + 1.0], [1.0, 2.0]), ([-1.0, 129.0], [1.0, 128.0]), ([63.0, 65.0], [1e-9, 1e9])] {
        assert!((0.0..=1.0).contains(&board.mean(x, y)), "{x:?} {y:?} {}", board.mean(x, y));
    }
}

#[test]
fn a_larger_check_is_a_lower_camera() {
    let camera = |height: f64| Camera::new(50.0, height, [10.0, -3.0]).unwrap();
    let large = Perspective::new(camera(3.0), Checks::new(1.5).unwrap(), 0.2).unwrap();
    let low = Perspective::new(camera(2.0), Checks::new(1.0).unwrap(), 0.2).unwrap();
    for j in 0..20 {
        let cell = [[f64::from(j), f64::from(j) + 1.0], [f64::from(j) - 4.0, f64::from(j) - 2.5]];
        let bound = large.mean_error(cell[0], cell[1]) + 1e-13;
        assert!((large.mean(cell[0], cell[1]) - low.mean(cell[0], cell[1])).abs() <= bound);
    }
}
