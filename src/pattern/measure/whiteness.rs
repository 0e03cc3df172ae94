//! Is it noise, or is there structure in it?

use crate::error::{Result, all_finite, positive, within};

/// The greatest of the powers divided by their mean: about `ln M` for `M` bins of white noise, and more where power is
/// gathered in lines (V32).
///
/// # Errors
/// No powers, powers that are not finite, or a mean that is not positive.
pub fn peak_to_mean(powers: &[f64]) -> Result<f64> {
    let sum: f64 = all_finite("powers", powers)?.iter().sum();
    let mean = positive("the mean of powers", sum / powers.len() as f64)?;
    Ok(powers.iter().copied().fold(f64::NEG_INFINITY, f64::max) / mean)
}

/// The peak that white noise in `bins` independent bins does not exceed with probability `p`, in units of the mean.
///
/// Powers of white noise are exponentially distributed, so that the greatest of `M` stays below `x` with probability
/// `(1 − e^{−x})^M`: the quantile is `−ln(1 − p^{1/M})`. The most probable peak is `ln M`, the median `ln M + 0.37`, the
/// mean `ln M + 0.58` (Gumbel 1935).
///
/// ```
/// use nyquist::pattern::measure::whiteness::white_peak;
/// assert!((white_peak(1536, (-1f64).exp())? - 1536f64.ln()).abs() < 1e-3); // 7.34
/// assert!(white_peak(1536, 0.999)? < 14.3);
/// # Ok::<(), nyquist::error::Error>(())
/// ```
///
/// # Errors
/// No bins; a probability outside `10⁻¹² ..= 1 − 10⁻¹²`.
pub fn white_peak(bins: usize, p: f64) -> Result<f64> {
    positive("the number of bins", bins as f64)?;
    within("a probability", p, 1e-12, 1.0 - 1e-12)?;
    Ok(-(-(p.ln() / bins as f64).exp_m1()).ln())
}
