//! The window and the grid for a tolerance.

use crate::engine::fft::{fast_multiple, long_length};
use crate::engine::nonuniform::window::{WIDTHS, Window};
use crate::engine::real::Real;
use crate::parallel;

/// A window, and how many cells the grid has along each axis.
pub(super) struct Shape<const D: usize> {
    pub(super) window: Window,
    pub(super) cells: [usize; D],
    /// The error of the window's values, summed over a window, that the tolerance leaves room for.
    pub(super) allowed: f64,
}

impl<const D: usize> Shape<D> {
    /// The cheapest one, by a cost as a function of cells and width. The window has nine tenths of an axis'
    /// `tolerance`, the polynomials that stand for it the tenth that is left. Cells come in multiples of `unit`.
    pub(super) fn of(degrees: [usize; D], tolerance: f64, unit: usize, cost: impl Fn([f64; D], f64) -> f64) -> Self {
        let candidate = |&width: &usize| {
            let ratio = Window::ratio(width, 0.9 * tolerance)?;
            let least = |degree: usize| ((2 * degree) as f64 * ratio).ceil().max(2.0 * width as f64) as usize;
            Some((width, degrees.map(|degree| length(least(degree), unit))))
        };
        let price = |&(width, cells): &(usize, [usize; D])| cost(cells.map(|n| n as f64), width as f64);
        let (width, cells) = WIDTHS
            .iter()
            .filter_map(candidate)
            .min_by(|a, b| price(a).total_cmp(&price(b)))
            .expect("the widest window has every tolerance that is allowed");
        let ratios = degrees.iter().zip(cells).map(|(&degree, n)| n as f64 / (2 * degree).max(1) as f64);
        let window = Window::new(width, ratios.fold(2.0, f64::min));
        let edges = degrees.iter().zip(cells).map(|(&degree, n)| window.transform(degree as f64 / n as f64));
        Self { allowed: 0.1 * tolerance * edges.fold(f64::INFINITY, f64::min), window, cells }
    }
}

/// Up to so many cells any product of the unit, twos, threes and fives is as good as another.
const SHORT: usize = 4096;

fn length(n: usize, unit: usize) -> usize {
    if n <= SHORT { fast_multiple(n, unit) } else { long_length(n) }
}

/// How many gains are computed together.
const BLOCK: usize = 4096;

/// `1/φ̂(k/cells)`: what undoes the window.
pub(super) fn gains<T: Real>(window: &Window, degree: usize, cells: usize) -> Vec<T> {
    let mut gains = vec![T::zero(); degree + 1];
    parallel::chunks(&mut gains, BLOCK, |block, gains| {
        for (k, gain) in (block * BLOCK..).zip(gains) {
            *gain = T::of(1.0 / window.transform(k as f64 / cells as f64));
        }
    });
    gains
}
