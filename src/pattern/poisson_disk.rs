//! Poisson disk patterns: random, but never too close.

use crate::error::{Error, Result, within};
use crate::num::random::{below, bits, unit, word};
use crate::pattern::{Pattern, countable};

/// Points uniform over the square on the condition that no two are nearer than `radius`: dart throwing (Dippé and Wold
/// 1985, Cook 1986), until no dart can hit any more.
///
/// The arrangement of the retina's cones outside the fovea (Yellott 1983). The periodogram has a low plateau around zero
/// (0.06, not zero), a ring of 1.8 at `1.14·√N` and ever smaller ones beyond: aliases become noise, and the noise of low
/// frequencies is small. A maximal pattern covers `0.547` of the area with disks of diameter `radius`
/// (random sequential addition jams there), so that `N ≈ 0.696/radius²`, and its radius is 0.777 of the greatest that `N`
/// points can keep.
///
/// Darts are thrown at the cells of a grid that may still have room, first squares of side `radius/√2` and then their
/// quarters, with those dropped that one disk covers whole (Ebeida et al., *A simple algorithm for maximal Poisson-disk
/// sampling in high dimensions*, 2012): the same distribution as throwing at random for ever, in time proportional to the
/// number of points. By default the square is a torus, so that the pattern tiles.
///
/// Order: of the darts, random; not progressive.
///
/// ```
/// use nyquist::prelude::*;
/// let points = PoissonDisk::new(0.04)?.points(1);
/// assert!(min_distance_torus(&points)? >= 0.04);
/// assert!((points.len() as f64 * 0.04f64.powi(2) - 0.696).abs() < 0.03);
/// // or about as many as asked for
/// let points = PoissonDisk::with_about(1000)?.points(1);
/// assert!((950..1050).contains(&points.len()));
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PoissonDisk {
    radius: f64,
    torus: bool,
    rounds: u32,
}

/// The part of the plane that equal disks cover when random sequential addition jams: 0.54707 (Feder 1980; Torquato, Uche,
/// Stillinger 2006).
pub const JAMMED: f64 = 0.54707;

/// How often the cells are quartered at most: beyond, they would be smaller than rounding.
const MOST_ROUNDS: u32 = 18;

/// Darts a cell and round: fewer leave more cells to quarter, more miss; the least time is near this.
const DARTS: f64 = 0.8;

impl PoissonDisk {
    /// No two points nearer than `radius`, on the torus, maximal.
    ///
    /// # Errors
    /// A radius outside `1/2048 ..= 1/2`.
    pub fn new(radius: f64) -> Result<Self> {
        let radius = within("the radius of a Poisson disk pattern", radius, 1.0 / 2048.0, 0.5)?;
        Ok(Self { radius, torus: true, rounds: MOST_ROUNDS })
    }

    /// The radius that gives about `count` points: `√(4·0.547/(π·count))`. The number deviates by `√(0.06·count)`.
    ///
    /// # Errors
    /// Fewer than 3 or more than 2.9 million: their radius would be out of range.
    pub fn with_about(count: usize) -> Result<Self> {
        const MOST: usize = 2_900_000;
        match countable(count)? {
            n if n < 3 => Err(Error::TooFew { what: "points of a Poisson disk pattern", least: 3, got: n }),
            n if n > MOST => {
                let what = "the number of points of a Poisson disk pattern";
                Err(Error::Overflow { what, value: n as f64, most: MOST as f64 })
            }
            n => Self::new((4.0 * JAMMED / (std::f64::consts::PI * n as f64)).sqrt()),
        }
    }

    /// The same in a square with edges, not on the torus: a few more points, more of them at the edges.
    #[must_use]
    pub fn bounded(self) -> Self {
        Self { torus: false, ..self }
    }

    /// The same, but stopped after so many times of quartering the cells: not maximal, gaps are left that darts could
    /// still hit. With zero there is one round, of 0.7 darts a cell.
    #[must_use]
    pub fn with_rounds(self, rounds: u32) -> Self {
        Self { rounds: rounds.min(MOST_ROUNDS), ..self }
    }

    /// The least distance of two points.
    pub fn radius(&self) -> f64 {
        self.radius
    }
}

impl Pattern<2> for PoissonDisk {
    fn name(&self) -> String {
        if self.torus { "poisson-disk" } else { "poisson-disk-bounded" }.into()
    }

    fn count(&self) -> Option<usize> {
        None
    }

