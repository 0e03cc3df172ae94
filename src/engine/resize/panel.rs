//! New columns that are made at a time, and what they read.

use crate::engine::resize::job::some;
use crate::engine::resize::sums::LEAST;
use crate::engine::resize::taps::Taps;
use std::ops::Range;

/// Some new columns, and the numbers of old rows that they read. A pixel is some numbers, one after another.
#[derive(Debug)]
pub(super) struct Panel {
    /// The new columns.
    pub(super) new: Range<usize>,
    /// The first old one that they read, and its first number.
    pub(super) first: usize,
    number: usize,
    /// Numbers of an old row, from a multiple of [`LEAST`] on, among them all that are read.
    pub(super) row: Range<usize>,
}

impl Panel {
    /// Pieces of `width` new columns.
    pub(super) fn all(across: &Taps, channels: usize, width: usize) -> impl Iterator<Item = Self> {
        some(0..across.len(), width).map(move |new| {
            let reads = across.reads(new.clone());
            let number = reads.start * channels;
            Self { new, first: reads.start, number, row: number / LEAST * LEAST..reads.end * channels }
        })
    }

    /// Numbers of the row, and a few more so that vectors are full.
    pub(super) fn padded(&self) -> usize {
        self.row.len().next_multiple_of(LEAST)
    }

    /// Where in the row the first number that is read is.
    pub(super) fn offset(&self) -> usize {
        self.number - self.row.start
    }
}
