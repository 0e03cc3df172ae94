//! Recovery from samples at irregular, known positions.

use crate::beyond::staircase::Staircase;
use crate::error::{Error, Result, all_finite, positive};
use crate::num::svd::Svd;
use crate::num::{cos_pi, sin_pi};
use crate::signal::Signal;
use crate::signal::trigonometric::{TrigPolynomial, rising};
use ndarray::Array2;
use num_complex::Complex;
use std::f64::consts::SQRT_2;
use std::ops::Range;

/// Values at irregular but known positions of one period.
///
/// The lecture says that irregular samples "will not help to restore the signal exactly". They do (E12): a band-limited
/// signal of a period is a trigonometric polynomial of `2K + 1` coefficients, and as many distinct positions determine
/// it. What irregularity costs is noise: the [condition number](Recovery::condition) of the equations. It is bounded
/// where the largest gap is below `1/(2B)`, by `((1 + 2Bδ)/(1 − 2Bδ))` for equations weighted by the gaps (Gröchenig,
/// *Reconstruction algorithms in irregular sampling*, 1992), and no density below `2B` will do (Landau 1967).
///
/// ```
/// use nyquist::prelude::*;
/// use nyquist::num::random::uniform;
/// // one sample somewhere in each of 64 cells, and a signal that reaches 0.7 of their Nyquist frequency
/// let positions: Vec<f64> = (0..64u32).map(|i| f64::from(i) + uniform(1, i.into(), 0)).collect();
/// let f = TrigPolynomial::new(0.0..64.0, (0..=22).map(|k| (1.0 / f64::from(1 + k)).into()).collect())?;
/// let recovery = Irregular::of(&f, 0.0..64.0, &positions)?.least_squares(0.35, 100.0)?;
/// assert!((recovery.at(20.25) - f.at(20.25)).abs() < 1e-12);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Irregular {
    start: f64,
    period: f64,
    points: Vec<[f64; 2]>,
}

/// A signal recovered by least squares, and how much its equations amplify noise.
#[derive(Debug, Clone, PartialEq)]
pub struct Recovery {
    signal: TrigPolynomial,
    singular_values: Vec<f64>,
}

impl Irregular {
    /// Values at positions of the half-open `period`, in any order; they are sorted.
    ///
    /// # Errors
    /// A period that is not finite and rising; no positions, or as many values as there are not positions; numbers that
    /// are not finite; positions outside the period, or two at the same place.
    pub fn new(period: Range<f64>, positions: &[f64], values: &[f64]) -> Result<Self> {
        let (start, length) = rising("the start of a period", "the end of a period", &period)?;
        all_finite("irregular positions", positions)?;
        if values.len() != positions.len() {
            let what = "values at irregular positions";
            return Err(Error::Length { what, expected: positions.len(), got: values.len() });
        }
        all_finite("values at irregular positions", values)?;
        if let Some(&value) = positions.iter().find(|x| !period.contains(x)) {
            let what = "a position of the half-open period";
            return Err(Error::OutOfRange { what, value, low: period.start, high: period.end });
        }
        let mut points: Vec<[f64; 2]> = positions.iter().zip(values).map(|(&x, &v)| [x, v]).collect();
        points.sort_by(|a, b| a[0].total_cmp(&b[0]));
        for pair in points.windows(2) {
            positive("the gap between neighbouring irregular positions", pair[1][0] - pair[0][0])?;
        }
        Ok(Self { start, period: length, points })
    }

    /// The values of a signal at irregular positions of a period.
    ///
    /// # Errors
    /// As [`Irregular::new`].
    pub fn of(signal: &impl Signal, period: Range<f64>, positions: &[f64]) -> Result<Self> {
        let values: Vec<f64> = positions.iter().map(|&x| signal.at(x)).collect();
        Self::new(period, positions, &values)
    }

    /// Positions and values, in order.
    pub fn points(&self) -> &[[f64; 2]] {
        &self.points
    }

    /// Samples per unit.
    pub fn density(&self) -> f64 {
        self.points.len() as f64 / self.period
    }

    /// The largest distance `δ` between neighbours, also around the end of the period. Recovery is stable for sure on
    /// bands below `1/(2δ)`.
    pub fn largest_gap(&self) -> f64 {
        (0..self.points.len()).map(|i| self.gap_after(i)).fold(0.0, f64::max)
    }

    fn gap_after(&self, i: usize) -> f64 {
        match self.points.get(i + 1) {
            Some(next) => next[0] - self.points[i][0],
            None => self.points[0][0] + self.period - self.points[i][0],
        }
    }

    /// The highest harmonic `K = ⌊B·L⌋` of a band; products within `4ε` of a whole number count as that number.
    fn degree(&self, band: f64) -> Result<usize> {
        positive("the band", band)?;
        let count = band * self.period;
        let degree = (count * (1.0 + 4.0 * f64::EPSILON)).floor();
        let most = ((self.points.len() - 1) / 2) as f64;
        if degree > most {
            let what = "the band that so many irregular samples can determine";
            return Err(Error::OutOfRange { what, value: band, low: 0.0, high: most / self.period });
        }
        Ok(degree as usize)
    }

