//! The natural cubic spline: a smooth curve through given values, whose curvature is known exactly.

use crate::axis::Axis;
use crate::error::{Error, Result, all_finite};
use crate::signal::{Differentiable, Signal};

/// The smoothest curve through values on an axis: the twice continuously differentiable function of least `∫ f″²` (Holladay 1957).
///
/// Between neighbours a cubic, beyond the ends the straight line that continues it, since `f″ = 0` there. The second
/// derivative is piecewise linear, so its extremes stand at the knots and [`Spline::max_curvature`] is exact: what error
/// bounds such as `T²/8·max|f″|` ask for.
///
/// ```
/// use nyquist::prelude::*;
/// let curve = Spline::natural(Axis::new(0.0, 1.0, 4)?, &[0.0, 1.0, 0.0, 2.0])?;
/// assert_eq!((curve.at(1.0), curve.at(3.0)), (1.0, 2.0));
/// assert_eq!((curve.curvature(0.0), curve.curvature(4.0)), (0.0, 0.0)); // straight beyond the ends
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Spline {
    axis: Axis,
    values: Vec<f64>,
    curvatures: Vec<f64>,
}

impl Spline {
    /// The natural spline (`f″ = 0` at both ends) through `values` at the positions of `axis`.
    ///
    /// The curvatures `M_i` at the knots solve `M_{i−1} + 4M_i + M_{i+1} = 6/h²·(f_{i−1} − 2f_i + f_{i+1})`; the matrix
    /// is diagonally dominant, so elimination without pivots is stable.
    ///
    /// # Errors
    /// Fewer than two values, a number other than the axis has positions, or values that are not finite.
    pub fn natural(axis: Axis, values: &[f64]) -> Result<Self> {
        let (f, n) = (all_finite("the values of a spline", values)?, values.len());
        if n != axis.len() {
            return Err(Error::Length { what: "the values of a spline", expected: axis.len(), got: n });
        }
        if n < 2 {
            return Err(Error::TooFew { what: "the values of a spline", least: 2, got: n });
        }
        let scale = 6.0 / axis.step().powi(2);
        // forward: M_i = right_i − upper_i·M_{i+1}
        let (mut upper, mut right) = (vec![0.0; n], vec![0.0; n]);
        for i in 1..n - 1 {
            let pivot = 4.0 - upper[i - 1];
            upper[i] = 1.0 / pivot;
            right[i] = (scale * (f[i - 1] - 2.0 * f[i] + f[i + 1]) - right[i - 1]) / pivot;
        }
        let mut curvatures = vec![0.0; n];
        for i in (1..n - 1).rev() {
            curvatures[i] = right[i] - upper[i] * curvatures[i + 1];
        }
        Ok(Self { axis, values: values.to_vec(), curvatures })
    }

    /// Where its knots are.
    pub fn axis(&self) -> Axis {
        self.axis
    }

    /// The second derivative at `x`: linear between the knots, zero beyond the ends.
    pub fn curvature(&self, x: f64) -> f64 {
        let (i, t) = self.piece(x);
        if (0.0..=1.0).contains(&t) { (1.0 - t) * self.curvatures[i] + t * self.curvatures[i + 1] } else { 0.0 }
    }

    /// `max|f″|`, exactly: it is reached at a knot.
    pub fn max_curvature(&self) -> f64 {
        self.curvatures.iter().fold(0.0, |most, m| m.abs().max(most))
    }

    /// The piece that holds `x`, or the nearest, and how far along it `x` is, in steps.
    fn piece(&self, x: f64) -> (usize, f64) {
        let u = self.axis.index_of(x);
        let i = u.floor().clamp(0.0, (self.curvatures.len() - 2) as f64);
        (i as usize, u - i)
    }
}

impl Signal for Spline {
    fn at(&self, x: f64) -> f64 {
        let (i, t) = self.piece(x);
        let (inside, h, f) = (t.clamp(0.0, 1.0), self.axis.step(), &self.values);
        let (s, bend) = (1.0 - inside, h * h / 6.0);
        let value = s * f[i]
            + inside * f[i + 1]
            + bend * ((s.powi(3) - s) * self.curvatures[i] + (inside.powi(3) - inside) * self.curvatures[i + 1]);
        if t == inside { value } else { value + h * (t - inside) * self.slope(x) }
    }
}

impl Differentiable for Spline {
    fn slope(&self, x: f64) -> f64 {
        let (i, t) = self.piece(x);
        let (t, h, f) = (t.clamp(0.0, 1.0), self.axis.step(), &self.values);
        let s = 1.0 - t;
        let bend = (3.0 * t * t - 1.0) * self.curvatures[i + 1] - (3.0 * s * s - 1.0) * self.curvatures[i];
        (f[i + 1] - f[i]) / h + h / 6.0 * bend
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::num::random::normal;

    fn noisy(n: usize) -> Spline {
        let values: Vec<f64> = (0..n as u64).map(|i| normal(3, i, 0)).collect();
        Spline::natural(Axis::new(-1.0, 0.7, n).unwrap(), &values).unwrap()
    }

    /// Both one-sided difference quotients of value, slope and curvature agree at every knot, ends included, where the
    /// straight continuation takes over.
    #[test]
    fn it_goes_through_its_values_and_is_twice_continuously_differentiable() {
        for n in [2, 3, 9, 50] {
            let spline = noisy(n);
            let most = spline.max_curvature();
            for (x, &v) in spline.axis().iter().zip(&spline.values) {
                assert!((spline.at(x) - v).abs() <= 8.0 * f64::EPSILON * (v.abs() + most), "n = {n}, x = {x}");
                let h = 1e-6;
                // f is C² and f‴ jumps by at most 2·max|f″|/0.7 per unit, so quotients differ by no more than 3h·that
                let room = 3.0 * h * 2.0 * most / 0.7 + 1e-8;
                let (left, right) = (spline.at(x) - spline.at(x - h), spline.at(x + h) - spline.at(x));
                assert!((left - right).abs() / h <= 2.0 * h * most + room, "slope jumps at {x}");
                let (left, right) = (spline.slope(x) - spline.slope(x - h), spline.slope(x + h) - spline.slope(x));
                assert!((left / h - spline.curvature(x - h)).abs() <= room + 1e-7, "curvature at {x}");
                assert!((right / h - spline.curvature(x + h)).abs() <= room + 1e-7, "curvature at {x}");
            }
        }
    }

    #[test]
    fn its_greatest_curvature_is_known_exactly() {
        // 4·M₁ = 6·(0 − 2 + 0): the one inner equation of the tent's three values
        let three = Axis::new(0.0, 1.0, 3).unwrap();
        assert_eq!(Spline::natural(three, &[0.0, 1.0, 0.0]).unwrap().max_curvature(), 3.0);
        let axis = Axis::new(0.0, 0.5, 6).unwrap();
        let line: Vec<f64> = axis.iter().map(|x| 3.0 * x - 1.0).collect();
        assert!(Spline::natural(axis, &line).unwrap().max_curvature() < 1e-13);
        assert!(Spline::natural(three, &[1.0, 2.0]).is_err() && Spline::natural(three, &[1.0, f64::NAN, 2.0]).is_err());
        assert!(Spline::natural(Axis::new(0.0, 1.0, 1).unwrap(), &[1.0]).is_err());
    }
}
