//! E13: coverage is exact for area, which makes it a box prefilter with the gain `sinc`: ghosts are dimmed and stay
//! visible. A better kernel before sampling removes ten times more. E14: a prefilter exists where areas have a closed form.

use nyquist::image::resize::resize;
use nyquist::laws::coverage::area_gain;
use nyquist::num::sinc;
use nyquist::prelude::*;

#[test]
fn at_nine_tenths_of_the_rate_a_ninth_is_left_and_at_the_first_side_lobe_a_fifth() {
    for (cycles, pixels, printed) in [(9, 10, 0.1093), (143, 100, -0.2172), (39, 10, -0.0252)] {
        let gain = sinc(f64::from(cycles) / pixels as f64);
        assert!((gain - printed).abs() < 5e-5);
        assert!(area_gain(cycles, pixels, gain).unwrap().holds());
    }
}

const M: f64 = 64.0;

/// The root mean square deviation from grey where the local frequency is between 0.75 and 1.25 cycles per pixel in `x` and
/// below a quarter in `y`: around the ghost at (M, 0), where a perfect picture is grey.
fn ghost(image: &Image) -> f64 {
    let near = image.grid().iter().zip(image.values());
    let inside = near.filter(|([x, y], _)| (0.75 * M..1.25 * M).contains(x) && y.abs() < 0.25 * M);
    let squares: Vec<f64> = inside.map(|(_, v)| (v - 0.5) * (v - 0.5)).collect();
    (squares.iter().sum::<f64>() / squares.len() as f64).sqrt()
}

/// The same for a prefilter of the response `k`: a wave of the amplitude ½ with the gain at its local frequency.
fn predicted(k: impl Fn(f64) -> f64) -> f64 {
    let cells = Grid::cells(0.75..1.25, 400, -0.25..0.25, 400).expect("the ranges rise");
    let powers = cells.iter().map(|[u, v]| (0.5 * k(u) * k(v)).powi(2) / 2.0);
    (powers.sum::<f64>() / cells.len() as f64).sqrt()
}

#[test]
fn ghosts_of_the_zone_plate_survive_exact_area_and_not_a_lanczos_prefilter() {
    let plate = ZonePlate::new(M).unwrap();
    let (width, height) = (100, 40);
    let across = |n: usize| Grid::cells(0.0..100.0, width * n, -20.0..20.0, height * n).unwrap();
    let point = ghost(&Image::of(&plate, across(1)));
    let area = ghost(&Image::averaged(&plate, across(1)));
    // eight exact areas a pixel each way stand for the continuous picture: their own gain there is above sinc(1.25/8)
    let kernel = Lanczos::new(3.0).unwrap();
    let lanczos = ghost(&resize(&Image::averaged(&plate, across(8)), width, height, &kernel, Edge::Clamp).unwrap());
    // within a pixel the phase is not quite linear: each value errs by up to π/12M (see `dimmed_ghosts`), and the mean of
    // cos² over 32 by 32 pixels is a half to a few hundredths
    let model = predicted(sinc);
    assert!((area - model).abs() < std::f64::consts::PI / (12.0 * M) + 0.05 * model, "{area} {model}");
    assert!((point - 0.5 / 2f64.sqrt()).abs() < 0.02, "{point}");
    assert!(area < 0.5 * point && area > 0.1 * point, "dimmed, and still there: {area} of {point}");
    assert!(lanczos < 0.2 * area, "{lanczos} of {area}");
}

#[test]
fn e14_a_prefilter_exists_where_areas_have_a_closed_form() {
    // a triangle's coverage is its convolution with the pixel: shifting the grid by a fraction changes nothing in the sum,
    // while the number of samples that hit it depends on where the grid stands
    let triangle = ConvexPolygon::new(&[[3.2, 2.1], [9.7, 4.4], [5.0, 11.3]]).unwrap();
    let sums = |exact: bool| -> Vec<f64> {
        let grid = |s: f64| Grid::cells(s..s + 14.0, 14, s..s + 14.0, 14).unwrap();
        let image = |s| if exact { Image::averaged(&triangle, grid(s)) } else { Image::of(&triangle, grid(s)) };
        (0..8).map(|k| image(f64::from(k) / 8.0).values().iter().sum()).collect()
    };
    let spread = |sums: Vec<f64>| {
        let (low, high) =
            (sums.iter().copied().fold(f64::INFINITY, f64::min), sums.iter().copied().fold(0.0, f64::max));
        high - low
    };
    assert!(spread(sums(true)) < 196.0 * 64.0 * f64::EPSILON);
    assert!(spread(sums(false)) >= 1.0);
}
