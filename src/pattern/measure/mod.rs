//! What a pattern is good for, in numbers; one measure, one file.

pub mod discrepancy;
pub mod distance;
pub mod elementary;
pub mod integration;
pub mod periodogram;
pub mod radial;
pub mod summary;
mod sweep;
pub mod whiteness;

use crate::error::{Error, Result};

/// `points` if there are any and all lie in the unit cube, its upper faces included.
///
/// # Errors
/// No points; a coordinate that is not finite or lies outside `0..=1`, with the index of its point.
fn in_cube<const D: usize>(points: &[[f64; D]]) -> Result<&[[f64; D]]> {
    if points.is_empty() {
        return Err(Error::TooFew { what: "points of a pattern", least: 1, got: 0 });
    }
    for (index, point) in points.iter().enumerate() {
        for &value in point {
            if !value.is_finite() {
                return Err(Error::NotFiniteAt { what: "coordinates of points", index, value });
            }
            crate::error::within("the coordinate of a point", value, 0.0, 1.0)?;
        }
    }
    Ok(points)
}
