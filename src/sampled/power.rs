//! Power spectra of samples.

use crate::sampled::dft::forward;
use crate::sampled::window::Window;
use crate::sampled::{Bins, Samples};

/// The energy density per length of the record, `P(ν_k) = |F(ν_k)|²/span`: power per unit of frequency.
///
/// Its sum times the bin width is the mean square of the samples (Parseval).
///
/// ```
/// use nyquist::prelude::*;
/// let samples = Samples::of(&Cosine::new(3.0)?, Axis::nodes(0.0..2.0, 32)?);
/// let total: f64 = power(&forward(&samples)).iter().map(|[_, p]| p * 0.5).sum();
/// assert!((total - 0.5).abs() < 1e-14); // the power of a cosine
/// # Ok::<(), Error>(())
/// ```
pub fn power(bins: &Bins) -> Vec<[f64; 2]> {
    let span = bins.space().span();
    bins.axis().iter().zip(bins.values()).map(|(nu, v)| [nu, v.norm_sqr() / span]).collect()
}

/// [`power`] of the samples under a window, divided by the window's mean square, so that the power of noise is kept
/// whatever the window.
///
/// A window trades the width of a line for the height of its side lobes: without one (rectangular) the side lobes of a
/// tone between two bins fall only like `1/Δν²`.
///
/// ```
/// use nyquist::prelude::*;
/// // half-way between two bins, far from the tone: the Hann window leaks far less
/// let samples = Samples::of(&Cosine::new(10.25)?, Axis::nodes(0.0..2.0, 256)?);
/// let far = |w: Window| periodogram(&samples, w)[128 + 80][1];
/// assert!(far(Window::Hann) < 1e-4 * far(Window::Rectangular));
/// # Ok::<(), Error>(())
/// ```
pub fn periodogram(samples: &Samples, window: Window) -> Vec<[f64; 2]> {
    let n = samples.values().len();
    let weights = window.values(n);
    let mean_square = weights.iter().map(|w| w * w).sum::<f64>() / n as f64;
    let windowed = samples.values().iter().zip(&weights).map(|(v, w)| v * w).collect();
    let spectrum = forward(&Samples::trusted(samples.axis(), windowed));
    power(&spectrum).into_iter().map(|[nu, p]| [nu, p / mean_square]).collect()
}
