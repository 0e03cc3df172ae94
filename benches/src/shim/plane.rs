//! Power spectra of images.

use crate::{boxed, freed, on, slice, slice_mut};
use nyquist::axis::Axis;
use nyquist::engine::fft::PlaneFft;
use nyquist::grid::Grid;

/// Pixels of size one, whose middles are whole numbers.
fn grid(width: usize, height: usize) -> nyquist::error::Result<Grid> {
    Grid::new(Axis::new(0.0, 1.0, width)?, Axis::new(0.0, 1.0, height)?)
}

macro_rules! powers {
    ($($number:ty, $new:ident, $power:ident);* $(;)?) => {
        $(
            /// A plan for images of `width × height` pixels of size one.
            #[unsafe(no_mangle)]
            pub extern "C" fn $new(width: usize, height: usize) -> *mut PlaneFft<$number> {
                boxed(grid(width, height).map(PlaneFft::new))
            }

            /// The power spectrum `|F|²/area` of an image of `pixels` pixels, zero in the middle. 0 if all went well.
            ///
            /// # Safety
            /// The plan came from `…_new`; both arrays hold `pixels` numbers.
            #[unsafe(no_mangle)]
            pub unsafe extern "C" fn $power(
                plan: *const PlaneFft<$number>,
                pixels: usize,
                image: *const $number,
                power: *mut $number,
                threads: usize,
            ) -> i32 {
                // SAFETY: promised by the caller
                let (plan, image, power) = unsafe { (&*plan, slice(image, pixels), slice_mut(power, pixels)) };
                on(threads, || plan.power(image, power)).is_err().into()
            }
        )*
    };
}

powers! {
    f64, plane_f64_new, power_f64;
    f32, plane_f32_new, power_f32;
}

freed! {
    plane_f64_free: PlaneFft<f64>,
    plane_f32_free: PlaneFft<f32>,
}
