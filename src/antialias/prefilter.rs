//! Filtering before sampling: no sample is taken of what the pixels cannot show.

use crate::axis::{Axis, Edge};
use crate::error::{Error, Result};
use crate::field::ExactMean;
use crate::grid::Grid;
use crate::image::Image;
use crate::image::resize::resample;
use crate::kernel::Kernel;

/// Samples of `f ⊗ k` on a grid: the field behind a prefilter with that kernel, a pixel wide a step.
///
/// The convolution is a sum over the field's exact means in `parts × parts` cells a pixel, weighted by the kernel at
/// their middles. So a frequency `ν` (in cycles per pixel, along one axis) is passed with
/// `sinc(ν/parts)·Σ_m s^m K(ν + m·parts)/Σ_m s^m K(m·parts)`, where `s` is −1 for an even number of parts, whose middles
/// stand half a cell beside the pixel's centre, and 1 for an odd one. That is the kernel's response to `O((ν/parts)²)`,
/// and what lies near multiples of `parts` cycles is held back by the exact mean, `sinc` being zero there. A constant
/// stays the constant.
///
/// ```
/// use nyquist::prelude::*;
/// use nyquist::antialias::prefilter::prefiltered;
/// let grid = Grid::pixels(40, 1)?;
/// let fine = Grating::new([0.9, 0.0])?; // beyond Nyquist: whatever is left of it is an alias
/// let left = |image: &Image| image.values().iter().fold(0.0, |most: f64, v| most.max(v.abs()));
/// let area = left(&Image::averaged(&fine, grid));
/// let lanczos = left(&prefiltered(&fine, grid, &Lanczos::new(3.0)?, 16)?);
/// assert!(area > 0.1 && lanczos < 0.02);
/// # Ok::<(), Error>(())
/// ```
///
/// # Errors
/// No parts, a kernel of infinite radius, more than [`Grid::MOST`] cells in all.
pub fn prefiltered(field: &impl ExactMean, grid: Grid, kernel: &dyn Kernel, parts: usize) -> Result<Image> {
    if parts == 0 {
        return Err(Error::TooFew { what: "parts of a pixel", least: 1, got: 0 });
    }
    if kernel.radius().is_infinite() {
        return Err(Error::Unsupported("a prefilter with the ideal kernel, which needs the field everywhere"));
    }
    // as many pixels beyond the frame as the kernel reaches, and one for the half pixels at its ends
    let beyond = kernel.radius().ceil() + 1.0;
    let finer = |axis: Axis| {
        let (start, end) = (axis.start() - (beyond + 0.5) * axis.step(), axis.at(axis.len() as i64 - 1));
        let cells = (axis.len() as f64 + 2.0 * beyond) * parts as f64;
        if cells > Grid::MOST as f64 {
            let what = "the number of cells of a prefilter along one axis";
            return Err(Error::Overflow { what, value: cells, most: Grid::MOST as f64 });
        }
        Axis::cells(start..end + (beyond + 0.5) * axis.step(), cells as usize)
    };
    let means = Image::averaged(field, Grid::new(finer(grid.x())?, finer(grid.y())?)?);
    resample(&means, grid, kernel, Edge::Clamp)
}
