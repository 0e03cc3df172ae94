//! What one axis of a resizing is: for every new position the old ones that it reads, and their weights.

use crate::axis::Edge;
use crate::engine::real::Real;
use crate::error::{Error, Result, finite};
use std::ops::Range;

/// New positions that are summed side by side where they read nearly the same old ones.
pub(super) const SIDE: usize = 4;

/// The sums along one axis: `g_j = Σ_k w_{jk} f(first_j + k)`, where old positions that lie outside are those that an
/// [`Edge`] says.
///
/// ```
/// use nyquist::axis::Edge;
/// use nyquist::engine::resize::Taps;
/// // four positions become two, each the mean of two
/// let means = Taps::new(4, Edge::Clamp, [(0, &[0.5, 0.5][..]), (2, &[0.5, 0.5])])?;
/// assert_eq!((means.old(), means.len()), (4, 2));
/// # Ok::<(), nyquist::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Taps {
    old: usize,
    /// The first old position of each, and its weights without zeros before and after, one at least.
    rows: Vec<(i64, Vec<f64>)>,
    /// Where the old position `low + i` stands; [`NOTHING`](Self::NOTHING) for nowhere.
    places: Vec<u32>,
    low: i64,
}

impl Taps {
    const NOTHING: u32 = u32::MAX;

    /// The most positions of an axis, old and new.
    pub const MOST: usize = 1 << 30;

    /// Of an axis of `old` positions, for every new one the first old position that it reads, which may lie outside, and
    /// the weights from there on.
    ///
    /// # Errors
    /// No or more than [`MOST`](Self::MOST) positions, old or new; a weight that is not finite; one that reads more than
    /// [`MOST`](Self::MOST) positions away.
    pub fn new<'a>(old: usize, edge: Edge, rows: impl IntoIterator<Item = (i64, &'a [f64])>) -> Result<Self> {
        let mut kept = Vec::new();
        for (first, weights) in rows {
            for &w in weights {
                finite("a weight of a resizing", w)?;
            }
            let used = |w: &f64| *w != 0.0;
            let (front, back) = match weights.iter().position(used) {
                Some(front) => (front, weights.iter().rposition(used).map_or(0, |i| i + 1)),
                None => (0, 0),
            };
            kept.push((first.saturating_add(front as i64), weights[front..back].to_vec()));
        }
        for (what, got) in [("the old positions of a resizing", old), ("the new positions of a resizing", kept.len())] {
            if got == 0 {
                return Err(Error::TooFew { what, least: 1, got });
            }
            if got > Self::MOST {
                return Err(Error::Overflow { what, value: got as f64, most: Self::MOST as f64 });
            }
        }
        let ends = |rows: &[(i64, Vec<f64>)]| {
            let used = || rows.iter().filter(|(_, w)| !w.is_empty());
            let low = used().map(|(first, _)| *first).min().unwrap_or(0);
            let high = used().map(|(first, w)| first.saturating_add(w.len() as i64)).max().unwrap_or(1);
            low..high
        };
        let Range { start: low, end: high } = ends(&kept);
        for position in [low, high] {
            if position.unsigned_abs() > Self::MOST as u64 {
                let (what, most) = ("a position that a resizing reads", Self::MOST as f64);
                return Err(Error::Overflow { what, value: position as f64, most });
            }
        }
        // a sum of nothing is zero times something, so that no range of what is read is empty
        for (first, weights) in &mut kept {
            if weights.is_empty() {
                (*first, *weights) = (low, vec![0.0]);
            }
        }
        let place = |i| edge.index(i, old).map_or(Self::NOTHING, |place| place as u32);
        Ok(Self { old, rows: kept, places: (low..high).map(place).collect(), low })
    }

    /// How many old positions there are.
    pub fn old(&self) -> usize {
        self.old
    }

    /// How many new positions there are.
    pub fn len(&self) -> usize {
        self.rows.len()
    }

    /// Never: an axis has positions.
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    /// Where an old position stands that is read, or that lies between such.
    #[inline(always)]
    pub(super) fn place(&self, position: i64) -> Option<usize> {
        let place = self.places.get(usize::try_from(position - self.low).ok()?)?;
        (*place != Self::NOTHING).then_some(*place as usize)
    }

    /// The old positions that some new ones read.
    pub(super) fn reads(&self, new: Range<usize>) -> Range<i64> {
        let rows = &self.rows[new];
        let low = rows.iter().map(|(first, _)| *first).min().unwrap_or(0);
        low..rows.iter().map(|(first, w)| first + w.len() as i64).max().unwrap_or(0)
    }

    /// The weight of an old position in a new one, if it reads it.
    pub(super) fn weight(&self, new: usize, position: i64) -> Option<f64> {
        let (first, weights) = self.rows.get(new)?;
        weights.get(usize::try_from(position - first).ok()?).copied()
    }

    /// How many old positions a new one reads in the mean: a measure of the work.
    pub(super) fn mean(&self) -> f64 {
        self.rows.iter().map(|(_, w)| w.len() as f64).sum::<f64>() / self.len() as f64
    }
}

/// New positions whose sums are computed together.
#[derive(Debug)]
struct Block {
    first: i64,
    /// Where its weights begin, for every old position one for each new one.
    weights: usize,
}

/// [`Taps`] in the order in which an engine reads them.
#[derive(Debug)]
pub(super) struct Blocks<T> {
    pub(super) taps: Taps,
    /// New positions in a block: 1 or [`SIDE`].
    side: usize,
    /// And one behind the last, where the weights end.
    blocks: Vec<Block>,
    weights: Vec<T>,
}

impl<T: Real> Blocks<T> {
    pub(super) fn new(taps: Taps) -> Self {
        let n = taps.len();
        let starts = || (0..n).step_by(SIDE);
        let together: i64 = starts().map(|j| Self::lines(&taps, j..(j + SIDE).min(n))).sum();
        // side by side four sums share what they read, but multiply zeros where one reads and another does not
        let side = if (together * SIDE as i64) as f64 <= 2.0 * taps.mean() * n as f64 { SIDE } else { 1 };
        let mut made = Self { side, blocks: Vec::new(), weights: Vec::new(), taps };
        for start in (0..n).step_by(side) {
            let reads = made.taps.reads(start..(start + side).min(n));
            made.blocks.push(Block { first: reads.start, weights: made.weights.len() });
            for position in reads {
                for j in start..start + side {
                    made.weights.push(T::of(made.taps.weight(j, position).unwrap_or(0.0)));
                }
            }
        }
        made.blocks.push(Block { first: 0, weights: made.weights.len() });
        made
    }

    fn lines(taps: &Taps, new: Range<usize>) -> i64 {
        let reads = taps.reads(new);
        reads.end - reads.start
    }

    pub(super) fn side(&self) -> usize {
        self.side
    }

    /// The blocks of new positions from a multiple of [`SIDE`] on: the first old position, and for every one from there on
    /// a weight for each new one.
    #[inline(always)]
    pub(super) fn of(&self, new: &Range<usize>) -> impl Iterator<Item = (i64, &[T])> {
        let blocks = &self.blocks[new.start / self.side..=new.end.div_ceil(self.side)];
        blocks.windows(2).map(|pair| (pair[0].first, &self.weights[pair[0].weights..pair[1].weights]))
    }

    /// The old positions that their sums read.
    pub(super) fn reads(&self, new: &Range<usize>) -> Range<i64> {
        self.taps.reads(new.clone())
    }
}
