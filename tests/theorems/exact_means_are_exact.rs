//! The exact mean of every chart is the integral of its values: by formulas that share nothing with the library, by
//! quadrature, and by counting, whose error for a black-and-white picture is bounded by the number of edges.

use nyquist::num::quadrature::{Integral, even_breaks, integrate_pieces};
use nyquist::prelude::*;
use std::f64::consts::PI;

/// Cells of several sizes around and beside the origin.
const CELLS: [[[f64; 2]; 2]; 6] = [
    [[-0.5, 0.5], [-0.5, 0.5]],
    [[0.0, 1.0], [2.0, 3.0]],
    [[-3.1, -2.7], [0.4, 1.9]],
    [[1.25, 1.2501], [0.3, 0.3001]],
    [[-4.0, 5.0], [-6.0, 2.5]],
    [[7.0, 7.5], [-7.25, -7.0]],
];

/// `∬ f / area` by quadrature within quadrature, for smooth fields.
fn by_quadrature(field: &impl Field, [x, y]: [[f64; 2]; 2], step: f64) -> Integral {
    let worst = std::cell::Cell::new(0.0f64);
    let row = |y: f64| {
        let inner = integrate_pieces(|x| field.at(x, y), &even_breaks(x[0], x[1], step), 1e-15);
        worst.set(worst.get().max(inner.error));
        inner.value
    };
    let outer = integrate_pieces(row, &even_breaks(y[0], y[1], step), 1e-15);
    let area = (x[1] - x[0]) * (y[1] - y[0]);
    Integral { value: outer.value / area, error: (outer.error + worst.get() * (y[1] - y[0])) / area }
}

fn smooth(field: &impl ExactMean, step: f64, rounding: f64) {
    for cell in CELLS {
        let integral = by_quadrature(field, cell, step);
        let mean = field.mean(cell[0], cell[1]);
        assert!((mean - integral.value).abs() <= integral.error + rounding, "{cell:?}: {mean} ≠ {integral:?}");
        let [x, y] = cell;
        assert_eq!(field.mean([x[1], x[0]], y), mean, "the ends may come in either order");
        let value = field.at(x[0], 0.5 * (y[0] + y[1]));
        assert!((field.mean([x[0], x[0]], y) - value).abs() <= 1e-13, "no area: the value");
    }
}

#[test]
fn smooth_charts_agree_with_quadrature() {
    // the cells are at most 9 wide and at least 10⁻⁴; means of differences round by ε·size/width
    let rounding = 64.0 * f64::EPSILON * 1e4;
    smooth(&Grating::with_phase([0.9, -0.35], 0.7).unwrap(), 0.5, rounding);
    smooth(&Grating::at_angle(0.25, 1.0).unwrap(), 0.5, rounding);
    smooth(
        &Plaid::new(Grating::new([0.5, 0.1]).unwrap(), Grating::with_phase([0.0, 0.7], -0.5 * PI).unwrap()).unwrap(),
        0.5,
        rounding,
    );
    smooth(&GaussianSpot::round(1.7).unwrap(), 0.5, rounding);
    smooth(&GaussianSpot::new([0.4, 2.5]).unwrap(), 0.2, rounding);
    smooth(&GaussianSpot::turned([0.6, 2.0], 0.8).unwrap(), 0.3, rounding);
    smooth(&ZonePlate::new(5.0).unwrap(), 0.25, 8.0 * rounding);
    smooth(&Flat::new(0.3).unwrap(), 1.0, rounding);
}

#[test]
fn moved_zoomed_and_added_fields_keep_their_exact_means() {
    let rounding = 256.0 * f64::EPSILON * 1e4;
    let wave = Grating::new([0.3, 0.4]).unwrap();
    smooth(&Moved::new([0.3, -1.2], GaussianSpot::round(1.1).unwrap()).unwrap(), 0.4, rounding);
    smooth(&Zoomed::new([2.0, 0.5], ZonePlate::new(3.0).unwrap()).unwrap(), 0.1, 16.0 * rounding);
    smooth(&Amplified::new(-2.5, wave).unwrap(), 0.5, rounding);
    smooth(&Added(Flat::new(0.5).unwrap(), Amplified::new(0.5, wave).unwrap()), 0.5, rounding);
}

