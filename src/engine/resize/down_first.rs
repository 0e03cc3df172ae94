//! Rows before columns: for images that become smaller.

use crate::engine::real::Real;
use crate::engine::resize::code::Direct;
use crate::engine::resize::job::{Job, ROWS, some};
use crate::engine::resize::lines::Lines;
use crate::engine::resize::panel::Panel;
use crate::engine::resize::room::{Aligned, Room};
use crate::engine::resize::shares::{Share, Shares, TOGETHER};
use crate::engine::resize::strips::Meaning;
use crate::engine::resize::sums::{LEAST, Sums};
use crate::engine::resize::taps::SIDE;
use crate::engine::simd::{Lanes, Turn, with_vectors};
use std::ops::Range;

/// Numbers of rows that are widened into the first cache and shared out from there.
const STRIP: usize = 512;

impl<C: Copy + Send + Sync, M: Meaning<C>> Job<'_, C, M> {
    /// A group of new rows at a time, down and then across.
    pub(super) fn down_first(&self, target: &mut [C], room: &mut Room<M::Sum>) {
        let channels = self.channels();
        let most =
            some(self.rows.clone(), ROWS).map(|group| self.end_of_takers(&group) - group.start).max().unwrap_or(ROWS);
        let slots = most.next_multiple_of(ROWS);
        for panel in self.panels(slots) {
            let (padded, wide) = (panel.padded(), panel.new.len() * channels);
            let line = panel.new.len().next_multiple_of(ROWS) * channels + LEAST;
            let next = self.down.reads(&self.rows).start;
            let mut down = Down { job: self, panel: &panel, slots, stride: padded + LEAST, next };
            for (group, target) in self.groups(ROWS, target) {
                down.group(&group, room);
                let from = &down.sums(&mut room.sums)[down.at(group.start)..];
                let columns = room.columns.numbers(padded * ROWS);
                let to = &mut *columns;
                M::Sum::turn(Turn { from, stride: down.stride, rows: ROWS, columns: padded, to, to_stride: ROWS });
                let squares = room.squares.numbers(ROWS * ROWS * channels);
                let finished = room.rows.numbers(ROWS * line);
                self.across_panel(&panel, columns, squares, finished, line);
                self.store(finished, line, wide, group.len(), &mut target[panel.new.start * channels..]);
            }
        }
    }

    /// Where the new rows end that take something of what is read for a group.
    fn end_of_takers(&self, group: &Range<usize>) -> usize {
        if let Direct::Narrow(_) = self.meaning.direct(self.source.values) {
            return group.end;
        }
        let end = self.down.reads(group).end;
        let later = (group.end..self.rows.end).rev().find(|y| self.down.reads(&(*y..y + 1)).start < end);
        later.map_or(group.end, |y| y + 1)
    }
}

/// The way down of a panel: new rows and their sums, in turn in some slots.
///
/// An image is read from memory, and so it is read once: its rows are shared out to all new ones that read them, while the
/// sums of these stay in the second cache. But bytes and words are fewer than the sums that they go into; of them it is the
/// rows that stay there, and new ones come back to them.
struct Down<'a, C, M: Meaning<C>> {
    job: &'a Job<'a, C, M>,
    panel: &'a Panel,
    slots: usize,
    /// Numbers from the sums of one row to those of the next.
    stride: usize,
    /// The first old row that is not yet shared out.
    next: usize,
}

impl<C: Copy + Send + Sync, M: Meaning<C>> Down<'_, C, M> {
    /// Which slot a row has.
    fn slot(&self, row: usize) -> usize {
        (row - self.job.rows.start) % self.slots
    }

    fn at(&self, row: usize) -> usize {
        self.slot(row) * self.stride
    }

    fn sums<'r>(&self, room: &'r mut Aligned<M::Sum>) -> &'r mut [M::Sum] {
        room.numbers(self.slots * self.stride)
    }

    /// Finishes the sums of a group.
    fn group(&mut self, group: &Range<usize>, room: &mut Room<M::Sum>) {
        let (job, reads) = (self.job, self.job.down.reads(group));
        match job.meaning.direct(job.source.values) {
            Direct::Narrow(numbers) => {
                let width = self.panel.row.len() / LEAST * LEAST;
                let lines = Lines { numbers, first: 0, stride: job.source.layout.stride };
                let (blocks, fused, at, stride) = (job.down, job.fused, self.panel.row.start, self.stride);
                for new in some(group.clone(), SIDE) {
                    let to = &mut self.sums(&mut room.sums)[self.at(new.start)..];
                    with_vectors(Sums { blocks, new, fused, lines, at, width, to, stride });
                }
                self.share(group.clone(), reads, width, room);
            }
            Direct::Themselves(_) | Direct::Not => {
                self.share(group.start..job.end_of_takers(group), self.next..reads.end, 0, room);
                self.next = self.next.max(reads.end);
            }
        }
    }

    /// Gives some old rows, from this number on, to those of some new ones that read them.
    fn share(&self, rows: Range<usize>, old: Range<usize>, from: usize, room: &mut Room<M::Sum>) {
        let (job, panel, padded) = (self.job, self.panel, self.panel.padded());
        for top in old.clone().step_by(TOGETHER).filter(|_| from < padded) {
            self.shares(rows.clone(), top..old.end, &mut room.shares);
            // behind the last row that one once more, for nothing
            let four: [_; TOGETHER] = std::array::from_fn(|k| (top + k).min(old.end - 1));
            let (to, lines) = (self.sums(&mut room.sums), room.lines.numbers(TOGETHER * STRIP));
            let (shares, fused, stride) = (&room.shares[..], job.fused, self.stride);
            let mut rest = from;
            if let Direct::Themselves(numbers) = job.meaning.direct(job.source.values) {
                let rows = four.map(|y| &numbers[y * job.source.layout.stride + panel.row.start..]);
                rest = panel.row.len() / LEAST * LEAST;
                with_vectors(Shares { shares, fused, rows, width: rest, to, stride });
            }
            for strip in some(rest..padded, STRIP) {
                let numbers = panel.row.start + strip.start..(panel.row.start + strip.end).min(panel.row.end);
                for (row, to) in four.iter().zip(lines.chunks_mut(STRIP)) {
                    job.load(*row, numbers.clone(), to);
                }
                let rows = std::array::from_fn(|k| &lines[k * STRIP..]);
                with_vectors(Shares { shares, fused, rows, width: strip.len(), to: &mut to[strip.start..], stride });
            }
        }
    }

    /// What each of some new rows takes of the first few old ones.
    fn shares(&self, rows: Range<usize>, old: Range<usize>, shares: &mut Vec<Share<M::Sum>>) {
        let taps = &self.job.down.taps;
        shares.clear();
        for row in rows {
            let weight = |k: usize| if old.start + k < old.end { taps.weight(row, old.start + k) } else { None };
            let weights: [_; TOGETHER] = std::array::from_fn(weight);
            if weights.iter().any(Option::is_some) {
                let first = old.start <= taps.reads(row..row + 1).start;
                let weights = weights.map(|w| M::Sum::of(w.unwrap_or(0.0)));
                shares.push(Share { slot: self.slot(row), first, weights });
            }
        }
    }
}
