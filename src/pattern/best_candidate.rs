//! Mitchell's best candidate.

use crate::error::{Error, Result};
use crate::num::random::{bits, unit, word};
use crate::pattern::buckets::Buckets;
use crate::pattern::{Pattern, countable};

/// Every new point is the best of `k` random candidates: the one farthest from its nearest neighbour (Mitchell,
/// *Spectrally optimal sampling for distribution ray tracing*, 1991).
///
/// Nearly a Poisson disk pattern, but with exactly as many points as asked for, and every beginning of it is one, too.
/// Distances are on the torus, so that the pattern tiles; [`BestCandidate::bounded`] makes them plain, which puts more
/// points on the edges. Neighbours are looked up in a grid of buckets, so that `N` points cost `O(N·k)` and not the
/// textbook's `O(N²·k)`. Mitchell takes candidates in proportion to the points that there are; here their number is
/// constant. The noise at low frequencies falls with it, from 0.16 for ten to 0.08 for a hundred, near the 0.06 of a
/// Poisson disk pattern, whose distances it never reaches.
///
/// Order: of construction; progressive.
///
/// ```
/// use nyquist::prelude::*;
/// let points = BestCandidate::new(256)?.points(1);
/// let random: Vec<[f64; 2]> = Random::new(256)?.points(1);
/// assert!(min_distance_torus(&points)? > 5.0 * min_distance_torus(&random)?);
/// // more candidates keep points farther apart; no 256 points can be farther apart than √(2/(√3·256)) = 0.0672
/// let points = BestCandidate::new(256)?.with_candidates(300)?.points(1);
/// assert!(min_distance_torus(&points)? > 0.5 * most_distance(256));
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BestCandidate {
    count: usize,
    candidates: u32,
    torus: bool,
}

/// How many candidates are looked at together: their buckets are far apart, and memory need not be waited for one after the
/// other.
const TOGETHER: u32 = 16;

impl BestCandidate {
    /// How many candidates a point has if nothing else is asked for.
    pub const CANDIDATES: u32 = 10;

    /// So many points, each the best of [`BestCandidate::CANDIDATES`].
    ///
    /// # Errors
    /// No points, or more than [`MOST_POINTS`](crate::pattern::MOST_POINTS).
    pub fn new(count: usize) -> Result<Self> {
        Ok(Self { count: countable(count)?, candidates: Self::CANDIDATES, torus: true })
    }

    /// The same with another number of candidates; one makes the points independent.
    ///
    /// # Errors
    /// No candidates.
    pub fn with_candidates(self, candidates: u32) -> Result<Self> {
        if candidates == 0 {
            return Err(Error::TooFew { what: "candidates for a point", least: 1, got: 0 });
        }
        Ok(Self { candidates, ..self })
    }

    /// The same in a square with edges, not on the torus.
    #[must_use]
    pub fn bounded(self) -> Self {
        Self { torus: false, ..self }
    }
}

impl Pattern<2> for BestCandidate {
    fn name(&self) -> String {
        let plain = if self.torus { "best-candidate" } else { "best-candidate-bounded" };
        if self.candidates == Self::CANDIDATES { plain.into() } else { format!("{plain}:{}", self.candidates) }
    }

    fn count(&self) -> Option<usize> {
        Some(self.count)
    }

    fn points(&self, seed: u64) -> Vec<[f64; 2]> {
        let key = bits(seed, 0, 0);
        let mut chosen = Buckets::new(self.torus);
        let mut candidates = vec![([0.0; 2], 0.0); self.candidates.min(TOGETHER) as usize];
        for i in 0..self.count as u64 {
            let (mut best, mut farthest) = ([0.0; 2], f64::NEG_INFINITY);
            for first in (0..self.candidates).step_by(TOGETHER as usize) {
                let at = 2 * (i * u64::from(self.candidates) + u64::from(first));
                let now = candidates.iter_mut().take((self.candidates - first) as usize);
                for ((candidate, inside), at) in now.zip((at..).step_by(2)) {
                    *candidate = [unit(word(key, at)), unit(word(key, at + 1))];
                    *inside = chosen.nearest_inside(*candidate);
                }
                for &(candidate, inside) in candidates.iter().take((self.candidates - first) as usize) {
                    let distance = chosen.nearest(candidate, inside, farthest);
                    if distance > farthest {
                        (best, farthest) = (candidate, distance);
                    }
                }
            }
            chosen.insert(best);
        }
        chosen.into_points()
    }
}
