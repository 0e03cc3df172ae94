//! Hammersley's points.

use crate::error::Result;
use crate::pattern::radical::{PRIMES, inverse};
use crate::pattern::{Pattern, countable};

/// Point `i` of `N` is `(i/N, Φ₂(i), Φ₃(i), …)` (Hammersley 1960).
///
/// One dimension less of radical inverses than Halton's sequence, and so a lower discrepancy, `O((ln N)^{D−1}/N)`; but
/// `N` has to be known beforehand. In the plane and for `N = 2^m ≥ 4` the star discrepancy is known in closed form,
/// `(m/3 + 13/9 − (−1)^m·4/(9·2^m))/N` (Halton, Zaremba 1969), and the points are a (0, m, 2)-net in base 2. Not
/// random: the seed changes nothing.
///
/// Order: of the index, which is that of the first coordinate. At most 65 dimensions.
///
/// ```
/// use nyquist::prelude::*;
/// let points: Vec<[f64; 2]> = Hammersley::new(4)?.points(0);
/// assert_eq!(points, [[0.0, 0.0], [0.25, 0.5], [0.5, 0.25], [0.75, 0.75]]);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hammersley {
    count: usize,
}

impl Hammersley {
    /// So many points.
    ///
    /// # Errors
    /// No points, or more than [`MOST_POINTS`](crate::pattern::MOST_POINTS).
    pub fn new(count: usize) -> Result<Self> {
        Ok(Self { count: countable(count)? })
    }
}

impl<const D: usize> Pattern<D> for Hammersley {
    fn name(&self) -> String {
        "hammersley".into()
    }

    fn count(&self) -> Option<usize> {
        Some(self.count)
    }

    fn points(&self, _: u64) -> Vec<[f64; D]> {
        const { assert!(D <= PRIMES.len() + 1, "a prime for each dimension but the first") };
        let n = self.count as f64;
        let coordinate = |i: u32, d: usize| if d == 0 { f64::from(i) / n } else { inverse(PRIMES[d - 1], i).value() };
        (0..self.count as u32).map(|i| std::array::from_fn(|d| coordinate(i, d))).collect()
    }
}
