//! Threads: the one place of the library that knows rayon.
//!
//! Work is split where its structure splits, never by the number of threads, and every result goes to its own place. So
//! the bits of a result do not depend on how many threads there are, or on whether there are any (feature `threads`).

/// `[f(0), f(1), …, f(n − 1)]`, on all threads of the current pool.
#[cfg(feature = "threads")]
pub(crate) fn map<T: Send>(n: usize, f: impl Fn(usize) -> T + Sync + Send) -> Vec<T> {
    use rayon::iter::{IntoParallelIterator, ParallelIterator};
    (0..n).into_par_iter().map(f).collect()
}

/// `[f(0), f(1), …, f(n − 1)]`.
#[cfg(not(feature = "threads"))]
pub(crate) fn map<T: Send>(n: usize, f: impl Fn(usize) -> T + Sync + Send) -> Vec<T> {
    (0..n).map(f).collect()
}

/// `f(i, chunk)` for the `i`-th chunk of `len` values (the last may be shorter), on all threads of the current pool.
#[cfg(feature = "threads")]
pub(crate) fn chunks<T: Send>(values: &mut [T], len: usize, f: impl Fn(usize, &mut [T]) + Sync + Send) {
    use rayon::iter::{IndexedParallelIterator, ParallelIterator};
    use rayon::slice::ParallelSliceMut;
    values.par_chunks_mut(len).enumerate().for_each(|(i, chunk)| f(i, chunk));
}

/// `f(i, chunk)` for the `i`-th chunk of `len` values (the last may be shorter).
#[cfg(not(feature = "threads"))]
pub(crate) fn chunks<T: Send>(values: &mut [T], len: usize, f: impl Fn(usize, &mut [T]) + Sync + Send) {
    values.chunks_mut(len).enumerate().for_each(|(i, chunk)| f(i, chunk));
}

/// `f(i, piece)` for consecutive pieces of those lengths, on all threads of the current pool.
#[cfg(feature = "threads")]
pub(crate) fn pieces<T: Send>(
    values: &mut [T],
    lengths: impl Iterator<Item = usize>,
    f: impl Fn(usize, &mut [T]) + Sync + Send,
) {
    use rayon::iter::{IndexedParallelIterator, IntoParallelIterator, ParallelIterator};
    cut(values, lengths).into_par_iter().enumerate().for_each(|(i, piece)| f(i, piece));
}

/// `f(i, piece)` for consecutive pieces of those lengths.
#[cfg(not(feature = "threads"))]
pub(crate) fn pieces<T: Send>(
    values: &mut [T],
    lengths: impl Iterator<Item = usize>,
    f: impl Fn(usize, &mut [T]) + Sync + Send,
) {
    cut(values, lengths).into_iter().enumerate().for_each(|(i, piece)| f(i, piece));
}

fn cut<T>(mut values: &mut [T], lengths: impl Iterator<Item = usize>) -> Vec<&mut [T]> {
    let next = |length| values.split_off_mut(..length).expect("pieces lie within the whole");
    lengths.map(next).collect()
}
