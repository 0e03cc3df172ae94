//! Where the pixels are: two axes.

use crate::axis::{Axis, Unit};
use crate::error::{Error, Result};
use std::ops::Range;

/// Equally spaced positions in the plane: an axis across and an axis down.
///
/// An image's first row is at the start of its `y` axis; whether that is above or below is for whoever draws it.
///
/// ```
/// use nyquist::grid::Grid;
/// let grid = Grid::pixels(4, 3)?;
/// assert_eq!((grid.width(), grid.height(), grid.len()), (4, 3, 12));
/// assert_eq!(grid.at(0, 2), [0.5, 2.5]); // pixel centres
/// assert_eq!(grid.cell(0, 2), [[0.0, 1.0], [2.0, 3.0]]);
/// # Ok::<(), nyquist::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grid {
    x: Axis,
    y: Axis,
}

impl Grid {
    /// The most positions a grid may have: 2³⁰, which fill 8 GiB.
    pub const MOST: usize = 1 << 30;

    /// The positions `(x_i, y_j)` of two axes.
    ///
    /// # Errors
    /// More than [`Grid::MOST`] positions.
    pub fn new(x: Axis, y: Axis) -> Result<Self> {
        match x.len().checked_mul(y.len()) {
            Some(n) if n <= Self::MOST => Ok(Self { x, y }),
            _ => {
                let (value, most) = (x.len() as f64 * y.len() as f64, Self::MOST as f64);
                Err(Error::Overflow { what: "the number of positions on a grid", value, most })
            }
        }
    }

    /// Pixels of size one: their centres stand at `i + ½`, `j + ½`.
    ///
    /// # Errors
    /// No pixels, or more than [`Grid::MOST`].
    pub fn pixels(width: usize, height: usize) -> Result<Self> {
        let axis = |n: usize| Ok(Axis::new(0.5, 1.0, n)?.in_unit(Unit::PIXEL));
        Self::new(axis(width)?, axis(height)?)
    }

    /// The centres of `nx` × `ny` equal cells of the rectangle `x` × `y`.
    ///
    /// # Errors
    /// As [`Axis::cells`], and more than [`Grid::MOST`] cells.
    pub fn cells(x: Range<f64>, nx: usize, y: Range<f64>, ny: usize) -> Result<Self> {
        Self::new(Axis::cells(x, nx)?, Axis::cells(y, ny)?)
    }

    /// Positions `step` apart with zero at the indices `nx/2` and `ny/2` (integer division).
    ///
    /// # Errors
    /// As [`Axis::centered`], and more than [`Grid::MOST`] positions.
    pub fn centered(step: f64, nx: usize, ny: usize) -> Result<Self> {
        Self::new(Axis::centered(step, nx)?, Axis::centered(step, ny)?)
    }

    /// Across.
    pub fn x(&self) -> Axis {
        self.x
    }

    /// Down.
    pub fn y(&self) -> Axis {
        self.y
    }

    /// Positions in a row.
    pub fn width(&self) -> usize {
        self.x.len()
    }

    /// Rows.
    pub fn height(&self) -> usize {
        self.y.len()
    }

    /// How many positions there are; never zero.
    #[expect(clippy::len_without_is_empty, reason = "a grid is never empty: its axes refuse it")]
    pub fn len(&self) -> usize {
        self.x.len() * self.y.len()
    }

    /// The position of column `i` and row `j`; indices beyond the ends continue the grid.
    pub fn at(&self, i: i64, j: i64) -> [f64; 2] {
        [self.x.at(i), self.y.at(j)]
    }

    /// The cell around that position, a step wide and high: `[[x₀, x₁], [y₀, y₁]]`.
    pub fn cell(&self, i: i64, j: i64) -> [[f64; 2]; 2] {
        let around = |axis: Axis, i: i64| {
            let (middle, half) = (axis.at(i), 0.5 * axis.step());
            [middle - half, middle + half]
        };
        [around(self.x, i), around(self.y, j)]
    }

    /// All positions, row by row.
    pub fn iter(&self) -> impl Iterator<Item = [f64; 2]> + use<> {
        let (x, y) = (self.x, self.y);
        y.iter().flat_map(move |y| x.iter().map(move |x| [x, y]))
    }

    /// The area `step_x·step_y` that belongs to one position.
    pub fn pixel_area(&self) -> f64 {
        self.x.step() * self.y.step()
    }

    /// The area of the whole, `span_x·span_y`.
    pub fn area(&self) -> f64 {
        self.x.span() * self.y.span()
    }

    /// The grid of the transform's frequencies: both axes' [dual](Axis::dual), zero at the indices `width/2`, `height/2`.
    #[must_use]
    pub fn dual(&self) -> Self {
        Self { x: self.x.dual(), y: self.y.dual() }
    }
}
