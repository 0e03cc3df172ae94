//! Projections: integrals along parallel lines, whose transforms are slices.

use crate::field::Field;
use crate::image::Image;
use crate::num::quadrature::{Integral, even_breaks, integrate_pieces};
use crate::sampled::Samples;
use ndarray::Axis as Along;

/// `p(x_i) = Δy Σ_j f(x_i, y_j)`: the image summed down its columns.
///
/// Its transform is exactly the row `v = 0` of the image's: the projection–slice theorem, which for sums is the
/// interchange of two sums (Bracewell 1956).
///
/// ```
/// use nyquist::prelude::*;
/// use nyquist::image::projection::project;
/// let image = Image::of(&field_fn(|x, y| x * y), Grid::pixels(3, 2)?);
/// assert_eq!(project(&image).values(), [1.0, 3.0, 5.0]);
/// # Ok::<(), Error>(())
/// ```
pub fn project(image: &Image) -> Samples {
    let grid = image.grid();
    let sums = image.pixels().sum_axis(Along(0)) * grid.y().step();
    Samples::trusted(grid.x(), sums.to_vec())
}

/// `∫ f(s·cos θ − t·sin θ, s·sin θ + t·cos θ) dt` for `|t| ≤ reach`: the integral along the line at the distance `s` from
/// the origin whose normal points in the direction `angle`; by quadrature in pieces no longer than `step`, between which
/// the field must be smooth, to about `10⁻¹⁴`.
///
/// ```
/// use nyquist::prelude::*;
/// use nyquist::image::projection::line_integral;
/// let spot = GaussianSpot::round(1.0)?;
/// let through = line_integral(&spot, 0.7, 0.5, 7.0, 1.0);
/// let known = std::f64::consts::PI.sqrt() * (-0.25f64).exp();
/// assert!((through.value - known).abs() <= through.error);
/// # Ok::<(), Error>(())
/// ```
pub fn line_integral(field: &impl Field, angle: f64, s: f64, reach: f64, step: f64) -> Integral {
    let (sin, cos) = angle.sin_cos();
    let along = |t: f64| field.at(s * cos - t * sin, s * sin + t * cos);
    integrate_pieces(along, &even_breaks(-reach, reach, step), 1e-14)
}
