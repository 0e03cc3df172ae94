//! An image: a grid and the values on it.

use crate::axis::Axis;
use crate::error::{Error, Result};
use crate::field::{ExactMean, Field};
use crate::grid::Grid;
use ndarray::Array2;

/// A grey image in linear light: one value for every position of a [`Grid`].
///
/// Rows are kept one after another, `pixels()[[iy, ix]]`; every function that takes a position takes `(ix, iy)`.
///
/// ```
/// use nyquist::prelude::*;
/// let ramp = Image::of(&field_fn(|x, y| x + 10.0 * y), Grid::pixels(3, 2)?);
/// assert_eq!((ramp.width(), ramp.height()), (3, 2));
/// assert_eq!(ramp.at(2, 1), 2.5 + 15.0); // sampled at the pixel's centre
/// assert_eq!(ramp.pixels()[[1, 2]], ramp.at(2, 1));
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Image {
    grid: Grid,
    pixels: Array2<f64>,
}

impl Image {
    /// Values row by row on a grid.
    ///
    /// # Errors
    /// A number of values other than the grid has positions; values that are not finite.
    pub fn new(grid: Grid, values: Vec<f64>) -> Result<Self> {
        if values.len() != grid.len() {
            return Err(Error::Length { what: "pixels on a grid", expected: grid.len(), got: values.len() });
        }
        crate::error::all_finite("pixels, row by row,", &values)?;
        Ok(Self::rows(grid, values))
    }

    /// Point samples `f(x_i, y_j)`: one at the place of every pixel. Aliases whatever is above the Nyquist frequency.
    pub fn of(field: &impl Field, grid: Grid) -> Self {
        Self::rows(grid, grid.iter().map(|[x, y]| field.at(x, y)).collect())
    }

