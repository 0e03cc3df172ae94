//! The radical inverse: digits mirrored at the point.

use crate::error::{Result, within};

/// The first 64 primes: the bases of Halton's and Hammersley's points.
pub const PRIMES: [u32; 64] = [
    2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53, 59, 61, 67, 71, 73, 79, 83, 89, 97, 101, 103, 107, 109,
    113, 127, 131, 137, 139, 149, 151, 157, 163, 167, 173, 179, 181, 191, 193, 197, 199, 211, 223, 227, 229, 233, 239,
    241, 251, 257, 263, 269, 271, 277, 281, 283, 293, 307, 311,
];

/// The prime that is the base of a dimension, counted from zero.
///
/// # Errors
/// A dimension beyond the 64 of the table.
pub fn base(dimension: usize) -> Result<u32> {
    within("the dimension of a radical inverse", dimension as f64, 0.0, (PRIMES.len() - 1) as f64)?;
    Ok(PRIMES[dimension])
}

/// A fraction of whole numbers, below one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Fraction {
    /// What stands above the line.
    pub numerator: u64,
    /// What stands below it: a power of the base, greater than the numerator.
    pub denominator: u64,
}

impl Fraction {
    /// The nearest `f64`: correctly rounded, and exact in base 2, for denominators up to `2⁵³`.
    pub fn value(&self) -> f64 {
        self.numerator as f64 / self.denominator as f64
    }

    /// The box that the fraction falls into when `[0, 1)` is cut into `boxes` equal ones, in whole numbers: no rounding.
    pub fn slice(&self, boxes: u64) -> u64 {
        (u128::from(self.numerator) * u128::from(boxes) / u128::from(self.denominator)) as u64
    }
}

/// The radical inverse `Φ_b(i) = Σ d_k b^{−k−1}` of `i = Σ d_k b^k`, exact in whole numbers (van der Corput 1935).
///
/// The digits of `i` mirrored at the point. The first `b^m` values are the multiples of `b^{−m}`, and every run of `b^m`
/// values has one in each interval `[j b^{−m}, (j+1) b^{−m})`.
///
/// ```
/// use nyquist::pattern::radical::{Fraction, radical_inverse};
/// // 11 = 1011 in base 2 becomes 0.1101; in base 3 it is 102, and becomes 0.201
/// assert_eq!(radical_inverse(2, 11)?, Fraction { numerator: 13, denominator: 16 });
/// assert_eq!(radical_inverse(3, 11)?, Fraction { numerator: 19, denominator: 27 });
/// assert_eq!(radical_inverse(2, 11)?.value(), 0.8125);
/// # Ok::<(), nyquist::error::Error>(())
/// ```
///
/// # Errors
/// A base outside `2 ..= 2¹⁶`.
pub fn radical_inverse(base: u32, index: u32) -> Result<Fraction> {
    within("the base of a radical inverse", base.into(), 2.0, 65536.0)?;
    Ok(inverse(base, index))
}

/// [`radical_inverse`] for a base that is known to be right; the denominator is at most `index·base < 2⁴⁸`.
pub(crate) fn inverse(base: u32, index: u32) -> Fraction {
    let (mut numerator, mut denominator, mut rest) = (0, 1, index);
    while rest > 0 {
        numerator = numerator * u64::from(base) + u64::from(rest % base);
        denominator *= u64::from(base);
        rest /= base;
    }
    Fraction { numerator, denominator }
}
