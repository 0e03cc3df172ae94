//! The mean.

/// `Σv/n`, with the mean of what is left added once more: exact for constants, and off by about one rounding for others.
///
/// ```
/// use nyquist::num::mean::mean;
/// assert_eq!(mean(&[0.1; 1000]), 0.1);
/// assert_eq!(mean(&[f64::MAX, f64::MAX]), f64::MAX);
/// ```
pub fn mean(values: &[f64]) -> f64 {
    let n = values.len() as f64;
    let first: f64 = values.iter().map(|v| v / n).sum();
    first + values.iter().map(|v| (v - first) / n).sum::<f64>()
}
