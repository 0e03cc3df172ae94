//! Star discrepancy: the worst box at the origin.

use crate::error::{Result, all_finite, within};
use crate::pattern::measure::in_cube;
use crate::pattern::measure::sweep::Sweep;

/// The star discrepancy of points on `[0, 1]`, `sup_x |#{x_i < x}/N − x|`, exact to rounding (V18):
/// `1/(2N) + max |x_(i) − (2i − 1)/(2N)|` over the sorted points (Niederreiter 1992, theorem 2.6).
///
/// The centred grid has the least that `N` points can have, `1/(2N)`; the grid `i/N` has `1/N`.
///
/// ```
/// use nyquist::pattern::measure::discrepancy::star_discrepancy_line;
/// assert_eq!(star_discrepancy_line(&[0.125, 0.375, 0.625, 0.875])?, 0.125);
/// assert_eq!(star_discrepancy_line(&[0.0, 0.25, 0.5, 0.75])?, 0.25);
/// # Ok::<(), nyquist::error::Error>(())
/// ```
///
/// # Errors
/// No points, or points outside `[0, 1]`.
pub fn star_discrepancy_line(points: &[f64]) -> Result<f64> {
    for &x in all_finite("points on a line", points)? {
        within("a point on the line", x, 0.0, 1.0)?;
    }
    let mut sorted = points.to_vec();
    sorted.sort_unstable_by(f64::total_cmp);
    let n = sorted.len() as f64;
    let off = |(i, x): (usize, &f64)| (x - (i as f64 + 0.5) / n).abs();
    Ok(0.5 / n + sorted.iter().enumerate().map(off).fold(0.0, f64::max))
}

/// The star discrepancy of points in the unit square, `sup |#{points in B}/N − area of B|` over all boxes
/// `B = [0, x) × [0, y)`: exact to rounding (4ε), in `O(N log² N)`.
///
/// The supremum is approached at boxes whose sides go through points: with too many points where the box is closed, too
/// few where it is open. Sweeping `x`, `#/N − x·y_j` is a line in `x` for each `y_j`, and each point shifts the lines of
/// all larger `y_j`: the worst boxes are kept in a kinetic tree, which makes a logarithm of the textbook's factor `N`
/// (Dobkin, Eppstein, Mitchell, *Computing the discrepancy with applications to supersampling patterns*, 1996).
///
/// ```
/// use nyquist::prelude::*;
/// let grid = Regular::new([16, 16])?.points(0);
/// assert!((star_discrepancy(&grid)? - (1.0 / 16.0 - 1.0 / 1024.0)).abs() < 4.0 * f64::EPSILON);
/// # Ok::<(), Error>(())
/// ```
///
/// # Errors
/// No points, or points outside the unit square.
pub fn star_discrepancy(points: &[[f64; 2]]) -> Result<f64> {
    let mut sorted = in_cube(points)?.to_vec();
    let n = sorted.len() as f64;
    let mut ys: Vec<f64> = sorted.iter().map(|p| p[1]).chain([1.0]).collect();
    ys.sort_unstable_by(f64::total_cmp);
    ys.dedup();
    sorted.sort_unstable_by(|a, b| a[0].total_cmp(&b[0]));
    let mut sweep = Sweep::new(ys.iter().map(|y| n * y), n);
    let mut worst: f64 = 0.0;
    for column in sorted.chunk_by(|a, b| a[0] == b[0]) {
        sweep.advance(column[0][0]);
        worst = worst.max(sweep.deficit());
        for [_, y] in column {
            sweep.add(ys.partition_point(|other| other < y));
        }
        worst = worst.max(sweep.surplus());
    }
    sweep.advance(1.0);
    Ok(worst.max(sweep.deficit()) / n)
}
