//! The numbers that the lecture's formal part must show, asked of its figures at their defaults: each to half a unit of
//! the last printed digit.

use nyquist::figure::common::peak;
use nyquist::figure::{Figure, Layer, Mark, catalog};
use nyquist::signal::lecture::SPIKES;
use nyquist::text::Lang;

fn figure(id: &str) -> Figure {
    catalog::by_name(id).and_then(|entry| entry.figure()).expect("a figure of the catalogue")
}

fn layer<'a>(figure: &'a Figure, panel: &str, layer: &str) -> &'a Layer {
    figure.panel(panel).and_then(|p| p.layer(layer)).expect("a layer of the figure")
}

/// Whether `value` is what `printed` says, to half a unit of its last digit (and rounding).
fn is(value: f64, printed: &str) -> bool {
    let decimals = printed.split_once('.').map_or(0, |(_, d)| d.len());
    let expected: f64 = printed.parse().expect("a number");
    (value - expected).abs() <= 0.5 * 10f64.powi(-(decimals as i32)) * (1.0 + 1e-9)
}

/// All numbers in the sentences of a figure's claims.
fn claimed(figure: &Figure) -> Vec<f64> {
    let sentence = |says: &str| {
        let kept: String =
            says.replace('−', "-").chars().map(|c| if "0123456789.-".contains(c) { c } else { ' ' }).collect();
        kept.split_whitespace().filter_map(|word| word.trim_end_matches('.').parse().ok()).collect::<Vec<f64>>()
    };
    figure.claims.iter().flat_map(|claim| sentence(claim.says.get(Lang::En))).collect()
}

fn claims_number(id: &str, printed: &str) {
    let numbers = claimed(&figure(id));
    assert!(numbers.iter().any(|n| is(*n, printed)), "{id}: {printed} is not among {numbers:?}");
}

#[test]
fn f06_and_f14_show_the_heights_measured_in_the_source() {
    for (id, panel, name) in [("f06-sampling", "sampled", "samples"), ("f14-comb", "product", "weights")] {
        let figure = figure(id);
        let points = layer(&figure, panel, name).points();
        assert_eq!(points.len(), SPIKES.len());
        for ((i, point), height) in points.iter().enumerate().zip(SPIKES) {
            assert!((point[0] - i as f64).abs() < 1e-15 && (point[1] - height).abs() < 1e-15, "{id}: {point:?}");
        }
    }
}

/// Where the drawn curve turns, and the value there relative to the peak.
fn turns(figure: &Figure, panel: &str) -> Vec<(f64, f64)> {
    let Mark::Verticals(places) = &layer(figure, panel, "extrema").mark else { panic!("the extrema are verticals") };
    let curve = layer(figure, panel, "closed");
    let nearest = |x: f64| {
        let near = |p: &&[f64; 2]| (p[0] - x).abs();
        curve.points().iter().min_by(|a, b| near(a).total_cmp(&near(b))).expect("the curve has points")[1]
    };
    places.iter().map(|&x| (x, nearest(x) / peak(curve))).collect()
}

#[test]
fn f09_has_the_peaks_zeros_and_extrema_of_the_source() {
    let figure = figure("f09-functions");
    let printed = [("1.43688", "-0.6456"), ("2.73229", "0.1991"), ("3.81104", "-0.1035")];
    for ((x, value), (place, height)) in turns(&figure, "low").into_iter().zip(printed) {
        assert!(is(x, place) && is(value, height), "{x} {value}, printed {place} {height}");
    }
    let printed = [("0.560", "-0.194"), ("0.954", "0.096"), ("1.333", "-0.056")];
    for ((x, value), (place, height)) in turns(&figure, "high").into_iter().zip(printed) {
        assert!(is(x, place) && is(value, height), "{x} {value}, printed {place} {height}");
    }
    for printed in ["0.79614", "2.5142", "0.53333"] {
        claims_number("f09-functions", printed);
    }
}

