//! What a kernel does to a signal, in six numbers: how much it blurs, lets alias through, ripples and rings.
//!
//! Kernels are compared as a film uses them, divided by their gain `K(0) = ∫ k`; so are the numbers below. After Marschner
//! & Lobb, *An evaluation of reconstruction filters for volume rendering*, Visualization 1994; Mitchell & Netravali 1988.

use crate::kernel::Kernel;
use crate::num::extremum::maximum;
use crate::num::quadrature::{even_breaks, integrate_pieces};

/// The six numbers of a kernel.
///
/// ```
/// use nyquist::prelude::*;
/// use nyquist::kernel::metrics::Metrics;
/// let (mitchell, catmull_rom) = (Metrics::of(&Cubic::mitchell()), Metrics::of(&Cubic::catmull_rom()));
/// assert!(mitchell.smoothing > catmull_rom.smoothing && mitchell.overshoot < catmull_rom.overshoot);
/// assert!((mitchell.overshoot - 0.0363).abs() < 5e-5);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Metrics {
    /// [`smoothing`], `S`.
    pub smoothing: f64,
    /// [`postaliasing`], `P`.
    pub postaliasing: f64,
    /// `K(½)/K(0)`: what is left of a tone at Nyquist.
    pub at_nyquist: f64,
    /// `K(1)/K(0)`: how much of the first image of a constant comes through; the ripple is about twice that.
    pub at_rate: f64,
    /// [`dc_ripple`].
    pub dc_ripple: f64,
    /// [`overshoot`].
    pub overshoot: f64,
}

impl Metrics {
    /// All six.
    pub fn of(kernel: &(impl Kernel + ?Sized)) -> Self {
        let gain = kernel.response(0.0);
        Self {
            smoothing: smoothing(kernel),
            postaliasing: postaliasing(kernel),
            at_nyquist: kernel.response(0.5) / gain,
            at_rate: kernel.response(1.0) / gain,
            dc_ripple: dc_ripple(kernel),
            overshoot: overshoot(kernel),
        }
    }
}

/// Quadrature breaks on `[0, radius]`, on every kink of the kernels of this library: they stand at halves of the radius.
fn breaks(kernel: &(impl Kernel + ?Sized)) -> Vec<f64> {
    let radius = kernel.radius();
    even_breaks(0.0, radius, radius / (2.0 * radius.ceil()))
}

/// `∫_{−½}^{½} K² / K(0)²`, at most one.
fn pass_band(kernel: &(impl Kernel + ?Sized)) -> f64 {
    let gain = kernel.response(0.0);
    // the ideal response has its jump at ½ itself, a single point
    let inside = integrate_pieces(|nu| kernel.response(nu).powi(2), &even_breaks(0.0, 0.5, 0.125), 1e-13);
    2.0 * inside.value / (gain * gain)
}

/// `S = 1 − ∫_{|ν|<½} K²/K(0)²`: the part of a white signal's energy below Nyquist that the kernel takes away. Zero for the
/// ideal kernel. By quadrature, to 1e-13.
pub fn smoothing(kernel: &(impl Kernel + ?Sized)) -> f64 {
    1.0 - pass_band(kernel)
}

/// `P = ∫_{|ν|>½} K²/K(0)²`: the energy that its images leave in the reconstruction. Zero for the ideal kernel.
///
/// By Parseval's theorem it is `∫ k² − ∫_{|ν|<½} K²`, both by quadrature to 1e-13. A kernel of infinite radius is taken to
/// be band-limited to `|ν| ≤ 8`, and integrated there.
pub fn postaliasing(kernel: &(impl Kernel + ?Sized)) -> f64 {
    let gain = kernel.response(0.0);
    if kernel.radius().is_infinite() {
        let beyond = integrate_pieces(|nu| kernel.response(nu).powi(2), &even_breaks(0.5, 8.0, 0.25), 1e-13);
        // the first break is Nyquist itself, which the quadrature does not look at
        return 2.0 * beyond.value / (gain * gain);
    }
    let energy = 2.0 * integrate_pieces(|t| kernel.at(t).powi(2), &breaks(kernel), 1e-13).value;
    energy / (gain * gain) - pass_band(kernel)
}

/// `max_x |Σ_i k(x−i)/K(0) − 1|`: how far the reconstruction of a constant strays from its mean.
///
/// Looked for at 64 places of a period and refined between them; zero, up to rounding, exactly for the kernels that
/// reproduce constants.
pub fn dc_ripple(kernel: &(impl Kernel + ?Sized)) -> f64 {
    let gain = kernel.response(0.0);
    maximum(|x| (kernel.periodic(x, 1) / gain - 1.0).abs(), 0.0, 0.5, 32).value
}

/// The overshoot of a sampled unit step, `max_x s(x)/p(x) − 1` with `s(x) = Σ_{i≥0} k(x−i)` divided by the sum of all
/// weights `p(x) = Σ_i k(x−i)`, as a film divides: zero for nonnegative kernels, 0.1411 for the ideal one.
///
/// The undershoot before the step is the same, because kernels are even. Looked for within the radius, but not beyond 8
/// steps, at 64 places a step, and refined between them.
pub fn overshoot(kernel: &(impl Kernel + ?Sized)) -> f64 {
    let reach = (kernel.radius() + 1.0).min(8.0);
    let places = (64.0 * (reach + 1.0)).ceil() as usize;
    let weighted = |x: f64| kernel.step_response(x) / kernel.periodic(x, 1);
    (maximum(weighted, -1.0, reach, places).value - 1.0).max(0.0)
}
