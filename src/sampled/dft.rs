//! The discrete Fourier transform in physical units.

use crate::axis::Axis;
use crate::error::{Error, Result};
use crate::num::{cos_pi, sin_pi};
use crate::sampled::plan::{Plan, RealPlan};
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
/// `O(n log n)`. The transform is the scalar one, so that every processor gives the same bits.
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
    let n = samples.values().len();
    let mut spectrum = real_dft(samples.values());
    to_physical(samples.axis(), &mut spectrum);
    spectrum.rotate_right(n / 2);
    Bins::trusted(samples.axis(), spectrum)
}

/// [`forward`] for complex values on an axis.
///
/// # Errors
/// A number of values other than the axis has positions; values that are not finite.
pub fn forward_complex(space: Axis, values: &[Complex<f64>]) -> Result<Bins> {
    let checked = Bins::new(space, values.to_vec())?;
    let mut spectrum = checked.into_values();
    Plan::forward(spectrum.len()).run(&mut spectrum);
    to_physical(space, &mut spectrum);
    spectrum.rotate_right(space.len() / 2);
    Ok(Bins::trusted(space, spectrum))
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
    let space = bins.space();
    let n = space.len();
    let mut values = bins.values().to_vec();
    values.rotate_left(n / 2);
    let gain = 1.0 / space.span();
    for (k, value) in signed(n).zip(values.iter_mut()) {
        *value *= phase(k, space).conj() * gain;
    }
    Plan::inverse(n).run(&mut values);
    values
}

/// The plain sum `X_k = Σ_j x_j e^{−2πijk/n}`, `0 ≤ k < n`, of real values: no unit, no phase, no order.
///
/// # Errors
/// No values, or values that are not finite.
pub fn dft(values: &[f64]) -> Result<Vec<Complex<f64>>> {
    crate::error::all_finite("values to transform", values).map(real_dft)
}

/// The plain sum with the positive exponent, divided by `n`: the inverse of [`dft`], real part.
///
/// # Errors
/// No values.
pub fn inverse_dft(spectrum: &[Complex<f64>]) -> Result<Vec<f64>> {
    let n = spectrum.len();
    if n == 0 {
        return Err(Error::TooFew { what: "values to transform", least: 1, got: 0 });
    }
    let mut values = spectrum.to_vec();
    Plan::inverse(n).run(&mut values);
    Ok(values.into_iter().map(|v| v.re / n as f64).collect())
}

/// Real values: an even number at half the cost, and the other half of the spectrum by its symmetry.
fn real_dft(values: &[f64]) -> Vec<Complex<f64>> {
    let n = values.len();
    if n % 2 == 1 {
        let mut full: Vec<Complex<f64>> = values.iter().map(|&v| v.into()).collect();
        Plan::forward(n).run(&mut full);
        return full;
    }
    let mut full = vec![Complex::ZERO; n];
    RealPlan::forward(n).transform(values, &mut full[..=n / 2], &mut Vec::new());
    for k in 0..=n / 2 {
        full[(n - k) % n] = full[k].conj();
    }
    full
}

/// `T·e^{−2πiν_k·start}` on every value, in the plain order.
fn to_physical(space: Axis, spectrum: &mut [Complex<f64>]) {
    for (k, value) in signed(spectrum.len()).zip(spectrum.iter_mut()) {
        *value *= phase(k, space) * space.step();
    }
}

/// The signed indices `0, 1, …, −2, −1` of the plain order, with `−n/2` for even `n`.
pub(crate) fn signed(n: usize) -> impl Iterator<Item = i64> {
    let (n, least) = (n as i64, -(n as i64 / 2));
    (0..n).map(move |k| if k - n >= least { k - n } else { k })
}

/// `e^{−2πiν_k·start}`; the turns are reduced before they are multiplied by π.
pub(crate) fn phase(k: i64, space: Axis) -> Complex<f64> {
    let turns = 2.0 * k as f64 * (space.start() / space.span());
    Complex::new(cos_pi(turns), -sin_pi(turns))
}
