//! Weighted sums of lines: all the arithmetic of a resizing.

use crate::engine::resize::taps::{Blocks, SIDE};
use crate::engine::simd::{Lanes, Simd, Task};
use std::ops::Range;

/// Lines that are `stride` apart, the first one at this old position.
#[derive(Clone, Copy)]
pub(super) struct Lines<'a, T> {
    pub(super) numbers: &'a [T],
    pub(super) first: i64,
    pub(super) stride: usize,
}

/// For new positions the sums of the lines at old ones: pieces of rows on the way down, and on the way across columns of
/// pixels of some rows, which turned lie one after another as lines do.
pub(super) struct Sums<'a, T> {
    pub(super) blocks: &'a Blocks<T>,
    pub(super) new: Range<usize>,
    pub(super) fused: bool,
    pub(super) lines: Lines<'a, T>,
    /// Numbers of a line, a multiple of [`LEAST`].
    pub(super) width: usize,
    /// Where the sums go, `to_stride` apart; as many as fill their blocks.
    pub(super) to: &'a mut [T],
    pub(super) to_stride: usize,
}

/// The numbers of the widest vector.
pub(super) const LEAST: usize = 16;

impl<T: Lanes> Task for Sums<'_, T> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        match (self.blocks.side() == 1, self.fused) {
            (true, true) => self.all::<S, true, 1, 8>(simd),
            (true, false) => self.all::<S, false, 1, 8>(simd),
            (false, true) => self.all::<S, true, SIDE, 2>(simd),
            (false, false) => self.all::<S, false, SIDE, 2>(simd),
        }
    }
}

impl<T: Lanes> Sums<'_, T> {
    #[inline(always)]
    fn all<S: Simd, const FUSED: bool, const R: usize, const C: usize>(self, simd: S) {
        let Self { blocks, new, lines: Lines { numbers, first, stride }, width, to, to_stride, .. } = self;
        let lanes = size_of::<T::Vector<S>>() / size_of::<T>();
        for ((at, weights), to) in blocks.of(&new).zip(to.chunks_mut(R * to_stride)) {
            let lines = &numbers[(at - first) as usize * stride..];
            let weights = weights.as_chunks::<R>().0;
            let mut c = 0;
            while c + C * lanes <= width {
                block::<T, S, FUSED, R, C>(simd, weights, lines, stride, c, to, to_stride);
                c += C * lanes;
            }
            while C > 4 && c + 4 * lanes <= width {
                block::<T, S, FUSED, R, 4>(simd, weights, lines, stride, c, to, to_stride);
                c += 4 * lanes;
            }
            while C > 2 && c + 2 * lanes <= width {
                block::<T, S, FUSED, R, 2>(simd, weights, lines, stride, c, to, to_stride);
                c += 2 * lanes;
            }
            while c + lanes <= width {
                block::<T, S, FUSED, R, 1>(simd, weights, lines, stride, c, to, to_stride);
                c += lanes;
            }
        }
    }
}

/// `R` sums of `C` vectors in registers.
#[inline(always)]
fn block<T: Lanes, S: Simd, const FUSED: bool, const R: usize, const C: usize>(
    simd: S,
    weights: &[[T; R]],
    lines: &[T],
    stride: usize,
    at: usize,
    to: &mut [T],
    to_stride: usize,
) {
    let lanes = size_of::<T::Vector<S>>() / size_of::<T>();
    let mut sums = [[T::splat(simd, T::zero()); C]; R];
    for (line, weights) in lines.chunks(stride).zip(weights) {
        let line = T::vectors::<S>(&line[at..at + C * lanes]);
        for r in 0..R {
            let w = T::splat(simd, weights[r]);
            for c in 0..C {
                sums[r][c] = if FUSED {
                    T::fuse_product(simd, w, line[c], sums[r][c])
                } else {
                    T::add_product(simd, w, line[c], sums[r][c])
                };
            }
        }
    }
    for (sums, to) in sums.iter().zip(to.chunks_mut(to_stride)) {
        T::vectors_mut::<S>(&mut to[at..at + C * lanes]).copy_from_slice(sums);
    }
}
