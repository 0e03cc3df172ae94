//! Convolution of images, by FFT and directly.

use crate::axis::{Axis, Edge};
use crate::engine::fft::fast_length;
use crate::error::{Error, Result, all_finite};
use crate::grid::Grid;
use crate::image::dft::{forward, inverse};
use crate::image::{Image, ImageBins};
use ndarray::{Array2, Slice};

/// `(f ⊗ g)(x, y) ≈ ΔxΔy Σ f(x_i, y_j) g(x − x_i, y − y_j)`: the linear convolution, as large as both together less one.
///
/// As for [samples](crate::sampled::convolution::convolve): the trapezoid rule for the integral, computed by FFT to a
/// rounding error of about `ε·log n·‖f‖‖g‖`.
///
/// ```
/// use nyquist::prelude::*;
/// use nyquist::image::convolution::convolve;
/// let dot = Image::new(Grid::centered(1.0, 1, 1)?, vec![2.0])?;
/// let image = Image::of(&field_fn(|x, y| x - y), Grid::pixels(3, 2)?);
/// let twice = convolve(&image, &dot)?;
/// assert_eq!(twice.grid(), image.grid());
/// assert!(twice.rmse(&image.map(|v| 2.0 * v))? < 1e-15);
/// # Ok::<(), Error>(())
/// ```
///
/// # Errors
/// Steps that differ, a result with more than [`Grid::MOST`] pixels.
pub fn convolve(f: &Image, g: &Image) -> Result<Image> {
    let (x, y) = (joined(f.grid().x(), g.grid().x())?, joined(f.grid().y(), g.grid().y())?);
    let grid = Grid::new(x, y)?;
    let padded = |image: &Image| -> Result<ImageBins> {
        let longer = |axis: Axis, n: usize| Axis::new(axis.start(), axis.step(), fast_length(n));
        let grid = Grid::new(longer(image.grid().x(), x.len())?, longer(image.grid().y(), y.len())?)?;
        let mut pixels = Array2::zeros((grid.height(), grid.width()));
        pixels.slice_each_axis_mut(|ax| Slice::from(..image.pixels().len_of(ax.axis))).assign(image.pixels());
        Ok(forward(&Image::trusted(grid, pixels)))
    };
    let (bins_f, bins_g) = (padded(f)?, padded(g)?);
    let space = Grid::new(
        Axis::new(x.start(), x.step(), bins_f.space().width())?,
        Axis::new(y.start(), y.step(), bins_f.space().height())?,
    )?;
    let product = bins_f.values() * bins_g.values();
    let whole = inverse(&ImageBins::trusted(space, product));
    let size = [grid.height(), grid.width()];
    let part =
        whole.pixels().slice_each_axis(|ax| Slice::from(..size[ax.axis.index()])).as_standard_layout().to_owned();
    Ok(Image::trusted(grid, part))
}

fn joined(a: Axis, b: Axis) -> Result<Axis> {
    // steps from different quotients may differ in the last bits
    if (a.step() - b.step()).abs() > 4.0 * f64::EPSILON * a.step() {
        return Err(Error::Unsupported("two images with different steps"));
    }
    Ok(Axis::new(a.start() + b.start(), a.step(), a.len() + b.len() - 1)?.in_unit(a.unit()))
}

/// `Σ_{k,l} across[k]·down[l]·f(i + r − k, j + s − l)`: convolution with a separable kernel given by its taps, directly,
/// rows first; the size stays. The middle tap, number `len/2`, stands on the pixel. Beyond its sides the image goes on as
/// `edge` says.
///
/// Costs the number of taps, added up over both directions, for every pixel. The taps are plain weights, without the
/// pixel's area.
///
/// ```
/// use nyquist::prelude::*;
/// use nyquist::image::convolution::convolve_separable;
/// let image = Image::new(Grid::pixels(3, 1)?, vec![0.0, 1.0, 0.0])?;
/// let soft = convolve_separable(&image, &[0.25, 0.5, 0.25], &[1.0], Edge::Zero)?;
/// assert_eq!(soft.values(), [0.25, 0.5, 0.25]);
/// let shifted = convolve_separable(&image, &[0.0, 0.0, 1.0], &[1.0], Edge::Zero)?;
/// assert_eq!(shifted.values(), [0.0, 0.0, 1.0]); // a convolution, not a correlation
/// # Ok::<(), Error>(())
/// ```
///
/// # Errors
/// No taps, or taps that are not finite.
pub fn convolve_separable(image: &Image, across: &[f64], down: &[f64], edge: Edge) -> Result<Image> {
    all_finite("the taps across", across)?;
    all_finite("the taps down", down)?;
    let (nx, ny) = (image.width(), image.height());
    // where output i reads with tap k
    let source = |i: usize, k: usize, taps: usize, n: usize| edge.index((i + taps / 2) as i64 - k as i64, n);
    let mut rows = Array2::zeros((ny, nx));
    for (j, mut out) in rows.rows_mut().into_iter().enumerate() {
        let row = image.row(j);
        for (i, value) in out.iter_mut().enumerate() {
            let read = |(k, w): (usize, &f64)| source(i, k, across.len(), nx).map_or(0.0, |at| w * row[at]);
            *value = across.iter().enumerate().map(read).sum();
        }
    }
    let mut pixels = Array2::zeros((ny, nx));
    for (j, mut out) in pixels.rows_mut().into_iter().enumerate() {
        for (l, &w) in down.iter().enumerate() {
            if let Some(at) = source(j, l, down.len(), ny) {
                out.scaled_add(w, &rows.row(at));
            }
        }
    }
    Ok(Image::trusted(image.grid(), pixels))
}
