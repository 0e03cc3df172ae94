//! Rows to columns.

use crate::engine::real::Real;
use crate::engine::simd::Loop;

/// Numbers on a side of the squares that are turned in registers.
pub(super) const SQUARE: usize = 8;

/// A matrix turned: `to[c·to_stride + r] = from[r·stride + c]`, for multiples of [`SQUARE`] of rows and columns.
pub(super) struct Turn<'a, T> {
    pub(super) from: &'a [T],
    pub(super) stride: usize,
    pub(super) rows: usize,
    pub(super) columns: usize,
    pub(super) to: &'a mut [T],
    pub(super) to_stride: usize,
}

impl<T: Real> Loop for Turn<'_, T> {
    #[inline(always)]
    fn run(self) {
        let Self { from, stride, rows, columns, to, to_stride } = self;
        for r in (0..rows).step_by(SQUARE) {
            for c in (0..columns).step_by(SQUARE) {
                let mut square = [[T::zero(); SQUARE]; SQUARE];
                for (i, line) in square.iter_mut().enumerate() {
                    if let Some(from) = from[(r + i) * stride + c..].first_chunk() {
                        *line = *from;
                    }
                }
                for i in 0..SQUARE {
                    if let Some(to) = to[(c + i) * to_stride + r..].first_chunk_mut() {
                        *to = square.map(|line| line[i]);
                    }
                }
            }
        }
    }
}
