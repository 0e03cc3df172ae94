//! Lines of equal value through a grid.

use ndarray::Array2;

/// Where the values of a grid equal `level`: segments between points `[x, y]`, by marching squares with linear
/// interpolation along the edges (Lorensen and Cline 1987, one dimension lower). `values[[iy, ix]]` stands at the middle
/// of its cell of the rectangle `x × y`, as a raster is drawn. In a saddle the two lines are kept apart as the mean of
/// the four corners says.
///
/// ```
/// use nyquist::num::isoline::isoline;
/// // the plane x + y on cells of size ¼: its line through 1 is the antidiagonal
/// let plane = ndarray::Array2::from_shape_fn((4, 4), |(iy, ix)| (ix + iy) as f64 / 4.0 + 0.25);
/// let line = isoline(&plane, (0.0, 1.0), (0.0, 1.0), 0.9);
/// assert!(!line.is_empty());
/// assert!(line.iter().flatten().all(|[x, y]| (x + y - 0.9).abs() < 1e-12));
/// ```
pub fn isoline(values: &Array2<f64>, x: (f64, f64), y: (f64, f64), level: f64) -> Vec<[[f64; 2]; 2]> {
    let (rows, columns) = values.dim();
    let place = |iy: usize, ix: usize| {
        let part = |i: usize, n: usize, (low, high): (f64, f64)| low + (high - low) * (i as f64 + 0.5) / n as f64;
        [part(ix, columns, x), part(iy, rows, y)]
    };
    let mut segments = Vec::new();
    for iy in 1..rows {
        for ix in 1..columns {
            let corners = [(iy - 1, ix - 1), (iy - 1, ix), (iy, ix), (iy, ix - 1)];
            let above = corners.map(|c| values[c] > level);
            // where the line crosses the edge from corner i to the next
            let crossing = |i: usize| {
                let (a, b) = (corners[i], corners[(i + 1) % 4]);
                let t = (level - values[a]) / (values[b] - values[a]);
                let (p, q) = (place(a.0, a.1), place(b.0, b.1));
                [p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])]
            };
            let crossed: Vec<usize> = (0..4).filter(|&i| above[i] != above[(i + 1) % 4]).collect();
            match crossed[..] {
                [i, j] => segments.push([crossing(i), crossing(j)]),
                [_, _, _, _] => {
                    let middle = corners.iter().map(|&c| values[c]).sum::<f64>() / 4.0 > level;
                    // if the middle is like corner 0 the lines cut off corners 1 and 3
                    let pairs = if middle == above[0] { [[0, 1], [2, 3]] } else { [[3, 0], [1, 2]] };
                    segments.extend(pairs.map(|[i, j]| [crossing(i), crossing(j)]));
                }
                _ => {}
            }
        }
    }
    segments
}
