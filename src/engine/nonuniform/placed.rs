//! Points sorted by the part of the grid that they fall into.

use crate::engine::nonuniform::position::{Position, Ruler};
use crate::engine::simd::{Loop, vectorised};
use crate::error::{Error, Result};
use crate::parallel;
use std::ops::Range;
use std::sync::atomic::{AtomicBool, Ordering};

/// How many points are sorted together: so few that what is taken from them in any order comes from a near cache.
pub(super) const CHUNK: usize = 1 << 17;

/// Points of a line or of the plane, sorted by the part of the grid that they fall into, once for any number of
/// transforms.
///
/// Stable, in chunks of 2¹⁷ points, each by itself: 10 bytes a point on the line and 18 in the plane.
#[derive(Debug, Clone)]
pub struct Placed<const D: usize> {
    rulers: [Ruler; D],
    len: usize,
    chunks: Vec<Chunk<D>>,
}

/// One chunk of them.
#[derive(Debug, Clone, Default)]
struct Chunk<const D: usize> {
    /// Bin by bin.
    codes: Vec<[u64; D]>,
    /// The bins of the points in their own order.
    bins: Vec<u16>,
    /// Where each bin starts, and where the last one ends.
    starts: Vec<u32>,
    /// Where each bin's points of this chunk stand when all chunks together are sorted by bins.
    offsets: Vec<usize>,
}

impl<const D: usize> Placed<D> {
    pub(super) fn none(rulers: [Ruler; D]) -> Self {
        Self { rulers, len: 0, chunks: Vec::new() }
    }

    /// How many points there are.
    pub fn len(&self) -> usize {
        self.len
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// Refuses points that were placed on another grid.
    pub(super) fn on(&self, rulers: &[Ruler; D]) -> Result<&Self> {
        if self.rulers == *rulers { Ok(self) } else { Err(Error::Unsupported("points placed for another transform")) }
    }

    fn bins(&self) -> usize {
        self.rulers.iter().map(Ruler::bins).product()
    }

    /// Places other points; memory is used again.
    pub(super) fn fill<P: Position>(&mut self, points: &[[P; D]]) -> Result<()> {
        self.len = points.len();
        self.chunks.resize(points.len().div_ceil(CHUNK), Chunk::default());
        let rulers = self.rulers;
        let bad = AtomicBool::new(false);
        parallel::chunks(&mut self.chunks, 1, |i, chunk| {
            let points = &points[i * CHUNK..points.len().min((i + 1) * CHUNK)];
            if !chunk[0].fill(&rulers, points) {
                bad.store(true, Ordering::Relaxed);
            }
        });
        if bad.into_inner() {
            *self = Self::none(rulers);
            let fault = |(index, point): (usize, &[P; D])| inside(&rulers, *point).err().map(|value| (index, value));
            let (index, value) = points.iter().enumerate().find_map(fault).expect("a chunk has met one");
            return Err(Error::NotFiniteAt { what: "the positions of a transform", index, value });
        }
        let mut before = 0;
        for bin in 0..self.bins() {
            for chunk in &mut self.chunks {
                chunk.offsets[bin] = before;
                before += chunk.range(bin).len();
            }
        }
        Ok(())
    }

    /// The codes of the points of one bin, chunk by chunk.
    #[inline(always)]
    pub(super) fn codes(&self, bin: usize) -> impl Iterator<Item = &[[u64; D]]> {
        self.chunks.iter().map(move |chunk| &chunk.codes[chunk.range(bin)])
    }

    /// The same beside numbers that are sorted chunk by chunk.
    #[inline(always)]
    pub(super) fn beside<'a, T>(
        &'a self,
        bin: usize,
        sorted: &'a [T],
    ) -> impl Iterator<Item = (&'a [[u64; D]], &'a [T])> {
        let chunks = self.chunks.iter().zip(sorted.chunks(CHUNK));
        chunks.map(move |(chunk, sorted)| (&chunk.codes[chunk.range(bin)], &sorted[chunk.range(bin)]))
    }