/// The area of a cell on one side of a line, `n·p < c`, by the formula of Gueyffier et al. (1999): a sum of squares.
fn half_plane_fraction(normal: [f64; 2], c: f64, [x, y]: [[f64; 2]; 2]) -> f64 {
    let (a, b) = (normal[0].abs() * (x[1] - x[0]), normal[1].abs() * (y[1] - y[0]));
    // the least value of n·p over the cell
    let low = (normal[0] * x[0]).min(normal[0] * x[1]) + (normal[1] * y[0]).min(normal[1] * y[1]);
    let s = c - low;
    let square = |t: f64| t.max(0.0).powi(2);
    (square(s) - square(s - a) - square(s - b) + square(s - a - b)) / (2.0 * a * b)
}

#[test]
fn an_edge_covers_what_the_sum_of_squares_says() {
    for i in 0..200u64 {
        let random = |d: u32| nyquist::num::random::uniform(5, i, d) - 0.5;
        let (sin, cos) = (2.0 * PI * random(0)).sin_cos();
        let offset = 2.0 * random(1);
        let edge = HalfPlane::new([3.0 * cos, 3.0 * sin], 3.0 * offset).unwrap();
        let corner = [3.0 * random(2), 3.0 * random(3)];
        let cell = [[corner[0], corner[0] + 0.1 + random(4).abs()], [corner[1], corner[1] + 0.1 + random(5).abs()]];
        let known = half_plane_fraction([cos, sin], offset, cell);
        // the formula's squares are up to 16 and are divided by 2ab
        let size = 2.0 * (cos * (cell[0][1] - cell[0][0])).abs() * (sin * (cell[1][1] - cell[1][0])).abs();
        let bound = 64.0 * f64::EPSILON * 16.0 / size;
        assert!((edge.mean(cell[0], cell[1]) - known).abs() <= bound, "{cell:?}");
    }
}

/// The mean by one integral along `y` of how much of the row lies inside.
/// `kinks` are the places where that is not smooth.
fn by_rows(length: impl Fn(f64) -> f64, [x, y]: [[f64; 2]; 2], kinks: &[f64]) -> Integral {
    let mut breaks = even_breaks(y[0], y[1], (y[1] - y[0]) / 8.0);
    breaks.extend(kinks.iter().filter(|k| (y[0]..y[1]).contains(k)));
    breaks.sort_by(f64::total_cmp);
    breaks.dedup();
    let rows = integrate_pieces(length, &breaks, 1e-15);
    let area = (x[1] - x[0]) * (y[1] - y[0]);
    Integral { value: rows.value / area, error: rows.error / area }
}

#[test]
fn a_disc_covers_the_integral_of_its_chords() {
    for i in 0..100u64 {
        let random = |d: u32| nyquist::num::random::uniform(6, i, d);
        let radius = 0.1 + 3.0 * random(0).powi(3);
        let center = [random(1) - 0.5, random(2) - 0.5];
        let corner = [4.0 * random(3) - 2.0, 4.0 * random(4) - 2.0];
        let cell = [[corner[0], corner[0] + 0.2 + random(5)], [corner[1], corner[1] + 0.2 + random(6)]];
        let chord = |y: f64| {
            let half = (radius * radius - (y - center[1]).powi(2)).max(0.0).sqrt();
            ((center[0] + half).min(cell[0][1]) - (center[0] - half).max(cell[0][0])).max(0.0)
        };
        let crossing = |x: f64| (radius * radius - (x - center[0]).powi(2)).max(0.0).sqrt();
        let heights = [radius, crossing(cell[0][0]), crossing(cell[0][1])];
        let kinks = heights.map(|h| [center[1] - h, center[1] + h]);
        let known = by_rows(chord, cell, kinks.as_flattened());
        let mean = Disc::new(center, radius).unwrap().mean(cell[0], cell[1]);
        // the chord ends like a square root: there halving stops at pieces of 2⁻⁵², whose size the estimate does not see
        assert!((mean - known.value).abs() <= known.error + 1e-12, "{radius} {cell:?}: {mean} {known:?}");
    }
    // whole, none, and a quarter
    let disc = Disc::new([1e3, -1e3], 2.0).unwrap();
    assert!((disc.mean([990.0, 1010.0], [-1010.0, -990.0]) * 400.0 - 4.0 * PI).abs() < 1e-12);
    assert_eq!(disc.mean([1003.0, 1010.0], [-1010.0, -990.0]), 0.0);
    assert_eq!(disc.mean([999.5, 1000.5], [-1000.5, -999.5]), 1.0);
    assert!((disc.mean([1000.0, 1010.0], [-1000.0, -990.0]) * 100.0 - PI).abs() < 1e-12);
}

