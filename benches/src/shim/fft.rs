//! Transforms of the line in physical units.

use crate::{boxed, freed, on, slice, slice_mut};
use num_complex::Complex;
use nyquist::axis::Axis;
use nyquist::engine::fft::{PhysicalFft, PhysicalRealFft};

/// The axis of all cases: `n` samples, a step that is no power of two, a start that is not zero.
fn axis(n: usize) -> nyquist::error::Result<Axis> {
    Axis::new(-0.3, 0.1, n)
}

macro_rules! transforms {
    ($($number:ty, $new:ident, $run:ident, $real_new:ident, $real_run:ident);* $(;)?) => {
        $(
            /// A plan for `n` complex samples from −0.3 in steps of 0.1.
            #[unsafe(no_mangle)]
            pub extern "C" fn $new(n: usize) -> *mut PhysicalFft<$number> {
                boxed(axis(n).map(PhysicalFft::new))
            }

            /// `n` complex samples to `n` samples of the transform, zero in the middle, `repeats` times: what the
            /// way to the threads costs would be more than a short transform. 0 if all went well.
            ///
            /// # Safety
            /// The plan came from `…_new`; both arrays hold `n` complex numbers.
            #[unsafe(no_mangle)]
            pub unsafe extern "C" fn $run(
                plan: *const PhysicalFft<$number>,
                n: usize,
                input: *const Complex<$number>,
                output: *mut Complex<$number>,
                threads: usize,
                repeats: usize,
            ) -> i32 {
                // SAFETY: promised by the caller
                let (plan, input, output) = unsafe { (&*plan, slice(input, n), slice_mut(output, n)) };
                on(threads, || (0..repeats).try_for_each(|_| plan.forward(input, output))).is_err().into()
            }

            /// A plan for `n` real samples.
            #[unsafe(no_mangle)]
            pub extern "C" fn $real_new(n: usize) -> *mut PhysicalRealFft<$number> {
                boxed(axis(n).map(PhysicalRealFft::new))
            }

            /// `n` real samples to the transform at the `n/2 + 1` frequencies from zero on, `repeats`
            /// times. 0 if all went well.
            ///
            /// # Safety
            /// The plan came from `…_new`; the arrays hold `n` numbers and `n/2 + 1` complex numbers.
            #[unsafe(no_mangle)]
            pub unsafe extern "C" fn $real_run(
                plan: *const PhysicalRealFft<$number>,
                n: usize,
                input: *const $number,
                output: *mut Complex<$number>,
                threads: usize,
                repeats: usize,
            ) -> i32 {
                // SAFETY: promised by the caller
                let (plan, input, output) = unsafe { (&*plan, slice(input, n), slice_mut(output, n / 2 + 1)) };
                on(threads, || (0..repeats).try_for_each(|_| plan.forward(input, output))).is_err().into()
            }
        )*
    };
}

transforms! {
    f64, fft_f64_new, fft_f64, real_fft_f64_new, real_fft_f64;
    f32, fft_f32_new, fft_f32, real_fft_f32_new, real_fft_f32;
}

freed! {
    fft_f64_free: PhysicalFft<f64>,
    fft_f32_free: PhysicalFft<f32>,
    real_fft_f64_free: PhysicalRealFft<f64>,
    real_fft_f32_free: PhysicalRealFft<f32>,
}
