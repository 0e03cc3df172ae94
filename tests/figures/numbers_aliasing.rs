//! The numbers that the figures of the problem, of reconstruction, of aliasing and of its remedies must show, asked of
//! their data at the defaults: each to half a unit of the last printed digit.

use crate::asking::{figure, layer, near, points, value};
use nyquist::figure::common::{difference, peak};
use nyquist::figure::{Figure, Mark};
use nyquist::num::{cos_pi, sinc};
use nyquist::text::Lang;

/// The largest `measured` of the claims whose law says so.
fn measured(figure: &Figure, law: &str) -> f64 {
    let found = figure.claims.iter().filter(|c| c.residual.law.contains(law)).map(|c| c.residual.measured);
    found.reduce(f64::max).unwrap_or_else(|| panic!("no claim on {law}"))
}

/// Whether some claim says this number.
fn says(figure: &Figure, number: &str) -> bool {
    figure.claims.iter().any(|c| c.says.get(Lang::En).split([' ', ',', ';', '±']).any(|word| word == number))
}

#[test]
fn f02_shows_the_images_of_a_display() {
    let display = figure("f02-display", &[]);
    let ratio = |panel: &str| {
        let (tone, image) = (points(&display, panel, "tone"), points(&display, panel, "images"));
        value(&image, 0.9) / value(&tone, 0.1)
    };
    near(ratio("hold-spectrum"), 1.0 / 9.0, 1e-14);
    near(ratio("spots-spectrum"), 0.0193, 5e-5);
    let ripple = points(&display, "spots-flat", "flat").iter().map(|p| (p[1] - 1.0).abs()).fold(0.0, f64::max);
    near(100.0 * ripple, 1.44, 5e-3);
    assert!(says(&display, "0.1111") && says(&display, "0.0193") && says(&display, "1.44"));
}

#[test]
fn f04_shows_a_ghost_that_the_filter_removes() {
    let scenes = figure("f04-antialiasing", &[]);
    let ghost = |panel: &str| {
        let samples = points(&scenes, panel, "samples");
        samples.iter().filter(|p| (p[0] - 80.0).abs() <= 8.0).map(|p| p[1].abs()).fold(0.0, f64::max)
    };
    near(ghost("sampled"), 1.0, 1e-5);
    assert!(ghost("filtered") < 1e-3 && ghost("filtered-again") < 1e-3);
}

#[test]
fn f07_has_one_set_of_samples_for_two_tones() {
    let cause = figure("f07-cause", &[]);
    for [x, v] in points(&cause, "fast", "samples") {
        near(v, cos_pi(0.2 * x), 6e-15); // 0.9 is seen as 0.1
    }
    for [x, v] in points(&cause, "sine", "samples") {
        near(v, -(0.2 * std::f64::consts::PI * x).sin(), 6e-15);
    }
    for [x, v] in points(&cause, "slow", "samples") {
        near(v, value(&points(&cause, "slow", "slowest"), x), 6e-15);
    }
}

#[test]
fn f08_folds_at_half_the_rate_and_at_zero() {
    let folding = figure("f08-folding", &[("slow", "1")]);
    let curve = points(&folding, "folding", "folded");
    for (f, seen) in [(0.0, 0.0), (4.0, 4.0), (8.0, 0.0), (12.0, 4.0), (16.0, 0.0), (20.0, 4.0), (24.0, 0.0)] {
        near(value(&curve, f), seen, 1e-14);
    }
    for [f, seen] in points(&folding, "folding", "measured") {
        near(seen, (f - 8.0 * (f / 8.0).round()).abs(), 8.0 / 128.0);
    }
    // the chirp's ridge turns at x = 1 and 3 (4), and at x = 2 (zero)
    let Mark::Raster { values, .. } = &layer(&folding, "spectrogram", "power").mark else { panic!() };
    let (rows, columns) = values.dim();
    let strongest = |x: f64| {
        let column = ((x / 4.0 * columns as f64) as usize).min(columns - 1);
        let row = (0..rows).max_by(|&i, &j| values[[i, column]].total_cmp(&values[[j, column]]));
        4.0 * (row.expect("there are rows") as f64 + 0.5) / rows as f64
    };
    for (x, ridge) in [(1.0, 4.0), (2.0, 0.0), (3.0, 4.0), (0.5, 2.0), (1.5, 2.0), (2.5, 2.0), (3.5, 2.0)] {
        near(strongest(x), ridge, 0.3);
    }
}

#[test]
fn f15_and_f16_add_up_filters() {
    let sliding = figure("f15-convolution", &[]);
    // the tent at 2.4 between the samples 0.796 and 0.311
    near(points(&sliding, "sliding", "sum")[0][1], 0.6 * 0.796 + 0.4 * 0.311, 1e-15);
    let tents = figure("f16-tents", &[]);
    assert!(measured(&tents, "linear interpolation") <= 1e-14 && measured(&tents, "Σ tents") <= 1e-14);
    // the unscaled tent averages: ¼, ½, ¼
    let samples = points(&tents, "unscaled", "samples");
    let sum = points(&tents, "unscaled", "sum");
    let close = |x: f64| sum.iter().min_by(|a, b| (a[0] - x).abs().total_cmp(&(b[0] - x).abs())).expect("a point")[1];
    for w in samples.windows(3) {
        near(close(w[1][0]), 0.25 * w[0][1] + 0.5 * w[1][1] + 0.25 * w[2][1], 2e-3); // the points are 0.005 apart
    }
    assert!(samples.iter().map(|p| (p[1] - close(p[0])).abs()).fold(0.0, f64::max) > 0.05);
}

