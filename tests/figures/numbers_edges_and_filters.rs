//! The numbers that the lecture's inventory prints for F48, F55 and F57, asked of the figures' own data.

use crate::asking::{figure, near, points};
use nyquist::figure::Figure;
use nyquist::laws::metrics::TABLE;
use nyquist::text::Lang;

fn says(figure: &Figure, claim: usize) -> &str {
    figure.claims[claim].says.get(Lang::En)
}

#[test]
fn f48_a_sampled_step_overshoots_by_14_114_percent_at_0_418_steps_then_by_minus_7_64() {
    let figure = figure("f48-gibbs", &[]);
    let top = points(&figure, "between", "top")[0];
    near(top[1], 1.14114, 5e-6);
    near(top[0] / 0.125, 0.418, 5e-4);
    assert!(says(&figure, 0).contains("14.114 %") && says(&figure, 0).contains("0.418 T"));
    assert!(says(&figure, 1).contains("7.64 %"));
    // the drawn curve itself: 800 pieces over 11 steps, so the peak is met within 0.007 steps
    let drawn = points(&figure, "between", "ringing").iter().map(|p| p[1]).fold(0.0, f64::max);
    near(drawn, 1.14114, 1e-4);
}

#[test]
fn f48_half_a_sample_on_the_jump_leaves_3_289_percent_and_the_fourier_integral_8_949() {
    let figure = figure("f48-gibbs", &[]);
    near(points(&figure, "on", "top")[0][1], 1.03289, 5e-6);
    near(points(&figure, "low-passed", "top")[0][1], 1.08949, 5e-6);
    near(points(&figure, "low-passed", "top")[0][0], 0.125, 1e-7);
    assert!(says(&figure, 3).contains("3.289 %") && says(&figure, 4).contains("8.949 %"));
}

#[test]
fn f48_the_overshoot_does_not_depend_on_where_between_the_samples_the_jump_is() {
    let heights =
        ["0.05", "0.3", "0.95"].map(|place| points(&figure("f48-gibbs", &[("place", place)]), "between", "top")[0][1]);
    assert!(heights.iter().all(|h| *h == heights[0]));
}

#[test]
fn f48_the_error_of_an_edge_falls_like_the_root_of_the_step() {
    let errors = points(&figure("f48-sources", &[]), "edge", "errors");
    for pair in errors.windows(2) {
        let slope = (pair[1][1] / pair[0][1]).ln() / (pair[1][0] / pair[0][0]).ln();
        near(slope, 0.5, 0.03);
    }
}

#[test]
fn f55_one_filter_gives_the_pixels_of_all_three_stages() {
    for r in ["tent", "box", "catmull-rom"] {
        for p in ["box", "tent", "mitchell", "gaussian"] {
            let figure = figure("f55-stages", &[("r", r), ("p", p)]);
            for (pixel, at_once) in points(&figure, "third", "pixels").iter().zip(points(&figure, "third", "at-once")) {
                near(pixel[1], at_once[1], 1e-12);
            }
        }
    }
}

#[test]
fn f57_shows_the_numbers_of_the_table() {
    let figure = figure("f57-choice", &[]);
    let dots = |panel: &str| -> Vec<[f64; 2]> {
        let layers = &figure.panel(panel).expect("the panel exists").layers;
        layers.iter().filter(|l| l.name == "kernels").flat_map(|l| l.points().to_vec()).collect()
    };
    for row in TABLE {
        let number = |i: usize| -> f64 { row.printed[i].parse().expect("the table consists of numbers") };
        let half_digit = |i: usize| 0.5 * 10f64.powi(2 - row.printed[i].len() as i32); // "0." and the digits
        let shown = |panel: &str, [x, y]: [usize; 2], scale: f64| {
            dots(panel).iter().any(|dot| {
                (dot[0] - number(x)).abs() <= half_digit(x) && (dot[1] / scale - number(y)).abs() <= half_digit(y)
            })
        };
        assert!(shown("images", [0, 1], 1.0), "{}: no dot at S, P", row.name);
        assert!(shown("ringing", [0, 5], 100.0), "{}: no dot at S, overshoot", row.name);
    }
}
