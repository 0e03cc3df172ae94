//! Void and cluster: dots on a grid, as far from each other as can be, in an order that keeps them so.

use crate::num::random::bits;
use crate::pattern::permutation::permutation;

/// Where the Gaussian ends, in standard deviations: `e^{−6.66²/2}` is the `2⁻³²` in which it is counted.
const ENDS: f64 = 6.66;

/// The side of a block of cells whose extremes are kept.
pub(crate) const BLOCK: usize = 8;

/// A square torus of cells, some with dots on them, and how crowded each is: the sum of Gaussians around the dots.
///
/// Crowding is counted in whole numbers, so that it is exact however often dots come and go, with random low bits of its
/// own for each cell, so that ties are broken at random. The extremes of blocks and of rows of blocks are kept: moving a
/// dot costs the cells of its neighbourhood and the rows, not the whole torus.
#[derive(Debug, Clone)]
struct Torus {
    side: usize,
    dots: Vec<bool>,
    crowding: Vec<u64>,
    /// The Gaussian around a dot, in rows.
    gaussian: Vec<Vec<u64>>,
    radius: i64,
    blocks: Vec<Extremes>,
    rows: Vec<Extremes>,
}

/// The most crowded dot and the least crowded gap: crowding and cell.
#[derive(Debug, Clone, Copy)]
struct Extremes {
    dot: (u64, u32),
    gap: (u64, u32),
}

impl Extremes {
    const NONE: Self = Self { dot: (0, u32::MAX), gap: (u64::MAX, u32::MAX) };

    fn and(self, other: &Self) -> Self {
        Self { dot: self.dot.max(other.dot), gap: self.gap.min(other.gap) }
    }
}

impl Torus {
    /// With those dots; `sigma` is the deviation of the Gaussian in cells.
    fn new(side: usize, sigma: f64, seed: u64, dots: &[u32]) -> Self {
        let radius = (ENDS * sigma) as i64;
        let gaussian = |d: i64| (-0.5 * (d as f64 / sigma).powi(2)).exp();
        let value = |y: i64, x: i64| ((gaussian(x) * gaussian(y) * (1u64 << 32) as f64).round() as u64) << 16;
        let cells = side * side;
        let mut torus = Self {
            side,
            dots: vec![false; cells],
            crowding: (0..cells as u64).map(|i| bits(seed, i, 0) >> 48).collect(),
            gaussian: (-radius..=radius).map(|y| (-radius..=radius).map(|x| value(y, x)).collect()).collect(),
            radius,
            blocks: vec![Extremes::NONE; cells / (BLOCK * BLOCK)],
            rows: vec![Extremes::NONE; side / BLOCK],
        };
        dots.iter().for_each(|&cell| torus.crowd(cell as usize));
        (0..torus.blocks.len()).for_each(|block| torus.look_at_block(block));
        (0..torus.rows.len()).for_each(|row| torus.look_at_row(row));
        torus
    }

    /// The most crowded dot, if there are dots.
    fn cluster(&self) -> Option<usize> {
        let worst = self.rows.iter().fold(Extremes::NONE, Extremes::and).dot.1;
        (worst != u32::MAX).then_some(worst as usize)
    }

    /// The least crowded gap, if there are gaps.
    fn void(&self) -> Option<usize> {
        let best = self.rows.iter().fold(Extremes::NONE, Extremes::and).gap.1;
        (best != u32::MAX).then_some(best as usize)
    }

    /// Puts a dot where there is none, or takes it away.
    fn toggle(&mut self, cell: usize) {
        self.crowd(cell);
        let (block, across) = (BLOCK as i64, (self.side / BLOCK) as i64);
        let radius = self.radius;
        let touched = |at: usize| {
            let (first, last) = ((at as i64 - radius).div_euclid(block), (at as i64 + radius).div_euclid(block));
            (first..=last.min(first + across - 1)).map(move |b| b.rem_euclid(across) as usize)
        };
        for row in touched(cell / self.side) {
            touched(cell % self.side).for_each(|column| self.look_at_block(row * across as usize + column));
            self.look_at_row(row);
        }
    }

