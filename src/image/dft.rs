//! The discrete Fourier transform of images in physical units.

use crate::axis::Axis;
use crate::engine::fft::{Butterflies, PlaneFft};
use crate::grid::Grid;
use crate::image::{Image, ImageBins};
use crate::num::{cos_pi, sin_pi};
use ndarray::Array2;
use num_complex::Complex;

/// `F(u_k, v_l) = ΔxΔy Σ f(x_i, y_j) e^{−2πi(u_k x_i + v_l y_j)}` at the frequencies of the dual grid.
///
/// The conventions are those of [`sampled::dft::forward`](crate::sampled::dft::forward), on both axes: samples of the
/// continuous transform up to aliasing, the phase knows where the image starts, frequencies rise with zero at column
/// `width/2` and row `height/2`. The transform is separable: first along the columns, two real ones as one complex, then
/// along the rows that symmetry does not repeat; `O(n log n)` for any size, and the same bits on every processor and for any
/// number of threads. (A [`PlaneFft`] of the engine is faster by whatever this processor has, and goes in `f32`, too.)
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
    let grid = image.grid();
    let mut bins = Array2::zeros((grid.height(), grid.width()));
    plan(grid).forward(image.values(), bins.as_slice_mut().expect(ROWS)).expect(POSITIONS);
    ImageBins::trusted(grid, bins)
}

/// The power spectrum `|F|²/area` of an image: that of its [bins](ImageBins::power), which are not kept.
///
/// ```
/// use nyquist::prelude::*;
/// let image = Image::of(&field_fn(|x, y| (3.0 * x).sin() + y * y), Grid::cells(0.0..1.0, 5, -2.0..2.0, 6)?);
/// let power = image_power(&image);
/// assert!(power.rmse(&image_forward(&image).power())? < 1e-15);
/// # Ok::<(), Error>(())
/// ```
pub fn power(image: &Image) -> Image {
    let grid = image.grid();
    let mut power = Array2::zeros((grid.height(), grid.width()));
    plan(grid).power(image.values(), power.as_slice_mut().expect(ROWS)).expect(POSITIONS);
    Image::trusted(grid.dual(), power)
}

fn plan(grid: Grid) -> PlaneFft<f64> {
    PlaneFft::with(grid, Butterflies::Scalar)
}

const ROWS: &str = "rows are kept one after another";
const POSITIONS: &str = "there are as many values as positions";

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
    let mut pixels = Array2::zeros((space.height(), space.width()));
    let values = bins.values().as_slice().expect(ROWS);
    plan(space).inverse(values, pixels.as_slice_mut().expect(ROWS)).expect(POSITIONS);
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
