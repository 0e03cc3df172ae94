//! Films.

use crate::{boxed, freed, on, slice, slice_mut};
use nyquist::engine::film::{Film, Sample};
use nyquist::kernel::Kernel;
use nyquist::kernel::cubic::Cubic;
use nyquist::kernel::gaussian::GaussianKernel;

fn plan(width: usize, height: usize, kernel: &dyn Kernel) -> *mut Film<f32> {
    boxed(Film::new([width, height], kernel.radius(), |t| kernel.at(t)))
}

/// A film of `width × height` pixels with the Gaussian of radius two.
#[unsafe(no_mangle)]
pub extern "C" fn film_gaussian_new(width: usize, height: usize) -> *mut Film<f32> {
    plan(width, height, &GaussianKernel::pbrt2())
}

/// A film of `width × height` pixels with Mitchell's cubic.
#[unsafe(no_mangle)]
pub extern "C" fn film_mitchell_new(width: usize, height: usize) -> *mut Film<f32> {
    plan(width, height, &Cubic::mitchell())
}

/// `Σ f·L / Σ f` of `count` samples `(x, y, L)`. 0 if all went well.
///
/// # Safety
/// The plan came from `…_new`; `samples` holds `3·count` numbers, `values` as many as there are pixels, `pixels`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn film_develop(
    plan: *const Film<f32>,
    count: usize,
    pixels: usize,
    samples: *const f32,
    values: *mut f32,
    threads: usize,
) -> i32 {
    // SAFETY: promised by the caller; a sample is three numbers, one after the other, since its layout is C's
    let (plan, samples, values) =
        unsafe { (&*plan, slice(samples.cast::<Sample<f32, 1>>(), count), slice_mut(values, pixels)) };
    match on(threads, || plan.develop(samples)) {
        Ok(exposure) => {
            values.copy_from_slice(&exposure.planes[0]);
            0
        }
        Err(_) => 1,
    }
}

freed! {
    film_free: Film<f32>,
}
