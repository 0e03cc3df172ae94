//! Vectors with the operators of numbers.

use crate::engine::real::Real;
use crate::engine::simd::{Lanes, Order, Simd};
use std::ops::{Add, Mul, Sub};

/// `body` for every `index` from zero on below `count ≤ 16`, which is known when the code is made: sixteen times in a row,
/// so that arrays of vectors stay in registers.
macro_rules! unrolled {
    ($index:ident < $count:expr, $body:expr) => {
        $crate::engine::simd::unrolled!($index < $count, $body; 0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15)
    };
    ($index:ident < $count:expr, $body:expr; $($number:literal)*) => {
        $({
            let $index = $number;
            if $index < $count {
                $body
            }
        })*
    };
}
pub(in crate::engine) use unrolled;

/// The most numbers that a vector has.
pub(in crate::engine) const LANES: usize = 16;

/// A vector of `T`.
pub(in crate::engine) struct Wide<T: Lanes, S: Simd> {
    simd: S,
    vector: T::Vector<S>,
}

impl<T: Lanes, S: Simd> Clone for Wide<T, S> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<T: Lanes, S: Simd> Copy for Wide<T, S> {}

impl<T: Real, S: Simd> Wide<T, S> {
    /// How many numbers a vector has: a power of two, `LANES` at most.
    pub(in crate::engine) const COUNT: usize = size_of::<T::Vector<S>>() / size_of::<T>();

    #[inline(always)]
    fn new(simd: S, vector: T::Vector<S>) -> Self {
        Self { simd, vector }
    }

    /// One number everywhere.
    #[inline(always)]
    pub(in crate::engine) fn splat(simd: S, value: T) -> Self {
        Self::new(simd, T::splat(simd, value))
    }

    /// The numbers from `at` on.
    #[inline(always)]
    pub(in crate::engine) fn read(simd: S, from: &[T], at: usize) -> Self {
        Self::new(simd, bytemuck::pod_read_unaligned(bytemuck::cast_slice(&from[at..at + Self::COUNT])))
    }

    /// To the places from `at` on.
    #[inline(always)]
    pub(in crate::engine) fn write(self, to: &mut [T], at: usize) {
        to[at..at + Self::COUNT].copy_from_slice(bytemuck::cast_slice(&[self.vector]));
    }

    /// `self + a·b`.
    #[inline(always)]
    pub(in crate::engine) fn plus_product(self, a: Self, b: Self) -> Self {
        Self::new(self.simd, T::fuse_product(self.simd, a.vector, b.vector, self.vector))
    }

    /// `self − a·b`.
    #[inline(always)]
    pub(in crate::engine) fn less_product(self, a: Self, b: Self) -> Self {
        Self::new(self.simd, T::fuse_less(self.simd, a.vector, b.vector, self.vector))
    }

    /// The numbers of two vectors in another order.
    #[inline(always)]
    pub(in crate::engine) fn rearranged([a, b]: [Self; 2], order: Order) -> [Self; 2] {
        let [first, second] = T::rearranged(a.simd, [a.vector, b.vector], order);
        [Self::new(a.simd, first), Self::new(a.simd, second)]
    }
}

impl<T: Real, S: Simd> Add for Wide<T, S> {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self::new(self.simd, T::plus(self.simd, self.vector, other.vector))
    }
}

impl<T: Real, S: Simd> Sub for Wide<T, S> {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self::new(self.simd, T::minus(self.simd, self.vector, other.vector))
    }
}

impl<T: Real, S: Simd> Mul for Wide<T, S> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self::new(self.simd, T::product(self.simd, self.vector, other.vector))
    }
}

/// As many vectors as one has numbers, turned: number `j` of vector `i` becomes number `i` of vector `j`. Blocks of half
/// the size are exchanged across the diagonal, then those within them, and so on.
#[inline(always)]
pub(in crate::engine) fn turned<T: Real, S: Simd, const N: usize>(mut rows: [Wide<T, S>; N]) -> [Wide<T, S>; N] {
    unrolled!(levels < N.ilog2() as usize, {
        let level = N.ilog2() as usize - 1 - levels;
        unrolled!(i < N, {
            if i >> level & 1 == 0 {
                let j = i + (1 << level);
                [rows[i], rows[j]] = Wide::rearranged([rows[i], rows[j]], Order::Exchanged { level });
            }
        });
    });
    rows
}
