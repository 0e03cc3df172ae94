//! Blue noise by void and cluster: a tile of thresholds, and points.

use crate::error::{Error, Result, within};
use crate::num::random::{below, bits, uniform};
use crate::pattern::cells::within_cell;
use crate::pattern::void_cluster::{BLOCK, Gaussian, Order, order};
use crate::pattern::{Pattern, countable};

/// A square of ranks whose every level is a blue-noise pattern: for any `k` the cells of rank below `k` are `k` dots as far
/// from each other as can be, on the torus (Ulichney 1993).
///
/// A matrix to dither with, and to offset the samples of neighbouring pixels so that their errors, too, are noise of high
/// frequencies (E11 b). Computed, in a time that is about 2 µs a cell; the same for the same side and seed.
///
/// ```
/// use nyquist::pattern::blue_noise::Tile;
/// let tile = Tile::new(32, 0)?;
/// // a constant of 1/16 dithered: one cell in 16, none beside another
/// let dot = |x: usize, y: usize| tile.threshold(x, y) < 1.0 / 16.0;
/// let dots: Vec<_> = (0..1024).map(|i| (i % 32, i / 32)).filter(|&(x, y)| dot(x, y)).collect();
/// assert_eq!(dots.len(), 64);
/// assert!(dots.iter().all(|&(x, y)| !dot(x + 1, y) && !dot(x, y + 1) && !dot(x + 1, y + 1)));
/// # Ok::<(), nyquist::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Tile {
    side: usize,
    ranks: Vec<u32>,
}

impl Tile {
    /// The largest tile that can be made, a million cells.
    pub const MOST_SIDE: usize = 1024;

    /// A tile of `side × side` cells.
    ///
    /// # Errors
    /// A side that is not a multiple of 8 from 16 to [`Tile::MOST_SIDE`]; the error names the nearest.
    pub fn new(side: usize, seed: u64) -> Result<Self> {
        within("the side of a blue-noise tile", side as f64, 16.0, Self::MOST_SIDE as f64)?;
        if !side.is_multiple_of(BLOCK) {
            let below = side - side % BLOCK;
            return Err(Error::Count {
                what: "the side of a blue-noise tile",
                given: side,
                below,
                above: below + BLOCK,
            });
        }
        let mut ranks = vec![0; side * side];
        let wanted = Order { side, dots: side * side / 10, gaussian: Gaussian::ULICHNEY, whole: true };
        for (cell, rank) in order(wanted, seed).into_iter().zip(0..) {
            ranks[cell as usize] = rank;
        }
        Ok(Self { side, ranks })
    }

    /// Cells along a side.
    pub fn side(&self) -> usize {
        self.side
    }

    /// The rank of a cell, from `0` to `side² − 1`, each once; the tile repeats.
    pub fn rank(&self, x: usize, y: usize) -> u32 {
        self.ranks[(y % self.side) * self.side + x % self.side]
    }

    /// `(rank + ½)/side²`: of thresholds below `t` there is a part `t`.
    pub fn threshold(&self, x: usize, y: usize) -> f64 {
        (f64::from(self.rank(x, y)) + 0.5) / (self.side * self.side) as f64
    }
}

/// Points in cells chosen by void and cluster, one random place in each.
///
/// The noise around zero frequency is half of that of a Poisson disk pattern (0.03), the number of points is exactly the
/// one asked for, and every beginning of the pattern is blue noise, too (down to a tenth; fewer do not see
/// each other). The cells are a sixteenth of the share of a point, and chosen once, at construction, in about 6 µs a
/// point; a seed shifts the pattern on the torus and draws the places in the cells.
///
/// Order: of rank.
///
/// ```
/// use nyquist::prelude::*;
/// let points = BlueNoise::new(256)?.points(1);
/// assert_eq!(points.len(), 256);
/// let low = |points: &[[f64; 2]]| Ok::<_, Error>(rings(&Periodogram::of(points, 8)?, 8.0)?[0].power);
/// assert!(low(&points)? < 0.5 * low(&Jittered::<2>::new([16, 16])?.points(1))?);
/// # use nyquist::pattern::measure::radial::rings;
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct BlueNoise {
    side: usize,
    cells: Vec<u32>,
}

impl BlueNoise {
    /// The most points: their cells are those of the largest tile.
    pub const MOST: usize = Tile::MOST_SIDE * Tile::MOST_SIDE / 16;

    /// So many points.
    ///
    /// # Errors
    /// No points, or more than [`BlueNoise::MOST`].
    pub fn new(count: usize) -> Result<Self> {
        if countable(count)? > Self::MOST {
            let what = "the number of points of a blue-noise pattern";
            return Err(Error::Overflow { what, value: count as f64, most: Self::MOST as f64 });
        }
        let side = (4.0 * (count as f64).sqrt() / BLOCK as f64).ceil() as usize * BLOCK;
        let side = side.max(2 * BLOCK);
        // half the distance of neighbours, which are four cells apart: the least noise at low frequencies
        let wanted = Order { side, dots: count, gaussian: Gaussian::WIDE, whole: false };
        Ok(Self { side, cells: order(wanted, 0) })
    }
}

impl Pattern<2> for BlueNoise {
    fn name(&self) -> String {
        "blue-noise".into()
    }

    fn count(&self) -> Option<usize> {
        Some(self.cells.len())
    }

    fn points(&self, seed: u64) -> Vec<[f64; 2]> {
        let shift = [2, 3].map(|d| below(bits(seed, 0, d), self.side as u64) as usize);
        let point = |(i, cell): (usize, &u32)| {
            let at = [*cell as usize % self.side, *cell as usize / self.side];
            std::array::from_fn(|d| {
                let shifted = (at[d] + shift[d]) % self.side;
                within_cell(shifted as u64, self.side as u64, uniform(seed, i as u64, d as u32))
            })
        };
        self.cells.iter().enumerate().map(point).collect()
    }
}
