//! The numbers that the lecture's inventory prints for the checkerboard (F33–F36, F40, F42, F50, F51) and for the film (F56,
//! F58), asked of the figures' own data and sentences.

use crate::asking::{figure, layer, near, points, value};
use ndarray::Array2;
use nyquist::figure::{Figure, Mark};
use nyquist::prelude::*;
use nyquist::text::Lang;

/// What claim number `i` says in English.
fn says(figure: &Figure, i: usize) -> &str {
    figure.claims[i].says.get(Lang::En)
}

/// The numbers in a sentence, in order.
fn numbers(sentence: &str) -> Vec<f64> {
    let clean = sentence.replace('−', "-");
    let parts = clean.split(|c: char| !(c.is_ascii_digit() || c == '.' || c == '-'));
    parts.filter_map(|part| part.trim_matches('.').parse().ok()).collect()
}

/// The values of the picture in that panel, the first row on top.
fn pixels<'a>(figure: &'a Figure, panel: &str, name: &str) -> &'a Array2<f64> {
    let Mark::Raster { values, .. } = &layer(figure, panel, name).mark else { panic!("{panel} shows no picture") };
    values
}

#[test]
fn f35_one_sample_errs_by_0_1284_and_sixteen_uniform_ones_by_0_0395() {
    let figure = figure("f35-checkerboard", &[]);
    assert_eq!(numbers(says(&figure, 0))[..2], [0.1284, 0.0395]);
}

#[test]
fn f35_ghosts_stand_in_rows_5_66_and_2_83_and_2_00() {
    let figure = figure("f35-checkerboard", &[]);
    for (panel, row) in [("point-far", 5.66), ("uniform-far", 2.83)] {
        let Mark::Horizontals(at) = &layer(&figure, panel, "ghost").mark else { panic!("no line in {panel}") };
        near(at[0], row, 0.005);
    }
    for (i, (rate, row)) in [(1.0, 5.66), (4.0, 2.83), (8.0, 2.0)].into_iter().enumerate() {
        let [told_rate, told_row, from, to] = numbers(says(&figure, 2 + i))[..] else { panic!("four numbers") };
        assert_eq!([told_rate, told_row], [rate, row]);
        // where the samples are found in step: a run of some samples, with the ghost's row in it
        assert!(from < row && row < to && to - from > 1.5 / rate, "{rate}: {from} to {to}");
    }
    // the pixel row that the ghost of four samples falls into: black where grey is right
    assert!(says(&figure, 5).contains("covers rows 2 to 3"));
    let far = pixels(&figure, "uniform-far", "pixels");
    assert_eq!(far[[2, 24]], 0.0);
}

#[test]
fn f36_exact_area_agrees_with_brute_force_of_1500_squared_samples() {
    let figure = figure("f36-exact-area", &[]);
    let exact = pixels(&figure, "exact", "pixels");
    let board = Checkerboard::lecture(128).expect("it has pixels");
    let left = (128 - exact.ncols()) / 2; // columns that are not shown
    for [i, j] in [[60usize, 32], [64, 9], [90, 12]] {
        let (x, y) = (i as f64, j as f64);
        let grid = Grid::cells(x..x + 1.0, 1500, y..y + 1.0, 1500).expect("the ranges rise");
        near(exact[[j, i - left]], Image::of(&board, grid).mean(), 3e-4);
    }
    // far away it is grey, where uniform samples are black and white
    let contrast = |panel: &str, j: usize| {
        let row = pixels(&figure, panel, "pixels").row(j).mapv(|v| (v - 0.5) * (v - 0.5));
        (row.sum() / row.len() as f64).sqrt()
    };
    for j in [1, 2] {
        assert!(contrast("exact-far", j) < 0.06 && contrast("uniform-far", j) > 0.15, "{j}");
    }
}

#[test]
fn f36_a_box_keeps_0_1093_of_a_tone_at_nine_tenths_of_the_rate() {
    assert!(says(&figure("f36-exact-area", &[]), 4).ends_with("keeps 0.1093"));
}

#[test]
fn f40_jitter_errs_by_0_0262_where_uniform_samples_err_by_0_0395() {
    let figure = figure("f40-jittered", &[]);
    let [measured, expected, uniform] = numbers(says(&figure, 0))[..] else { panic!("three errors") };
    assert_eq!(uniform, 0.0395);
    // the printed 0.0262 is of one seed; one picture deviates by 2 % of its error
    near(measured, 0.0262, 4.0 * 0.02 * 0.0262);
    near(expected, 0.0262, 2.0 * 0.02 * 0.0262);
    let told = numbers(says(&figure, 1));
    let [uniform, jittered] = told[told.len() - 2..] else { panic!("two errors of the far rows") };
    near(uniform, 0.1325, 0.0005);
    near(jittered, 0.0848, 4.0 * 0.02 * 0.0848);
}

