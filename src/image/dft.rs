//! The discrete Fourier transform of images in physical units.

use crate::axis::Axis;
use crate::image::{Image, ImageBins};
use crate::num::{cos_pi, sin_pi};
use crate::parallel;
use crate::sampled::dft::phase;
use crate::sampled::plan::{Plan, RealPlan};
use ndarray::Array2;
use num_complex::Complex;

/// `F(u_k, v_l) = ΔxΔy Σ f(x_i, y_j) e^{−2πi(u_k x_i + v_l y_j)}` at the frequencies of the dual grid.
///
/// The conventions are those of [`sampled::dft::forward`](crate::sampled::dft::forward), on both axes: samples of the
/// continuous transform up to aliasing, the phase knows where the image starts, frequencies rise with zero at column
/// `width/2` and row `height/2`. The transform is separable: first along the rows, as real records at half the cost,
/// then along the `width/2 + 1` columns that symmetry does not repeat; `O(n log n)` for any size, and the same bits on
/// every processor and for any number of threads.
///
/// ```
/// use nyquist::prelude::*;
/// // an elongated, turned Gaussian, not in the middle of its picture, against its spectrum in closed form
/// let spot = Moved::new([1.5, -0.5], GaussianSpot::turned([1.0, 2.0], 0.6)?)?;
/// let bins = image_forward(&Image::of(&spot, Grid::cells(-14.0..14.0, 100, -14.0..12.0, 91)?));
/// let spectrum = spot.spectrum();
/// let errors = bins.grid().iter().zip(bins.values()).map(|([u, v], f)| (f - spectrum.density(u, v)).norm());
/// assert!(errors.fold(0.0, f64::max) < 1e-13); // of 2π
/// # Ok::<(), Error>(())
/// ```
pub fn forward(image: &Image) -> ImageBins {
    let (grid, left) = (image.grid(), half_plane(image));
    let (nx, ny) = (grid.width(), grid.height());
    let across = physical(grid.x());
    let down = physical(grid.y());
    let mut full = Array2::zeros((ny, nx));
    parallel::chunks(full.as_slice_mut().expect(ROWS), nx, |l, row| {
        // row l stands for the frequency l − ny/2; its opposite, modulo ny
        let here = (l + ny - ny / 2) % ny;
        let opposite = (ny - here) % ny;
        for (k, value) in row.iter_mut().enumerate() {
            let raw = match k.checked_sub(nx / 2) {
                Some(k) => left[[here, k]],
                // X(−k, −l) is the conjugate of X(k, l): the image is real
                None => left[[opposite, nx / 2 - k]].conj(),
            };
            *value = raw * (across[k] * down[l]);
        }
    });
    ImageBins::trusted(grid, full)
}

const ROWS: &str = "rows are kept one after another";

/// How many rows share their work space, and how many columns are gathered at a time: as many complex numbers as two
/// lines of a cache hold.
const TOGETHER: usize = 8;

/// The plain sums `X(k, l)` for `0 ≤ k ≤ nx/2` and all `l`, in plain order.
fn half_plane(image: &Image) -> Array2<Complex<f64>> {
    let (nx, ny) = (image.width(), image.height());
    let (plan, width) = (RealPlan::forward(nx), nx / 2 + 1);
    let mut half = Array2::zeros((ny, width));
    parallel::chunks(half.as_slice_mut().expect(ROWS), TOGETHER * width, |chunk, rows| {
        let mut work = Vec::new();
        for (j, row) in rows.chunks_exact_mut(width).enumerate() {
            plan.transform(image.row(chunk * TOGETHER + j), row, &mut work);
        }
    });
    columns(&mut half, &Plan::forward(ny));
    half
}

/// Transforms every column in place.
fn columns(values: &mut Array2<Complex<f64>>, plan: &Plan) {
    let (ny, nx) = values.dim();
    let rows = values.as_slice_mut().expect(ROWS);
    let blocks = parallel::map(nx.div_ceil(TOGETHER), |block| {
        let first = block * TOGETHER;
        let count = TOGETHER.min(nx - first);
        let mut work = vec![Complex::ZERO; count * ny];
        for (j, row) in rows.chunks_exact(nx).enumerate() {
            row[first..first + count].iter().enumerate().for_each(|(i, v)| work[i * ny + j] = *v);
        }
        plan.run(&mut work);
        work
    });
    parallel::chunks(rows, TOGETHER * nx, |chunk, rows| {
        for (block, work) in blocks.iter().enumerate() {
            for (j, row) in rows.chunks_exact_mut(nx).enumerate() {
                let (j, columns) = (chunk * TOGETHER + j, row[block * TOGETHER..].iter_mut().take(TOGETHER));
                columns.enumerate().for_each(|(i, v)| *v = work[i * ny + j]);
            }
        }
    });
}

