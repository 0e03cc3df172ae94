//! The numbers that the lecture's inventory prints for pictures and their spectra (F43–F46, V26, V27, E13), asked of the
//! figures' own data.

use crate::asking::{figure, layer, near, points, value};
use nyquist::figure::{Figure, Mark};
use nyquist::text::Lang;

/// Where a spectrum that is shown is within half a decibel of its largest bin: `[k, l]`, rising.
fn peaks(figure: &Figure, panel: &str) -> Vec<[i64; 2]> {
    let Mark::Raster { values, .. } = &layer(figure, panel, "spectrum").mark else { panic!("no spectrum") };
    let reach = (values.ncols() / 2) as i64;
    let found = values.indexed_iter().filter(|(_, v)| **v > -0.5);
    let mut found: Vec<[i64; 2]> = found.map(|((l, k), _)| [k as i64 - reach, l as i64 - reach]).collect();
    found.sort_unstable();
    found
}

#[test]
fn a_sine_of_32_pixels_is_the_bins_4_and_minus_4_of_half_the_pixels() {
    let figure = figure("f43-spatial-and-frequency", &[]);
    assert_eq!(peaks(&figure, "constant-spectrum"), [[0, 0]]);
    assert_eq!(peaks(&figure, "sine-spectrum"), [[-4, 0], [4, 0]]);
    for [k, size] in points(&figure, "sine-row", "bins") {
        near(size, if k.abs() == 4.0 { 0.5 } else { 0.0 }, 1e-13); // in units of N²
    }
}

#[test]
fn a_product_of_two_waves_has_four_peaks_of_a_quarter() {
    let figure = figure("f44-waves", &[]);
    assert_eq!(peaks(&figure, "across-spectrum"), [[-8, 0], [8, 0]]);
    assert_eq!(peaks(&figure, "up-spectrum"), [[0, -8], [0, 8]]);
    assert_eq!(peaks(&figure, "product-spectrum"), [[-4, -8], [-4, 8], [4, -8], [4, 8]]);
    assert!(figure.claims[2].says.get(Lang::En).ends_with("four peaks at (±4, ±8), N²/4 = 4096"));
}

#[test]
fn the_spectrum_of_the_spot_of_16_pixels_falls_to_0_85709_in_one_bin() {
    let figure = figure("f45-gaussians", &[]);
    near(value(&points(&figure, "narrow-row", "bins"), 1.0), 0.85709, 5e-6);
    // twice as wide, half as wide
    near(value(&points(&figure, "wide-row", "bins"), 1.0), value(&points(&figure, "narrow-row", "bins"), 2.0), 1e-13);
}

#[test]
fn the_spectrum_of_an_elongated_spot_stands_upright_and_turns_by_45_degrees() {
    let figure = figure("f46-turned", &[]);
    let farthest = |layer: &str| {
        let points = points(&figure, "spectrum-contours", layer);
        let far = points.into_iter().max_by(|a, b| a[0].hypot(a[1]).total_cmp(&b[0].hypot(b[1])));
        far.map(|[u, v]| v.atan2(u).to_degrees().rem_euclid(180.0)).expect("the ellipse has points")
    };
    // one of 120 places on the ellipse, which stands on the end of its axis
    near(farthest("along"), 90.0, 1e-3);
    near(farthest("turned"), 135.0, 1e-3);
    assert!(figure.claims[1].says.get(Lang::En).contains("in frequency 2 times"));
}

#[test]
fn the_hexagonal_lattice_needs_0_8660_of_the_samples() {
    let figure = figure("x-hexagonal", &[]);
    assert!(figure.claims[0].says.get(Lang::En).contains("4 neighbours, 2·B away"));
    assert!(figure.claims[1].says.get(Lang::En).contains("6 neighbours, 2·B away"));
    assert!(figure.claims[2].says.get(Lang::En).contains("0.866"));
}

#[test]
fn exact_area_leaves_sinc_of_the_ghosts() {
    let figure = figure("x-area-ghosts", &[]);
    let measured = |name: &str, nu: f64| {
        let dots = points(&figure, "contrast", name);
        let nearest = dots.into_iter().min_by(|a, b| (a[0] - nu).abs().total_cmp(&(b[0] - nu).abs()));
        nearest.expect("there are dots")
    };
    for nu in [0.5, 0.9, 1.43] {
        let [at, held] = measured("area", nu);
        near(held, nyquist::num::sinc(at), 0.02);
        near(measured("point", nu)[1], 1.0, 1e-12);
    }
    // −0.2172 at the bottom of the first side lobe
    near(measured("area", 1.43)[1], -0.2172, 0.01);
    assert!(measured("lanczos", 0.9)[1].abs() < 0.02);
}

#[test]
fn the_wide_sinc_removes_postaliasing_and_keeps_the_false_rings() {
    let figure = figure("x-zone-plate", &[]);
    let gain = |name: &str, nu: f64| {
        let Some(panel) = figure.panel("gain") else { panic!("no gains") };
        let curve = panel.layer(name).expect("the kernel is there").points();
        curve.iter().min_by(|a, b| (a[0] - nu).abs().total_cmp(&(b[0] - nu).abs())).expect("a curve has points")[1]
    };
    // K(½) of the table of metrics; four places a sample add what they fold: up to 4 %
    for (name, printed) in [("box", std::f64::consts::FRAC_2_PI), ("tent", 0.4053), ("mitchell", 0.3833)] {
        near(gain(name, 0.5), printed, 0.04 * printed);
    }
    assert!(gain("kaiser", 0.4) > 0.99 && gain("kaiser", 0.6).abs() < 1e-3);
}

#[test]
fn the_copies_of_the_plane_are_1_over_t_apart_in_both_directions() {
    let figure = figure("x-plane-copies", &[]);
    let apart = [("second", 60), ("fourth", 30), ("sixth", 20)];
    for (name, bins) in apart {
        let found = peaks(&figure, &format!("{name}-spectrum"));
        let all = found.iter().flatten().all(|k| k % bins == 0);
        let along = (-59..60).filter(|k| k % bins == 0).count();
        assert!(all && found.len() == along * along, "{name}: {found:?}");
    }
}

#[test]
fn the_three_references_are_checked() {
    let figure = figure("f59-references", &[]);
    assert_eq!(value(&points(&figure, "hypergraph", "found"), 0.0), 1.0);
    near(value(&points(&figure, "hypergraph", "found"), 0.5), 0.0, 1e-12);
    near(value(&points(&figure, "cs148", "bins"), 4.0), 0.5, 1e-13);
    near(value(&points(&figure, "cs348b", "theory"), 0.5), 0.5947, 5e-5);
}