#[test]
fn a_pixel_of_a_huge_disc_is_a_pixel_of_an_edge() {
    // at r = 10⁶ the sagitta over one pixel is 1/(8r)
    let disc = Disc::new([0.0, -1e6], 1e6).unwrap();
    let edge = HalfPlane::through([0.0, 0.0], 0.0).unwrap();
    let cell = [[-0.5, 0.5], [-0.3, 0.7]];
    let difference = disc.mean(cell[0], cell[1]) - edge.mean(cell[0], cell[1]);
    let segment = -1.0 / (24.0 * 1e6); // ∫ −x²/2r
    assert!((difference - segment).abs() < 16.0 * f64::EPSILON * 1e6, "{difference}");
}

#[test]
fn a_convex_polygon_covers_the_integral_of_its_rows() {
    let vertices = [[1.3, 0.7], [5.2, 1.1], [6.1, 3.6], [3.0, 5.9], [0.9, 3.4]];
    let polygon = ConvexPolygon::new(&vertices).unwrap();
    for i in 0..50u64 {
        let random = |d: u32| nyquist::num::random::uniform(8, i, d);
        let corner = [6.0 * random(0), 6.0 * random(1)];
        let cell = [[corner[0], corner[0] + 0.1 + 2.0 * random(2)], [corner[1], corner[1] + 0.1 + 2.0 * random(3)]];
        let row = |y: f64| {
            let (mut left, mut right) = (f64::INFINITY, f64::NEG_INFINITY);
            for (a, b) in vertices.iter().zip(vertices.iter().cycle().skip(1)) {
                let t = (y - a[1]) / (b[1] - a[1]);
                if (0.0..=1.0).contains(&t) {
                    let x = a[0] + t * (b[0] - a[0]);
                    (left, right) = (left.min(x), right.max(x));
                }
            }
            (right.min(cell[0][1]) - left.max(cell[0][0])).max(0.0)
        };
        let crossing =
            |(a, b): (&[f64; 2], &[f64; 2])| cell[0].map(|x| a[1] + (x - a[0]) / (b[0] - a[0]) * (b[1] - a[1]));
        let sides = vertices.iter().zip(vertices.iter().cycle().skip(1));
        let kinks: Vec<f64> = vertices.iter().map(|p| p[1]).chain(sides.flat_map(crossing)).collect();
        let known = by_rows(row, cell, &kinks);
        let mean = polygon.mean(cell[0], cell[1]);
        assert!((mean - known.value).abs() <= known.error + 1e-13, "{cell:?}: {mean} {known:?}");
    }
}

/// `field` must be 0 or 1, and `lines` edges may cross the cell: counting errs by at most `lines/n`.
fn counted(field: &impl ExactMean, cell: [[f64; 2]; 2], lines: f64) {
    let residual =
        nyquist::laws::coverage::mean_by_counting(field, cell, 500, lines, 0.0).expect("the arguments are valid");
    assert!(residual.holds(), "{cell:?}: {residual:?}");
}

#[test]
fn black_and_white_charts_agree_with_counting() {
    let star = SiemensStar::new([0.2, -0.1], 9).unwrap();
    let wall = BrickWall::new([3.0, 1.3], 0.2, [1.0, 0.0]).unwrap();
    let checks = Checks::new(0.7).unwrap();
    let word = Glyphs::new("ШVAE", [-4.0, -3.0], 4.0).unwrap();
    let line = ThinLine::new([-5.0, -2.0], [6.0, 1.0], 0.08).unwrap();
    for cell in CELLS {
        let [w, h] = cell.map(|[a, b]| b - a);
        counted(&star, cell, 18.0);
        counted(&checks, cell, (w / 0.7).ceil() + (h / 0.7).ceil() + 2.0);
        // two edges a brick and course, and one more at either end
        counted(&wall, cell, 2.0 * ((w / 1.5).ceil() + (h / 1.3).ceil() + 2.0));
        counted(&word, cell, 4.0 * word.pieces().len() as f64);
        counted(&line, cell, 4.0);
    }
}

