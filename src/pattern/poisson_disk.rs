//! Poisson disk patterns: random, but never too close.

use crate::error::{Error, Result, within};
use crate::num::random::{below, bits, unit, word};
use crate::pattern::board::{BATCH, Board, PARTS};
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
/// Darts are thrown at the whole square first, then at those parts of it that may still have room, ever smaller squares
/// with those dropped that one disk covers whole (Ebeida et al., *A simple algorithm for maximal Poisson-disk sampling in
/// high dimensions*, 2012): the same distribution as throwing at random for ever, in time proportional to the number of
/// points. By default the square is a torus, so that the pattern tiles.
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

/// Rounds after the first at most: the parts of the last are 3·10⁻⁶ radii wide; two rounds more, and those of the
/// smallest radius could not be numbered along a side of the square in 32 bits.
const MOST_ROUNDS: u32 = 16;

/// Twice the darts that the first round throws for every square of side `radius/√2`; every later round throws one for every
/// two parts that are open. Fewer leave more parts to look at, more miss; the least time is near these.
const FIRST: u64 = 5;

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

    /// The same, but stopped after so many rounds beyond the first: not maximal, gaps are left that darts could still hit.
    /// The first throws five darts for every `radius²`; 16 more are all.
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
        let mut board = Board::new(self.radius, self.torus);
        let key = bits(seed, 0, 0);
        let cells = u64::from(board.side()).pow(2);
        board.throw(FIRST * cells / 2, |first, places| {
            (first..).zip(places).for_each(|(dart, at)| *at = [0, 1].map(|d| unit(word(key, 2 * dart + d))));
        });
        let mut parts = board.open();
        for round in 0..self.rounds {
            if parts.is_empty() {
                break;
            }
            let key = bits(seed, 1 + u64::from(round), 0);
            let part = 1.0 / (f64::from(PARTS * board.side()) * f64::from(1u32 << round));
            board.throw(parts.len().div_ceil(2) as u64, |first, places| {
                // parts are picked for all of them first: memory is waited for once
                let mut corners = [[0; 2]; BATCH];
                let last = first + places.len() as u64;
                let pick = |dart| below(word(key, 3 * dart), parts.len() as u64) as usize;
                corners.iter_mut().zip(first..last).for_each(|(corner, dart)| *corner = parts[pick(dart)]);
                for ((at, dart), corner) in places.iter_mut().zip(first..last).zip(corners) {
                    let within = [1, 2].map(|k| unit(word(key, 3 * dart + k)));
                    *at = [0, 1].map(|d| (f64::from(corner[d]) + within[d]) * part);
                }
            });
            parts = board.quarters(&parts, round);
        }
        board.into_points()
    }
}
