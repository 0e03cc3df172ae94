//! The distance of the two nearest points.

use crate::error::Result;
use crate::pattern::measure::in_cube;

/// The distance of the two nearest of the points, in the plane; infinite for a single point.
///
/// Divide and conquer in `O(N log N)` (Shamos and Hoey 1975), whatever the points: no grid that clusters could fill.
/// Correct to rounding, 2ε.
///
/// # Errors
/// No points, or points outside the unit square.
pub fn min_distance(points: &[[f64; 2]]) -> Result<f64> {
    Ok(closest(in_cube(points)?.to_vec()))
}

/// [`min_distance`] on the torus, where the square's opposite edges are one.
///
/// The points and those of their images that lie nearer to the square than the plain distance. Rounding, 4ε.
///
/// ```
/// use nyquist::prelude::*;
/// let points = [[0.01, 0.5], [0.97, 0.5], [0.5, 0.6]];
/// assert!((min_distance_torus(&points)? - 0.04).abs() < 1e-15);
/// assert!((min_distance(&points)? - 0.47_f64.hypot(0.1)).abs() < 1e-15);
/// # Ok::<(), Error>(())
/// ```
///
/// # Errors
/// No points, or points outside the unit square.
pub fn min_distance_torus(points: &[[f64; 2]]) -> Result<f64> {
    let plain = min_distance(points)?;
    if points.len() < 2 {
        return Ok(plain);
    }
    let mut all = points.to_vec();
    for shift in [[-1.0, -1.0], [0.0, -1.0], [1.0, -1.0], [-1.0, 0.0], [1.0, 0.0], [-1.0, 1.0], [0.0, 1.0], [1.0, 1.0]]
    {
        let image = |p: &[f64; 2]| [p[0] + shift[0], p[1] + shift[1]];
        let near = |p: &[f64; 2]| p.iter().all(|&c| -plain < c && c < 1.0 + plain);
        all.extend(points.iter().map(image).filter(near));
    }
    // a point and its own image are 1 apart, and two points on the torus never more than √½
    Ok(closest(all))
}

/// The greatest distance that `n` points on the unit torus can keep, `√(2/(√3·n))`: a hexagonal lattice, where it fits
/// (V21; Thue 1910).
///
/// ```
/// use nyquist::pattern::measure::distance::most_distance;
/// assert!((most_distance(1024) - 0.033_580).abs() < 1e-6);
/// ```
pub fn most_distance(n: usize) -> f64 {
    (2.0 / (3f64.sqrt() * n as f64)).sqrt()
}

fn closest(mut points: Vec<[f64; 2]>) -> f64 {
    points.sort_unstable_by(|a, b| a[0].total_cmp(&b[0]));
    let mut scratch = vec![[0.0; 2]; points.len()];
    let mut strip = Vec::new();
    divide(&mut points, &mut scratch, &mut strip, f64::INFINITY).sqrt()
}

/// The least squared distance, or `best` if that is less. Takes points sorted by x and leaves them sorted by y.
fn divide(points: &mut [[f64; 2]], scratch: &mut [[f64; 2]], strip: &mut Vec<[f64; 2]>, best: f64) -> f64 {
    let n = points.len();
    if n < 2 {
        return best;
    }
    let half = n / 2;
    let middle = points[half][0];
    let mut best = best;
    {
        let (left, right) = points.split_at_mut(half);
        let (below, above) = scratch.split_at_mut(half);
        best = divide(left, below, strip, best);
        best = divide(right, above, strip, best);
        let (mut i, mut j) = (0, 0);
        for slot in below.iter_mut().chain(above.iter_mut()) {
            let from_left = i < left.len() && (j == right.len() || left[i][1] <= right[j][1]);
            *slot = if from_left { left[i] } else { right[j] };
            if from_left { i += 1 } else { j += 1 }
        }
    }
    points.copy_from_slice(scratch);
    strip.clear();
    for &[x, y] in points.iter() {
        if (x - middle) * (x - middle) < best {
            for &[sx, sy] in strip.iter().rev() {
                if (y - sy) * (y - sy) >= best {
                    break;
                }
                best = best.min((x - sx) * (x - sx) + (y - sy) * (y - sy));
            }
            strip.push([x, y]);
        }
    }
    best
}
