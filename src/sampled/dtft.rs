//! The discrete-time Fourier transform: the spectrum of samples at any frequency.

use crate::num::{cos_pi, sin_pi};
use crate::sampled::Samples;
use num_complex::Complex;

/// `T Σ_j f(x_j) e^{−2πiνx_j}`: the spectrum of the comb times the signal, at any frequency, by the direct sum in
/// `O(n)`.
///
/// Periodic with the sampling rate (up to the phase of the start). By Poisson summation it equals `Σ_k F(ν − k/T)`:
/// the replicas, with gain 1, up to what the record leaves out.
///
/// ```
/// use nyquist::prelude::*;
/// let gaussian = Gaussian::with_spectrum(8.0)?; // replicas overlap at rate 1
/// let samples = Samples::of(&gaussian, Axis::centered(1.0, 41)?);
/// let replicas = gaussian.spectrum().replicated(1.0, 4)?;
/// assert!((dtft(&samples, 0.5) - replicas.density(0.5)).norm() < 1e-15);
/// # Ok::<(), Error>(())
/// ```
pub fn dtft(samples: &Samples, nu: f64) -> Complex<f64> {
    let axis = samples.axis();
    let sum: Complex<f64> = samples
        .points()
        .map(|[x, v]| {
            let turns = 2.0 * nu * x;
            Complex::new(v * cos_pi(turns), -v * sin_pi(turns))
        })
        .sum();
    sum * axis.step()
}
