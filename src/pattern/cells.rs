//! The unit cube cut into equal cells.

use crate::error::{Error, Result};
use crate::pattern::{MOST_POINTS, countable};

/// The place at `fraction` of the way through cell `cell` of the `of` equal cells of `[0, 1)`: `(cell + fraction)/of`.
///
/// For `0 ≤ fraction < 1` it never leaves its half-open cell, though `cell + fraction` rounds up to the next one for
/// fractions near one.
///
/// ```
/// use nyquist::pattern::cells::within_cell;
/// let last = 1.0 - f64::EPSILON / 2.0; // the largest number below one
/// assert_eq!((15.0 + last) / 16.0, 1.0);
/// assert!(within_cell(15, 16, last) < 1.0);
/// ```
pub fn within_cell(cell: u64, of: u64, fraction: f64) -> f64 {
    let place = (cell as f64 + fraction) / of as f64;
    let end = (cell + 1) as f64 / of as f64;
    if place < end { place } else { end.next_down() }
}

/// The unit cube cut into a grid of equal cells, `n_d` along axis `d`.
///
/// ```
/// use nyquist::pattern::cells::Cells;
/// use nyquist::error::Error;
/// let cells = Cells::new([4, 3])?;
/// assert_eq!((cells.total(), cells.of(5)), (12, [1, 1])); // x runs fastest
/// assert_eq!(Cells::<2>::with_count(1024)?, Cells::new([32, 32])?);
/// let error = Cells::<2>::with_count(1000).unwrap_err();
/// assert_eq!(error.to_string(), "cells of a square or cubic grid: 1000 is impossible; the nearest numbers are 961 and 1024");
/// assert_eq!(Cells::<2>::nearest(1000)?.total(), 1024);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Cells<const D: usize>([usize; D]);

impl<const D: usize> Cells<D> {
    /// So many cells along each axis.
    ///
    /// # Errors
    /// No cells along an axis, or more than [`MOST_POINTS`] in all.
    pub fn new(along: [usize; D]) -> Result<Self> {
        const { assert!(D > 0, "a cube has at least one dimension") };
        let total = along.iter().try_fold(1usize, |product, &n| product.checked_mul(n));
        countable(total.unwrap_or(usize::MAX))?;
        Ok(Self(along))
    }

    /// The same number along every axis, `count` in all.
    ///
    /// # Errors
    /// [`Error::Count`] with the nearest possible numbers unless `count` is a `D`-th power; no cells or too many.
    pub fn with_count(count: usize) -> Result<Self> {
        let (below, above) = around(countable(count)?, D as u32);
        if below.pow(D as u32) == count {
            return Self::new([below; D]);
        }
        let what = "cells of a square or cubic grid";
        Err(Error::Count { what, given: count, below: below.pow(D as u32), above: above.saturating_pow(D as u32) })
    }

    /// The same number along every axis, as near to `count` in all as possible, and the fewer if two are equally near.
    ///
    /// # Errors
    /// No cells or too many.
    pub fn nearest(count: usize) -> Result<Self> {
        let (below, above) = around(countable(count)?, D as u32);
        let (low, high) = (below.pow(D as u32), above.saturating_pow(D as u32));
        let fits = count - low > high - count && high <= MOST_POINTS;
        Self::new([if fits { above } else { below }; D])
    }

    /// How many cells there are along each axis.
    pub fn along(&self) -> [usize; D] {
        self.0
    }

    /// How many cells there are.
    pub fn total(&self) -> usize {
        self.0.iter().product()
    }

    /// The cell number `index`, counted along the first axis first; indices beyond the last begin again.
    pub fn of(&self, index: usize) -> [usize; D] {
        let mut rest = index;
        self.0.map(|n| {
            let cell = rest % n;
            rest /= n;
            cell
        })
    }

    /// The point at those fractions of the way through cell number `index`.
    pub fn point(&self, index: usize, fractions: [f64; D]) -> [f64; D] {
        let cell = self.of(index);
        std::array::from_fn(|d| within_cell(cell[d] as u64, self.0[d] as u64, fractions[d]))
    }
}

/// The largest `k` with `k^power ≤ n`, and `k + 1`.
fn around(n: usize, power: u32) -> (usize, usize) {
    let mut k = (n as f64).powf(1.0 / f64::from(power)) as usize; // may be off by one
    while k.checked_pow(power).is_none_or(|p| p > n) {
        k -= 1;
    }
    while (k + 1).checked_pow(power).is_some_and(|p| p <= n) {
        k += 1;
    }
    (k, k + 1)
}
