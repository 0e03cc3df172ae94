//! What the figures of the checkerboard share: its picture made by any pattern of samples, the exact one, and what theory
//! says of their difference (slides «Point vs. Supersampled» to «1 луч с джиттерингом»).

use crate::antialias::supersample::supersample;
use crate::error::Result;
use crate::field::checkerboard::Checkerboard;
use crate::field::{ExactMean, Field};
use crate::figure::common::unmarked;
use crate::figure::{Layer, Meaning, Panel, Tones};
use crate::grid::Grid;
use crate::image::Image;
use crate::image::dft::forward;
use crate::kernel::box_kernel::BoxKernel;
use crate::pattern::Pattern;
use crate::pattern::cells::Cells;
use crate::text::Text;
use ndarray::Array2;
use std::ops::Range;

/// The pictures are so many pixels wide and high.
pub(super) const SIDE: usize = 128;
/// All columns.
const ACROSS: Range<usize> = 0..SIDE;
/// The columns and rows that are shown: below them there are four squares and no surprise.
const SHOWN_ACROSS: Range<usize> = 4..SIDE - 4;
const SHOWN: Range<usize> = 0..SIDE / 2;
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

    /// The root mean square difference to the exact picture.
    pub(super) fn error(&self, image: &Image, rows: Range<usize>) -> f64 {
        let differences = part(&(image.pixels() - self.exact.pixels()), ACROSS, rows);
        (differences.iter().map(|d| d * d).sum::<f64>() / differences.len() as f64).sqrt()
    }

    /// What `cells` jittered samples a pixel are expected to err by.
    pub(super) fn expected(&self, cells: Cells<2>) -> Expected {
        let [nx, ny] = cells.along();
        let share = 1.0 / cells.total() as f64;
        let mut variances = Array2::zeros((SIDE, SIDE));
        let (mut mean, mut scatter) = (0.0, 0.0);
        for (j, i) in ROWS.flat_map(|j| (0..SIDE).map(move |i| (j, i))) {
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
            variances[[j, i]] = variance * share * share;
            mean += variance * share * share;
            scatter += (2.0 * variance * variance + fourth) * share.powi(4);
        }
        let pixels = (ROWS.len() * SIDE) as f64;
        Expected { variances, mean: mean / pixels, deviation: scatter.max(0.0).sqrt() / pixels }
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
    pub(super) variances: Array2<f64>,
    /// The mean square error of the picture.
    pub(super) mean: f64,
    /// The standard deviation of the mean square error of one picture.
    pub(super) deviation: f64,
}

/// The power spectrum of a picture's error in the rows [`ERRING`], zero frequency in the middle.
pub(super) fn error_power(board: &Board, image: &Image) -> Result<Image> {
    let error = image.pixels() - board.exact.pixels();
    Ok(forward(&Image::trusted(Grid::pixels(SIDE, ERRING.len())?, part(&error, ACROSS, ERRING))).power())
}

/// The power spectrum of the error along one row, at the positive frequencies below Nyquist.
pub(super) fn row_power(board: &Board, image: &Image, row: usize) -> Result<Vec<[f64; 2]>> {
    let error = part(&(image.pixels() - board.exact.pixels()), ACROSS, row..row + 1);
    let power = forward(&Image::trusted(Grid::pixels(SIDE, 1)?, error)).power();
    let positive = power.grid().x().iter().zip(power.values()).filter(|(nu, _)| *nu > 0.0);
    Ok(positive.map(|(nu, p)| [nu, *p]).collect())
}

/// A part of the pixels.
pub(super) fn part(pixels: &Array2<f64>, columns: Range<usize>, rows: Range<usize>) -> Array2<f64> {
    Array2::from_shape_fn((rows.len(), columns.len()), |(j, i)| pixels[[rows.start + j, columns.start + i]])
}

/// The powers of all bins but the mean's.
pub(super) fn bins(power: &Image) -> Vec<f64> {
    let middle = power.grid().len() / 2 + power.width() / 2;
    power.values().iter().enumerate().filter(|(k, _)| *k != middle).map(|(_, p)| *p).collect()
}

/// A part of a picture, as it is seen: the first row on top.
fn view(name: &'static str, title: Text, image: &Image, columns: Range<usize>, rows: Range<usize>) -> Panel {
    raster(name, title, &part(image.pixels(), columns.clone(), rows.clone()), columns, rows, ((0.0, 1.0), Tones::Grey))
}

/// Values of all pixels, as many of them as are shown, in tones for the range of the values.
pub(super) fn map(name: &'static str, title: Text, values: &Array2<f64>, tones: ((f64, f64), Tones)) -> Panel {
    raster(name, title, &part(values, SHOWN_ACROSS, SHOWN), SHOWN_ACROSS, SHOWN, tones)
}

fn raster(
    name: &'static str,
    title: Text,
    values: &Array2<f64>,
    columns: Range<usize>,
    rows: Range<usize>,
    (range, tones): ((f64, f64), Tones),
) -> Panel {
    let ends = |range: Range<usize>| (range.start as f64, range.end as f64);
    let (x, y) = (ends(columns), ends(rows));
    Panel::new(name, title, unmarked(x.0, x.1), unmarked(y.1, y.0)).square().with(Layer::raster(
        "pixels",
        x,
        y,
        values.clone(),
        range,
        tones,
    ))
}

/// A picture, as much of it as is shown.
pub(super) fn whole(name: &'static str, title: Text, image: &Image) -> Panel {
    view(name, title, image, SHOWN_ACROSS, SHOWN)
}

/// The part near the horizon, enlarged.
pub(super) fn enlarged(name: &'static str, image: &Image) -> Panel {
    view(name, Text::EMPTY, image, COLUMNS, NEAR_HORIZON)
}

/// The frame of the part that is enlarged.
pub(super) fn frame() -> Layer {
    let [x0, x1, y0, y1] = [COLUMNS.start, COLUMNS.end, NEAR_HORIZON.start, NEAR_HORIZON.end].map(|v| v as f64);
    Layer::line("part", Meaning::Error, [[x0, y0], [x1, y0], [x1, y1], [x0, y1], [x0, y0]])
}
