//! Another size: reconstruction by a kernel, one axis at a time.

use crate::axis::{Axis, Edge};
use crate::error::Result;
use crate::grid::Grid;
use crate::image::Image;
use crate::image::weights::{Taps, Weights};
use crate::kernel::Kernel;
use crate::parallel;
use ndarray::Array2;

/// The image with another width and height over the same rectangle, by a kernel; what interpolates, and what filters on
/// the way down.
///
/// ```
/// use nyquist::prelude::*;
/// use nyquist::image::resize::resize;
/// // a checkerboard of single pixels has the mean ½ in linear light, and is grey when it is made smaller
/// let checks = Image::of(&Checks::new(1.0)?, Grid::pixels(8, 8)?);
/// let small = resize(&checks, 4, 4, &BoxKernel, Edge::Clamp)?;
/// assert!(small.values().iter().all(|v| *v == 0.5));
/// assert_eq!(small.grid().at(0, 0), [1.0, 1.0]); // the middle of four pixels
/// # Ok::<(), Error>(())
/// ```
///
/// # Errors
/// A width or height of zero, more than [`Grid::MOST`] pixels, a kernel of infinite radius.
pub fn resize(image: &Image, width: usize, height: usize, kernel: &dyn Kernel, edge: Edge) -> Result<Image> {
    resample(image, over(image.grid(), width, height)?, kernel, edge)
}

/// So many pixels across and down over the rectangle that the pixels of `grid` cover.
///
/// # Errors
/// A width or height of zero, more than [`Grid::MOST`] pixels.
pub fn over(grid: Grid, width: usize, height: usize) -> Result<Grid> {
    let axis = |axis: Axis, n: usize| {
        let start = axis.start() - 0.5 * axis.step();
        Ok(Axis::cells(start..start + axis.span(), n)?.in_unit(axis.unit()))
    };
    Grid::new(axis(grid.x(), width)?, axis(grid.y(), height)?)
}

/// The image on any other grid: `Σ f_i k((x − x_i)/cT) / Σ k((x − x_i)/cT)` along each axis, with the [`Weights`] of the
/// kernel.
///
/// Where the new step is longer than the old one `T`, `c` is their ratio: the kernel widens and becomes the prefilter of
/// the new rate; otherwise it is 1. The weights of every pixel are divided by their sum, so that a constant stays the
/// constant whatever the kernel, and to the last bit (except beside nothing, [`Edge::Zero`], where the sum counts what is
/// not there).
///
/// The axis on which more is saved goes first. Exact to the rounding of the two sums, `2ε·taps·max|f|·Σ|k|/|Σk|`. On several
/// threads, with the same bits.
///
/// ```
/// use nyquist::prelude::*;
/// use nyquist::image::resize::resample;
/// let ramp = Image::of(&field_fn(|x, _| x), Grid::pixels(8, 1)?);
/// let finer = resample(&ramp, Grid::cells(2.0..6.0, 16, 0.0..1.0, 1)?, &TentKernel, Edge::Clamp)?;
/// assert!(finer.rmse(&Image::of(&field_fn(|x, _| x), finer.grid()))? < 1e-15); // a tent reproduces lines
/// # Ok::<(), Error>(())
/// ```
///
/// # Errors
/// A kernel of infinite radius; more than 2²⁸ weights along one axis (a step many times the image's).
pub fn resample(image: &Image, grid: Grid, kernel: &dyn Kernel, edge: Edge) -> Result<Image> {
    let across = Weights::of(image.grid().x(), grid.x(), kernel)?;
    let down = Weights::of(image.grid().y(), grid.y(), kernel)?;
    Ok(weighted(image, &across, &down, edge))
}

/// Every pixel of the grid takes that of the image which is nearest to it: no filter at all, and whatever is too fine for
/// the grid folds.
///
/// ```
/// use nyquist::prelude::*;
/// use nyquist::image::resize::{nearest, over};
/// let image = Image::new(Grid::pixels(4, 1)?, vec![0.0, 1.0, 2.0, 3.0])?;
/// // half-way between two pixels the later one is taken: every second
/// assert_eq!(nearest(&image, over(image.grid(), 2, 1)?, Edge::Clamp).values(), [1.0, 3.0]);
/// # Ok::<(), Error>(())
/// ```
pub fn nearest(image: &Image, grid: Grid, edge: Edge) -> Image {
    let (across, down) = (Weights::nearest(image.grid().x(), grid.x()), Weights::nearest(image.grid().y(), grid.y()));
    weighted(image, &across, &down, edge)
}

fn weighted(image: &Image, across: &Weights, down: &Weights, edge: Edge) -> Image {
    let grid = Grid::new(across.new_axis(), down.new_axis()).expect("the two axes of a grid that there is");
    let (across, down) = (across.within(edge), down.within(edge));
    let ratio = |new: usize, old: usize| new as f64 / old as f64;
    let rows_first = ratio(grid.width(), image.width()) < ratio(grid.height(), image.height());
    let pixels = if rows_first {
        columns(&rows(image.pixels(), &across), &down)
    } else {
        rows(&columns(image.pixels(), &down), &across)
    };
    Image::trusted(grid, pixels)
}

const ROWS: &str = "rows are kept one after another";

/// Along the rows: every new pixel of a row is a sum over the old ones.
fn rows(pixels: &Array2<f64>, taps: &[Taps]) -> Array2<f64> {
    let (width, old) = (pixels.ncols(), pixels.as_slice().expect(ROWS));
    let mut out = Array2::zeros((pixels.nrows(), taps.len()));
    parallel::chunks(out.as_slice_mut().expect(ROWS), taps.len(), |j, new| {
        let old = &old[j * width..][..width];
        for (value, Taps { base, whole, read }) in new.iter_mut().zip(taps) {
            let base = old[*base];
            *value = whole * base + read.iter().map(|&(i, w)| w * (old[i] - base)).sum::<f64>();
        }
    });
    out
}

/// Along the columns: every new row is a sum of old rows, so that memory is read in its order.
fn columns(pixels: &Array2<f64>, taps: &[Taps]) -> Array2<f64> {
    let (width, old) = (pixels.ncols(), pixels.as_slice().expect(ROWS));
    let row = |j: usize| &old[j * width..][..width];
    let mut out = Array2::zeros((taps.len(), width));
    parallel::chunks(out.as_slice_mut().expect(ROWS), width, |j, new| {
        let Taps { base, whole, read } = &taps[j];
        let base = row(*base);
        for &(i, w) in read {
            new.iter_mut().zip(row(i)).zip(base).for_each(|((sum, f), base)| *sum += w * (f - base));
        }
        new.iter_mut().zip(base).for_each(|(sum, base)| *sum += whole * base);
    });
    out
}