/// `Δ·e^{−2πiν_k·start}` for the bins of one axis, in rising order.
fn physical(axis: Axis) -> Vec<Complex<f64>> {
    let n = axis.len() as i64;
    (0..n).map(|k| phase(k - n / 2, axis) * axis.step()).collect()
}

/// `f(x_i, y_j) = (1/area) Σ F(u_k, v_l) e^{2πi(u_k x_i + v_l y_j)}`: the image back from its bins, real part.
///
/// `inverse(forward(f))` is `f` to rounding. Of bins that are not the spectrum of a real image only the Hermitian part
/// counts, which is the spectrum of the real part.
///
/// ```
/// use nyquist::prelude::*;
/// let image = Image::of(&field_fn(|x, y| (3.0 * x).sin() + y * y), Grid::cells(0.0..1.0, 5, -2.0..2.0, 6)?);
/// let back = image_inverse(&image_forward(&image));
/// assert!(image.rmse(&back)? < 1e-15);
/// # Ok::<(), Error>(())
/// ```
pub fn inverse(bins: &ImageBins) -> Image {
    let space = bins.space();
    let (nx, ny) = (space.width(), space.height());
    let gain = 1.0 / space.area();
    let turns = |axis: Axis| {
        let n = axis.len() as i64;
        (0..n).map(|k| phase(k - n / 2, axis).conj()).collect::<Vec<_>>()
    };
    let (across, down) = (turns(space.x()), turns(space.y()));
    // without units, at the plain indices
    let raw = |k: usize, l: usize| {
        let (k, l) = ((k + nx / 2) % nx, (l + ny / 2) % ny);
        bins.values()[[l, k]] * (across[k] * down[l]) * gain
    };
    let mut half = Array2::from_shape_fn((ny, nx / 2 + 1), |(l, k)| {
        let mirrored = raw((nx - k) % nx, (ny - l) % ny).conj();
        0.5 * (raw(k, l) + mirrored)
    });
    columns(&mut half, &Plan::inverse(ny));
    let (plan, width) = (RealPlan::inverse(nx), nx / 2 + 1);
    let mut pixels = Array2::zeros((ny, nx));
    let half = half.as_slice().expect(ROWS);
    parallel::chunks(pixels.as_slice_mut().expect(ROWS), TOGETHER * nx, |chunk, rows| {
        let mut work = Vec::new();
        for (half, row) in half[chunk * TOGETHER * width..].chunks_exact(width).zip(rows.chunks_exact_mut(nx)) {
            plan.restore(half, row, &mut work);
        }
    });
    Image::trusted(space, pixels)
}

/// `ΔxΔy Σ f(x_i, y_j) e^{−2πi(ux_i + vy_j)}` at any frequency, by the direct sum in `O(n)`: what [`forward`] has at the
/// bins, between them.
///
/// ```
/// use nyquist::prelude::*;
/// use nyquist::image::dft::spectrum_at;
/// let image = Image::of(&field_fn(|x, y| x * y), Grid::pixels(7, 4)?);
/// let (bins, [u, v]) = (image_forward(&image), [2.0 / 7.0, -0.25]);
/// assert!((spectrum_at(&image, u, v) - bins.bin(2, -1)).norm() < 1e-12);
/// # Ok::<(), Error>(())
/// ```
pub fn spectrum_at(image: &Image, u: f64, v: f64) -> Complex<f64> {
    let grid = image.grid();
    let wave = |axis: Axis, nu: f64| {
        axis.iter().map(|x| Complex::new(cos_pi(2.0 * nu * x), -sin_pi(2.0 * nu * x))).collect::<Vec<_>>()
    };
    let (across, down) = (wave(grid.x(), u), wave(grid.y(), v));
    let row = |j: usize| image.row(j).iter().zip(&across).map(|(f, w)| w * f).sum::<Complex<f64>>();
    let sum: Complex<f64> = down.iter().enumerate().map(|(j, w)| w * row(j)).sum();
    sum * grid.pixel_area()
}
