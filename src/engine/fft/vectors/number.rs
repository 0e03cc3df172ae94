//! Vectors of complex numbers, real and imaginary parts apart.

use crate::engine::real::Real;
use crate::engine::simd::{LANES, Simd, Wide};
use num_complex::Complex;
use std::ops::{Add, Sub};

/// As many numbers as the widest vector has: real parts, and imaginary ones.
pub(in crate::engine::fft) type Block<T> = [[T; LANES]; 2];

/// Complex numbers side by side.
pub(in crate::engine::fft) struct Number<T: Real, S: Simd> {
    pub(in crate::engine::fft) re: Wide<T, S>,
    pub(in crate::engine::fft) im: Wide<T, S>,
}

impl<T: Real, S: Simd> Clone for Number<T, S> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<T: Real, S: Simd> Copy for Number<T, S> {}

impl<T: Real, S: Simd> Number<T, S> {
    /// One number everywhere.
    #[inline(always)]
    pub(in crate::engine::fft) fn splat(simd: S, z: Complex<T>) -> Self {
        Self { re: Wide::splat(simd, z.re), im: Wide::splat(simd, z.im) }
    }

    /// Those of a block from number `at` on.
    #[inline(always)]
    pub(in crate::engine::fft) fn part(simd: S, block: &Block<T>, at: usize) -> Self {
        Self { re: Wide::read(simd, &block[0], at), im: Wide::read(simd, &block[1], at) }
    }

    /// To a block, from number `at` on.
    #[inline(always)]
    pub(in crate::engine::fft) fn to_part(self, block: &mut Block<T>, at: usize) {
        self.re.write(&mut block[0], at);
        self.im.write(&mut block[1], at);
    }

    /// Every number times its own one.
    #[inline(always)]
    pub(in crate::engine::fft) fn times(self, w: Self) -> Self {
        Self { re: (self.re * w.re).less_product(self.im, w.im), im: (self.im * w.re).plus_product(self.re, w.im) }
    }

    /// `self − i·other`.
    #[inline(always)]
    pub(super) fn plus_quarter(self, other: Self) -> Self {
        Self { re: self.re + other.im, im: self.im - other.re }
    }

    /// `self + i·other`.
    #[inline(always)]
    pub(super) fn less_quarter(self, other: Self) -> Self {
        Self { re: self.re - other.im, im: self.im + other.re }
    }

    /// `scale·self`.
    #[inline(always)]
    pub(super) fn scaled(self, scale: Wide<T, S>) -> Self {
        Self { re: self.re * scale, im: self.im * scale }
    }

    /// `self + scale·other`.
    #[inline(always)]
    pub(super) fn plus_scaled(self, other: Self, scale: Wide<T, S>) -> Self {
        Self { re: self.re.plus_product(other.re, scale), im: self.im.plus_product(other.im, scale) }
    }

    /// `self − scale·other`.
    #[inline(always)]
    pub(super) fn less_scaled(self, other: Self, scale: Wide<T, S>) -> Self {
        Self { re: self.re.less_product(other.re, scale), im: self.im.less_product(other.im, scale) }
    }

    /// `(1 − i)·self`.
    #[inline(always)]
    pub(super) fn eighth(self) -> Self {
        Self { re: self.re + self.im, im: self.im - self.re }
    }
}

impl<T: Real, S: Simd> Add for Number<T, S> {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self { re: self.re + other.re, im: self.im + other.im }
    }
}

impl<T: Real, S: Simd> Sub for Number<T, S> {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self { re: self.re - other.re, im: self.im - other.im }
    }
}
