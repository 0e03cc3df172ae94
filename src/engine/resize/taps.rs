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
/// Weights of positions outside are added to those of the positions that they stand for, so that a sum reads from the first
/// to the last of these: beyond a border that continues at the other one ([`Edge::Wrap`]) it reads the whole axis.
///
/// ```
/// use nyquist::axis::Edge;
/// use nyquist::engine::resize::Taps;
/// // four positions become two, each the mean of two
/// let means = Taps::new(4, Edge::Clamp, [(0, &[0.5, 0.5][..]), (2, &[0.5, 0.5])])?;
/// assert_eq!((means.old(), means.len()), (4, 2));
/// // what lies before the first position is the first position
/// assert_eq!(Taps::new(4, Edge::Clamp, [(-1, &[0.5, 0.5][..])])?, Taps::new(4, Edge::Clamp, [(0, &[1.0][..])])?);
/// # Ok::<(), nyquist::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Taps {
    old: usize,
    /// The first old position of each new one, and its weights, one at least.
    rows: Vec<(usize, Vec<f64>)>,
}

impl Taps {
    /// The most positions of an axis, old and new.
    pub const MOST: usize = 1 << 30;

    /// Of an axis of `old` positions, for every new one the first old position that it reads, which may lie outside, and
    /// the weights from there on.
    ///
    /// # Errors
    /// No or more than [`MOST`](Self::MOST) positions, old or new; a weight that is not finite; one of a position farther
    /// than [`MOST`](Self::MOST) from the first.
    pub fn new<'a>(old: usize, edge: Edge, rows: impl IntoIterator<Item = (i64, &'a [f64])>) -> Result<Self> {
        Self::check("the old positions of a resizing", old)?;
        let mut kept: Vec<(usize, Vec<f64>)> = Vec::new();
        for (first, weights) in rows {
            for &w in weights {
                finite("a weight of a resizing", w)?;
            }
            let used = |w: &f64| *w != 0.0;
            let front = weights.iter().position(used).unwrap_or(0);
            let back = weights.iter().rposition(used).map_or(front, |i| i + 1);
            let read = first.saturating_add(front as i64)..first.saturating_add(back as i64);
            for position in [read.start, read.end] {
                if front < back && position.unsigned_abs() > Self::MOST as u64 {
                    let (what, most) = ("a position that a resizing reads", Self::MOST as f64);
                    return Err(Error::Overflow { what, value: position as f64, most });
                }
            }
            // a sum of nothing is zero times something near by, so that no range of what is read is empty
            let near = kept.last().map_or(0, |(first, _)| *first);
            let (first, weights) = folded(old, edge, read, &weights[front..back]).unwrap_or((near, vec![0.0]));
            for &w in &weights {
                finite("a weight of a resizing, beyond a border too,", w)?;
            }
            kept.push((first, weights));
        }
        Self::check("the new positions of a resizing", kept.len())?;
        Ok(Self { old, rows: kept })
    }

    fn check(what: &'static str, got: usize) -> Result<()> {
        match got {
            0 => Err(Error::TooFew { what, least: 1, got }),
            _ if got > Self::MOST => Err(Error::Overflow { what, value: got as f64, most: Self::MOST as f64 }),
            _ => Ok(()),
        }
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

    /// The old positions that some new ones read.
    pub(super) fn reads(&self, new: Range<usize>) -> Range<usize> {
        let rows = &self.rows[new];
        let low = rows.iter().map(|(first, _)| *first).min().unwrap_or(0);
        low..rows.iter().map(|(first, w)| first + w.len()).max().unwrap_or(0)
    }

    /// The weight of an old position in a new one, if it reads it.
    pub(super) fn weight(&self, new: usize, position: usize) -> Option<f64> {
        let (first, weights) = self.rows.get(new)?;
        weights.get(position.checked_sub(*first)?).copied()
    }

    /// How many old positions a new one reads in the mean: a measure of the work.
    pub(super) fn mean(&self) -> f64 {
        self.rows.iter().map(|(_, w)| w.len() as f64).sum::<f64>() / self.len() as f64
    }
}

/// Weights by the positions that those beyond the borders stand for, from the first to the last one; nothing if all of them
/// are zero.
fn folded(old: usize, edge: Edge, read: Range<i64>, weights: &[f64]) -> Option<(usize, Vec<f64>)> {
    let places = || read.clone().zip(weights).filter_map(|(i, w)| edge.index(i, old).map(|i| (i, *w)));
    let (low, high) = places().fold(None, |ends: Option<(usize, usize)>, (i, _)| {
        ends.map_or(Some((i, i)), |(low, high)| Some((low.min(i), high.max(i))))
    })?;
    let mut sums = vec![0.0; high - low + 1];
    places().for_each(|(i, w)| sums[i - low] += w);
    Some((low, sums))
}

/// New positions whose sums are computed together.
#[derive(Debug)]
struct Block {
    first: usize,
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
        let together: usize = starts().map(|j| Self::lines(&taps, j..(j + SIDE).min(n))).sum();
        // side by side four sums share what they read, but multiply zeros where one reads and another does not
        let side = if (together * SIDE) as f64 <= 2.0 * taps.mean() * n as f64 { SIDE } else { 1 };
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

    fn lines(taps: &Taps, new: Range<usize>) -> usize {
        let reads = taps.reads(new);
        reads.end - reads.start
    }

    pub(super) fn side(&self) -> usize {
        self.side
    }

    /// The blocks of new positions from a multiple of [`SIDE`] on: the first old position, and for every one from there on
    /// a weight for each new one.
    #[inline(always)]
    pub(super) fn of(&self, new: &Range<usize>) -> impl Iterator<Item = (usize, &[T])> {
        let blocks = &self.blocks[new.start / self.side..=new.end.div_ceil(self.side)];
        blocks.windows(2).map(|pair| (pair[0].first, &self.weights[pair[0].weights..pair[1].weights]))
    }

    /// The old positions that their sums read.
    pub(super) fn reads(&self, new: &Range<usize>) -> Range<usize> {
        self.taps.reads(new.clone())
    }
}
