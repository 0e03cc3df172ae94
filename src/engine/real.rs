//! The numbers that engines compute with.

use crate::engine::simd::Lanes;
use std::ops::{AddAssign, MulAssign, SubAssign};

mod sealed {
    pub trait Sealed {}
    impl Sealed for f32 {}
    impl Sealed for f64 {}
}

/// `f32` or `f64`.
pub trait Real:
    num_traits::Float
    + num_traits::FromPrimitive
    + num_traits::Signed
    + AddAssign
    + SubAssign
    + MulAssign
    + Default
    + std::fmt::Debug
    + Lanes
    + Send
    + Sync
    + sealed::Sealed
    + 'static
{
    /// The nearest number to `value`.
    fn of(value: f64) -> Self;

    /// The whole part, as near as an `i32` can be; zero for NaN.
    fn whole(self) -> i32;
}

impl Real for f64 {
    fn of(value: f64) -> Self {
        value
    }

    #[inline(always)]
    fn whole(self) -> i32 {
        self as i32
    }
}

impl Real for f32 {
    fn of(value: f64) -> Self {
        value as Self
    }

    #[inline(always)]
    fn whole(self) -> i32 {
        self as i32
    }
}