#[test]
fn f23_restores_the_signal() {
    let cardinal = figure("f23-cardinal", &[]);
    assert!(measured(&cardinal, "cardinal series = signal") <= 1e-12);
    assert_eq!(measured(&cardinal, "at every sample"), 0.0);
}

#[test]
fn f24_shows_what_the_sinc_costs() {
    let problems = figure("f24-problems", &[]);
    let lost = points(&problems, "energy", "lost");
    for (n, printed) in [(1.0, 0.0972), (2.0, 0.0501), (8.0, 0.0127)] {
        near(value(&lost, n), printed, 5e-5);
    }
    let Mark::Horizontals(step) = &layer(&problems, "ringing", "overshoot").mark else { panic!() };
    near(100.0 * (step[0] - 1.0), 14.114, 5e-4);
    // the pulse of eight samples overshoots by more than a single step: both its edges ring
    near(100.0 * (peak(layer(&problems, "ringing", "sinc")) - 1.0), 16.29, 5e-3);
}

#[test]
fn f25_and_f26_are_the_chain_with_and_without_overlap() {
    let overview = figure("f25-overview", &[]);
    let (f, back) = (layer(&overview, "signal", "signal"), layer(&overview, "result", "result"));
    assert!(difference(f, back) < 1e-9);
    let lines = points(&overview, "comb-spectrum", "lines");
    assert_eq!(lines, [[-2.5, 1.0], [0.0, 1.0], [2.5, 1.0]]);
    let undersampled = figure("f26-undersampled", &[]);
    let Mark::Spans(overlap) = &layer(&undersampled, "copies", "overlap").mark else { panic!() };
    assert_eq!(overlap, &[[-1.0, -0.25], [0.25, 1.0]]);
    let worst = difference(layer(&undersampled, "signal", "signal"), layer(&undersampled, "result", "result"));
    near(worst, 0.0943, 5e-5); // V08
}

#[test]
fn f29_is_zero_from_twice_the_band_on() {
    let step = figure("f29-step", &[]);
    let marked = points(&step, "energy", "marked");
    // in the order of T·B = 0.6, 0.8, 1
    for (mark, printed, half) in [(0, 0.000808, 5e-7), (1, 0.04081, 5e-6), (2, 0.15117, 5e-6)] {
        near(marked[mark][1].powi(2), printed, half);
    }
    let curve = points(&step, "energy", "energy");
    near(value(&curve, 0.8).powi(2), 0.335, 5e-4);
    assert!(curve.iter().filter(|p| p[0] >= 2.0).all(|p| p[1] == 0.0));
    let largest = points(&step, "supremum", "marked");
    near(largest[1][1], 0.0943, 5e-5);
    near(largest[2][1], 0.2129, 5e-5);
}

#[test]
fn f30_returns_the_cosine_of_the_phase() {
    let theorem = figure("f30-theorem", &[]);
    for [degrees, amplitude] in points(&theorem, "phases", "amplitude") {
        near(amplitude, cos_pi(degrees / 180.0), 1e-14);
    }
    assert!(measured(&theorem, "sup|f̃ − f| at f_s = 2B") <= 4e-15);
    assert_eq!(measured(&theorem, "sin(2πB·k/2B) = 0"), 0.0);
}

#[test]
fn f31_and_f32_leave_what_their_filters_leave() {
    let boxed = figure("f31-remedies", &[("filter", "box")]);
    let peak_of = |panel: &str| peak(layer(&boxed, panel, "alias"));
    near(peak_of("point"), 1.0, 1e-12);
    near(peak_of("filtered"), 0.1093, 5e-5); // the box over a pixel
    near(peak_of("uniform"), 0.309_017 / (4.0 * 0.649_448), 1e-6); // D(0.9) = sin 0.9π/(4·sin 0.225π)
    near(peak_of("uniform-fast"), 0.98464, 5e-6);
    near(peak_of("stochastic"), sinc(0.9), 0.01);
    let prefilter = figure("f32-prefilter", &[]);
    near(points(&prefilter, "gain-box", "tone")[0][1], 0.1093, 5e-5);
    assert!(says(&prefilter, "0.1093"));
    let ends = points(&prefilter, "filtered", "back");
    assert!(ends.iter().filter(|p| p[0] >= 2.0).all(|p| (p[1] - 1.0).abs() < 0.03));
}

#[test]
fn f33_passes_what_the_area_stops() {
    let supersampling = figure("f33-supersampling", &[]);
    let [nu, passes] = points(&supersampling, "transfer", "alias")[0];
    near(nu, 3.9, 1e-12);
    near(passes, -0.98464, 5e-6);
    near(sinc(nu), -0.02522, 5e-6);
    assert!(says(&supersampling, "−0.98464") && says(&supersampling, "−0.02522"));
}
