//! New columns that are made at a time, and what they read.

use crate::engine::resize::sums::LEAST;
use crate::engine::resize::taps::Taps;
use std::ops::Range;

/// Some new columns, and the numbers of old rows that they read. A pixel is some numbers, one after another.
#[derive(Debug)]
pub(super) struct Panel {
    /// The new columns.
    pub(super) new: Range<usize>,
    channels: usize,
    /// The old pixels that they read, beyond the borders too.
    reads: Range<i64>,
    /// Numbers of an old row, from a multiple of [`LEAST`] on, among them all that are read.
    pub(super) row: Range<usize>,
}

impl Panel {
    /// Pieces of `width` new columns; all columns at once if a piece reads beyond a border what is not beside it.
    pub(super) fn all(across: &Taps, channels: usize, width: usize) -> impl Iterator<Item = Self> {
        let pieces = move |width| {
            let starts = (0..across.len()).step_by(width);
            starts.map(move |x| Self::new(across, channels, x..(x + width).min(across.len())))
        };
        let near = pieces(width).all(|panel| panel.is_near(across));
        pieces(if near { width } else { across.len() }).map(move |panel| {
            let row = if near { panel.row } else { 0..across.old() * channels };
            Self { row, ..panel }
        })
    }

    fn new(across: &Taps, channels: usize, new: Range<usize>) -> Self {
        let reads = across.reads(new.clone());
        let [first, end] = [reads.start, reads.end].map(|x| x.clamp(0, across.old() as i64) as usize * channels);
        Self { new, channels, reads, row: first / LEAST * LEAST..end }
    }

    /// Whether all that is read beyond a border stands among the numbers of the row.
    fn is_near(&self, across: &Taps) -> bool {
        let near = |x: usize| self.row.start <= x * self.channels && x * self.channels < self.row.end;
        self.outside(across).all(|(_, place)| place.is_none_or(near))
    }

    /// The positions that are read beyond the borders, and where they stand.
    fn outside<'a>(&self, across: &'a Taps) -> impl Iterator<Item = (i64, Option<usize>)> + use<'a> {
        let (Range { start, end }, old) = (self.reads.clone(), across.old() as i64);
        (start..end.min(0)).chain(start.max(old)..end).map(|x| (x, across.place(x)))
    }

    /// Numbers of the row, and a few more so that vectors are full.
    pub(super) fn padded(&self) -> usize {
        self.row.len().next_multiple_of(LEAST)
    }

    /// The number of the first column, beyond the border or not.
    fn base(&self) -> i64 {
        (self.reads.start * self.channels as i64).min(self.row.start as i64)
    }

    /// Where the column of a number is among all columns.
    fn column(&self, number: i64) -> usize {
        (number - self.base()) as usize
    }

    /// How many columns of numbers there are: of the row and beyond.
    pub(super) fn columns(&self) -> usize {
        let row = (self.row.start + self.padded()) as i64;
        self.column(row.max(self.reads.end * self.channels as i64))
    }

    /// Where those of the row begin.
    pub(super) fn inside(&self) -> usize {
        self.column(self.row.start as i64)
    }

    /// Where those of the first pixel that is read begin, and which one it is.
    pub(super) fn first(&self) -> (usize, i64) {
        (self.column(self.reads.start * self.channels as i64), self.reads.start)
    }

    /// Copies columns of `length` numbers to those beyond the borders.
    pub(super) fn continue_beyond<T: Copy + Default>(&self, across: &Taps, columns: &mut [T], length: usize) {
        let pixel = self.channels * length;
        let at = |x: i64| self.column(x * self.channels as i64) * length;
        for (x, place) in self.outside(across) {
            match place {
                Some(place) => columns.copy_within(at(place as i64)..at(place as i64) + pixel, at(x)),
                None => columns[at(x)..at(x) + pixel].fill(T::default()),
            }
        }
    }
}
