//! N rooks: Latin hypercubes.

use crate::error::Result;
use crate::num::random::{bits, uniform};
use crate::pattern::cells::within_cell;
use crate::pattern::permutation::permutation;
use crate::pattern::{Pattern, countable};

/// `N` points of which every one of the `N` equal slices along every axis holds one: rooks that do not attack each other
/// (Shirley 1991), a Latin hypercube (McKay, Beckman, Conover 1979).
///
/// Every coordinate by itself is jittered; together they are no better spread than random points. The variance of a mean
/// falls as `N⁻³` for functions that are sums of smooth functions of one coordinate, as `1/(6N²)` for an edge along an
/// axis, and otherwise as `N⁻¹`.
///
/// Order: random; the permutations of the coordinates are independent.
///
/// ```
/// use nyquist::prelude::*;
/// let points: Vec<[f64; 3]> = NRooks::new(100)?.points(2);
/// for d in 0..3 {
///     let mut slices: Vec<_> = points.iter().map(|p| (100.0 * p[d]) as usize).collect();
///     slices.sort_unstable();
///     assert!(slices.into_iter().eq(0..100));
/// }
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NRooks {
    count: usize,
}

impl NRooks {
    /// So many points.
    ///
    /// # Errors
    /// No points, or more than [`MOST_POINTS`](crate::pattern::MOST_POINTS).
    pub fn new(count: usize) -> Result<Self> {
        Ok(Self { count: countable(count)? })
    }
}

impl<const D: usize> Pattern<D> for NRooks {
    fn name(&self) -> String {
        "n-rooks".into()
    }

    fn count(&self) -> Option<usize> {
        Some(self.count)
    }

    fn points(&self, seed: u64) -> Vec<[f64; D]> {
        let n = self.count;
        let slices: [Vec<u32>; D] = std::array::from_fn(|d| permutation(bits(seed, u64::MAX, d as u32), n));
        let coordinate =
            |i: usize, d: usize| within_cell(slices[d][i].into(), n as u64, uniform(seed, i as u64, d as u32));
        (0..n).map(|i| std::array::from_fn(|d| coordinate(i, d))).collect()
    }
}