    fn points(&self, seed: u64) -> Vec<[f64; 2]> {
        let key = bits(seed, 0, 0);
        let mut board = Board::new(self.radius, self.torus);
        let side = board.side;
        let mut active: Vec<[u32; 2]> = (0..side * side).map(|i| [i % side, i / side]).collect();
        let mut dart = 0u64;
        for round in 0..=self.rounds {
            // cells of this round are 2^-round of the board's
            let cell = 1.0 / (f64::from(side) * f64::from(1u32 << round));
            for _ in 0..(DARTS * active.len() as f64).ceil() as u64 {
                let [pick, x, y] = [0, 1, 2].map(|k| word(key, 3 * dart + k));
                dart += 1;
                let chosen = below(pick, active.len() as u64) as usize;
                let corner = active[chosen];
                if board.taken(corner.map(|c| c >> round)) {
                    active.swap_remove(chosen);
                    if active.is_empty() {
                        break;
                    }
                    continue;
                }
                let place = [(f64::from(corner[0]) + unit(x)) * cell, (f64::from(corner[1]) + unit(y)) * cell];
                if place[0] < 1.0 && place[1] < 1.0 && board.free(place) {
                    board.insert(place);
                }
            }
            let mut next = Vec::with_capacity(active.len());
            for corner in active {
                if !board.taken(corner.map(|c| c >> round)) {
                    board.uncovered_quarters(corner, round, &mut next);
                }
            }
            active = next;
            if active.is_empty() {
                break;
            }
        }
        board.points
    }
}

/// The square in cells of side at most `radius/√2`, which hold at most one point each, with a margin of two cells around
/// for the images of points across the edges.
struct Board {
    side: u32,
    squared: f64,
    torus: bool,
    /// The point of each cell, infinitely far away if there is none.
    cells: Vec<[f64; 2]>,
    points: Vec<[f64; 2]>,
}

const MARGIN: u32 = 2;
const EMPTY: [f64; 2] = [f64::INFINITY; 2];

impl Board {
    fn new(radius: f64, torus: bool) -> Self {
        let side = (2f64.sqrt() / radius).ceil() as u32;
        let width = (side + 2 * MARGIN) as usize;
        let cells = vec![EMPTY; width * width];
        Self { side, squared: radius * radius, torus, cells, points: Vec::new() }
    }

    /// The index of a cell, counted from the margin's corner.
    fn index(&self, [x, y]: [u32; 2]) -> usize {
        (y * (self.side + 2 * MARGIN) + x) as usize
    }

    /// The cell, counted from the square's corner, that a place of the square is in.
    fn cell(&self, place: [f64; 2]) -> [u32; 2] {
        place.map(|c| ((c * f64::from(self.side)) as u32).min(self.side - 1))
    }

    fn taken(&self, [x, y]: [u32; 2]) -> bool {
        self.cells[self.index([x + MARGIN, y + MARGIN])][0] < f64::INFINITY
    }

    /// The five rows of cells around the given one: all that its radius can reach, since two cells are wider than it. The
    /// middle rows first: they tell most darts that miss.
    fn around(&self, [x, y]: [u32; 2]) -> impl Iterator<Item = &[[f64; 2]]> {
        let width = (self.side + 2 * MARGIN) as usize;
        let start = self.index([x, y]);
        [2, 1, 3, 0, 4].into_iter().map(move |row| &self.cells[start + row * width..][..5])
    }

    /// Whether a place is at least the radius away from all points.
    fn free(&self, [x, y]: [f64; 2]) -> bool {
        let too_near = |[px, py]: &[f64; 2]| (px - x) * (px - x) + (py - y) * (py - y) < self.squared;
        self.around(self.cell([x, y])).all(|row| !row.iter().any(too_near))
    }

    /// Adds those quarters of a cell of the given round that no disk covers whole.
    fn uncovered_quarters(&self, corner: [u32; 2], round: u32, into: &mut Vec<[u32; 2]>) {
        let quarter = 0.5 / (f64::from(self.side) * f64::from(1u32 << round));
        let [x, y] = corner.map(|c| f64::from(2 * c + 1) * quarter);
        // the disks that cover the middle: only they can cover a quarter whole
        let (mut disks, mut count) = ([[0.0; 2]; 25], 0);
        for row in self.around(corner.map(|c| c >> round)) {
            for &[px, py] in row {
                let (dx, dy) = (px - x, py - y);
                if dx * dx + dy * dy < self.squared && count < disks.len() {
                    disks[count] = [dx, dy];
                    count += 1;
                }
            }
        }
        for [right, up] in [[0, 0], [1, 0], [0, 1], [1, 1]] {
            let middle = [right, up].map(|side| (f64::from(side) - 0.5) * quarter);
            let covers = |disk: &[f64; 2]| {
                let [dx, dy] = [0, 1].map(|d| (disk[d] - middle[d]).abs() + 0.5 * quarter);
                dx * dx + dy * dy < self.squared
            };
            if !disks[..count].iter().any(covers) {
                into.push([2 * corner[0] + right, 2 * corner[1] + up]);
            }
        }
    }

    /// Puts a point, and on the torus its images that fall into the margin.
    fn insert(&mut self, place: [f64; 2]) {
        self.points.push(place);
        let cell = self.cell(place);
        let (side, margin) = (i64::from(self.side), i64::from(MARGIN));
        let turns = if self.torus { -1..=1 } else { 0..=0 };
        for v in turns.clone() {
            for u in turns.clone() {
                let [x, y] = [i64::from(cell[0]) + margin + u * side, i64::from(cell[1]) + margin + v * side];
                let width = side + 2 * margin;
                if (0..width).contains(&x) && (0..width).contains(&y) {
                    let at = self.index([x as u32, y as u32]);
                    self.cells[at] = [place[0] + u as f64, place[1] + v as f64];
                }
            }
        }
    }
}
