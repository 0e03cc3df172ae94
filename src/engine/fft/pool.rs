//! Room to work in, kept by a plan.

use num_complex::Complex;
use std::fmt;
use std::sync::{Mutex, PoisonError};

/// Buffers that are lent and taken back: a plan allocates in its first call on every thread, and no more.
pub(crate) struct Pool<T>(Mutex<Vec<Vec<Complex<T>>>>);

impl<T: Copy + Default> Pool<T> {
    pub(crate) fn new() -> Self {
        Self(Mutex::new(Vec::new()))
    }

    /// `f` with room for `len` numbers, whatever they are.
    pub(crate) fn lend<R>(&self, len: usize, f: impl FnOnce(&mut [Complex<T>]) -> R) -> R {
        let free = || self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let mut room = free().pop().unwrap_or_default();
        if room.len() < len {
            room.resize(len, Complex::default());
        }
        let result = f(&mut room[..len]);
        free().push(room);
        result
    }
}

impl<T> fmt::Debug for Pool<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Pool")
    }
}
