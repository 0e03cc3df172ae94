//! Sample patterns and their discrepancy: no plans.

use crate::{slice, slice_mut};
use nyquist::pattern::Pattern;
use nyquist::pattern::measure::discrepancy::star_discrepancy;
use nyquist::pattern::scrambling::Scrambling;
use nyquist::pattern::sobol::Sobol;

/// `count` points of Sobol's sequence with Owen's scrambling, `(x, y)` after `(x, y)`. 0 if all went well.
///
/// # Safety
/// `points` holds `2·count` numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sobol_owen(count: usize, seed: usize, points: *mut f64) -> i32 {
    let Ok(pattern) = Sobol::new(count) else { return 1 };
    let found: Vec<[f64; 2]> = pattern.scrambled(Scrambling::Owen).points(seed as u64);
    // SAFETY: promised by the caller
    unsafe { slice_mut(points, 2 * count) }.copy_from_slice(found.as_flattened());
    0
}

/// The star discrepancy of `count` points `(x, y)`; NaN if there is none.
///
/// # Safety
/// `points` holds `2·count` numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn discrepancy(count: usize, points: *const f64) -> f64 {
    // SAFETY: promised by the caller
    let points = unsafe { slice(points, 2 * count) };
    let (pairs, _) = points.as_chunks::<2>();
    star_discrepancy(pairs).unwrap_or(f64::NAN)
}