#[test]
fn f50_256_rays_are_within_0_0043_of_exact_area() {
    let told = numbers(says(&figure("f50-reference", &[]), 0));
    near(told[1], 0.0043, 0.00025);
}

#[test]
fn f51_one_jittered_ray_errs_more_than_a_regular_one_and_four_less() {
    let figure = figure("f51-one-ray", &[]);
    let [jittered, expected, regular] = numbers(says(&figure, 0))[..] else { panic!("three errors") };
    assert_eq!(regular, 0.1284);
    // the printed 0.1479 is of one seed: one picture deviates by 1 %
    near(expected, 0.1479, 0.0015);
    near(jittered, 0.1479, 4.0 * 0.0015);
    let four = numbers(says(&figure, 2));
    near(four[0], 0.0647, 4.0 * 0.001);
    assert_eq!(four[2], 0.072);
    // the structure: from 13.3 to the level of noise
    assert_eq!(numbers(says(&figure, 3))[0], 13.3);
    let told = numbers(says(&figure, 4));
    assert!((7.3..=9.0).contains(&told[0]), "{told:?}");
}

#[test]
fn f33_weights_that_do_not_add_up_to_one_change_the_brightness() {
    let figure = figure("f33-pixel", &[]);
    let (one, other) = (pixels(&figure, "one", "pixels"), pixels(&figure, "other", "pixels"));
    assert!(one.iter().zip(other).all(|(a, b)| (0.5 * a - b).abs() < 1e-15));
    near(pixels(&figure, "weights", "weights").sum(), 1.0, 1e-14);
}

#[test]
fn f42_frequencies_that_are_known_can_be_faded_out() {
    let figure = figure("f42-application", &[]);
    // a ghost of the rings, as bright as their centre, and nothing there after fading
    assert_eq!(pixels(&figure, "formula-point", "pixels")[[48, 48]], 1.0);
    assert_eq!(pixels(&figure, "formula", "pixels")[[48, 48]], 0.5);
}

#[test]
fn f56_the_bias_of_the_quotient_is_0_08889_by_k() {
    let figure = figure("f56-weights", &[]);
    let theory = points(&figure, "bias", "theory");
    near(3.0 * theory[0][1], 0.08889, 5e-6);
    // 0.0880/K was found at K = 32; here by 8000 films that deviate by 0.4/√(32·8000)
    near(32.0 * value(&points(&figure, "bias", "found"), 32.0), 0.0880, 32.0 * 4.0 * 0.4 / 256_000f64.sqrt());
}

#[test]
fn f58_the_numbers_of_three_filters() {
    let figure = figure("f58-filters", &[]);
    assert_eq!(numbers(says(&figure, 0))[..3], [0.2263, 0.0149, 0.0219]);
    let [.., boxed, gaussian, mitchell] = numbers(says(&figure, 4))[..] else { panic!("three widths") };
    assert!(gaussian > mitchell && mitchell > boxed);
    near(boxed, 0.8, 1e-9); // of the box an edge is a ramp one pixel wide
    let told = numbers(says(&figure, 6));
    assert_eq!(told[1], 3.63);
}

#[test]
fn f58_what_the_filters_do_is_seen_in_their_pictures() {
    let figure = figure("f58-filters", &[]);
    let shown = |name: &str| pixels(&figure, name, "pixels");
    let [boxed, gaussian, mitchell] = ["box", "gaussian", "mitchell"].map(shown);
    // rows 22 to 26, columns 12 to 15 of the detail lie on the plate, a pixel right of the post and above the letters: even,
    // but for what filters bring from the post
    let part = |image: &Array2<f64>, rows: std::ops::Range<usize>, columns: std::ops::Range<usize>| -> Vec<f64> {
        rows.flat_map(|j| columns.clone().map(move |i| image[[j, i]])).collect()
    };
    let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
    let plate = |image: &Array2<f64>| mean(&part(image, 22..26, 12..15));
    assert!(plate(mitchell) > plate(boxed) && plate(boxed) > plate(gaussian));
    // rows 0 to 16, columns 16 to 24: rings beyond Nyquist, grey where nothing is false
    let rough = |image: &Array2<f64>| {
        let rings = part(image, 0..16, 16..24);
        let grey = mean(&rings);
        mean(&rings.iter().map(|v| (v - grey) * (v - grey)).collect::<Vec<_>>())
    };
    assert!(rough(boxed) > rough(mitchell) && rough(mitchell) > rough(gaussian));
}
