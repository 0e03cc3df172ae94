//! Room to work in, kept by a plan.

use crate::engine::fft::vectors::line_start;
use num_complex::Complex;
use std::fmt;
use std::sync::{Mutex, PoisonError};

/// Buffers that are lent and taken back: a plan allocates in its first call on every thread, and no more.
pub(crate) struct Pool<T>(Mutex<Vec<Vec<Complex<T>>>>);

/// As many as a line of the cache has, at most.
const SPARE: usize = 8;

impl<T: Copy + Default> Pool<T> {
    pub(crate) fn new() -> Self {
        Self(Mutex::new(Vec::new()))
    }

    /// `f` with room for `len` numbers, whatever they are, from the start of a line of the cache on (where the
    /// allocator aligns numbers at all).
    pub(crate) fn lend<R>(&self, len: usize, f: impl FnOnce(&mut [Complex<T>]) -> R) -> R {
        let free = || self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let mut room = free().pop().unwrap_or_default();
        if room.len() < len + SPARE {
            room.resize(len + SPARE, Complex::default());
        }
        let start = line_start(&room);
        let result = f(&mut room[start..start + len]);
        free().push(room);
        result
    }
}

impl<T> fmt::Debug for Pool<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Pool")
    }
}
