//! What windowed sinc kernels have in common: a response that is their window's spectrum, averaged over a band.

use crate::kernel::Claims;
use crate::num::quadrature::{even_breaks, integrate_pieces};
use crate::num::sinc;

/// A window keeps the sinc's zeros, and nothing else: the gain is not one, constants ripple, the lobes go below zero.
pub(crate) const CLAIMS: Claims = Claims {
    interpolating: true,
    unit_gain: false,
    reproduces_constants: false,
    reproduces_lines: false,
    nonnegative: false,
};

/// `sinc(t)·w(t)` for `|t| ≤ radius`, half of it at the edge, nothing beyond.
pub(crate) fn value(t: f64, radius: f64, window: impl Fn(f64) -> f64) -> f64 {
    match t.abs().partial_cmp(&radius) {
        Some(std::cmp::Ordering::Less) => sinc(t) * window(t),
        Some(std::cmp::Ordering::Equal) => 0.5 * sinc(t) * window(t),
        Some(std::cmp::Ordering::Greater) => 0.0,
        None => f64::NAN,
    }
}

/// `∫_{ν−½}^{ν+½} W(u) du`: the spectrum `W` of the window, convolved with the unit box that the sinc is in frequency.
///
/// `W` is entire and oscillates with period `1/radius`; a quadrature piece covers at most half of that, so that the
/// 15-point rule is exact to rounding: absolute error below `16ε·∫|W|`.
pub(crate) fn response(nu: f64, radius: f64, spectrum: impl Fn(f64) -> f64) -> f64 {
    if !nu.is_finite() {
        return if nu.is_nan() { nu } else { 0.0 };
    }
    let nu = nu.abs();
    let breaks = even_breaks(nu - 0.5, nu + 0.5, 0.5 / radius.max(0.5));
    integrate_pieces(spectrum, &breaks, 1e-16).value
}
