//! Numbers of an image to numbers that sums are made of, and back.

use crate::engine::real::Real;
use crate::engine::resize::code::{Code, Direct};
use crate::engine::simd::Loop;

/// What the numbers of an image stand for. Implementations are `#[inline(always)]`.
pub(super) trait Meaning<C>: Sync {
    type Sum: Real + Code<Sum = Self::Sum>;
    /// What sums can be made of as it stands.
    type Line: Code<Sum = Self::Sum>;
    fn widen(&self, from: &[C], to: &mut [Self::Sum]);
    fn narrow(&self, from: &[Self::Sum], to: &mut [C]);
    /// The numbers as they stand, if sums can be made of them.
    fn direct<'a>(&self, values: &'a [C]) -> Direct<'a, Self::Line>;
}

/// For themselves.
pub(super) struct Themselves;

impl<C: Code> Meaning<C> for Themselves {
    type Sum = C::Sum;
    type Line = C;

    #[inline(always)]
    fn widen(&self, from: &[C], to: &mut [C::Sum]) {
        C::widen(from, to);
    }

    #[inline(always)]
    fn narrow(&self, from: &[C::Sum], to: &mut [C]) {
        C::narrow(from, to);
    }

    fn direct<'a>(&self, values: &'a [C]) -> Direct<'a, C> {
        C::direct(values)
    }
}

/// A piece of a row, to be summed.
pub(super) struct Load<'a, C, M: Meaning<C>> {
    pub(super) meaning: &'a M,
    pub(super) from: &'a [C],
    pub(super) to: &'a mut [M::Sum],
}

impl<C, M: Meaning<C>> Loop for Load<'_, C, M> {
    #[inline(always)]
    fn run(self) {
        self.meaning.widen(self.from, self.to);
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
