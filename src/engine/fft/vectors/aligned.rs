//! Numbers that start at a line of the cache.

use std::ops::Deref;

/// Bytes in a line of the cache, and in the widest vector.
const LINE: usize = 64;

/// The number of the first value that starts a line.
pub(in crate::engine::fft) fn line_start<T>(values: &[T]) -> usize {
    values.as_ptr().align_offset(LINE).min(LINE / size_of::<T>())
}

/// Numbers whose vectors lie in one line each.
#[derive(Debug)]
pub(super) struct Aligned<T> {
    values: Vec<T>,
    start: usize,
}

impl<T: Copy + Default> Aligned<T> {
    pub(super) fn new(mut values: Vec<T>) -> Self {
        let len = values.len();
        values.resize(len + LINE / size_of::<T>(), T::default());
        let start = line_start(&values);
        values.truncate(len + start);
        values.copy_within(..len, start);
        Self { values, start }
    }
}

impl<T> Deref for Aligned<T> {
    type Target = [T];

    fn deref(&self) -> &[T] {
        &self.values[self.start..]
    }
}
