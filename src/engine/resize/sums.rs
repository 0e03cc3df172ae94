//! Weighted sums of lines: all the arithmetic of a resizing.

use crate::engine::resize::code::Code;
use crate::engine::resize::lines::Lines;
use crate::engine::resize::taps::{Blocks, SIDE};
use crate::engine::simd::{Lanes, Simd, Task};
use std::ops::Range;

/// For new positions the sums of the lines at old ones: pieces of rows on the way down, and on the way across columns of
/// pixels of some rows, which turned lie one after another as lines do.
pub(super) struct Sums<'a, L: Code> {
    pub(super) blocks: &'a Blocks<L::Sum>,
    pub(super) new: Range<usize>,
    pub(super) fused: bool,
    pub(super) lines: Lines<'a, L>,
    /// From where on in every line.
    pub(super) at: usize,
    /// So many numbers, a multiple of [`LEAST`].
    pub(super) width: usize,
    /// Where the sums go, `stride` apart; as many as fill their blocks.
    pub(super) to: &'a mut [L::Sum],
    pub(super) stride: usize,
}

/// The numbers of the widest vector.
pub(super) const LEAST: usize = 16;

impl<L: Code> Task for Sums<'_, L> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        // sums in registers: as many as processors with vectors of this size have room for
        match (self.blocks.side() == 1, self.fused, size_of::<Vector<L, S>>() == 64) {
            (true, true, _) => self.all::<S, true, 1, 8>(simd),
            (true, false, _) => self.all::<S, false, 1, 8>(simd),
            (false, true, true) => self.all::<S, true, SIDE, 4>(simd),
            (false, false, true) => self.all::<S, false, SIDE, 4>(simd),
            (false, true, false) => self.all::<S, true, SIDE, 2>(simd),
            (false, false, false) => self.all::<S, false, SIDE, 2>(simd),
        }
    }
}

impl<L: Code> Sums<'_, L> {
    #[inline(always)]
    fn all<S: Simd, const FUSED: bool, const R: usize, const C: usize>(self, simd: S) {
        let Self { blocks, new, lines, at, width, to, stride, .. } = self;
        let lanes = size_of::<Vector<L, S>>() / size_of::<L::Sum>();
        for ((first, weights), to) in blocks.of(&new).zip(to.chunks_mut(R * stride)) {
            let weights = weights.as_chunks::<R>().0;
            let read = Read { lines, first, weights };
            let mut c = 0;
            while c + C * lanes <= width {
                read.block::<S, FUSED, C>(simd, at + c, &mut to[c..], stride);
                c += C * lanes;
            }
            while C > 2 && c + 2 * lanes <= width {
                read.block::<S, FUSED, 2>(simd, at + c, &mut to[c..], stride);
                c += 2 * lanes;
            }
            while c + lanes <= width {
                read.block::<S, FUSED, 1>(simd, at + c, &mut to[c..], stride);
                c += lanes;
            }
        }
    }
}

type Vector<L, S> = <<L as Code>::Sum as Lanes>::Vector<S>;

/// What `R` sums read, and by which weights.
struct Read<'a, L: Code, const R: usize> {
    lines: Lines<'a, L>,
    first: usize,
    weights: &'a [[L::Sum; R]],
}

impl<L: Code, const R: usize> Read<'_, L, R> {
    /// `C` vectors of every sum, in registers.
    #[inline(always)]
    fn block<S: Simd, const FUSED: bool, const C: usize>(&self, simd: S, at: usize, to: &mut [L::Sum], stride: usize) {
        let lanes = size_of::<Vector<L, S>>() / size_of::<L::Sum>();
        let mut sums = [[L::Sum::splat(simd, L::Sum::default()); C]; R];
        for (line, weights) in self.lines.from(self.first).zip(self.weights) {
            let line = &line[at..at + C * lanes];
            let line: [_; C] = std::array::from_fn(|c| L::vector::<S>(&line[c * lanes..(c + 1) * lanes]));
            for r in 0..R {
                let w = L::Sum::splat(simd, weights[r]);
                for c in 0..C {
                    sums[r][c] = if FUSED {
                        L::Sum::fuse_product(simd, w, line[c], sums[r][c])
                    } else {
                        L::Sum::add_product(simd, w, line[c], sums[r][c])
                    };
                }
            }
        }
        for (sums, to) in sums.iter().zip(to.chunks_mut(stride)) {
            L::Sum::vectors_mut::<S>(&mut to[..C * lanes]).copy_from_slice(sums);
        }
    }
}
