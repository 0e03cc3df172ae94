//! Columns before rows.

use crate::engine::resize::job::{Job, ROWS, some};
use crate::engine::resize::lines::Lines;
use crate::engine::resize::room::Room;
use crate::engine::resize::strips::Meaning;
use crate::engine::resize::sums::{LEAST, Sums};
use crate::engine::resize::taps::SIDE;
use crate::engine::simd::{Lanes, Turn, with_vectors};

/// Numbers of rows that are summed down into the first cache and stored from there.
const STRIP: usize = 1024;

impl<C: Copy + Send + Sync, M: Meaning<C>> Job<'_, C, M> {
    /// All old rows that the new ones read, finished across; then these.
    pub(super) fn across_first(&self, target: &mut [C], room: &mut Room<M::Sum>) {
        let channels = self.channels();
        let reads = self.down.reads(&self.rows);
        let blocks = reads.len().div_ceil(ROWS);
        for panel in self.panels(blocks * ROWS) {
            let (padded, wide) = (panel.padded(), panel.new.len() * channels);
            let line = panel.new.len().next_multiple_of(ROWS) * channels + LEAST;
            let finished = room.rows.numbers(blocks * ROWS * line);
            let lines = room.lines.numbers(ROWS * padded);
            let columns = room.columns.numbers(padded * ROWS);
            let squares = room.squares.numbers(ROWS * ROWS * channels);
            for (b, finished) in finished.chunks_mut(ROWS * line).enumerate() {
                for (row, to) in (reads.start + b * ROWS..reads.end).zip(lines.chunks_mut(padded)) {
                    self.load(row, panel.row.clone(), to);
                }
                let to = &mut *columns;
                M::Sum::turn(Turn { from: lines, stride: padded, rows: ROWS, columns: padded, to, to_stride: ROWS });
                self.across_panel(&panel, columns, squares, finished, line);
            }
            let lines = Lines { numbers: finished, first: reads.start, stride: line };
            let sums = room.sums.numbers(SIDE * STRIP);
            for (group, target) in self.groups(SIDE, target) {
                for strip in some(0..wide, STRIP) {
                    let width = strip.len().next_multiple_of(LEAST);
                    let (blocks, new, fused, to) = (self.down, group.clone(), self.fused, &mut *sums);
                    with_vectors(Sums { blocks, new, fused, lines, at: strip.start, width, to, stride: STRIP });
                    let to = &mut target[panel.new.start * channels + strip.start..];
                    self.store(sums, STRIP, strip.len(), group.len(), to);
                }
            }
        }
    }
}
