//! The order of magnitude of numbers.

/// A power of two near the largest size among the numbers, one if all are zero: divided by it, squares neither overflow nor
/// vanish, and nothing is rounded that counts beside the largest.
pub(crate) fn scale(numbers: impl Iterator<Item = f64>) -> f64 {
    let largest = numbers.fold(0.0, |most: f64, v| most.max(v.abs()));
    // that power itself is a normal number, and so is its inverse
    if largest > 0.0 { largest.log2().floor().clamp(-1000.0, 1000.0).exp2() } else { 1.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn squares_of_what_is_left_are_normal_numbers() {
        for largest in [f64::MAX, 3e200, 1.0, -7.5, 3e-200, f64::MIN_POSITIVE, f64::from_bits(1)] {
            let unit = scale([0.0, 0.1 * largest, largest].into_iter());
            let part = largest / unit;
            assert!((part * part).is_normal() && part * unit == largest, "{largest:e} {unit:e}");
        }
        assert_eq!(scale([0.0, -0.0].into_iter()), 1.0);
    }
}
