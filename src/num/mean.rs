//! The mean.

/// `Σv/n = m`, with the mean of what is left added once more: exact for constants, and for others off by at most about
/// `ε(Σ|v − m|/n + ½|m|)`, the roundings of the differences, of their quotients and of the result.
///
/// ```
/// use nyquist::num::mean::mean;
/// assert_eq!(mean(&[0.1; 1000]), 0.1);
/// assert_eq!(mean(&[f64::MAX, f64::MAX]), f64::MAX);
/// // a click among zeros
/// let mut click = vec![0.0; 100_003];
/// click[50_001] = 1.0;
/// assert!((mean(&click) * 100_003.0 - 1.0).abs() <= f64::EPSILON);
/// ```
pub fn mean(values: &[f64]) -> f64 {
    let n = values.len() as f64;
    let first = sum(values.iter().map(|v| v / n));
    first + sum(values.iter().map(|v| (v - first) / n))
}

/// `Σwv/Σw`, with that of what is left added once more, so that of a loud constant at most a rounding stays; plain sums,
/// whose rounding is that of a transform of as many values.
pub(crate) fn weighted_mean(values: &[f64], weights: &[f64]) -> f64 {
    let pairs = || values.iter().zip(weights);
    let (sum, weight) = pairs().fold((0.0f64, 0.0f64), |(sum, weight), (v, w)| (sum + v * w, weight + w));
    let first = sum / weight;
    first + pairs().map(|(v, w)| (v - first) * w).sum::<f64>() / weight
}

/// A sum that loses nothing but the roundings of its terms: what each addition drops is added at the end (Neumaier 1974).
fn sum(terms: impl Iterator<Item = f64>) -> f64 {
    let (sum, dropped) = terms.fold((0.0f64, 0.0f64), |(sum, dropped), term| {
        let next = sum + term;
        let less = if sum.abs() >= term.abs() { (sum - next) + term } else { (term - next) + sum };
        (next, dropped + less)
    });
    sum + dropped
}
