//! A piece of the work: some new rows, all that is loaded for them, summed and stored.

use crate::engine::resize::lines::Lines;
use crate::engine::resize::panel::Panel;
use crate::engine::resize::strips::{Load, Meaning, Store};
use crate::engine::resize::sums::Sums;
use crate::engine::resize::taps::Blocks;
use crate::engine::resize::view::View;
use crate::engine::simd::{Lanes, Turn, vectorised, with_vectors};
use std::ops::Range;

/// Rows that are summed side by side on the way across.
pub(super) const ROWS: usize = 32;

/// The most numbers of a piece of a row, as long as memory is read and written row by row.
const PIECE: usize = 4096;

/// Bytes of the pieces of rows that are read again and again: half of a second cache.
const WINDOW: usize = 1 << 20;

/// Some new rows of an image.
pub(super) struct Job<'a, C, M: Meaning<C>> {
    pub(super) across: &'a Blocks<M::Sum>,
    pub(super) down: &'a Blocks<M::Sum>,
    pub(super) fused: bool,
    pub(super) meaning: &'a M,
    pub(super) source: View<'a, C>,
    pub(super) rows: Range<usize>,
    /// From one new row to the next.
    pub(super) stride: usize,
}

impl<C: Copy + Send + Sync, M: Meaning<C>> Job<'_, C, M> {
    pub(super) fn channels(&self) -> usize {
        self.source.layout.channels
    }

    /// Pieces of rows of which so many stay in the second cache.
    pub(super) fn panels(&self, rows: usize) -> impl Iterator<Item = Panel> {
        let across = &self.across.taps;
        let piece = (WINDOW / size_of::<M::Sum>() / rows).min(PIECE) as f64;
        let width = piece / (across.old() as f64 / across.len() as f64).max(1.0) / self.channels() as f64;
        Panel::all(across, self.channels(), (width as usize).next_multiple_of(ROWS).max(ROWS))
    }

    /// So many new rows at a time, the last time perhaps fewer.
    pub(super) fn groups<'t>(
        &self,
        rows: usize,
        target: &'t mut [C],
    ) -> impl Iterator<Item = (Range<usize>, &'t mut [C])> + use<'t, C, M> {
        some(self.rows.clone(), rows).zip(target.chunks_mut(rows * self.stride))
    }

    /// A piece of an old row.
    pub(super) fn load(&self, row: usize, numbers: Range<usize>, to: &mut [M::Sum]) {
        let (meaning, from) = (self.meaning, &self.source.row(row)[numbers]);
        vectorised(Load { meaning, to: &mut to[..from.len()], from });
    }

    pub(super) fn store(&self, from: &[M::Sum], stride: usize, width: usize, rows: usize, to: &mut [C]) {
        vectorised(Store { meaning: self.meaning, from, stride, width, rows, to, to_stride: self.stride });
    }

    /// The new columns of a panel, from the old ones of [`ROWS`] rows, to as many rows `line` apart.
    pub(super) fn across_panel(
        &self,
        panel: &Panel,
        columns: &[M::Sum],
        sums: &mut [M::Sum],
        rows: &mut [M::Sum],
        line: usize,
    ) {
        let wide = ROWS * self.channels();
        let lines = Lines { numbers: &columns[panel.offset() * ROWS..], first: panel.first, stride: wide };
        let (blocks, fused) = (self.across, self.fused);
        for x in some(panel.new.clone(), ROWS) {
            let (new, to) = (x.clone(), &mut *sums);
            with_vectors(Sums { blocks, new, fused, lines, at: 0, width: wide, to, stride: wide });
            let to = &mut rows[(x.start - panel.new.start) * self.channels()..];
            M::Sum::turn(Turn { from: sums, stride: ROWS, rows: wide, columns: ROWS, to, to_stride: line });
        }
    }
}

/// A range in pieces of so many, the last one perhaps shorter.
pub(super) fn some(range: Range<usize>, many: usize) -> impl Iterator<Item = Range<usize>> {
    let end = range.end;
    range.step_by(many).map(move |start| start..(start + many).min(end))
}