    /// [`Torus::toggle`] without looking for extremes.
    fn crowd(&mut self, cell: usize) {
        let side = self.side as i64;
        let (x, y) = ((cell % self.side) as i64, (cell / self.side) as i64);
        self.dots[cell] = !self.dots[cell];
        let more = self.dots[cell];
        for (weights, dy) in self.gaussian.iter().zip(-self.radius..) {
            let row = ((y + dy).rem_euclid(side) * side) as usize;
            let mut column = (x - self.radius).rem_euclid(side) as usize;
            for weight in weights {
                let crowding = &mut self.crowding[row + column];
                *crowding = if more { *crowding + weight } else { *crowding - weight };
                column = if column + 1 == self.side { 0 } else { column + 1 };
            }
        }
    }

    fn look_at_block(&mut self, block: usize) {
        let across = self.side / BLOCK;
        let corner = (block / across) * BLOCK * self.side + (block % across) * BLOCK;
        let mut extremes = Extremes::NONE;
        for y in 0..BLOCK {
            let start = corner + y * self.side;
            let cells = self.crowding[start..start + BLOCK].iter().zip(&self.dots[start..start + BLOCK]);
            for ((&crowding, &dot), cell) in cells.zip(start as u32..) {
                if dot && crowding >= extremes.dot.0 {
                    extremes.dot = (crowding, cell);
                } else if !dot && crowding < extremes.gap.0 {
                    extremes.gap = (crowding, cell);
                }
            }
        }
        self.blocks[block] = extremes;
    }

    fn look_at_row(&mut self, row: usize) {
        let across = self.side / BLOCK;
        let blocks = &self.blocks[row * across..(row + 1) * across];
        self.rows[row] = blocks.iter().fold(Extremes::NONE, Extremes::and);
    }
}

/// How many times its number of dots the first pattern may be rearranged; it comes to rest long before.
const MOST_MOVES: usize = 16;

/// What is to be ordered.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Order {
    /// Cells along a side of the torus, a multiple of [`BLOCK`].
    pub(crate) side: usize,
    /// The dots of the first pattern, `1 ≤ dots ≤ side²`.
    pub(crate) dots: usize,
    /// The deviation of the Gaussian by which crowding is measured, in cells.
    pub(crate) sigma: f64,
    /// Whether all cells are wanted, or only the first `dots`.
    pub(crate) whole: bool,
}

/// The cells in the order in which dots are to be put, void-and-cluster (Ulichney, *The void-and-cluster method for
/// dither array generation*, 1993).
///
/// Cells for the first pattern are chosen at random; then the most crowded dot moves to the least crowded gap until it
/// stays. From there dots are taken away, the most crowded first, which numbers the first cells from the last to the
/// first; and, for the others, put into the least crowded gap. On the torus that is also the most crowded gap of the
/// inverse pattern, which Ulichney takes for the second half.
pub(crate) fn order(wanted: Order, seed: u64) -> Vec<u32> {
    let Order { side, dots, sigma, whole } = wanted;
    let mut cells = permutation(bits(seed, 0, 1), side * side);
    cells.truncate(dots);
    let mut torus = Torus::new(side, sigma, seed, &cells);
    for _ in 0..MOST_MOVES * dots {
        let Some(cluster) = torus.cluster() else { break };
        torus.toggle(cluster);
        let Some(void) = torus.void() else { break };
        torus.toggle(void);
        if void == cluster {
            break;
        }
    }
    let mut rest = whole.then(|| torus.clone());
    cells.clear();
    while let Some(cluster) = torus.cluster() {
        torus.toggle(cluster);
        cells.push(cluster as u32);
    }
    cells.reverse();
    if let Some(torus) = &mut rest {
        while let Some(void) = torus.void() {
            torus.toggle(void);
            cells.push(void as u32);
        }
    }
    cells
}
