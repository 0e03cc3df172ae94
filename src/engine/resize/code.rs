//! How numbers stand in an image.

use crate::engine::real::Real;
use crate::engine::resize::sums::LEAST;
use crate::engine::simd::{Lanes, Simd};

/// A number of an image. Codes are averaged as they are; for averages of the light behind them see
/// [`Light`](crate::engine::resize::Light).
///
/// Sums are made in `f32` (of `f64` in `f64`), and rounded once: codes of 8 and 16 bits to the nearest, half to even, and
/// to the first or the last if they lie beyond.
pub trait Code: Copy + Send + Sync + 'static {
    /// What sums are made in.
    type Sum: Real + Code<Sum = Self::Sum>;

    #[doc(hidden)]
    fn widen(from: &[Self], to: &mut [Self::Sum]);

    #[doc(hidden)]
    fn narrow(from: &[Self::Sum], to: &mut [Self]);

    #[doc(hidden)]
    fn vector<S: Simd>(from: &[Self]) -> <Self::Sum as Lanes>::Vector<S>;

    #[doc(hidden)]
    fn direct(values: &[Self]) -> Direct<'_, Self>;
}

/// Numbers that sums can be made of where they stand.
#[derive(Debug, Clone, Copy)]
pub enum Direct<'a, C: Code> {
    /// As they are.
    Themselves(&'a [C::Sum]),
    /// Widened on the way: they fill less of a cache than their sums.
    Narrow(&'a [C]),
    /// They must be read through a table first.
    Not,
}

macro_rules! itself {
    ($real:ty) => {
        impl Code for $real {
            type Sum = Self;

            #[inline(always)]
            fn widen(from: &[Self], to: &mut [Self]) {
                to.copy_from_slice(from);
            }

            #[inline(always)]
            fn narrow(from: &[Self], to: &mut [Self]) {
                to.copy_from_slice(from);
            }

            #[inline(always)]
            fn vector<S: Simd>(from: &[Self]) -> <Self as Lanes>::Vector<S> {
                Self::vectors::<S>(from)[0]
            }

            fn direct(values: &[Self]) -> Direct<'_, Self> {
                Direct::Themselves(values)
            }
        }
    };
}

itself!(f32);
itself!(f64);

/// 2²³: beside it the spacing of `f32` is one, so that adding it rounds to whole numbers, which then are the last bits.
const WHOLE: f32 = 8_388_608.0;

macro_rules! whole {
    ($code:ty) => {
        impl Code for $code {
            type Sum = f32;

            #[inline(always)]
            fn widen(from: &[Self], to: &mut [f32]) {
                for (to, from) in to.iter_mut().zip(from) {
                    *to = f32::from(*from);
                }
            }

            #[inline(always)]
            fn narrow(from: &[f32], to: &mut [Self]) {
                for (to, from) in to.iter_mut().zip(from) {
                    // in this order, one instruction each; not a number becomes zero
                    let v = if *from > 0.0 { *from } else { 0.0 };
                    let v = if v < f32::from(Self::MAX) { v } else { f32::from(Self::MAX) };
                    *to = (v + WHOLE).to_bits() as Self;
                }
            }

            #[inline(always)]
            fn vector<S: Simd>(from: &[Self]) -> <f32 as Lanes>::Vector<S> {
                let mut wide = [0.0; LEAST];
                for (wide, from) in wide.iter_mut().zip(from) {
                    *wide = f32::from(*from);
                }
                f32::vectors::<S>(&wide)[0]
            }

            fn direct(values: &[Self]) -> Direct<'_, Self> {
                Direct::Narrow(values)
            }
        }
    };
}

whole!(u8);
whole!(u16);
