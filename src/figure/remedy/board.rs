//! What the figures of the checkerboard share: its picture made by any pattern of samples, the exact one, and what theory
//! says of their difference (slides «Point vs. Supersampled» to «1 луч с джиттерингом»).

use crate::antialias::supersample::supersample;
use crate::error::Result;
use crate::field::checkerboard::Checkerboard;
use crate::field::{ExactMean, Field};
use crate::figure::picture::{frame, part, picture};
use crate::figure::{Layer, Meaning, Panel};
use crate::grid::Grid;
use crate::image::Image;
use crate::image::dft::forward;
use crate::kernel::box_kernel::BoxKernel;
use crate::parallel;
use crate::pattern::Pattern;
use crate::pattern::cells::Cells;
use crate::text::Text;
use std::ops::Range;

/// The pictures are so many pixels wide and high.
pub(super) const SIDE: usize = 128;
/// All columns.
const ACROSS: Range<usize> = 0..SIDE;
/// The columns and rows that are shown: below them there are four squares and no surprise.
const SHOWN_ACROSS: Range<usize> = 4..SIDE - 4;
pub(super) const SHOWN: Range<usize> = 0..SIDE / 2;
/// Those with the most to see, where there is less room.
pub(super) const UPPER: Range<usize> = 0..48;
/// The part that is shown enlarged.
const COLUMNS: Range<usize> = 40..88;
pub(super) const NEAR_HORIZON: Range<usize> = 0..16;
/// The rows that pictures are compared in: without the first one, which touches the horizon, where there is no end of
/// squares.
pub(super) const ROWS: Range<usize> = 1..SIDE;
/// The rows in which the squares are smaller than a pixel or not much larger.
pub(super) const FAR: Range<usize> = 1..11;
/// The rows whose error is transformed: those with visible errors.
pub(super) const ERRING: Range<usize> = 1..25;

/// The checkerboard in perspective and its exact pixels.
pub(super) struct Board {
    pub(super) scene: Checkerboard,
    pub(super) exact: Image,
}

impl Board {
    pub(super) fn new() -> Result<Self> {
        let scene = Checkerboard::lecture(SIDE)?;
        Ok(Self { exact: Image::averaged(&BelowHorizon(&scene), Grid::pixels(SIDE, SIDE)?), scene })
    }

    /// The picture whose pixels are means of samples.
    pub(super) fn sampled(&self, pattern: &dyn Pattern<2>, seed: u64) -> Result<Image> {
        supersample(&self.scene, self.exact.grid(), pattern, &BoxKernel, seed)
    }

    /// By how much every pixel differs from the exact picture.
    pub(super) fn differences(&self, image: &Image) -> Image {
        Image::trusted(self.exact.grid(), image.pixels() - self.exact.pixels())
    }

    /// The root mean square difference to the exact picture.
    pub(super) fn error(&self, image: &Image, rows: Range<usize>) -> f64 {
        let differences = self.differences(image);
        let of_rows = &differences.values()[rows.start * SIDE..rows.end * SIDE];
        (of_rows.iter().map(|d| d * d).sum::<f64>() / of_rows.len() as f64).sqrt()
    }

    /// What `cells` jittered samples a pixel are expected to err by.
    pub(super) fn expected(&self, cells: Cells<2>) -> Result<Expected> {
        let [nx, ny] = cells.along();
        let share = 1.0 / cells.total() as f64;
        // the variance of every pixel's sum, and its fourth cumulant
        let pixel = |i: usize, j: usize| {
            let (mut variance, mut fourth) = (0.0, 0.0);
            for k in 0..cells.total() {
                let [a, b] = cells.of(k);
                let part = |start: usize, k: usize, n: usize| [0, 1].map(|e| start as f64 + (k + e) as f64 / n as f64);
                // a sample of a black-and-white picture is one with the probability p
                let p = self.scene.mean(part(i, a, nx), part(j, b, ny)).clamp(0.0, 1.0);
                let own = p * (1.0 - p);
                variance += own;
                fourth += own * (1.0 - 6.0 * own);
            }
            [variance, fourth]
        };
        let sums = parallel::map(ROWS.len(), |j| (0..SIDE).map(|i| pixel(i, ROWS.start + j)).collect::<Vec<_>>());
        let mut variances = vec![0.0; ROWS.start * SIDE];
        variances.extend(sums.iter().flatten().map(|[variance, _]| variance * share * share));
        let pixels = (ROWS.len() * SIDE) as f64;
        let scatter: f64 = sums.iter().flatten().map(|[v, fourth]| (2.0 * v * v + fourth) * share.powi(4)).sum();
        let variances = Image::new(self.exact.grid(), variances)?;
        let mean = variances.values().iter().sum::<f64>() / pixels;
        Ok(Expected { variances, mean, deviation: scatter.max(0.0).sqrt() / pixels })
    }
}

