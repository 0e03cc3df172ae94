//! Between points and the cells around them: the sums that run over a window.

use crate::engine::nonuniform::taps::{FRACTION_BITS, FixedTaps};
use crate::engine::real::Real;

/// The sum of the cells of a line, weighted by the window.
#[inline(always)]
pub(super) fn gather<T: Real, const W: usize>(taps: &FixedTaps<'_, T, W>, cells: &[T], code: u64) -> T {
    weigh(&taps.at(code), window_of(cells, (code >> FRACTION_BITS) as usize))
}

#[inline(always)]
fn weigh<T: Real, const W: usize>(weights: &[T; W], cells: &[T; W]) -> T {
    let mut lanes = [T::zero(); 4];
    for j in 0..W {
        lanes[j % 4] += weights[j] * cells[j];
    }
    (lanes[0] + lanes[2]) + (lanes[1] + lanes[3])
}

/// Adds the window to cells of a line.
#[inline(always)]
pub(super) fn spread<T: Real, const W: usize>(taps: &FixedTaps<'_, T, W>, cells: &mut [T], code: u64, weight: T) {
    let window = taps.at(code);
    let cells = window_of_mut::<T, W>(cells, (code >> FRACTION_BITS) as usize);
    for j in 0..W {
        cells[j] += weight * window[j];
    }
}

/// The sum of the cells of a plane, whose rows lie `pitch` apart.
#[inline(always)]
pub(super) fn gather_plane<T: Real, const W: usize>(
    taps: &FixedTaps<'_, T, W>,
    cells: &[T],
    pitch: usize,
    [x, y]: [u64; 2],
) -> T {
    let (across, down) = (taps.at(x), taps.at(y));
    let first = (y >> FRACTION_BITS) as usize * pitch + (x >> FRACTION_BITS) as usize;
    let mut sums = [T::zero(); W];
    for (i, weight) in down.into_iter().enumerate() {
        let row: &[T; W] = window_of(cells, first + i * pitch);
        for j in 0..W {
            sums[j] += weight * row[j];
        }
    }
    weigh(&across, &sums)
}

/// Adds the product of two windows to cells of a plane, whose rows lie `pitch` apart.
#[inline(always)]
pub(super) fn spread_plane<T: Real, const W: usize>(
    taps: &FixedTaps<'_, T, W>,
    cells: &mut [T],
    pitch: usize,
    [x, y]: [u64; 2],
    weight: T,
) {
    let (across, down) = (taps.at(x).map(|a| a * weight), taps.at(y));
    let first = (y >> FRACTION_BITS) as usize * pitch + (x >> FRACTION_BITS) as usize;
    for (i, weight) in down.into_iter().enumerate() {
        let row: &mut [T; W] = window_of_mut(cells, first + i * pitch);
        for j in 0..W {
            row[j] += weight * across[j];
        }
    }
}

#[inline(always)]
fn window_of<T, const W: usize>(cells: &[T], first: usize) -> &[T; W] {
    cells[first..].first_chunk().expect("grids go on for a window behind their last cell")
}

#[inline(always)]
fn window_of_mut<T, const W: usize>(cells: &mut [T], first: usize) -> &mut [T; W] {
    cells[first..].first_chunk_mut().expect("grids go on for a window behind their last cell")
}
