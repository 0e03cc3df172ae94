//! Several samples a pixel: a finer rate first, the pixel's filter afterwards.

use crate::error::{Error, Result};
use crate::field::Field;
use crate::film::{Film, Sample};
use crate::grid::Grid;
use crate::image::Image;
use crate::kernel::Kernel;
use crate::num::random::bits;
use crate::parallel;
use crate::pattern::Pattern;

/// The seed of a pixel's own pattern: patterns of different pixels are independent.
pub fn pixel_seed(seed: u64, column: i64, row: i64) -> u64 {
    const PIXELS: u32 = 0x7069_7865; // a dimension that no pattern uses
    bits(bits(seed, column as u64, PIXELS), row as u64, PIXELS)
}

/// A picture of a field by a pattern of samples in every pixel, weighed by a kernel: regular, random and jittered
/// supersampling, low discrepancy and blue noise differ in the pattern only.
///
/// Every pixel has the pattern of its own seed, so that what is random is independent from pixel to pixel; the samples of
/// the pixels just beyond the frame are taken too, as far as the kernel reaches. A pure function of its arguments: the
/// same bits for any number of threads.
///
/// ```
/// use nyquist::prelude::*;
/// let (board, grid) = (Checkerboard::lecture(32)?, Grid::pixels(32, 32)?);
/// let exact = Image::averaged(&board, grid);
/// let error = |pattern: &dyn Pattern<2>| supersample(&board, grid, pattern, &BoxKernel, 1)?.rmse(&exact);
/// let [regular, jittered] = [error(&Regular::<2>::new([4, 4])?)?, error(&Jittered::<2>::new([4, 4])?)?];
/// assert!(jittered < regular); // and what is left of it is noise instead of structure
/// # Ok::<(), Error>(())
/// ```
///
/// # Errors
/// A kernel of infinite radius.
pub fn supersample(
    field: &(impl Field + Sync),
    grid: Grid,
    pattern: &dyn Pattern<2>,
    kernel: &dyn Kernel,
    seed: u64,
) -> Result<Image> {
    let film = Film::new(grid, kernel)?;
    let reach = film.reach() as i64;
    let (width, step) = (grid.width() as i64, [grid.x().step(), grid.y().step()]);
    let exposure = film.expose(|row| {
        let columns = -reach..width + reach;
        let samples = columns.flat_map(|column| {
            let [middle_x, middle_y] = grid.at(column, row);
            pattern.points(pixel_seed(seed, column, row)).into_iter().map(move |[u, v]| {
                let at = [middle_x + (u - 0.5) * step[0], middle_y + (v - 0.5) * step[1]];
                Sample { at, light: [field.at(at[0], at[1])] }
            })
        });
        samples.collect::<Vec<_>>()
    });
    let [image] = exposure.planes().clone();
    Ok(image)
}

/// A place in the pixel, from `[0, 1)²`, and how much the sample there counts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tap {
    /// Where in the pixel.
    pub at: [f64; 2],
    /// Its weight `w_s`.
    pub weight: f64,
}

/// `Pixel = Σ_s w_s·Sample_s` with the same samples in every pixel (Φ13, slide «Однородный супер-сэмплинг»).
///
/// A digital filter at the finer rate, and then only every n-th value kept: its transfer is `Σ w_s e^{2πi(u·x_s + v·y_s)}`,
/// periodic where the samples are regular. The weights must add up to one, or the picture becomes darker or brighter;
/// the lecture does not say so.
///
/// ```
/// use nyquist::prelude::*;
/// use nyquist::antialias::supersample::{Tap, weighted};
/// let grid = Grid::pixels(2, 2)?;
/// let tap = |x, weight| Tap { at: [x, 0.5], weight };
/// let picture = weighted(&field_fn(|x, _| x), grid, &[tap(0.25, 0.75), tap(0.75, 0.25)])?;
/// assert_eq!(picture.at(1, 0), 1.375); // the mean of 1.25 and 1.75, the first counting three times
/// assert!(weighted(&field_fn(|x, _| x), grid, &[tap(0.5, 0.9)]).is_err()); // a tenth of the light is lost
/// # Ok::<(), Error>(())
/// ```
///
/// # Errors
/// No samples; places or weights that are not finite; weights that do not add up to 1 to the rounding of their sum, `2ε`
/// times the sum of their amounts for every tap.
pub fn weighted(field: &(impl Field + Sync), grid: Grid, taps: &[Tap]) -> Result<Image> {
    if taps.is_empty() {
        return Err(Error::TooFew { what: "samples of a pixel", least: 1, got: 0 });
    }
    let numbers: Vec<f64> = taps.iter().flat_map(|t| [t.at[0], t.at[1], t.weight]).collect();
    crate::error::all_finite("places and weights of samples", &numbers)?;
    let (sum, amounts) = taps.iter().fold((0.0, 0.0), |(s, a), t| (s + t.weight, a + t.weight.abs()));
    let slack = 2.0 * f64::EPSILON * taps.len() as f64 * amounts;
    if !amounts.is_finite() || (sum - 1.0).abs() > slack {
        let what = "the sum of the weights of a pixel's samples";
        return Err(Error::OutOfRange { what, value: sum, low: 1.0 - slack, high: 1.0 + slack });
    }
    let [dx, dy] = [grid.x().step(), grid.y().step()];
    let rows = parallel::map(grid.height(), |j| {
        let pixel = |i: usize| -> f64 {
            let [x, y] = grid.at(i as i64, j as i64);
            let light = |t: &Tap| t.weight * field.at(x + (t.at[0] - 0.5) * dx, y + (t.at[1] - 0.5) * dy);
            taps.iter().map(light).sum()
        };
        (0..grid.width()).map(pixel).collect::<Vec<f64>>()
    });
    Image::new(grid, rows.concat())
}
