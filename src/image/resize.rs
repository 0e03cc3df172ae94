//! Another size: reconstruction by a kernel, one axis at a time.

use crate::axis::{Axis, Edge};
use crate::error::{Error, Result};
use crate::grid::Grid;
use crate::image::Image;
use crate::kernel::Kernel;
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
    let over = |axis: Axis, n: usize| {
        let start = axis.start() - 0.5 * axis.step();
        Ok(Axis::cells(start..start + axis.span(), n)?.in_unit(axis.unit()))
    };
    let grid = image.grid();
    resample(image, Grid::new(over(grid.x(), width)?, over(grid.y(), height)?)?, kernel, edge)
}

/// The image on any other grid: `Σ f_i k((x − x_i)/cT) / Σ k((x − x_i)/cT)` along each axis.
///
/// Where the new step is longer than the old one `T`, `c` is their ratio: the kernel widens and becomes the prefilter of
/// the new rate; otherwise it is 1. The weights of every pixel are divided by their sum, so that a constant stays the
/// constant whatever the kernel (except beside nothing, [`Edge::Zero`], where the sum counts what is not there). A kernel
/// so narrow that no pixel lies within its radius takes the nearest one.
///
/// The axis on which more is saved goes first. Exact to the rounding of the two sums, `2ε·taps·max|f|·Σ|k|/|Σk|`.
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
    if kernel.radius().is_infinite() {
        let what = "a resampling with the ideal kernel, which needs every pixel: filter in frequency instead";
        return Err(Error::Unsupported(what));
    }
    let across = taps(image.grid().x(), grid.x(), kernel, edge)?;
    let down = taps(image.grid().y(), grid.y(), kernel, edge)?;
    let ratio = |new: usize, old: usize| new as f64 / old as f64;
    let rows_first = ratio(grid.width(), image.width()) < ratio(grid.height(), image.height());
    let pixels = if rows_first {
        columns(&rows(image.pixels(), &across), &down)
    } else {
        rows(&columns(image.pixels(), &down), &across)
    };
    Ok(Image::trusted(grid, pixels))
}

/// For one new position: the old ones that it reads, and their weights.
type Taps = Vec<(usize, f64)>;

fn taps(old: Axis, new: Axis, kernel: &dyn Kernel, edge: Edge) -> Result<Vec<Taps>> {
    let stretch = (new.step() / old.step()).max(1.0);
    let radius = kernel.radius() * stretch;
    let (value, most) = ((2.0 * radius + 1.0) * new.len() as f64, 268_435_456.0);
    // not a number counts as too many
    if !matches!(value.partial_cmp(&most), Some(std::cmp::Ordering::Less)) {
        return Err(Error::Overflow { what: "the number of weights of a resampling", value, most });
    }
    let of = |x: f64| {
        let at = old.index_of(x);
        let (first, last) = ((at - radius).ceil() as i64, (at + radius).floor() as i64);
        let mut read: Vec<(i64, f64)> =
            (first..=last).map(|i| (i, kernel.at((at - i as f64) / stretch))).filter(|(_, w)| *w != 0.0).collect();
        let mut sum: f64 = read.iter().map(|(_, w)| w).sum();
        if read.is_empty() || sum == 0.0 {
            (read, sum) = (vec![(at.round() as i64, 1.0)], 1.0);
        }
        let inside = |(i, w): (i64, f64)| edge.index(i, old.len()).map(|i| (i, w / sum));
        read.into_iter().filter_map(inside).collect()
    };
    Ok(new.iter().map(of).collect())
}

/// Along the rows: every new pixel of a row is a sum over the old ones.
fn rows(pixels: &Array2<f64>, taps: &[Taps]) -> Array2<f64> {
    let mut out = Array2::zeros((pixels.nrows(), taps.len()));
    for (old, mut new) in pixels.rows().into_iter().zip(out.rows_mut()) {
        let old = old.as_slice().expect("rows are kept one after another");
        for (value, taps) in new.iter_mut().zip(taps) {
            *value = taps.iter().map(|&(i, w)| w * old[i]).sum();
        }
    }
    out
}

/// Along the columns: every new row is a sum of old rows, so that memory is read in its order.
fn columns(pixels: &Array2<f64>, taps: &[Taps]) -> Array2<f64> {
    let mut out = Array2::zeros((taps.len(), pixels.ncols()));
    for (mut new, taps) in out.rows_mut().into_iter().zip(taps) {
        for &(i, w) in taps {
            new.scaled_add(w, &pixels.row(i));
        }
    }
    out
}
