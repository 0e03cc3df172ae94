//! Threads: the one place that knows rayon.
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
