//! Room to work in, kept by a plan.

use crate::engine::real::Real;
use crate::engine::resize::shares::Share;
use std::fmt;
use std::sync::{Mutex, PoisonError};

/// Numbers from the beginning of a line of the cache on, so that no vector lies on two.
#[derive(Default)]
pub(super) struct Aligned<T>(Vec<T>);

impl<T: Real> Aligned<T> {
    const LINE: usize = 64;

    /// So many, whatever they are.
    pub(super) fn numbers(&mut self, n: usize) -> &mut [T] {
        let all = n + Self::LINE / size_of::<T>();
        if self.0.len() < all {
            self.0.resize(all, T::zero());
        }
        let at = self.0.as_ptr().align_offset(Self::LINE).min(all - n);
        &mut self.0[at..at + n]
    }
}

/// What one thread needs.
#[derive(Default)]
pub(super) struct Room<T> {
    /// Old numbers.
    pub(super) lines: Aligned<T>,
    /// The sums of some of them.
    pub(super) sums: Aligned<T>,
    /// Rows, turned.
    pub(super) columns: Aligned<T>,
    /// New columns of a few pixels, not yet turned.
    pub(super) squares: Aligned<T>,
    /// Rows whose columns are finished.
    pub(super) rows: Aligned<T>,
    /// What new rows take of some old ones.
    pub(super) shares: Vec<Share<T>>,
}

/// Rooms that are lent and taken back: a plan allocates in its first call on every thread, and no more.
pub(super) struct Rooms<T>(Mutex<Vec<Room<T>>>);

impl<T: Real> Rooms<T> {
    pub(super) fn new() -> Self {
        Self(Mutex::new(Vec::new()))
    }

    pub(super) fn lend(&self, f: impl FnOnce(&mut Room<T>)) {
        let free = || self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let mut room = free().pop().unwrap_or_default();
        f(&mut room);
        free().push(room);
    }
}

impl<T> fmt::Debug for Rooms<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Rooms")
    }
}
