//! Old rows, shared out to the new ones that read them: the sums of [`Sums`](crate::engine::resize::sums::Sums), in the
//! order in which an image is read.

use crate::engine::real::Real;
use crate::engine::simd::{Simd, Task};

/// Old rows that are shared out at a time.
pub(super) const TOGETHER: usize = 4;

/// What a new row takes.
pub(super) struct Share<T> {
    /// Where its sums are.
    pub(super) slot: usize,
    /// Whether these are the first rows that it takes, and there are no sums yet.
    pub(super) first: bool,
    pub(super) weights: [T; TOGETHER],
}

/// Pieces of old rows, and the sums of new ones, `stride` apart. Every old number is read once.
pub(super) struct Shares<'a, T> {
    pub(super) shares: &'a [Share<T>],
    pub(super) fused: bool,
    pub(super) rows: [&'a [T]; TOGETHER],
    /// Numbers of a row, a multiple of [`LEAST`](crate::engine::resize::sums::LEAST).
    pub(super) width: usize,
    pub(super) to: &'a mut [T],
    pub(super) stride: usize,
}

impl<T: Real> Task for Shares<'_, T> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        // what is read stays in registers: as many as processors with vectors of this size have room for
        match (self.fused, size_of::<T::Vector<S>>() == 64) {
            (true, true) => self.all::<S, true, 4>(simd),
            (false, true) => self.all::<S, false, 4>(simd),
            (true, false) => self.all::<S, true, 2>(simd),
            (false, false) => self.all::<S, false, 2>(simd),
        }
    }
}

impl<T: Real> Shares<'_, T> {
    #[inline(always)]
    fn all<S: Simd, const FUSED: bool, const C: usize>(mut self, simd: S) {
        let lanes = size_of::<T::Vector<S>>() / size_of::<T>();
        let mut c = 0;
        while c + C * lanes <= self.width {
            self.block::<S, FUSED, C>(simd, c);
            c += C * lanes;
        }
        while c + lanes <= self.width {
            self.block::<S, FUSED, 1>(simd, c);
            c += lanes;
        }
    }

    /// `C` vectors of every row.
    #[inline(always)]
    fn block<S: Simd, const FUSED: bool, const C: usize>(&mut self, simd: S, at: usize) {
        let wide = C * size_of::<T::Vector<S>>() / size_of::<T>();
        let old: [_; TOGETHER] = std::array::from_fn(|k| {
            let vectors = T::vectors::<S>(&self.rows[k][at..at + wide]);
            std::array::from_fn::<_, C, _>(|c| vectors[c])
        });
        for Share { slot, first, weights } in self.shares {
            let sums = T::vectors_mut::<S>(&mut self.to[slot * self.stride + at..][..wide]);
            let weights = weights.map(|w| T::splat(simd, w));
            for c in 0..C {
                let mut sum = if *first { T::splat(simd, T::zero()) } else { sums[c] };
                for k in 0..TOGETHER {
                    sum = if FUSED {
                        T::fuse_product(simd, weights[k], old[k][c], sum)
                    } else {
                        T::add_product(simd, weights[k], old[k][c], sum)
                    };
                }
                sums[c] = sum;
            }
        }
    }
}