    /// Numbers of the points in their own order, sorted chunk by chunk.
    pub(super) fn sort<T: Copy + Send + Sync>(&self, values: &[T], sorted: &mut [T]) {
        parallel::chunks(sorted, CHUNK, |i, sorted| {
            let chunk = &self.chunks[i];
            let mut next: Vec<u32> = chunk.starts.clone();
            for (bin, value) in chunk.bins.iter().zip(&values[i * CHUNK..]) {
                let at = &mut next[usize::from(*bin)];
                sorted[*at as usize] = *value;
                *at += 1;
            }
        });
    }

    /// A number for every point: `numbers` of each bin, bin by bin into `sorted`, then in their own order into `values`.
    pub(super) fn each<T: Copy + Send + Sync>(
        &self,
        sorted: &mut [T],
        values: &mut [T],
        numbers: impl Fn(usize, &mut [T]) + Sync + Send,
    ) {
        let counts = (0..self.bins()).map(|bin| self.codes(bin).map(<[_]>::len).sum());
        parallel::pieces(sorted, counts, numbers);
        parallel::chunks(values, CHUNK, |i, values| {
            let chunk = &self.chunks[i];
            let mut next = chunk.offsets.clone();
            for (bin, value) in chunk.bins.iter().zip(values) {
                let at = &mut next[usize::from(*bin)];
                *value = sorted[*at];
                *at += 1;
            }
        });
    }
}

/// A point within the period, or the number in it that is not finite.
fn inside<P: Position, const D: usize>(rulers: &[Ruler; D], mut point: [P; D]) -> std::result::Result<[P; D], f64> {
    for (position, ruler) in point.iter_mut().zip(rulers) {
        if !position.is_inside(ruler.period()) {
            *position = position.brought_inside(ruler.period())?;
        }
    }
    Ok(point)
}

impl<const D: usize> Chunk<D> {
    #[inline(always)]
    fn range(&self, bin: usize) -> Range<usize> {
        self.starts[bin] as usize..self.starts[bin + 1] as usize
    }

    /// Sorts by counting; false if a position is not finite.
    fn fill<P: Position>(&mut self, rulers: &[Ruler; D], points: &[[P; D]]) -> bool {
        const TOGETHER: usize = 512;
        let count = rulers.iter().map(Ruler::bins).product();
        self.bins.resize(points.len(), 0);
        let mut coded = vec![[0; D]; points.len()];
        let places = self.bins.chunks_mut(TOGETHER).zip(coded.chunks_mut(TOGETHER));
        for (points, (bins, codes)) in points.chunks(TOGETHER).zip(places) {
            let all_inside = |point: &[P; D]| point.iter().zip(rulers).all(|(p, ruler)| p.is_inside(ruler.period()));
            if points.iter().fold(true, |so_far, point| so_far & all_inside(point)) {
                vectorised(Code { rulers, points, bins, codes });
            } else {
                let brought = points.iter().map(|point| inside(rulers, *point));
                let Ok(points) = brought.collect::<std::result::Result<Vec<_>, _>>() else { return false };
                vectorised(Code { rulers, points: &points, bins, codes });
            }
        }
        let mut next = vec![0u32; count];
        self.bins.iter().for_each(|bin| next[usize::from(*bin)] += 1);
        self.starts.clear();
        let mut sum = 0;
        for count in &mut next {
            self.starts.push(sum);
            (sum, *count) = (sum + *count, sum);
        }
        self.starts.push(sum);
        self.offsets.resize(count, 0);
        self.codes.resize(points.len(), [0; D]);
        for (code, bin) in coded.into_iter().zip(&self.bins) {
            let at = &mut next[usize::from(*bin)];
            self.codes[*at as usize] = code;
            *at += 1;
        }
        true
    }
}

/// Bins and codes of points within the period.
struct Code<'a, P, const D: usize> {
    rulers: &'a [Ruler; D],
    points: &'a [[P; D]],
    bins: &'a mut [u16],
    codes: &'a mut [[u64; D]],
}

impl<P: Position, const D: usize> Loop for Code<'_, P, D> {
    #[inline(always)]
    fn run(self) {
        for ((point, bin), code) in self.points.iter().zip(self.bins).zip(self.codes) {
            let mut number = 0;
            for axis in (0..D).rev() {
                let (along, rest) = self.rulers[axis].bin(point[axis].parts());
                (number, code[axis]) = (number * self.rulers[axis].bins() as u32 + along, rest);
            }
            *bin = number as u16;
        }
    }
}
