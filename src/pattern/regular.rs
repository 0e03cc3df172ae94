//! The regular grid.

use crate::error::Result;
use crate::num::random::uniform;
use crate::pattern::Pattern;
use crate::pattern::cells::Cells;

/// One point in each cell of a grid, everywhere at the same place.
///
/// Its spectrum is a lattice of lines as strong as the one at zero, so that what it cannot resolve returns as a clear
/// wrong picture: the aliasing that the lecture is about (slide "Равномерное сэмплирование"). With the points in the
/// middles the star discrepancy of an `n × n` grid is exactly `1/n − 1/(4n²)`. With a random offset of the whole grid a
/// mean over the points has the right expectation, and is exact for every trigonometric polynomial of degree below `n`.
///
/// Order: along the first axis first.
///
/// ```
/// use nyquist::prelude::*;
/// let grid = Regular::new([2, 2])?;
/// assert_eq!(grid.points(0), [[0.25, 0.25], [0.75, 0.25], [0.25, 0.75], [0.75, 0.75]]);
/// // the offset is less than a cell, and the same for all
/// let offset = Regular::new([2, 2])?.with_random_offset().points(5);
/// assert!(offset[0].iter().all(|c| (0.0..0.5).contains(c)));
/// assert!((offset[1][0] - offset[0][0] - 0.5).abs() <= f64::EPSILON && offset[1][1] == offset[0][1]);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Regular<const D: usize> {
    cells: Cells<D>,
    random_offset: bool,
}

impl<const D: usize> Regular<D> {
    /// So many points along each axis, in the middles of their cells.
    ///
    /// # Errors
    /// As [`Cells::new`].
    pub fn new(along: [usize; D]) -> Result<Self> {
        Cells::new(along).map(Self::of)
    }

    /// A square (cubic, …) grid of `count` points.
    ///
    /// # Errors
    /// As [`Cells::with_count`]: the error names the nearest possible numbers.
    pub fn with_count(count: usize) -> Result<Self> {
        Cells::with_count(count).map(Self::of)
    }

    /// The square (cubic, …) grid whose number of points is nearest to `count`.
    ///
    /// # Errors
    /// As [`Cells::nearest`].
    pub fn nearest(count: usize) -> Result<Self> {
        Cells::nearest(count).map(Self::of)
    }

    fn of(cells: Cells<D>) -> Self {
        Self { cells, random_offset: false }
    }

    /// The grid displaced as a whole: all points at the same random place of their cells.
    #[must_use]
    pub fn with_random_offset(self) -> Self {
        Self { random_offset: true, ..self }
    }

    /// The cells.
    pub fn cells(&self) -> Cells<D> {
        self.cells
    }

    /// The point number `index` alone; beyond the last they begin again.
    pub fn sample(&self, index: usize, seed: u64) -> [f64; D] {
        let place = |d| if self.random_offset { uniform(seed, 0, d as u32) } else { 0.5 };
        self.cells.point(index, std::array::from_fn(place))
    }
}

impl<const D: usize> Pattern<D> for Regular<D> {
    fn name(&self) -> String {
        if self.random_offset { "regular-offset" } else { "regular" }.into()
    }

    fn count(&self) -> Option<usize> {
        Some(self.cells.total())
    }

    fn points(&self, seed: u64) -> Vec<[f64; D]> {
        (0..self.cells.total()).map(|i| self.sample(i, seed)).collect()
    }
}
