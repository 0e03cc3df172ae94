//! A piece of the work: some new rows, all that is loaded for them, summed and stored.

use crate::engine::resize::room::Room;
use crate::engine::resize::strips::{Load, Meaning, Store};
use crate::engine::resize::sums::{LEAST, Lines, Sums};
use crate::engine::resize::taps::{Blocks, SIDE};
use crate::engine::resize::view::View;
use crate::engine::simd::{Lanes, SQUARE, Turn, vectorised, with_vectors};
use std::ops::Range;

/// Rows that are summed side by side on the way across.
pub(super) const ROWS: usize = 32;

/// Numbers of a row that are summed down at a time: with those of the old rows that a group of new ones reads they stay in
/// the first cache, or nearly so.
const fn strip<T>() -> usize {
    256 / size_of::<T>()
}

/// Numbers of old rows, or of new ones if these are longer, between whose sums memory is not left: with the rows of a
/// window they stay in the second cache.
const PANEL: f64 = 512.0;

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
    fn panels(&self) -> impl Iterator<Item = Range<usize>> + use<C, M> {
        let across = &self.across.taps;
        let (old, new, channels) = (across.old() as f64, across.len(), self.source.layout.channels as f64);
        let width = PANEL / (old / new as f64).max(1.0) / channels;
        let width = (width as usize).next_multiple_of(ROWS).max(ROWS);
        (0..new).step_by(width).map(move |x| x..(x + width).min(new))
    }

    /// So many new rows at a time, the last time perhaps fewer.
    fn groups<'t>(
        &self,
        rows: usize,
        target: &'t mut [C],
    ) -> impl Iterator<Item = (Range<usize>, &'t mut [C])> + use<'t, C, M> {
        let end = self.rows.end;
        let starts = self.rows.clone().step_by(rows);
        starts.map(move |y| y..(y + rows).min(end)).zip(target.chunks_mut(rows * self.stride))
    }

    fn load(&self, rows: Range<i64>, columns: Range<i64>, to: &mut [M::Sum], stride: usize) {
        let (across, down) = (&self.across.taps, &self.down.taps);
        vectorised(Load { meaning: self.meaning, view: self.source, across, down, rows, columns, to, stride });
    }

    fn store(&self, from: &[M::Sum], stride: usize, width: usize, rows: usize, to: &mut [C]) {
        vectorised(Store { meaning: self.meaning, from, stride, width, rows, to, to_stride: self.stride });
    }

    /// Rows before columns: a group of new rows at a time.
    pub(super) fn down_first(&self, target: &mut [C], room: &mut Room<M::Sum>) {
        let (channels, strip) = (self.source.layout.channels, strip::<M::Sum>());
        for panel in self.panels() {
            let reads = self.across.reads(&panel);
            let start = reads.start * channels as i64;
            let strips = ((reads.end - reads.start) as usize * channels).div_ceil(strip);
            let line = panel.len().next_multiple_of(ROWS) * channels + LEAST;
            for (group, target) in self.groups(ROWS, target) {
                let inside = self.inside(self.down.reads(&group), start, strips);
                self.down_inside(&group, start, inside.clone(), strips, room);
                self.down_copied(&group, start, 0..inside.start, strips, room);
                self.down_copied(&group, start, inside.end..strips, strips, room);
                let columns = room.columns.numbers(strips * strip * ROWS);
                let (finished, sums) = (room.rows.numbers(ROWS * line), room.sums.numbers(ROWS * ROWS * channels));
                self.across_panel(panel.clone(), reads.start, columns, sums, finished, line);
                let width = panel.len() * channels;
                self.store(finished, line, width, group.len(), &mut target[panel.start * channels..]);
            }
        }
    }

    /// The strips from `start` on that can be summed where they stand; the rest must be copied first.
    fn inside(&self, rows: Range<i64>, start: i64, strips: usize) -> Range<usize> {
        let (layout, strip) = (self.source.layout, strip::<M::Sum>() as i64);
        if self.meaning.direct(self.source.values).is_none() || rows.start < 0 || rows.end > layout.height as i64 {
            return 0..0;
        }
        let first = (-start).max(0).unsigned_abs().div_ceil(strip.unsigned_abs()) as usize;
        let last = (layout.row() as i64 - start).max(0) / strip;
        first.min(strips)..(last as usize).clamp(first.min(strips), strips)
    }

    /// The sums of the rows of a group, where they stand, turned.
    fn down_inside(
        &self,
        group: &Range<usize>,
        start: i64,
        inside: Range<usize>,
        strips: usize,
        room: &mut Room<M::Sum>,
    ) {
        let (strip, down) = (strip::<M::Sum>(), self.down);
        let Some(values) = self.meaning.direct(self.source.values).filter(|_| !inside.is_empty()) else { return };
        let width = inside.len() * strip;
        let sums = room.sums.numbers(SQUARE * width);
        let columns = &mut room.columns.numbers(strips * strip * ROWS)[inside.start * strip * ROWS..];
        for (rows, at) in group.clone().step_by(SQUARE).zip((0..ROWS).step_by(SQUARE)) {
            let rows = rows..(rows + SQUARE).min(group.end);
            let first = down.reads(&rows).start;
            let stride = self.source.layout.stride;
            let place = first as usize * stride + (start + (inside.start * strip) as i64) as usize;
            self.sums(down, rows, Lines { numbers: &values[place..], first, stride }, width, sums, width);
            let to = &mut columns[at..];
            M::Sum::turn(Turn { from: sums, stride: width, rows: SQUARE, columns: width, to, to_stride: ROWS });
        }
    }

    /// The sums of copied rows of a group, turned.
    fn down_copied(
        &self,
        group: &Range<usize>,
        start: i64,
        copied: Range<usize>,
        strips: usize,
        room: &mut Room<M::Sum>,
    ) {
        let (strip, down) = (strip::<M::Sum>(), self.down);
        if copied.is_empty() {
            return;
        }
        let (reads, stride) = (down.reads(group), copied.len() * strip + LEAST);
        let lines = room.lines.numbers((reads.end - reads.start) as usize * stride);
        let columns = &mut room.columns.numbers(strips * strip * ROWS)[copied.start * strip * ROWS..];
        let sums = room.sums.numbers(ROWS * strip);
        let at = [copied.start, copied.end].map(|s| start + (s * strip) as i64);
        self.load(reads.clone(), at[0]..at[1], lines, stride);
        for (s, columns) in copied.zip(columns.chunks_mut(strip * ROWS)) {
            let offset = (start + (s * strip) as i64 - at[0]) as usize;
            let lines = Lines { numbers: &lines[offset..], first: reads.start, stride };
            self.sums(down, group.clone(), lines, strip, sums, strip);
            M::Sum::turn(Turn { from: sums, stride: strip, rows: ROWS, columns: strip, to: columns, to_stride: ROWS });
        }
    }

    /// Columns before rows: all old rows that the new ones read.
    pub(super) fn across_first(&self, target: &mut [C], room: &mut Room<M::Sum>) {
        let (channels, down) = (self.source.layout.channels, self.down);
        let reads_down = down.reads(&self.rows);
        let blocks = ((reads_down.end - reads_down.start) as usize).div_ceil(ROWS);
        for panel in self.panels() {
            let reads = self.across.reads(&panel);
            let at = reads.start * channels as i64..reads.end * channels as i64;
            let (count, width) = ((at.end - at.start) as usize, panel.len() * channels);
            let padded = count.next_multiple_of(LEAST);
            let all = panel.len().next_multiple_of(ROWS) * channels;
            let line = all + LEAST;
            let finished = room.rows.numbers(blocks * ROWS * line);
            let sums = room.sums.numbers(ROWS * ROWS * channels.max(all / ROWS));
            let lines = room.lines.numbers(ROWS * padded);
            let columns = room.columns.numbers(padded * ROWS);
            for (b, finished) in finished.chunks_mut(ROWS * line).enumerate() {
                let top = reads_down.start + (b * ROWS) as i64;
                self.load(top..(top + ROWS as i64).min(reads_down.end), at.clone(), lines, padded);
                M::Sum::turn(Turn {
                    from: lines,
                    stride: padded,
                    rows: ROWS,
                    columns: padded,
                    to: columns,
                    to_stride: ROWS,
                });
                self.across_panel(panel.clone(), reads.start, columns, sums, finished, line);
            }
            for (group, target) in self.groups(SIDE, target) {
                let lines = Lines { numbers: finished, first: reads_down.start, stride: line };
                self.sums(down, group.clone(), lines, all, sums, all);
                self.store(sums, all, width, group.len(), &mut target[panel.start * channels..]);
            }
        }
    }

    fn sums(
        &self,
        blocks: &Blocks<M::Sum>,
        new: Range<usize>,
        lines: Lines<'_, M::Sum>,
        width: usize,
        to: &mut [M::Sum],
        to_stride: usize,
    ) {
        with_vectors(Sums { blocks, new, fused: self.fused, lines, width, to, to_stride });
    }

    /// The new columns of a panel, from the old ones of [`ROWS`] rows, to as many rows `line` apart.
    fn across_panel(
        &self,
        panel: Range<usize>,
        first: i64,
        columns: &[M::Sum],
        sums: &mut [M::Sum],
        rows: &mut [M::Sum],
        line: usize,
    ) {
        let channels = self.source.layout.channels;
        let wide = ROWS * channels;
        for x in panel.clone().step_by(ROWS) {
            let lines = Lines { numbers: columns, first, stride: wide };
            self.sums(self.across, x..(x + ROWS).min(panel.end), lines, wide, sums, wide);
            let to = &mut rows[(x - panel.start) * channels..];
            M::Sum::turn(Turn { from: sums, stride: ROWS, rows: wide, columns: ROWS, to, to_stride: line });
        }
    }
}