    /// The matrix of the equations: one row a sample, one column for each of the `2K + 1` functions `1, √2 cos(2πu),
    /// √2 sin(2πu), …`, `u = (x − a)/L`, which are orthonormal on the period. For equally spaced positions its columns
    /// are orthogonal and all singular values are `√n`.
    pub fn matrix(&self, degree: usize) -> Array2<f64> {
        Array2::from_shape_fn((self.points.len(), 2 * degree + 1), |(row, column)| {
            let angle = 2.0 * (column.div_ceil(2) as f64) * ((self.points[row][0] - self.start) / self.period);
            match column {
                0 => 1.0,
                _ if column % 2 == 1 => SQRT_2 * cos_pi(angle),
                _ => SQRT_2 * sin_pi(angle),
            }
        })
    }

    /// The trigonometric polynomial of the given band nearest to the values in the mean square. If they are values of
    /// such a polynomial it is returned to rounding, `κ·ε` times its size; errors of the values grow by at most `κ`. It
    /// costs about `10·n·(2K + 1)²`: for some hundred samples. For many there is
    /// [`Weighted`](crate::beyond::weighted::Weighted).
    ///
    /// # Errors
    /// A band that is not positive; [`Error::OutOfRange`] where the density is below `2B` (fewer samples than
    /// coefficients); [`Error::IllConditioned`] where the condition number exceeds `most_condition`.
    pub fn least_squares(&self, band: f64, most_condition: f64) -> Result<Recovery> {
        let degree = self.degree(band)?;
        let svd = Svd::of(&self.matrix(degree))?;
        let condition = svd.condition();
        if condition.is_nan() || condition > most_condition {
            let what = "recovery from irregular samples";
            return Err(Error::IllConditioned { what, condition, most: most_condition });
        }
        let values: Vec<f64> = self.points.iter().map(|p| p[1]).collect();
        let signal = TrigPolynomial::of_real(self.start, self.period, &svd.solve(&values)?);
        Ok(Recovery { signal, singular_values: svd.values().to_vec() })
    }

    /// By what factor every step of [`Irregular::iterate`] makes the error smaller: `2δK/L ≤ 2Bδ`.
    ///
    /// # Errors
    /// As [`Irregular::iterate`].
    pub fn contraction(&self, band: f64) -> Result<f64> {
        let degree = self.degree(band)?;
        let factor = 2.0 * self.largest_gap() * degree as f64 / self.period;
        if factor < 1.0 {
            return Ok(factor);
        }
        let what = "the band for which the largest gap lets the iteration converge";
        Err(Error::OutOfRange { what, value: band, low: 0.0, high: 0.5 / self.largest_gap() })
    }

    /// Gröchenig's iteration: `p ← p + P V(f − p)`, where `V` extends the values to steps around their positions, each as
    /// wide as the way half to both neighbours, and `P` cuts off what is beyond the band.
    ///
    /// No equations are solved. On the band, `‖q − P V q‖ ≤ ‖q − V q‖ ≤ (δ/π)‖q′‖ ≤ 2Bδ‖q‖` by the inequalities of
    /// Wirtinger (on half gaps, where `q − V q` vanishes at one end) and Bernstein, so every step makes the error
    /// smaller by at least `2Bδ` (Gröchenig 1992). A step costs `O(n + K log K)`.
    ///
    /// # Errors
    /// A band that is not positive or that the density does not support; [`Error::OutOfRange`] where `2Bδ ≥ 1`.
    pub fn iterate(&self, band: f64, steps: usize) -> Result<TrigPolynomial> {
        self.contraction(band)?;
        let degree = self.degree(band)?;
        let positions: Vec<f64> = self.points.iter().map(|p| p[0]).collect();
        let staircase = Staircase::new(&positions, [self.start, self.period], degree)?;
        let period = self.start..self.start + self.period;
        let mut signal = TrigPolynomial::new(period.clone(), vec![Complex::ZERO; degree + 1])?;
        for _ in 0..steps {
            let values = staircase.values(&signal)?;
            let rest: Vec<f64> = self.points.iter().zip(values).map(|(p, value)| p[1] - value).collect();
            let band = staircase.coefficients(&rest)?;
            let coefficients = signal.coefficients().iter().zip(band).map(|(c, more)| c + more).collect();
            signal = TrigPolynomial::new(period.clone(), coefficients)?;
        }
        Ok(signal)
    }
}

impl Recovery {
    /// The signal, as a trigonometric polynomial.
    pub fn polynomial(&self) -> &TrigPolynomial {
        &self.signal
    }

    /// The singular values of the equations, falling.
    pub fn singular_values(&self) -> &[f64] {
        &self.singular_values
    }

    /// Their ratio `κ`: relative errors of the values grow by at most this factor. One for equally spaced positions.
    pub fn condition(&self) -> f64 {
        self.singular_values[0] / self.singular_values[self.singular_values.len() - 1]
    }
}

impl Signal for Recovery {
    fn at(&self, x: f64) -> f64 {
        self.signal.at(x)
    }
}
