//! What a period does not continue.

use crate::error::Result;
use crate::num::svd::Svd;
use crate::parallel;
use crate::record::dense::Dense;
use crate::signal::Signal;
use crate::signal::trigonometric::TrigPolynomial;
use ndarray::Array2;
use num_complex::Complex;

/// How many polynomials beside the constant: Legendre's `P_1` to `P_4` over the record. They take up what its ends differ
/// by, in value and the first derivatives.
const COUNT: usize = 4;
/// What rounding may leave of a polynomial of size one that the period continues, `κ²ε` of a fit whose condition number is
/// two thousand; directions below it are not determined.
const LOST: f64 = 1e-9;

/// Polynomials over a record, and what is left of each where the period takes the best part of it.
#[derive(Debug, Clone)]
pub(super) struct Ends {
    middle: f64,
    half: f64,
    /// The nearest of the period to each polynomial.
    nearest: Vec<Dense>,
    /// What is left at the samples, column by column, and the roots of their weights.
    left: Option<(Svd, Vec<f64>)>,
}

impl Ends {
    /// No polynomials.
    pub(super) fn none(positions: &[f64]) -> Self {
        let (first, last) = (positions[0], positions[positions.len() - 1]);
        Self { middle: 0.5 * (first + last), half: 0.5 * (last - first), nearest: Vec::new(), left: None }
    }

    /// For samples of these weights, fitted by `fit`.
    pub(super) fn new(positions: &[f64], weights: &[f64], fit: impl Fn(&[f64]) -> Result<Dense>) -> Result<Self> {
        let mut ends = Self::none(positions);
        let roots: Vec<f64> = weights.iter().map(|w| w.sqrt()).collect();
        let mut left = Array2::zeros((positions.len(), COUNT));
        for i in 0..COUNT {
            let values: Vec<f64> = positions.iter().map(|&x| ends.basis(x)[i]).collect();
            let dense = fit(&values)?;
            for (j, (near, root)) in dense.at_all(positions).iter().zip(&roots).enumerate() {
                left[[j, i]] = root * (values[j] - near);
            }
            ends.nearest.push(dense);
        }
        ends.left = Some((Svd::of(&left)?, roots));
        Ok(ends)
    }

    fn basis(&self, x: f64) -> [f64; COUNT] {
        let s = (x - self.middle) / self.half;
        let (mut before, mut now) = (1.0, s);
        let mut basis = [s; COUNT];
        for (k, value) in (2..).zip(basis.iter_mut().skip(1)) {
            let k = f64::from(k);
            let next = ((2.0 * k - 1.0) * s * now - (k - 1.0) * before) / k;
            (before, now) = (now, next);
            *value = next;
        }
        basis
    }

    /// The signal nearest to `values`, of which `dense` is the nearest of the period: least squares in what both leave
    /// (Frisch and Waugh 1933).
    pub(super) fn taken_up(
        &self,
        dense: Dense,
        positions: &[f64],
        values: &[f64],
        mirrored: bool,
    ) -> Result<Recovered> {
        let mut recovered =
            Recovered { dense, parts: [0.0; COUNT], ends: Self { left: None, ..self.clone() }, mirrored };
        let Some((svd, roots)) = &self.left else { return Ok(recovered) };
        let near = recovered.dense.at_all(positions);
        let rest: Vec<f64> = near.iter().zip(values).zip(roots).map(|((near, v), root)| root * (v - near)).collect();
        let parts = svd.solve_above(&rest, LOST)?;
        let polynomial = recovered.dense.polynomial();
        let without = |(k, c): (usize, &Complex<f64>)| {
            let taken: Complex<f64> =
                self.nearest.iter().zip(&parts).map(|(n, part)| n.polynomial().coefficients()[k] * *part).sum();
            c - taken
        };
        let coefficients = polynomial.coefficients().iter().enumerate().map(without).collect();
        let period = polynomial.start()..polynomial.start() + polynomial.period();
        recovered.dense = Dense::of(TrigPolynomial::new(period, coefficients)?);
        recovered.parts.copy_from_slice(&parts);
        recovered.ends.nearest = Vec::new();
        Ok(recovered)
    }
}

/// A signal recovered from irregular samples: a trigonometric polynomial, and a polynomial for what it does not continue.
/// Beyond the ends it goes on as a period or as its reflection.
#[derive(Debug, Clone)]
pub struct Recovered {
    dense: Dense,
    parts: [f64; COUNT],
    ends: Ends,
    mirrored: bool,
}

impl Recovered {
    /// The values at many places, on all threads.
    pub fn at_all(&self, places: &[f64]) -> Vec<f64> {
        let values = self.dense.at_all(places);
        parallel::map(places.len(), |i| values[i] + self.beside(places[i]))
    }

    /// What stands beside the period.
    fn beside(&self, x: f64) -> f64 {
        let polynomial = self.dense.polynomial();
        let part = (x - polynomial.start()) / polynomial.period();
        let part = part - part.floor();
        let inside = if self.mirrored && part > 0.5 { 1.0 - part } else { part };
        // the place of the record where the polynomial is meant
        let place = polynomial.start() + inside * polynomial.period();
        self.ends.basis(place).iter().zip(&self.parts).map(|(p, part)| p * part).sum()
    }
}

impl Signal for Recovered {
    fn at(&self, x: f64) -> f64 {
        self.dense.at(x) + self.beside(x)
    }
}
