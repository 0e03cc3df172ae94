//! The numbers that the figures of lens and shutter must show, asked of their data at the defaults.

use crate::asking::{figure, layer, near, points, value};
use nyquist::figure::{Figure, Mark};
use nyquist::prelude::*;
use nyquist::text::Lang;

/// The values of the picture in that panel, of a picture in colours its luminance.
fn picture(figure: &Figure, panel: &str) -> Vec<f64> {
    match &layer(figure, panel, "pixels").mark {
        Mark::Raster { values, .. } => values.iter().copied().collect(),
        Mark::Colors { light, .. } => {
            let [red, green, blue] = &**light;
            let pixels = red.iter().zip(green).zip(blue);
            pixels.map(|((r, g), b)| 0.2126 * r + 0.7152 * g + 0.0722 * b).collect()
        }
        _ => panic!("no picture in {panel}"),
    }
}

fn mean_square(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum::<f64>() / a.len() as f64
}

#[test]
fn f47_traces_rays_that_meet_in_focus_and_miss_by_the_circle_of_confusion() {
    let scene = figure("f47-scene-function", &[]);
    // each ray: point, lens, film, and the pen lifted
    let film = |name: &str| -> Vec<f64> {
        let Mark::Line(path) = &layer(&scene, "rays", name).mark else { panic!("rays") };
        path.iter().filter(|p| p[0] == 2.0).map(|p| p[1]).collect()
    };
    let spread = |name: &str| {
        let film = film(name);
        film.iter().copied().fold(f64::NEG_INFINITY, f64::max) - film.iter().copied().fold(f64::INFINITY, f64::min)
    };
    assert!(film("focused").len() > 5 && spread("focused") <= 1e-12);
    // |(d′ − z′)/z′|·A by hand: film at 2, focus at 5, so 1/f = 0.7; z = 2.75 and 10
    for (name, z) in [("near", 2.75), ("far", 10.0)] {
        let image: f64 = 1.0 / (0.7 - 1.0 / z);
        let confusion = ((2.0 - image) / image).abs() * 1.6;
        near(spread(name), confusion, 1e-12);
        let slice = points(&scene, "slice", name);
        let (first, last) = (slice[0], slice[slice.len() - 1]);
        near(((last[0] - first[0]) / (last[1] - first[1])).abs() * 1.6, confusion, 1e-12);
    }
}

#[test]
fn f53_gains_by_strata_of_the_lens_and_not_of_the_image() {
    let sphere = figure("f53-defocus", &[]);
    let [truth, random, stratified] = ["reference", "random", "stratified"].map(|panel| picture(&sphere, panel));
    let ratio = mean_square(&random, &truth) / mean_square(&stratified, &truth);
    assert!(ratio >= 3.0, "{ratio}");
    let error = |name: &str, n: f64| value(&points(&sphere, "errors", name), n);
    near(error("random", 16.0), mean_square(&random, &truth), 1e-12);
    near(error("image", 16.0) / error("random", 16.0), 1.0, 0.1);
    let gains = [4.0, 16.0, 64.0].map(|n| error("random", n) / error("stratified", n));
    // edges alone would gain √N·0.94 (V15): 1.9, 3.7, 7.5
    assert!(gains[0] > 1.5 && gains[1] > 3.0 && gains[2] > 5.0, "{gains:?}");
    // not shuffled, the picture is as good at once and its error does not average out
    let [in_order, shuffled] = ["in-order", "shuffled"].map(|panel| picture(&sphere, panel));
    let zero = vec![0.0; in_order.len()];
    assert!(mean_square(&in_order, &zero) > 2.0 * mean_square(&shuffled, &zero));
}

#[test]
fn f53_groups_not_shuffled_are_as_good_in_one_picture() {
    let scene = nyquist::scene::catalog::by_name("defocus").expect("a scene").scene();
    let picture = |pattern: &dyn Pattern<5>, seed| {
        render(&*scene, 32, 32, pattern, &BoxKernel, seed).expect("a picture").luminance()
    };
    let truth = picture(&Padded::new(40).expect("samples"), 9);
    let pattern = Padded::new(4).expect("samples");
    let errors = [pattern, pattern.associated(Association::InOrder)].map(|pattern| {
        (0..8).map(|seed| picture(&pattern, seed).rmse(&truth).expect("one size").powi(2)).sum::<f64>() / 8.0
    });
    assert!((errors[1] / errors[0] - 1.0).abs() < 0.35, "{errors:?}");
}

#[test]
fn motion_keeps_what_passes_a_whole_number_of_periods_between_two_moments() {
    let motion = figure("x-motion", &[]);
    near(value(&points(&motion, "transfer", "by-moments"), 4.0).abs(), 1.0, 1e-13);
    near(value(&points(&motion, "transfer", "by-strata"), 4.5), nyquist::num::sinc(4.5), 0.03);
    assert!(motion.claims.iter().any(|c| c.says.get(Lang::En).contains("0.658"))); // V29
}

#[test]
fn shears_lie_where_the_circle_of_confusion_says() {
    let shear = figure("x-shear", &[]);
    let slope = |panel: &str| {
        let line = points(&shear, panel, "sheared");
        -(line[1][1] - line[0][1]) / (line[1][0] - line[0][0])
    };
    near(slope("motion-spectrum"), 0.7, 1e-12);
    near(slope("focus-spectrum"), 0.0, 1e-12);
    near(slope("near-spectrum"), 0.6 * (1.0 / 3.0 - 1.0), 1e-12);
    near(slope("far-spectrum"), 0.6 / 3.0, 1e-6);
}

#[test]
fn the_sensor_keeps_the_light() {
    let camera = figure("x-camera", &[]);
    let mean = |panel: &str| {
        let picture = picture(&camera, panel);
        picture.iter().sum::<f64>() / picture.len() as f64
    };
    near(mean("sensor"), mean("shutter"), 1e-12);
}
