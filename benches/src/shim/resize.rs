//! Images at another size.

use crate::{boxed, freed, on, slice, slice_mut};
use nyquist::axis::{Axis, Edge};
use nyquist::door::srgb::srgb_to_linear;
use nyquist::engine::Arithmetic;
use nyquist::engine::resize::{Code, Light, Resizer, View, ViewMut};
use nyquist::error::Result;
use nyquist::image::weights::Weights;
use nyquist::kernel::catalog;

/// A plan for square images, and the curve of sRGB.
pub struct Plan {
    resizer: Resizer<f32>,
    light: Light,
    sides: [usize; 2],
}

impl Plan {
    fn new(kernel: usize, from: usize, to: usize) -> Result<Self> {
        let kernel = catalog::by_name(["lanczos-3", "mitchell", "catmull-rom"][kernel])?;
        let axis = |n| Axis::cells(0.0..from as f64, n);
        let taps = || Weights::of(axis(from)?, axis(to)?, &kernel)?.taps(Edge::Clamp);
        let resizer = Resizer::new(taps()?, taps()?, Arithmetic::Fused);
        Ok(Self { resizer, light: Light::new(srgb_to_linear)?, sides: [from, to] })
    }

    fn run<C: Code<Sum = f32>>(
        &self,
        channels: usize,
        source: &[C],
        target: &mut [C],
        work: impl FnOnce(View<'_, C>, ViewMut<'_, C>) -> Result<()>,
    ) -> Result<()> {
        let [from, to] = self.sides;
        work(
            View::new(source, [from; 2], channels, from * channels)?,
            ViewMut::new(target, [to; 2], channels, to * channels)?,
        )
    }
}

/// A plan by the kernel of this number (Lanczos-3, Mitchell, Catmull–Rom) for images of `from²` to `to²` pixels.
#[unsafe(no_mangle)]
pub extern "C" fn resize_new(kernel: usize, from: usize, to: usize) -> *mut Plan {
    boxed(Plan::new(kernel, from, to))
}

macro_rules! resizes {
    ($($name:ident, $code:ty, $plan:ident, $source:ident, $target:ident => $work:expr);* $(;)?) => {
        $(
            /// An image of interleaved channels, resized. 0 if all went well.
            ///
            /// # Safety
            /// The plan came from `resize_new`; the arrays hold `from²·channels` and `to²·channels` numbers.
            #[unsafe(no_mangle)]
            pub unsafe extern "C" fn $name(
                $plan: *const Plan,
                channels: usize,
                $source: *const $code,
                $target: *mut $code,
                threads: usize,
            ) -> i32 {
                // SAFETY: promised by the caller
                let $plan = unsafe { &*$plan };
                let [from, to] = $plan.sides.map(|n| n * n * channels);
                // SAFETY: promised by the caller
                let ($source, $target) = unsafe { (slice($source, from), slice_mut($target, to)) };
                on(threads, || $plan.run(channels, $source, $target, $work)).is_err().into()
            }
        )*
    };
}

resizes! {
    resize_f32, f32, plan, source, target => |source, target| plan.resizer.run(source, target);
    resize_u8, u8, plan, source, target => |source, target| plan.resizer.run(source, target);
    resize_light, u8, plan, source, target => |source, target| plan.resizer.run_in_light(&plan.light, source, target);
}

freed! { resize_free: Plan }
