//! Independent random points.

use crate::error::Result;
use crate::num::random::uniform;
use crate::pattern::{Pattern, countable};

/// Independent points, uniform over the cube: white noise.
///
/// The expected periodogram is one at every frequency but zero: aliasing becomes noise of *all* frequencies, not of high
/// ones, as the lecture has it (E11). The number of points in a cell of volume `1/N` is nearly Poisson's, so that
/// `e⁻¹ = 37 %` of the cells stay empty. The yardstick for all other patterns, and never the best one.
///
/// Order: of the index; `n` points are the first `n` of any more.
///
/// ```
/// use nyquist::prelude::*;
/// let [ten, five]: [Vec<[f64; 2]>; 2] = [Random::new(10)?.points(3), Random::new(5)?.points(3)];
/// assert_eq!(ten[..5], five);
/// assert_eq!(five[4][1], Random::sample(4, 1, 3)); // a pure function of index, dimension and seed
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Random {
    count: usize,
}

impl Random {
    /// So many points.
    ///
    /// # Errors
    /// No points, or more than [`MOST_POINTS`](crate::pattern::MOST_POINTS).
    pub fn new(count: usize) -> Result<Self> {
        Ok(Self { count: countable(count)? })
    }

    /// One coordinate of one point alone.
    pub fn sample(index: u64, dimension: u32, seed: u64) -> f64 {
        uniform(seed, index, dimension)
    }
}

impl<const D: usize> Pattern<D> for Random {
    fn name(&self) -> String {
        "random".into()
    }

    fn count(&self) -> Option<usize> {
        Some(self.count)
    }

    fn points(&self, seed: u64) -> Vec<[f64; D]> {
        let point = |i| std::array::from_fn(|d| Self::sample(i, d as u32, seed));
        (0..self.count as u64).map(point).collect()
    }
}
