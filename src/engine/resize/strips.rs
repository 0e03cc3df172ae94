//! Numbers of an image to numbers that sums are made of, and back.

use crate::engine::resize::code::Code;
use crate::engine::resize::taps::Taps;
use crate::engine::resize::view::View;
use crate::engine::simd::{Lanes, Loop};
use std::ops::Range;

/// What the numbers of an image stand for. Implementations are `#[inline(always)]`.
pub(super) trait Meaning<C>: Sync {
    type Sum: Lanes;
    fn widen(&self, from: &[C], to: &mut [Self::Sum]);
    fn narrow(&self, from: &[Self::Sum], to: &mut [C]);
    /// The numbers themselves, if they are what sums are made of.
    fn direct<'a>(&self, _: &'a [C]) -> Option<&'a [Self::Sum]> {
        None
    }
}

/// For themselves.
pub(super) struct Themselves;

impl<C: Code> Meaning<C> for Themselves {
    type Sum = C::Sum;

    #[inline(always)]
    fn widen(&self, from: &[C], to: &mut [C::Sum]) {
        C::widen(from, to);
    }

    #[inline(always)]
    fn narrow(&self, from: &[C::Sum], to: &mut [C]) {
        C::narrow(from, to);
    }

    fn direct<'a>(&self, values: &'a [C]) -> Option<&'a [C::Sum]> {
        C::direct(values)
    }
}

/// A piece of some rows, continued beyond the borders.
pub(super) struct Load<'a, C, M: Meaning<C>> {
    pub(super) meaning: &'a M,
    pub(super) view: View<'a, C>,
    pub(super) across: &'a Taps,
    pub(super) down: &'a Taps,
    pub(super) rows: Range<i64>,
    /// From where to where, counted in numbers and not in pixels.
    pub(super) columns: Range<i64>,
    pub(super) to: &'a mut [M::Sum],
    pub(super) stride: usize,
}

impl<C: Copy + Sync, M: Meaning<C>> Loop for Load<'_, C, M> {
    #[inline(always)]
    fn run(self) {
        let Self { meaning, view, across, down, rows, columns, to, stride } = self;
        let (width, channels) = (view.layout.row() as i64, view.layout.channels as i64);
        let first = 0.clamp(columns.start, columns.end);
        let inside = first..width.clamp(first, columns.end);
        for (row, to) in rows.zip(to.chunks_mut(stride)) {
            let to = &mut to[..(columns.end - columns.start) as usize];
            let Some(y) = down.place(row) else {
                to.fill(M::Sum::default());
                continue;
            };
            let from = view.row(y);
            if inside == columns {
                meaning.widen(&from[columns.start as usize..][..to.len()], to);
                continue;
            }
            if !inside.is_empty() {
                let part = (inside.start - columns.start) as usize..(inside.end - columns.start) as usize;
                meaning.widen(&from[inside.start as usize..inside.end as usize], &mut to[part]);
            }
            for i in (columns.start..inside.start).chain(inside.end..columns.end) {
                let to = &mut to[(i - columns.start) as usize..][..1];
                match across.place(i.div_euclid(channels)) {
                    Some(x) => meaning.widen(&from[x * channels as usize + i.rem_euclid(channels) as usize..][..1], to),
                    None => to[0] = M::Sum::default(),
                }
            }
        }
    }
}

/// Finished pieces of rows.
pub(super) struct Store<'a, C, M: Meaning<C>> {
    pub(super) meaning: &'a M,
    pub(super) from: &'a [M::Sum],
    pub(super) stride: usize,
    pub(super) width: usize,
    pub(super) rows: usize,
    pub(super) to: &'a mut [C],
    pub(super) to_stride: usize,
}

impl<C: Copy, M: Meaning<C>> Loop for Store<'_, C, M> {
    #[inline(always)]
    fn run(self) {
        let Self { meaning, from, stride, width, rows, to, to_stride } = self;
        for (from, to) in from.chunks(stride).zip(to.chunks_mut(to_stride)).take(rows) {
            meaning.narrow(&from[..width], &mut to[..width]);
        }
    }
}
