//! The numbers that the lecture's inventory prints for patterns (F37, F39, F49, F52, F54, V14–V16, V18, V20, V21), asked of
//! the figures' own data.

use crate::asking::{figure, layer, near, points, value};
use nyquist::figure::{Figure, Mark};
use nyquist::text::Lang;

/// What the claim of that number says, in English.
fn says(figure: &Figure, claim: usize) -> &str {
    figure.claims[claim].says.get(Lang::En)
}

#[test]
fn f37_a_grid_of_16_by_16_has_the_power_256_at_the_multiples_of_16_and_none_elsewhere() {
    let figure = figure("f37-plane", &[]);
    assert_eq!(points(&figure, "points", "points").len(), 256);
    let lines = points(&figure, "spectrum", "lines");
    assert_eq!(lines.len(), 25);
    assert!(lines.iter().flatten().all(|f| f % 16.0 == 0.0));
    for [u, power] in points(&figure, "row", "row") {
        near(power, if u % 16.0 == 0.0 { 256.0 } else { 0.0 }, 1e-9);
    }
}

#[test]
fn f39_on_the_axis_jitter_has_0_1894_at_a_quarter_0_5947_at_a_half_and_1_at_one() {
    let figure = figure("f39-plane", &[]);
    let measured = points(&figure, "axis", "measured");
    for (nu, printed) in [(0.25, 0.1894), (0.5, 0.5947), (1.0, 1.0)] {
        // 1500 patterns: five standard errors of exponential numbers
        near(value(&measured, nu), printed, 5.0 * printed / 1500f64.sqrt());
    }
    assert!(says(&figure, 0).ends_with("(theory 0.1894 and 0.5947)"), "{}", says(&figure, 0));
    // the whole plane: 1 − sinc²u·sinc²v at (½, ½), eight cells to the unit, twenty to the edge
    let Mark::Raster { values, .. } = &layer(&figure, "theory", "power").mark else { panic!("tones") };
    let sinc = (2.0 / std::f64::consts::PI).powi(2);
    near(values[[24, 24]], 1.0 - sinc * sinc, 1e-14);
}

#[test]
fn f49_random_points_leave_36_7_percent_of_256_cells_empty_and_the_grid_has_0_06152() {
    let figure = figure("f49-stratified", &[]);
    let empty: f64 = says(&figure, 0).split(' ').nth(3).and_then(|w| w.parse().ok()).expect("a number");
    // (1 − 1/256)²⁵⁶ = 36.72 %; 60 patterns: five times 1.2 %/√60
    near(empty, 36.72, 5.0 * 1.2 / 60f64.sqrt());
    assert!(says(&figure, 2).contains("0.06152"), "{}", says(&figure, 2));
    // D*: random about 0.075, jitter about 0.033
    assert!(says(&figure, 3).contains("0.03") && says(&figure, 3).contains("0.07"), "{}", says(&figure, 3));
    assert!(says(&figure, 4).contains("grid 1/16 = 0.0625"), "{}", says(&figure, 4));
}

#[test]
fn f52_576_associations_are_equally_likely_and_four_samples_stand_for_1024() {
    let figure = figure("f52-groups", &[]);
    let Mark::Raster { values, .. } = &layer(&figure, "pairings", "pairings").mark else { panic!("tones") };
    assert_eq!(values.dim(), (24, 24));
    near(values.sum() / 576.0 * 100_000.0 / 576.0, 100_000.0 / 576.0, 1e-9);
    assert_eq!(value(&points(&figure, "cost", "each"), 4.0), 1024.0);
    assert!(says(&figure, 3).contains("take 1024 samples, in groups 4"), "{}", says(&figure, 3));
}

#[test]
fn v18_star_discrepancies_are_those_of_the_independent_table() {
    let figure = figure("x-discrepancy", &[]);
    // N = 16, 64, 256, 1024: means of several patterns, except for Halton's and Hammersley's
    let table = [
        ("random", [0.284, 0.155, 0.075, 0.038], 0.2),
        ("jittered", [0.204, 0.082, 0.033, 0.014], 0.2),
        ("multi-jittered", [0.139, 0.051, 0.020, 0.0078], 0.2),
        ("n-rooks", [0.161, 0.077, 0.040, 0.024], 0.3),
        ("halton", [0.201, 0.052, 0.0188, 0.0068], 0.0),
        ("hammersley", [0.172, 0.054, 0.0161, 0.0047], 0.0),
    ];
    for (name, printed, chance) in table {
        let found = points(&figure, "growth", name);
        for ([_, measured], printed) in found.into_iter().zip(printed) {
            // one pattern's D* deviates by a fifth and less; half a unit of the last digit printed
            let digit = if printed < 0.02 { 5e-5 } else { 5e-4 };
            near(measured, printed, chance * printed + digit);
        }
    }
    assert!(says(&figure, 0).ends_with("|1/4 − 0.09| = 0.16"), "{}", says(&figure, 0));
}

#[test]
fn v20_the_five_divisions_of_sixteen_points() {
    let figure = figure("x-elementary", &[]);
    assert_eq!(figure.panels.len(), 6);
    let same = points(&figure, "1x16", "points");
    for name in ["2x8", "4x4", "8x2", "16x1"] {
        assert_eq!(points(&figure, name, "points"), same);
    }
}

#[test]
fn v21_the_plateau_of_poisson_disks_is_0_06_and_jitter_starts_at_zero() {
    let figure = figure("x-jitter-poisson", &[]);
    let disks = points(&figure, "radial", "disks");
    // up to 0.35√N: 0.062, 0.063, 0.066; rings of 1.5/16, 80 patterns
    for [nu, power] in disks.iter().filter(|p| p[0] < 0.35) {
        near(*power, 0.063, 5.0 * 0.063 / 320f64.sqrt());
        assert!(*nu > 0.0);
    }
    let jitter = points(&figure, "radial", "jitter");
    assert!(jitter[0][1] < disks[0][1] && jitter[2][1] > disks[2][1]);
    let ring = disks.iter().copied().fold([0.0; 2], |a, b| if b[1] > a[1] { b } else { a });
    assert!((1.0..1.3).contains(&ring[0]) && (1.55..1.85).contains(&ring[1]), "{ring:?}");
}

#[test]
fn v14_and_v16_slopes_and_the_constant_1_7008() {
    let figure = figure("x-convergence", &[]);
    let slope = |claim: usize| -> f64 {
        let says = says(&figure, claim).replace('−', "-");
        says.split("exponent ").nth(1).and_then(|s| s.split(',').next()).and_then(|s| s.parse().ok()).expect("a number")
    };
    // 240, 160 and 100 trials: a relative deviation of √(2/R), over ln 16
    let chance = 4.0 * (2f64 / 100.0).sqrt() / 16f64.ln();
    near(slope(1), -2.0, chance);
    near(slope(2), -1.5, chance);
    near(slope(3), -1.5, chance + 0.15);
    assert!(says(&figure, 4).contains("1.701"), "{}", says(&figure, 4));
}

#[test]
fn the_worst_of_64_jittered_points_has_sixteen_in_a_line() {
    let figure = figure("x-worst-strata", &[]);
    assert_eq!(value(&points(&figure, "jittered-strips", "strips"), 0.5), 16.0);
    assert!(points(&figure, "multi-strips", "strips").iter().all(|p| p[1] <= 2.0));
}