    /// Exact means over every pixel: point samples of the field behind a box prefilter as wide as a pixel.
    ///
    /// Exact in area, not free of aliasing: a frequency `ν` keeps `sinc(ν)` of its amplitude (E13).
    ///
    /// ```
    /// use nyquist::prelude::*;
    /// let edge = HalfPlane::through([0.0, 1.25], 0.0)?;
    /// let image = Image::averaged(&edge, Grid::pixels(1, 3)?);
    /// assert_eq!([0, 1, 2].map(|j| image.at(0, j)), [1.0, 0.25, 0.0]);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn averaged(field: &impl ExactMean, grid: Grid) -> Self {
        let places = (0..grid.height() as i64).flat_map(|j| (0..grid.width() as i64).map(move |i| (i, j)));
        let means = places.map(|(i, j)| {
            let [x, y] = grid.cell(i, j);
            field.mean(x, y)
        });
        Self::rows(grid, means.collect())
    }

    /// Values that are known to fit.
    fn rows(grid: Grid, values: Vec<f64>) -> Self {
        let shape = (grid.height(), grid.width());
        let pixels = Array2::from_shape_vec(shape, values).expect("there are as many values as positions");
        Self { grid, pixels }
    }

    /// An array that is known to fit.
    pub(crate) fn trusted(grid: Grid, pixels: Array2<f64>) -> Self {
        debug_assert_eq!(pixels.dim(), (grid.height(), grid.width()));
        debug_assert!(pixels.is_standard_layout());
        Self { grid, pixels }
    }

    /// Where the pixels are.
    pub fn grid(&self) -> Grid {
        self.grid
    }

    /// Pixels in a row.
    pub fn width(&self) -> usize {
        self.grid.width()
    }

    /// Rows.
    pub fn height(&self) -> usize {
        self.grid.height()
    }

    /// The value in column `ix` and row `iy`.
    ///
    /// # Panics
    /// Beyond the last column or row.
    pub fn at(&self, ix: usize, iy: usize) -> f64 {
        self.pixels[[iy, ix]]
    }

    /// All values, `[[iy, ix]]`.
    pub fn pixels(&self) -> &Array2<f64> {
        &self.pixels
    }

    /// All values, row by row.
    pub fn values(&self) -> &[f64] {
        self.pixels.as_slice().expect("rows are kept one after another")
    }

    /// The values of one row.
    pub(crate) fn row(&self, iy: usize) -> &[f64] {
        &self.values()[iy * self.width()..][..self.width()]
    }

    /// Every value through `f`.
    #[must_use]
    pub fn map(&self, f: impl Fn(f64) -> f64) -> Self {
        Self { grid: self.grid, pixels: self.pixels.mapv(f) }
    }

    /// `f` of the values of two images, pixel by pixel.
    ///
    /// # Errors
    /// Another width or height.
    pub fn with(&self, other: &Self, f: impl Fn(f64, f64) -> f64) -> Result<Self> {
        same_size(self, other)?;
        let values = self.values().iter().zip(other.values()).map(|(&a, &b)| f(a, b)).collect();
        Ok(Self::rows(self.grid, values))
    }

    /// The mean of all values.
    pub fn mean(&self) -> f64 {
        self.values().iter().sum::<f64>() / self.values().len() as f64
    }

    /// The root of the mean squared difference.
    ///
    /// ```
    /// use nyquist::prelude::*;
    /// let grid = Grid::pixels(2, 1)?;
    /// let (a, b) = (Image::new(grid, vec![0.0, 1.0])?, Image::new(grid, vec![0.6, 0.2])?);
    /// assert!((a.rmse(&b)? - 0.5f64.sqrt()).abs() < 1e-15);
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    /// Another width or height.
    pub fn rmse(&self, other: &Self) -> Result<f64> {
        Ok(self.with(other, |a, b| (a - b) * (a - b))?.mean().sqrt())
    }

    /// The pixels of a rectangle, where they are: so many columns and rows from the one in column `left` and row `top` on.
    ///
    /// ```
    /// use nyquist::prelude::*;
    /// let ramp = Image::of(&field_fn(|x, y| x + 10.0 * y), Grid::pixels(5, 4)?);
    /// let part = ramp.part([1, 2], [3, 2])?;
    /// assert_eq!((part.width(), part.height(), part.at(0, 0)), (3, 2, ramp.at(1, 2)));
    /// assert_eq!(part.grid().at(0, 0), ramp.grid().at(1, 2));
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    /// A rectangle without pixels, or one that is not inside.
    pub fn part(&self, [left, top]: [usize; 2], [width, height]: [usize; 2]) -> Result<Self> {
        let inside = |what, first: usize, n: usize, all: usize| match first.checked_add(n) {
            Some(end) if end <= all => Ok(()),
            _ => Err(Error::Overflow { what, value: first as f64 + n as f64, most: all as f64 }),
        };
        inside("the right side of a part of an image", left, width, self.width())?;
        inside("the lower side of a part of an image", top, height, self.height())?;
        let axis = |axis: Axis, first: usize, n: usize| {
            Ok::<_, Error>(Axis::new(axis.at(first as i64), axis.step(), n)?.in_unit(axis.unit()))
        };
        let grid = Grid::new(axis(self.grid.x(), left, width)?, axis(self.grid.y(), top, height)?)?;
        let rows = (top..top + height).flat_map(|y| &self.row(y)[left..left + width]);
        Ok(Self::rows(grid, rows.copied().collect()))
    }

    /// The same values elsewhere: on another grid of the same width and height.
    ///
    /// # Errors
    /// Another width or height.
    pub fn on(&self, grid: Grid) -> Result<Self> {
        let size = (grid.width(), grid.height());
        if size != (self.width(), self.height()) {
            return Err(Error::Length { what: "pixels on a grid", expected: grid.len(), got: self.grid.len() });
        }
        Ok(Self { grid, pixels: self.pixels.clone() })
    }
}

fn same_size(a: &Image, b: &Image) -> Result<()> {
    if a.width() != b.width() {
        return Err(Error::Length { what: "the width of the second image", expected: a.width(), got: b.width() });
    }
    if a.height() != b.height() {
        return Err(Error::Length { what: "the height of the second image", expected: a.height(), got: b.height() });
    }
    Ok(())
}
