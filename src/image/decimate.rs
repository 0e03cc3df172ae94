//! Every n-th pixel: sampling an image again.

use crate::axis::Axis;
use crate::error::{Error, Result};
use crate::grid::Grid;
use crate::image::Image;
use ndarray::Slice;

/// Every `by[0]`-th column and `by[1]`-th row, from the first on; the rest is thrown away.
///
/// Whatever is above the new Nyquist frequency folds. Filter first ([`Filter`](crate::image::filter::Filter)), or
/// [`resize`](crate::image::resize::resize), which does.
///
/// ```
/// use nyquist::prelude::*;
/// use nyquist::image::decimate::decimate;
/// let fine = Image::of(&Grating::new([7.0 / 16.0, 0.0])?, Grid::centered(1.0, 64, 1)?);
/// let coarse = decimate(&fine, [2, 1])?;
/// // 7/16 of the old rate is 7/8 of the new one, and looks like 1/8
/// let alias = Image::of(&Grating::new([1.0 / 16.0, 0.0])?, coarse.grid());
/// assert!(coarse.rmse(&alias)? < 1e-13);
/// # Ok::<(), Error>(())
/// ```
///
/// # Errors
/// A factor of zero.
pub fn decimate(image: &Image, by: [usize; 2]) -> Result<Image> {
    if by.contains(&0) {
        return Err(Error::TooFew { what: "the factor of a decimation", least: 1, got: 0 });
    }
    let grid = image.grid();
    let axis = |axis: Axis, by: usize| {
        Ok(Axis::new(axis.start(), axis.step() * by as f64, axis.len().div_ceil(by))?.in_unit(axis.unit()))
    };
    let coarse = Grid::new(axis(grid.x(), by[0])?, axis(grid.y(), by[1])?)?;
    // a stride is a signed number to ndarray, and one beyond the end takes the first alone
    let strides = [by[1].min(grid.height()), by[0].min(grid.width())].map(|stride| stride as isize);
    let every = |along: usize| Slice::new(0, None, strides[along]);
    let kept = image.pixels().slice_each_axis(|ax| every(ax.axis.index())).as_standard_layout().to_owned();
    Ok(Image::trusted(coarse, kept))
}
