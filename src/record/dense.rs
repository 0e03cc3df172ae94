//! Trigonometric polynomials at many places.

use crate::engine::fft::Butterflies;
use crate::engine::nonuniform::Nufft;
use crate::parallel;
use crate::signal::Signal;
use crate::signal::trigonometric::TrigPolynomial;
use std::sync::Arc;

/// Up to this degree Horner's rule is no slower than the grid below.
const FEW: usize = 128;
/// The error of the sums over it, as a part of the sum of the coefficients' sizes.
const TOLERANCE: f64 = 1e-13;

/// A trigonometric polynomial of high degree that is quick to evaluate: from the grid of a
/// [non-uniform transform](Nufft), where a value costs 16 terms whatever the degree.
///
/// The error is below `10⁻¹³` times the sum of the coefficients' sizes, to which Horner's rule adds up roundings of
/// `2Kε`.
///
/// ```
/// use nyquist::laws::frames::random_polynomial;
/// use nyquist::prelude::*;
/// use nyquist::record::Dense;
/// let p = random_polynomial(1, 10.0, 1000)?;
/// let size: f64 = p.coefficients().iter().map(|c| 2.0 * c.norm()).sum();
/// let dense = Dense::of(p.clone());
/// let worst = (0..100).map(|i| 0.1234 * f64::from(i)).map(|x| (dense.at(x) - p.at(x)).abs()).fold(0.0, f64::max);
/// // Horner's rule itself rounds by up to 2Kε of that
/// assert!(worst < (1e-13 + 2000.0 * f64::EPSILON) * size, "{worst:e} {size}");
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Dense {
    polynomial: TrigPolynomial,
    fine: Option<Arc<Fine>>,
}

#[derive(Debug)]
struct Fine {
    nufft: Nufft<f64>,
    grid: Vec<f64>,
}

impl Dense {
    /// The values of `polynomial`.
    pub fn of(polynomial: TrigPolynomial) -> Self {
        let degree = polynomial.degree();
        if degree <= FEW {
            return Self { polynomial, fine: None };
        }
        let fine = Nufft::with(degree, 1, TOLERANCE, Butterflies::Scalar)
            .and_then(|nufft| Ok(Fine { grid: nufft.grid(polynomial.coefficients())?, nufft }));
        Self { polynomial, fine: fine.ok().map(Arc::new) }
    }

    /// The values at many places, on all threads.
    pub fn at_all(&self, places: &[f64]) -> Vec<f64> {
        if let Some(fine) = &self.fine {
            let parts: Vec<f64> = places.iter().map(|x| self.part(*x)).collect();
            let mut values = vec![0.0; places.len()];
            let read = |placed| fine.nufft.values_from(&fine.grid, &placed, &mut values);
            if fine.nufft.place(&parts).and_then(read).is_ok() {
                return values;
            }
        }
        // few coefficients, or a place that is not finite
        parallel::map(places.len(), |i| self.at(places[i]))
    }

    /// The polynomial itself.
    pub fn polynomial(&self) -> &TrigPolynomial {
        &self.polynomial
    }

    /// A place as a part of the period: nothing is lost far from zero.
    fn part(&self, x: f64) -> f64 {
        let part = (x - self.polynomial.start()) / self.polynomial.period();
        part - part.floor()
    }
}

impl Signal for Dense {
    fn at(&self, x: f64) -> f64 {
        match &self.fine {
            None => self.polynomial.at(x),
            Some(fine) => fine.nufft.value(&fine.grid, self.part(x)).expect("its own grid"),
        }
    }
}
