//! Conversion of sampling rates.

use crate::{boxed, freed, on, slice, slice_mut};
use nyquist::engine::fft::Butterflies;
use nyquist::rate::{Converter, Quality};

macro_rules! sounds {
    ($($number:ty, $new:ident, $run:ident);* $(;)?) => {
        $(
            /// A converter of `channels` channels: qualities are 0 (fast), 1 (high), 2 (best).
            #[unsafe(no_mangle)]
            pub extern "C" fn $new(from: f64, to: f64, channels: usize, quality: usize) -> *mut Converter<$number> {
                let quality = Quality::ALL[quality.min(2)];
                boxed(Converter::with(from, to, channels, quality, Butterflies::Fastest))
            }

            /// A whole record: `given` values of frames to `made` values. 0 if all went well.
            ///
            /// # Safety
            /// The converter came from `…_new` and no other thread uses it; the arrays hold so many numbers.
            #[unsafe(no_mangle)]
            pub unsafe extern "C" fn $run(
                converter: *mut Converter<$number>,
                given: usize,
                input: *const $number,
                made: usize,
                output: *mut $number,
                threads: usize,
            ) -> i32 {
                // SAFETY: promised by the caller
                let (converter, input, output) =
                    unsafe { (&mut *converter, slice(input, given), slice_mut(output, made)) };
                on(threads, || converter.whole(input, output)).is_err().into()
            }
        )*
    };
}

sounds! {
    f64, sound_f64_new, sound_f64;
    f32, sound_f32_new, sound_f32;
}

freed! {
    sound_f64_free: Converter<f64>,
    sound_f32_free: Converter<f32>,
}