#[test]
fn f10_ends_at_one_half_and_the_root_of_two() {
    let figure = figure("f10-spectra");
    for (panel, band) in [("low", 0.5), ("high", 2f64.sqrt())] {
        let closed = layer(&figure, panel, "closed").points();
        assert!(closed.iter().all(|p| (p[1] > 0.0) == (p[0].abs() < band && (panel == "high" || p[0] != 0.0))));
    }
    claims_number("f10-spectra", "0.3536");
}

#[test]
fn f11_has_the_peaks_and_errors_of_the_partial_sums() {
    let series = figure("f11-series");
    let drawn = ["wave 1", "wave 2", "wave 3", "wave 4"].map(|panel| peak(layer(&series, panel, "sum")));
    for (value, printed) in drawn.into_iter().zip(["1.273240", "1.200422", "1.188357", "1.180284"]) {
        assert!(is(value, printed), "{value}, printed {printed}");
    }
    for printed in ["0.18943", "0.09937", "0.06694", "0.02530", "8.949"] {
        claims_number("f11-series", printed);
    }
    claims_number("f11-literal", "5.818");
}

#[test]
fn f13_has_the_lobes_and_lines_of_the_table() {
    for printed in ["0.6366", "-13.26", "1.430", "0.159155"] {
        claims_number("f13-pairs", printed);
    }
    let table = figure("f13-pairs");
    let lines = layer(&table, "cosine lines", "lines").points();
    assert!(lines.len() == 2 && lines.iter().all(|l| is(l[0].abs(), "0.159155") && l[1] == 0.5));
    let comb = layer(&table, "comb lines", "lines").points();
    assert!(comb.iter().enumerate().all(|(i, l)| l[0] == 0.5 * (i as f64 - 5.0) && l[1] == 1.0));
    // windows of width L: peaks of height L, of a cosine L/2
    let limits = figure("f13-limits");
    for (panel, share) in [("constant", 1.0), ("cosine", 0.5), ("comb", 1.0)] {
        let heights: Vec<f64> =
            limits.panel(panel).expect("a panel").layers.iter().map(|l| (peak(l) / share).round()).collect();
        assert_eq!(heights, [10.0, 20.0, 40.0], "{panel}");
    }
}

#[test]
fn f14_adds_up_to_the_integral() {
    let figure = figure("f14-weights");
    let sums = layer(&figure, "sum", "measured").points();
    let fast = sums.iter().filter(|p| p[0] > 1.0);
    assert!(fast.count() > 20 && sums.iter().filter(|p| p[0] > 1.0).all(|p| is(p[1], "1.000000")));
    // at 1/T = ½ the copies at ±1 add F(±½) = ½ each, those at ±2 nothing
    let slow = sums.iter().find(|p| (p[0] - 0.5).abs() < 1e-9).expect("the rate ½ is drawn");
    assert!(is(slow[1], "2.000000"), "{slow:?}");
}

#[test]
fn f19_and_f20_have_copies_of_gain_one_a_rate_apart() {
    let replicas = figure("f19-replicas");
    for name in ["copies", "dtft", "fft"] {
        assert!(is(peak(layer(&replicas, name, name)), "1.000000"), "{name}");
    }
    for printed in ["2.000", "1.000", "0.6667", "0.5000"] {
        claims_number("f20-closer", printed);
    }
}

#[test]
fn f21_errs_by_the_tail_of_the_neighbour() {
    let figure = figure("f21-low-pass");
    let (product, truth) = (layer(&figure, "product", "product"), layer(&figure, "product", "spectrum"));
    let error = nyquist::figure::common::difference(product, truth);
    // the tail of the next copy at the edge of the box, e^{−12.5}; off the edge it is less
    assert!(error <= (-12.5f64).exp() * (1.0 + 1e-9) && error > 0.5 * (-12.5f64).exp(), "{error}");
    let claim = figure.claims[0].says.get(Lang::En);
    assert!(claim.contains("3.7·10^{−6}") || claim.contains("0.0000037"), "{claim}");
}