/// The checkerboard, half grey at the horizon's edge: the last 64th of a row has as many squares as all the rest, and they
/// add at most `½·(1/64)²/2` to a pixel of the first row, which is shown and not compared.
struct BelowHorizon<'a>(&'a Checkerboard);

impl Field for BelowHorizon<'_> {
    fn at(&self, x: f64, y: f64) -> f64 {
        self.0.at(x, y)
    }
}

impl ExactMean for BelowHorizon<'_> {
    fn mean(&self, x: [f64; 2], [y0, y1]: [f64; 2]) -> f64 {
        let edge = y0.max(1.0 / 64.0);
        (self.0.mean(x, [edge, y1]) * (y1 - edge) + 0.5 * (edge - y0)) / (y1 - y0)
    }
}

/// What theory says of jittered samples: in every cell a sample is white with the probability `p` of its exact area, all
/// independent. The mean of `N` has the variance `Σ p(1 − p)/N²`, and its square that of a sum of such.
pub(super) struct Expected {
    /// Of every pixel; zero in the row at the horizon.
    pub(super) variances: Image,
    /// The mean square error of the picture.
    pub(super) mean: f64,
    /// The standard deviation of the mean square error of one picture.
    pub(super) deviation: f64,
}

/// The power spectrum of a picture's error in the rows [`ERRING`], zero frequency in the middle.
pub(super) fn error_power(board: &Board, image: &Image) -> Result<Image> {
    Ok(forward(&part(&board.differences(image), ACROSS, ERRING)?).power())
}

impl Expected {
    /// The mean of the variances in one row: the power that jitter's error has there at every frequency.
    pub(super) fn of_row(&self, row: usize) -> f64 {
        self.variances.row(row).iter().sum::<f64>() / SIDE as f64
    }
}

/// The power spectrum of the error along one row, at the positive frequencies below Nyquist.
pub(super) fn row_power(board: &Board, image: &Image, row: usize) -> Result<Vec<[f64; 2]>> {
    let power = forward(&part(&board.differences(image), ACROSS, row..row + 1)?).power();
    let positive = power.grid().x().iter().zip(power.values()).filter(|(nu, _)| *nu > 0.0);
    Ok(positive.map(|(nu, p)| [nu, *p]).collect())
}

/// The powers of all bins but the mean's.
pub(super) fn bins(power: &Image) -> Vec<f64> {
    let middle = power.grid().len() / 2 + power.width() / 2;
    power.values().iter().enumerate().filter(|(k, _)| *k != middle).map(|(_, p)| *p).collect()
}

/// Some rows of a picture, from side to side.
pub(super) fn shown(name: &'static str, title: Text, image: &Image, rows: Range<usize>) -> Result<Panel> {
    Ok(picture(name, title, &across(image, rows)?))
}

/// Some rows of pixels, as far as they are shown.
pub(super) fn across(image: &Image, rows: Range<usize>) -> Result<Image> {
    part(image, SHOWN_ACROSS, rows)
}

/// The part near the horizon, enlarged.
pub(super) fn enlarged(name: &'static str, image: &Image) -> Result<Panel> {
    Ok(picture(name, Text::EMPTY, &part(image, COLUMNS, NEAR_HORIZON)?))
}

/// The frame of the part that is enlarged.
pub(super) fn outline() -> Layer {
    let [x, y] = [COLUMNS, NEAR_HORIZON].map(|range| [range.start, range.end].map(|v| v as f64));
    frame("part", Meaning::Error, x, y)
}
