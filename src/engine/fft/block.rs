//! Eight complex numbers at a time, as they stand in memory: real and imaginary parts in turn.
//!
//! Loops over arrays of a known length become shuffles and wide vectors, without taking the parts of all numbers apart and
//! putting those of the results together again.

use crate::engine::real::Real;
use num_complex::Complex;

/// How many complex numbers are in a block.
pub(super) const BLOCK: usize = 8;

/// A block.
pub(super) type Block<T> = [T; 2 * BLOCK];

/// The block that starts at `at`.
#[inline(always)]
pub(super) fn block<T: Real>(numbers: &[Complex<T>], at: usize) -> Block<T> {
    let parts: &[T] = bytemuck::cast_slice(&numbers[at..at + BLOCK]);
    std::array::from_fn(|i| parts[i])
}

/// The block that starts at `at`, to be written.
#[inline(always)]
pub(super) fn block_mut<T: Real>(numbers: &mut [Complex<T>], at: usize) -> &mut Block<T> {
    let parts: &mut [T] = bytemuck::cast_slice_mut(&mut numbers[at..at + BLOCK]);
    parts.try_into().expect("so many are in a block")
}

/// Element by element.
#[inline(always)]
pub(super) fn each<T: Real>(a: &Block<T>, b: &Block<T>, f: impl Fn(T, T) -> T) -> Block<T> {
    std::array::from_fn(|i| f(a[i], b[i]))
}

/// Number times number. The operations are those of [`Complex`], and so are the bits.
#[inline(always)]
pub(super) fn times<T: Real>(a: &Block<T>, b: &Block<T>) -> Block<T> {
    let straight: Block<T> = std::array::from_fn(|i| a[i] * b[i & !1]);
    let across: Block<T> = std::array::from_fn(|i| a[i ^ 1] * b[i | 1]);
    std::array::from_fn(|i| if i % 2 == 0 { straight[i] - across[i] } else { straight[i] + across[i] })
}

/// The last number first.
#[inline(always)]
pub(super) fn reversed<T: Real>(z: &Block<T>) -> Block<T> {
    std::array::from_fn(|i| z[(2 * BLOCK - 2 - (i & !1)) | (i & 1)])
}

/// The conjugates.
#[inline(always)]
pub(super) fn conjugate<T: Real>(z: &Block<T>) -> Block<T> {
    std::array::from_fn(|i| if i % 2 == 0 { z[i] } else { -z[i] })
}
