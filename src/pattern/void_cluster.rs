//! Void and cluster: dots on a grid, as far from each other as can be, in an order that keeps them so.

use crate::num::random::bits;
use crate::pattern::permutation::permutation;

/// The Gaussian `q^{d²}` by which crowding is measured, at whole distances `d`.
///
/// Given by `q = e^{−1/2σ²}` and its powers, not by the exponential function, whose last bits differ between machines.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Gaussian {
    decay: f64,
    radius: i64,
}

impl Gaussian {
    /// `σ = 1.5` cells (Ulichney 1993), to `2⁻³²` of its height.
    pub(crate) const ULICHNEY: Self = Self { decay: 0.800_737_402_916_808, radius: 10 };

    /// `σ = 2` cells, to `2⁻³²` of its height.
    pub(crate) const WIDE: Self = Self { decay: 0.882_496_902_584_595_4, radius: 13 };

    /// The Gaussian around a dot, in rows, as whole numbers of `2⁻³²`, sixteen bits up.
    fn table(&self) -> Vec<Vec<u64>> {
        let side: Vec<f64> =
            (-self.radius..=self.radius).map(|d| (0..d * d).fold(1.0, |power, _| power * self.decay)).collect();
        let cell = |y: f64, x: f64| ((y * x * (1u64 << 32) as f64).round() as u64) << 16;
        side.iter().map(|&y| side.iter().map(|&x| cell(y, x)).collect()).collect()
    }
}

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
    /// With those dots.
    fn new(side: usize, gaussian: Gaussian, seed: u64, dots: &[u32]) -> Self {
        let cells = side * side;
        let mut torus = Self {
            side,
            dots: vec![false; cells],
            crowding: (0..cells as u64).map(|i| bits(seed, i, 0) >> 48).collect(),
            gaussian: gaussian.table(),
            radius: gaussian.radius,
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
    /// How crowding is measured.
    pub(crate) gaussian: Gaussian,
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
    let Order { side, dots, gaussian, whole } = wanted;
    let mut cells = permutation(bits(seed, 0, 1), side * side);
    cells.truncate(dots);
    let mut torus = Torus::new(side, gaussian, seed, &cells);
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
