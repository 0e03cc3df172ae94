//! One random point in each cell.

use crate::error::{Result, within};
use crate::num::random::uniform;
use crate::pattern::Pattern;
use crate::pattern::cells::Cells;

/// One point in each cell of a grid, independent and uniform over the middle `width` of the cell along every axis; with
/// width 1, over all of it: stratified sampling (Cook 1986; slides "Jittered Sampling", "Стратифицированный сэмплинг").
///
/// The expected periodogram of an `n × n` pattern at integer frequencies is `1 − φ²` with `φ = sinc(au/n)·sinc(av/n)`
/// for width `a`, and `φ²·N` stands on top at the multiples of `n`. With `a = 1` all lines are gone but the one at zero,
/// and the floor starts as `π²(u² + v²)/(3n²)`: noise at high frequencies only. The variance of a mean of `N` points
/// falls as `N^{−1−2/D}` for smooth functions and as `N^{−1−1/D}` for edges, never slower than for independent points.
///
/// Order: of the cells, along the first axis first.
///
/// ```
/// use nyquist::prelude::*;
/// let points = Jittered::new([4, 4])?.points(1);
/// for (i, [x, y]) in points.into_iter().enumerate() {
///     assert_eq!(((4.0 * x) as usize, (4.0 * y) as usize), (i % 4, i / 4)); // one a cell
/// }
/// // as near to 1000 as a square grid comes; or exactly 1000, of cells that are not square
/// assert_eq!(Jittered::<2>::nearest(1000)?.count(), Some(1024));
/// assert_eq!(Jittered::new([40, 25])?.count(), Some(1000));
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Jittered<const D: usize> {
    cells: Cells<D>,
    width: f64,
}

impl<const D: usize> Jittered<D> {
    /// So many cells along each axis, and points anywhere in them.
    ///
    /// # Errors
    /// As [`Cells::new`].
    pub fn new(along: [usize; D]) -> Result<Self> {
        Cells::new(along).map(Self::of)
    }

    /// A square (cubic, …) grid of `count` cells.
    ///
    /// # Errors
    /// As [`Cells::with_count`]: the error names the nearest possible numbers.
    pub fn with_count(count: usize) -> Result<Self> {
        Cells::with_count(count).map(Self::of)
    }

    /// The square (cubic, …) grid whose number of cells is nearest to `count`.
    ///
    /// # Errors
    /// As [`Cells::nearest`].
    pub fn nearest(count: usize) -> Result<Self> {
        Cells::nearest(count).map(Self::of)
    }

    fn of(cells: Cells<D>) -> Self {
        Self { cells, width: 1.0 }
    }

    /// Points only within the middle `width` of their cells: 0 is the regular grid, 1 the whole cell.
    ///
    /// # Errors
    /// A width outside `0..=1`.
    pub fn with_width(self, width: f64) -> Result<Self> {
        Ok(Self { width: within("the width of the jitter", width, 0.0, 1.0)?, ..self })
    }

    /// The cells.
    pub fn cells(&self) -> Cells<D> {
        self.cells
    }

    /// The part of the cell that points may be in.
    pub fn width(&self) -> f64 {
        self.width
    }

    /// The point number `index` alone; beyond the last, other points of the same cells.
    pub fn sample(&self, index: usize, seed: u64) -> [f64; D] {
        let place = |d| 0.5 + self.width * (uniform(seed, index as u64, d as u32) - 0.5);
        self.cells.point(index, std::array::from_fn(place))
    }
}

impl<const D: usize> Pattern<D> for Jittered<D> {
    fn name(&self) -> String {
        if self.width == 1.0 { "jittered".into() } else { format!("jittered:{}", self.width) }
    }

    fn count(&self) -> Option<usize> {
        Some(self.cells.total())
    }

    fn points(&self, seed: u64) -> Vec<[f64; D]> {
        (0..self.cells.total()).map(|i| self.sample(i, seed)).collect()
    }
}
