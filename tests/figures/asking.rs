//! Asking figures for their data.

#![allow(dead_code, reason = "every test uses a part of this")]

use nyquist::figure::catalog::by_name;
use nyquist::figure::params::Params;
use nyquist::figure::{Figure, Layer};

/// The figure of that id with these parameters.
pub(crate) fn figure(id: &str, set: &[(&str, &str)]) -> Figure {
    let entry = by_name(id).expect("the figure exists");
    let params = Params::with(entry.params, set.iter().copied()).expect("the parameters are declared");
    (entry.build)(&params).expect("the figure can be computed")
}

/// The layer of that name in the panel of that name.
pub(crate) fn layer<'a>(figure: &'a Figure, panel: &str, layer: &str) -> &'a Layer {
    figure.panel(panel).expect("the panel exists").layer(layer).expect("the layer exists")
}

/// Its points.
pub(crate) fn points(figure: &Figure, panel: &str, name: &str) -> Vec<[f64; 2]> {
    layer(figure, panel, name).points().to_vec()
}

/// The value at the point nearest to `x`, which must be there.
pub(crate) fn value(points: &[[f64; 2]], x: f64) -> f64 {
    points.iter().find(|p| (p[0] - x).abs() < 1e-9).unwrap_or_else(|| panic!("no point at {x}"))[1]
}

/// `value` is within `bound` of `expected`.
#[track_caller]
pub(crate) fn near(value: f64, expected: f64, bound: f64) {
    assert!((value - expected).abs() <= bound, "{value} is not within {bound} of {expected}");
}
