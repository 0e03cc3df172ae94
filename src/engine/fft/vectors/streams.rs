//! Where vectors come from, and where they go.

use crate::engine::fft::vectors::number::Number;
use crate::engine::real::Real;
use crate::engine::simd::{Order, Simd, Wide};
use num_complex::Complex;

/// Numbers that are read a vector at a time.
pub(in crate::engine::fft) trait Input<T: Real> {
    /// Those from `at` on.
    fn read<S: Simd>(&self, simd: S, at: usize) -> Number<T, S>;
}

/// Places that are written a vector at a time.
pub(in crate::engine::fft) trait Output<T: Real> {
    /// Those from `at` on.
    fn write<S: Simd>(&mut self, simd: S, at: usize, z: Number<T, S>);
}

/// The numbers themselves.
pub(in crate::engine::fft) struct InTurn<'a, T>(pub(in crate::engine::fft) &'a [Complex<T>]);

impl<T: Real> Input<T> for InTurn<'_, T> {
    #[inline(always)]
    fn read<S: Simd>(&self, simd: S, at: usize) -> Number<T, S> {
        let parts: &[T] = bytemuck::cast_slice(&self.0[at..at + Wide::<T, S>::COUNT]);
        let both = [Wide::read(simd, parts, 0), Wide::read(simd, parts, Wide::<T, S>::COUNT)];
        let [re, im] = Wide::rearranged(both, Order::Apart);
        Number { re, im }
    }
}

/// Places of numbers.
pub(in crate::engine::fft) struct InTurnTo<'a, T>(pub(in crate::engine::fft) &'a mut [Complex<T>]);

impl<T: Real> Output<T> for InTurnTo<'_, T> {
    #[inline(always)]
    fn write<S: Simd>(&mut self, _: S, at: usize, z: Number<T, S>) {
        let parts: &mut [T] = bytemuck::cast_slice_mut(&mut self.0[at..at + Wide::<T, S>::COUNT]);
        let [first, second] = Wide::rearranged([z.re, z.im], Order::Together);
        first.write(parts, 0);
        second.write(parts, Wide::<T, S>::COUNT);
    }
}
