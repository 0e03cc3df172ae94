//! The numbers that the pictures of the problem must show (F01, F03, F04, F05 and the tilted square), asked of their data
//! at the defaults: each to half a unit of the last printed digit.

use crate::asking::{figure, layer, near, points, value};
use ndarray::Array2;
use nyquist::figure::{Figure, Mark};
use nyquist::text::Lang;

fn pixels<'a>(figure: &'a Figure, panel: &str) -> &'a Array2<f64> {
    let Mark::Raster { values, .. } = &layer(figure, panel, "pixels").mark else { panic!("{panel} is no picture") };
    values
}

fn says(figure: &Figure, number: &str) -> bool {
    figure.claims.iter().any(|c| c.says.get(Lang::En).split([' ', ',', ';', ':']).any(|word| word == number))
}

fn variance(points: &[[f64; 2]]) -> f64 {
    let n = points.len() as f64;
    let mean = points.iter().map(|p| p[1]).sum::<f64>() / n;
    points.iter().map(|p| (p[1] - mean).powi(2)).sum::<f64>() / n
}

#[test]
fn f01_a_pixel_is_a_box_before_point_samples() {
    let pixel = figure("f01-pixels", &[]);
    let at_nyquist = points(&pixel, "transfer", "at-nyquist");
    near(at_nyquist[0][1], std::f64::consts::FRAC_2_PI, 5e-5); // printed as 0.6366
    near(at_nyquist[1][1], 0.9003, 5e-5);
    assert!(says(&pixel, "0.6366") && says(&pixel, "−3.92") && says(&pixel, "0.9003"));
    let equal = pixel.claims.iter().find(|c| c.residual.law.contains("E ⊗ box")).expect("it is claimed");
    assert!(equal.residual.measured < 1e-12);
}

#[test]
fn f01_a_lattice_has_peaks_and_a_mosaic_a_quiet_middle_and_noise() {
    let sensor = figure("f01-sensor", &[]);
    let lines = points(&sensor, "cut", "lines");
    for [nu, power] in lines {
        near(power, if nu == 1.0 || nu == 2.0 { 144.0 } else { 0.0 }, 1e-9);
    }
    let radial = points(&sensor, "radial", "mean");
    assert!(radial.iter().filter(|p| p[0] < 0.35).all(|p| p[1] < 0.1));
    let top = radial.iter().map(|p| p[1]).fold(0.0, f64::max);
    near(top, 1.75, 0.1);
}

#[test]
fn f03_steps_are_as_long_as_the_cotangent() {
    let jaggies = figure("f03-jaggies", &[]);
    assert!(says(&jaggies, "28.64") && says(&jaggies, "2.747"));
    for (panel, cot) in [("flat-runs", 28.636), ("steep-runs", 2.7475)] {
        let runs = points(&jaggies, panel, "runs");
        let mean = runs.iter().map(|r| r[1]).sum::<f64>() / runs.len() as f64;
        near(mean, cot, 1.0 / runs.len() as f64);
    }
}

#[test]
fn f03_the_zone_plate_repeats() {
    let moire = figure("f03-moire", &[]);
    let plate = pixels(&moire, "point");
    let (mut worst, period) = (0.0f64, 64);
    for ((j, i), v) in plate.indexed_iter().filter(|((j, i), _)| *i < 128 && *j < 128) {
        worst = worst.max((plate[[j, i + period]] - v).abs()).max((plate[[j + period, i]] - v).abs());
    }
    assert!(worst <= 3e-13);
    for (j, i) in [(96, 96), (96, 32), (160, 160), (32, 96)] {
        assert_eq!(plate[[j, i]], 1.0, "a centre");
    }
    // the mean over a pixel has only the true one
    let area = pixels(&moire, "area");
    assert!(area[[96, 96]] > 0.999 && (area[[96, 32]] - 0.5).abs() < 0.01);
}

#[test]
fn f03_a_small_disc_is_hit_or_missed() {
    let flicker = figure("f03-small-objects", &[]);
    assert!(says(&flicker, "0.2827"));
    assert!(points(&flicker, "light", "point").iter().all(|p| p[1] == 0.0 || p[1] == 1.0));
    for frame in points(&flicker, "light", "area") {
        near(frame[1], 0.2827, 5e-5);
    }
}

#[test]
fn f03_highlights_sparkle_only_where_they_are_sampled() {
    let highlights = figure("f03-highlights", &[]);
    let [point, area] = [("point-total", "point"), ("area-total", "area")]
        .map(|(panel, name)| variance(&points(&highlights, panel, name)));
    assert!(point > 1e-2 && area < 1e-24, "{point:e} {area:e}");
}

#[test]
fn f03_the_wheel_turns_backwards() {
    let strobing = figure("f03-strobing", &[]);
    assert!(["23.2", "−0.8", "−0.1", "0.658"].iter().all(|number| says(&strobing, number)));
    // a spoke's distance is 1: −0.8 of it in a second
    let frames = points(&strobing, "positions", "frames");
    near(value(&frames, 0.5), -0.4, 1e-12);
    let motion = strobing.motion.expect("it is shown in motion");
    // three pictures for each of thirty frames, in which the spokes come back by just one distance: a loop without a jump
    assert_eq!((motion.frames.len(), motion.rate), (90, 24));
}

#[test]
fn f04_the_ghosts_of_an_image_are_filtered_away() {
    let images = figure("f04-images", &[]);
    let behind = images.claims.iter().find(|c| c.residual.law.contains("behind")).expect("it is claimed");
    assert!(behind.residual.measured < 1e-3 && behind.residual.bound < 1e-3);
    let before = pixels(&images, "quarter");
    assert_eq!(before.dim(), (40, 40));
    assert_eq!(before[[10, 20]], 1.0, "a ghost's centre");
}

#[test]
fn f05_two_scenes_have_the_same_samples() {
    let synthesis = figure("f05-synthesis", &[]);
    assert_eq!(pixels(&synthesis, "pixels"), pixels(&synthesis, "glass-pixels"));
    assert_ne!(pixels(&synthesis, "scene"), pixels(&synthesis, "glass"));
}

#[test]
fn a_flat_edge_meets_whole_rows_of_a_regular_grid() {
    let tilted = figure("x-tilted-square", &[]);
    let greys = |panel: &str| {
        // along the upper edge, without its corners
        let row = pixels(&tilted, panel).rows().into_iter().nth(5).expect("there are 32 rows").to_vec();
        let mut levels: Vec<u64> = row[8..20].iter().map(|v| v.to_bits()).collect();
        levels.sort_unstable();
        levels.dedup();
        levels.len()
    };
    assert!(greys("flat-3") <= 4 && greys("flat-3-jittered") > greys("flat-3"));
}
