//! Elementary intervals: how many points each box of a division holds.

use crate::error::{Error, Result, within};
use crate::pattern::cells::Cells;
use crate::pattern::measure::in_cube;

/// The number of points in each of the boxes into which `cells` cuts the cube, along the first axis first.
///
/// Boxes are half-open, and their faces are the `f64` nearest to `j/n`. So points that are fractions correctly rounded, as
/// radical inverses are, fall into the box of the fraction itself, while `⌊x·n⌋` may round it into the box beside.
///
/// ```
/// use nyquist::prelude::*;
/// use nyquist::pattern::measure::elementary::occupancy;
/// // Halton: one in each of 4 × 9 boxes
/// let points = Pattern::<2>::points(&Halton::new(36)?, 0);
/// assert!(occupancy(&points, Cells::new([4, 9])?)?.iter().all(|&n| n == 1));
/// # Ok::<(), Error>(())
/// ```
///
/// # Errors
/// No points, or points outside the unit cube; those on its upper faces count to the last box.
pub fn occupancy<const D: usize>(points: &[[f64; D]], cells: Cells<D>) -> Result<Vec<u32>> {
    let along = cells.along();
    let mut counts = vec![0; cells.total()];
    for point in in_cube(points)? {
        let index = (0..D).rev().fold(0, |index, d| index * along[d] + slice(point[d], along[d]));
        counts[index] += 1;
    }
    Ok(counts)
}

/// The slice `j` of `n` with `fl(j/n) ≤ x < fl((j+1)/n)`.
fn slice(x: f64, n: usize) -> usize {
    let face = |j: usize| j as f64 / n as f64;
    let guess = ((x * n as f64) as usize).min(n - 1);
    if guess + 1 < n && face(guess + 1) <= x {
        guess + 1
    } else if guess > 0 && x < face(guess) {
        guess - 1
    } else {
        guess
    }
}

/// The largest difference between the number of points in a box and its fair share, over all boxes.
///
/// # Errors
/// As [`occupancy`].
pub fn unfairness<const D: usize>(points: &[[f64; D]], cells: Cells<D>) -> Result<f64> {
    let share = points.len() as f64 / cells.total() as f64;
    let counts = occupancy(points, cells)?;
    Ok(counts.into_iter().map(|n| (f64::from(n) - share).abs()).fold(0.0, f64::max))
}

/// The quality parameter `t` of a net: `b^m` points are a `(t, m, D)`-net in base `b` if every elementary interval
/// `Π [j_d b^{−a_d}, (j_d + 1) b^{−a_d})` of volume `b^{t−m}` holds exactly `b^t` of them (Niederreiter 1987).
///
/// The least such `t` is returned: 0 is the best, and `m` is nothing. All `C(m−t+D−1, D−1)` divisions are counted.
///
/// ```
/// use nyquist::prelude::*;
/// assert_eq!(net_quality(&Pattern::<2>::points(&Sobol::new(256)?, 0), 2)?, 0);
/// assert!(net_quality(&Pattern::<2>::points(&Random::new(256)?, 0), 2)? > 3);
/// # Ok::<(), Error>(())
/// ```
///
/// # Errors
/// A base outside `2 ..= 1024`; a number of points that is no power of it ([`Error::Count`]); points outside the cube.
pub fn net_quality<const D: usize>(points: &[[f64; D]], base: u32) -> Result<u32> {
    within("the base of a net", base.into(), 2.0, 1024.0)?;
    let (mut m, mut power) = (0, 1);
    while power < points.len() {
        power *= base as usize;
        m += 1;
    }
    if power != points.len() {
        let what = "points of a net";
        return Err(Error::Count { what, given: points.len(), below: power / base as usize, above: power });
    }
    in_cube(points)?;
    for t in 0..m {
        let mut fair = true;
        for exponents in compositions::<D>(m - t) {
            let cells = Cells::new(exponents.map(|a| (base as usize).pow(a)))?;
            fair = fair && unfairness(points, cells)? == 0.0;
        }
        if fair {
            return Ok(t);
        }
    }
    Ok(m)
}

/// All ways to write `total` as an ordered sum of `D` numbers.
pub fn compositions<const D: usize>(total: u32) -> Vec<[u32; D]> {
    let mut all = Vec::new();
    let mut parts = [0; D];
    fill(&mut parts, 0, total, &mut all);
    all
}

fn fill<const D: usize>(parts: &mut [u32; D], from: usize, rest: u32, all: &mut Vec<[u32; D]>) {
    if from + 1 == D {
        parts[from] = rest;
        all.push(*parts);
        return;
    }
    for part in 0..=rest {
        parts[from] = part;
        fill(parts, from + 1, rest - part, all);
    }
}
