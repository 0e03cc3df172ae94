//! A window at all phases, in vectors.

use crate::engine::Arithmetic;
use crate::engine::nonuniform::{PIECE_BITS, Taps, Window};
use crate::engine::real::Real;
use crate::engine::simd::{Simd, Task, with_vectors};
use crate::rate::time::Time;

/// How many samples a value is made of; those beyond the width of a window weigh nothing.
pub(super) const TAPS: usize = 16;
/// How many powers its polynomials have.
const POWERS: usize = 6;
/// Bytes of the widest vectors: rows that start at multiples of it are read at once.
const WIDEST: usize = 64;

/// Polynomials for the weights of [`TAPS`] samples, piece by piece of the step between two of them, from the highest power
/// to the lowest.
pub(super) struct Phases<T> {
    rows: Vec<T>,
    /// Where the first piece begins.
    first: usize,
    arithmetic: Arithmetic,
}

impl<T: Real> Phases<T> {
    /// Of a window, with an error of all weights together that is at most `allowed`: of so few powers only where that is
    /// possible.
    pub(super) fn new(window: &Window, allowed: f64, arithmetic: Arithmetic) -> Self {
        let taps = Taps::<T>::new(window, allowed);
        let (width, piece) = (taps.width(), taps.rows().len() >> PIECE_BITS);
        let missing = POWERS.checked_sub(piece / width).expect("the tolerances of both windows need no more");
        let mut rows = vec![T::zero(); ((POWERS * TAPS) << PIECE_BITS) + WIDEST / size_of::<T>()];
        let first = rows.as_ptr().align_offset(WIDEST).min(WIDEST / size_of::<T>());
        for (rows, taps) in rows[first..].chunks_exact_mut(POWERS * TAPS).zip(taps.rows().chunks_exact(piece)) {
            for (row, taps) in rows.chunks_exact_mut(TAPS).skip(missing).zip(taps.chunks_exact(width)) {
                row[..width].copy_from_slice(taps);
            }
        }
        Self { rows, first, arithmetic }
    }

    /// Frames at times that are a `step` apart, each channel's samples in a line of `length`, where those of the first frame
    /// begin at `time`; false if a value is not finite.
    pub(super) fn values(&self, time: Time, step: Time, lines: &[T], length: usize, out: &mut [T]) -> bool {
        let (rows, arithmetic) = (&self.rows[self.first..], self.arithmetic);
        with_vectors(Values { rows, arithmetic, lines, length, time, step, out })
    }
}

struct Values<'a, T> {
    rows: &'a [T],
    arithmetic: Arithmetic,
    lines: &'a [T],
    length: usize,
    time: Time,
    step: Time,
    out: &'a mut [T],
}

impl<T: Real> Task for Values<'_, T> {
    type Output = bool;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> bool {
        match self.arithmetic {
            Arithmetic::Plain => self.all::<S, false>(simd),
            Arithmetic::Fused => self.all::<S, true>(simd),
        }
    }
}

/// A number for every tap.
#[repr(align(64))]
struct Row<T>([T; TAPS]);

impl<T: Real> Values<'_, T> {
    #[inline(always)]
    fn all<S: Simd, const FUSED: bool>(self, simd: S) -> bool {
        let Self { rows, lines, length, mut time, step, out, .. } = self;
        let pieces = rows.as_chunks::<TAPS>().0.as_chunks::<POWERS>().0;
        let zero = T::splat(simd, T::zero());
        let (mut weights, mut products) = (Row([T::zero(); TAPS]), Row([T::zero(); TAPS]));
        let mut none = T::zero();
        for frame in out.chunks_exact_mut(lines.len() / length) {
            let piece = &pieces[(time.fraction >> (u128::BITS - PIECE_BITS)) as usize];
            // the part of the piece, in 53 bits
            let u = (time.fraction << PIECE_BITS >> 75) as u64 as f64 * 0.5f64.powi(53);
            let u = T::splat(simd, T::of(u));
            for (i, weight) in T::vectors_mut::<S>(&mut weights.0).iter_mut().enumerate() {
                let mut sum = T::vectors::<S>(&piece[0])[i];
                for row in &piece[1..] {
                    let row = T::vectors::<S>(row)[i];
                    sum = if FUSED { T::fuse_product(simd, sum, u, row) } else { T::add_product(simd, sum, u, row) };
                }
                *weight = sum;
            }
            let from = time.whole as usize;
            for (value, line) in frame.iter_mut().zip(lines.chunks_exact(length)) {
                let samples = T::vectors::<S>(&line[from..][..TAPS]);
                let factors = T::vectors::<S>(&weights.0).iter().zip(samples);
                for (product, (weight, sample)) in T::vectors_mut::<S>(&mut products.0).iter_mut().zip(factors) {
                    *product = T::add_product(simd, *weight, *sample, zero);
                }
                *value = total(&products.0);
                // of what is not finite nothing comes but NaN
                none += *value * T::zero();
            }
            time = time.after(1, step);
        }
        none == T::zero()
    }
}

/// The sum, by halves.
#[inline(always)]
fn total<T: Real>(p: &[T; TAPS]) -> T {
    let eight: [T; 8] = std::array::from_fn(|i| p[i] + p[i + 8]);
    let four: [T; 4] = std::array::from_fn(|i| eight[i] + eight[i + 4]);
    (four[0] + four[2]) + (four[1] + four[3])
}
