//! The numbers that the lecture's inventory prints among its results (V05, V09, V22, V23, V24), asked of the figures'
//! own data.

use crate::asking::{figure, layer, near, points, value};
use nyquist::figure::Mark;
use nyquist::text::Lang;

#[test]
fn the_samples_of_the_chirp_have_the_period_2_and_are_mirrored_about_1() {
    let figure = figure("x-chirp", &[]);
    let samples = points(&figure, "back", "samples");
    for k in 0..=16 {
        near(samples[k + 16][1], samples[k][1], 1e-13);
        near(samples[16 - k][1], samples[k][1], 1e-13);
    }
    assert_eq!(figure.panel("back").and_then(|p| p.layer("mirrors")).map(|l| l.mark.clone()), {
        Some(Mark::Verticals(vec![1.0, 2.0, 3.0]))
    });
}

#[test]
fn the_regularised_series_errs_by_4_2e_4_5_5e_7_and_8_4e_10() {
    let figure = figure("x-truncation", &[]);
    // the inventory's are those of one phase; the worst phase is at most a seventh worse
    for (n, printed) in [(8.0, 4.2e-4), (16.0, 5.5e-7), (24.0, 8.4e-10)] {
        let error = value(&points(&figure, "tone", "fine"), n);
        assert!((0.9 * printed..1.15 * printed).contains(&error), "n = {n}: {error:e}");
        let bound = (-std::f64::consts::PI * 0.5 * n / 2.0).exp();
        assert!(error < bound);
    }
}

#[test]
fn straight_lines_are_off_by_0_096_at_the_origin_of_the_plane_of_cubics() {
    let figure = figure("x-bc-plane", &[]);
    assert!(figure.claims[1].says.get(Lang::En).contains("0.096"));
    let Mark::Raster { values, low, high, .. } = &layer(&figure, "ringing", "map").mark else { panic!("no map") };
    assert_eq!(values.dim(), (28, 28));
    // from nothing to more than the ideal sinc at (0, 1)
    assert!(*low < 0.4 && *high > 14.0);
}

#[test]
fn pairs_of_samples_multiply_noise_by_1_2_and_10_5() {
    let figure = figure("x-papoulis", &[]);
    let measured = points(&figure, "noise", "measured");
    for (a, printed) in [(0.5, 1.0), (0.25, 2.0), (0.1, 10.5)] {
        // 2000 trials, four standard deviations; the record's end takes 1 %
        near(value(&measured, a), printed, 0.14 * printed);
    }
    let restored = |panel: &str| {
        let pairs = points(&figure, panel, "restored").into_iter().zip(points(&figure, panel, "signal"));
        pairs.filter(|(r, s)| (r[0] - s[0]).abs() < 1e-12).map(|(r, s)| (r[1] - s[1]).abs()).fold(0.0, f64::max)
    };
    assert!(restored("slopes") < 1e-6 && restored("pairs") < 1e-6);
}

#[test]
fn the_band_from_21_to_24_is_restored_at_8_2_and_10_and_not_at_9_7_5_and_6_5() {
    let figure = figure("x-bandpass", &[]);
    assert_eq!(points(&figure, "wedges", "works"), [[24.0, 8.2], [24.0, 10.0]]);
    assert_eq!(points(&figure, "wedges", "fails"), [[24.0, 6.5], [24.0, 7.5], [24.0, 9.0]]);
    let error = points(&figure, "error", "error");
    for rate in [8.2, 10.0] {
        assert!(value(&error, rate) < 1e-3);
    }
    // of a signal of height 1.4: 0.77–0.89 of it or more
    for rate in [6.5, 7.5, 9.0] {
        assert!(value(&error, rate) > 0.77);
    }
}

#[test]
fn levinsons_positions_keep_more_than_kadec_promises() {
    let figure = figure("x-irregular", &[]);
    let eigenvalues = points(&figure, "kadec", "eigenvalues");
    let bound = points(&figure, "kadec", "kadec");
    for (deviation, promised) in [(0.1, 0.412), (0.2, 0.049)] {
        near(value(&bound, deviation), promised, 5e-4);
        assert!(value(&eigenvalues, deviation) > promised);
    }
    near(value(&bound, 0.25), 0.0, 1e-15);
    // full-cell jitter of 48 samples: the condition stays near ten up to 0.97 of Nyquist
    let condition = points(&figure, "condition", "jittered");
    assert!(condition.iter().all(|c| c[1] < 20.0));
}
