//! Multi-jittered points: jittered and N rooks at once.

use crate::error::Result;
use crate::num::random::{bits, uniform};
use crate::pattern::Pattern;
use crate::pattern::cells::{Cells, within_cell};
use crate::pattern::permutation::permutation;

/// One point in each of `m × n` cells, and one in each of the `N = mn` columns and `N` rows (Chiu, Shirley, Wang,
/// *Multi-jittered sampling*, Graphics Gems IV, 1994).
///
/// In cell `(i, j)` the point is at `x = (i + (σ_i(j) + ξ)/n)/m` and `y = (j + (τ_j(i) + η)/m)/n` with random
/// permutations `σ_i` of the `n` sub-columns of every column and `τ_j` of the `m` sub-rows of every row. The correlated
/// variant (Kensler 2013) takes the same `σ` in all columns and the same `τ` in all rows, which keeps neighbours farther
/// apart and the discrepancy lower, but gathers noise on the lines `u = km` and `v = kn` of frequencies. An edge along an
/// axis has the variance `1/(6N²)`, edges in other directions are as with jitter.
///
/// Order: of the cells, along x first.
///
/// ```
/// use nyquist::prelude::*;
/// let points = MultiJittered::new([4, 3])?.points(2);
/// let mut rows: Vec<_> = points.iter().map(|[_, y]| (12.0 * y) as usize).collect();
/// rows.sort_unstable();
/// assert!(rows.into_iter().eq(0..12));
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MultiJittered {
    cells: Cells<2>,
    correlated: bool,
}

impl MultiJittered {
    /// So many cells along each axis.
    ///
    /// # Errors
    /// As [`Cells::new`].
    pub fn new(along: [usize; 2]) -> Result<Self> {
        Cells::new(along).map(Self::of)
    }

    /// A square grid of `count` cells.
    ///
    /// # Errors
    /// As [`Cells::with_count`]: the error names the nearest possible numbers.
    pub fn with_count(count: usize) -> Result<Self> {
        Cells::with_count(count).map(Self::of)
    }

    /// The square grid whose number of cells is nearest to `count`.
    ///
    /// # Errors
    /// As [`Cells::nearest`].
    pub fn nearest(count: usize) -> Result<Self> {
        Cells::nearest(count).map(Self::of)
    }

    fn of(cells: Cells<2>) -> Self {
        Self { cells, correlated: false }
    }

    /// The same permutation in all columns, and the same in all rows.
    #[must_use]
    pub fn correlated(self) -> Self {
        Self { correlated: true, ..self }
    }

    /// The cells.
    pub fn cells(&self) -> Cells<2> {
        self.cells
    }
}

impl Pattern<2> for MultiJittered {
    fn name(&self) -> String {
        if self.correlated { "multi-jittered-correlated" } else { "multi-jittered" }.into()
    }

    fn count(&self) -> Option<usize> {
        Some(self.cells.total())
    }

    fn points(&self, seed: u64) -> Vec<[f64; 2]> {
        let [m, n] = self.cells.along();
        let total = (m * n) as u64;
        // `axis` 0: sub-columns of every column, 1: sub-rows of every row
        let permutations = |axis: u32, lines: usize, length: usize| -> Vec<Vec<u32>> {
            let kinds = if self.correlated { 1 } else { lines };
            (0..kinds as u64).map(|line| permutation(bits(seed, line, 2 + axis), length)).collect()
        };
        let (columns, rows) = (permutations(0, m, n), permutations(1, n, m));
        let point = |index: usize| {
            let [i, j] = self.cells.of(index);
            let sub_column = columns[i % columns.len()][j] as usize;
            let sub_row = rows[j % rows.len()][i] as usize;
            let place = |slice: usize, axis| within_cell(slice as u64, total, uniform(seed, index as u64, axis));
            [place(i * n + sub_column, 0), place(j * m + sub_row, 1)]
        };
        (0..m * n).map(point).collect()
    }
}
