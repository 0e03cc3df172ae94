//! The discrete Fourier transform in physical units.

use crate::axis::Axis;
use crate::engine::fft::{Butterflies, Fft, PhysicalFft, PhysicalRealFft, RealFft};
use crate::error::Result;
use crate::sampled::{Bins, Samples};
use num_complex::Complex;

/// `F(ν_k) = T Σ_j f(x_j) e^{−2πiν_k x_j}` at the frequencies of the dual axis: the left arrow of the square.
///
/// Samples of the continuous transform of `f`, up to aliasing: the step `T` stands in front, the phase knows where the
/// record starts, and the frequencies rise with zero at index `n/2`. By Poisson summation the result is
/// `Σ_k F(ν − k/T)`, smeared by the record's length: exact to rounding for signals that are band-limited below half the
/// rate and have decayed at both ends. The values at `±ν` are conjugates, since samples are real.
///
/// An even number of samples is transformed as half as many complex ones (half the cost); any length works, in
/// `O(n log n)`; a large one uses all threads. The transform is the scalar one, so that every processor gives the same
/// bits; [`PhysicalRealFft`] of the engine is planned once for many records, and as fast as the processor can.
///
/// ```
/// use nyquist::prelude::*;
/// // a Gaussian that is not centred, on a record that does not start at zero
/// let f = Shifted::new(3.0, Gaussian::new(1.0)?)?;
/// let bins = forward(&Samples::of(&f, Axis::nodes(-4.0..10.0, 91)?));
/// let worst = bins.axis().iter().zip(bins.values()).map(|(nu, v)| (v - f.spectrum().density(nu)).norm());
/// assert!(worst.fold(0.0, f64::max) < 1e-14);
/// # Ok::<(), Error>(())
/// ```
pub fn forward(samples: &Samples) -> Bins {
    let (axis, n) = (samples.axis(), samples.values().len());
    // the half goes where it belongs, and its mirror image before it
    let mut values = vec![Complex::ZERO; n / 2 + n / 2 + 1];
    let plan = PhysicalRealFft::with(axis, Butterflies::Scalar);
    plan.forward(samples.values(), &mut values[n / 2..]).expect(POSITIONS);
    for k in 1..=n / 2 {
        values[n / 2 - k] = values[n / 2 + k].conj();
    }
    values.truncate(n);
    Bins::trusted(axis, values)
}

const POSITIONS: &str = "there are as many values as positions, and at least one";

/// [`forward`] for complex values on an axis.
///
/// # Errors
/// A number of values other than the axis has positions; values that are not finite.
pub fn forward_complex(space: Axis, values: &[Complex<f64>]) -> Result<Bins> {
    let mut bins = Bins::new(space, values.to_vec())?.into_values();
    PhysicalFft::with(space, Butterflies::Scalar).forward(values, &mut bins)?;
    Ok(Bins::trusted(space, bins))
}

/// `f(x_j) = (1/span) Σ_k F(ν_k) e^{2πiν_k x_j}`: the samples back from their bins, real part.
///
/// `inverse(forward(s))` is `s` to rounding. Of bins that are not the spectrum of a real signal (not Hermitian) this
/// is the real part; [`inverse_complex`] gives both.
///
/// ```
/// use nyquist::prelude::*;
/// let samples = Samples::new(Axis::nodes(-1.0..2.0, 5)?, vec![3.0, -1.0, 4.0, 1.0, -5.0])?;
/// let back = inverse(&forward(&samples));
/// assert!(samples.values().iter().zip(back.values()).all(|(a, b)| (a - b).abs() < 1e-14));
/// # Ok::<(), Error>(())
/// ```
pub fn inverse(bins: &Bins) -> Samples {
    let values = inverse_complex(bins).into_iter().map(|v| v.re).collect();
    Samples::trusted(bins.space(), values)
}

/// [`inverse`] without dropping the imaginary part.
pub fn inverse_complex(bins: &Bins) -> Vec<Complex<f64>> {
    let mut values = vec![Complex::ZERO; bins.values().len()];
    PhysicalFft::with(bins.space(), Butterflies::Scalar).inverse(bins.values(), &mut values).expect(POSITIONS);
    values
}

/// The plain sum `X_k = Σ_j x_j e^{−2πijk/n}`, `0 ≤ k < n`, of real values: no unit, no phase, no order.
///
/// # Errors
/// No values, or values that are not finite.
pub fn dft(values: &[f64]) -> Result<Vec<Complex<f64>>> {
    crate::error::all_finite("values to transform", values).and_then(real_dft)
}

/// The plain sum with the positive exponent, divided by `n`: the inverse of [`dft`], real part.
///
/// # Errors
/// No values.
pub fn inverse_dft(spectrum: &[Complex<f64>]) -> Result<Vec<f64>> {
    let n = spectrum.len();
    let mut values = vec![Complex::ZERO; n];
    Fft::with(n, Butterflies::Scalar)?.inverse(spectrum, &mut values)?;
    Ok(values.into_iter().map(|v| v.re / n as f64).collect())
}

/// The half of the spectrum, and the other half by its symmetry.
fn real_dft(values: &[f64]) -> Result<Vec<Complex<f64>>> {
    let n = values.len();
    let mut full = vec![Complex::ZERO; n.max(n / 2 + 1)];
    RealFft::with(n, Butterflies::Scalar)?.forward(values, &mut full[..=n / 2])?;
    for k in 1..n.div_ceil(2) {
        full[n - k] = full[k].conj();
    }
    Ok(full)
}