#[test]
fn letters_are_made_of_pieces_that_do_not_overlap() {
    for letter in nyquist::field::glyphs::LETTERS.chars().filter(|c| *c != ' ') {
        let word = Glyphs::new(&letter.to_string(), [0.0, 0.0], 1.0).unwrap();
        let sum = word.mean([-0.5, 1.5], [-0.5, 1.5]) * 4.0;
        assert!((sum - word.area()).abs() < 1e-13, "{letter}");
        // counting each place once gives the same area: no place lies in two pieces
        let count = Image::of(&word, Grid::cells(-0.5..1.5, 800, -0.5..1.5, 800).unwrap()).mean() * 4.0;
        let lines = 4.0 * word.pieces().len() as f64;
        assert!((count - word.area()).abs() <= 4.0 * lines / 800.0, "{letter}");
        assert!((0..10_000u64).all(|i| {
            let p = [0, 1].map(|d| 1.4 * nyquist::num::random::uniform(1, i, d) - 0.4);
            word.pieces().filter(|piece| piece.at(p[0], p[1]) == 1.0).count() <= 1
        }));
    }
}

#[test]
fn bad_shapes_are_refused_by_name() {
    let pentagram: Vec<[f64; 2]> = (0..5).map(|i| (0.8 * PI * f64::from(i)).sin_cos().into()).collect();
    let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let dent = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [1.0, 0.5], [0.0, 2.0]];
    let not_a_number = [[0.0, 0.0], [1.0, f64::NAN], [0.0, 1.0]];
    assert!(ConvexPolygon::new(&square).is_ok());
    assert!(ConvexPolygon::new(&square.iter().rev().copied().collect::<Vec<_>>()).is_ok());
    assert!(matches!(ConvexPolygon::new(&pentagram), Err(Error::Unsupported(_))));
    assert!(matches!(ConvexPolygon::new(&dent), Err(Error::Unsupported(_))));
    assert!(matches!(ConvexPolygon::new(&not_a_number), Err(Error::NotFiniteAt { index: 1, .. })));
    assert!(matches!(ConvexPolygon::new(&square[..2]), Err(Error::TooFew { .. })));
    assert!(matches!(ConvexPolygon::new(&[[0.0, 0.0], [1.0, 1.0], [2.0, 2.0]]), Err(Error::NotPositive { .. })));
    assert!(matches!(
        ConvexPolygon::new(&[[0.0; 2], [1.0, 0.0], [1.0, 0.0], [0.0, 1.0]]),
        Err(Error::NotPositive { .. })
    ));
    assert!(matches!(HalfPlane::new([0.0, 0.0], 1.0), Err(Error::NotPositive { .. })));
    assert!(matches!(Disc::new([0.0, 0.0], f64::INFINITY), Err(Error::NotFinite { .. })));
    assert!(matches!(ThinLine::new([1.0, 1.0], [1.0, 1.0], 0.1), Err(Error::NotPositive { .. })));
    assert!(matches!(SiemensStar::new([0.0, 0.0], 0), Err(Error::TooFew { .. })));
    assert!(matches!(BrickWall::new([2.0, 1.0], 1.0, [1.0, 0.0]), Err(Error::NotPositive { .. })));
    assert!(matches!(Glyphs::new("ABC", [0.0, 0.0], 1.0), Err(Error::Unknown { .. })));
    assert!(matches!(ZonePlate::new(-1.0), Err(Error::NotPositive { .. })));
    assert!(matches!(Grating::new([f64::NAN, 0.0]), Err(Error::NotFinite { .. })));
    assert!(matches!(Checkerboard::lecture(0), Err(Error::TooFew { .. })));
    assert!(matches!(Camera::new(0.0, 1.0, [0.0, 0.0]), Err(Error::NotPositive { .. })));
    assert!(matches!(Zoomed::new([1.0, 0.0], Flat::new(1.0).unwrap()), Err(Error::NotPositive { .. })));
}
