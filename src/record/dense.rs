//! Trigonometric polynomials at many places.

use crate::axis::{Axis, Edge};
use crate::engine::fft::{Butterflies, RealFft, fast_length};
use crate::kernel::regularised::Regularised;
use crate::parallel;
use crate::reconstruct::reconstruct;
use crate::sampled::Samples;
use crate::signal::Signal;
use crate::signal::trigonometric::TrigPolynomial;
use num_complex::Complex;

const NODES: &str = "rooms are as long as their transform";

/// Up to this degree Horner's rule is no slower than the kernel below.
const FEW: usize = 128;
/// Of the kernel that reads between the nodes: `e^{−π·½·46/2} = 2·10⁻¹⁶`.
const RADIUS: f64 = 46.0;

/// A trigonometric polynomial of high degree that is quick to evaluate: its values on twice as many nodes as it needs, by
/// the fast transform, and the regularised sinc between them.
///
/// The nodes see the polynomial fill half of their band at most, so that the error is below `e^{−πn/4}` for the radius
/// `n = 46`: rounding of the sum of the coefficients' sizes. A value costs 92 terms whatever the degree.
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
/// assert!(worst < 2000.0 * f64::EPSILON * size, "{worst:e} {size}");
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Dense {
    polynomial: TrigPolynomial,
    nodes: Option<(Samples, Regularised)>,
}

impl Dense {
    /// The values of `polynomial`.
    pub fn of(polynomial: TrigPolynomial) -> Self {
        let degree = polynomial.degree();
        if degree <= FEW {
            return Self { polynomial, nodes: None };
        }
        let n = fast_length(4 * degree + 4);
        let mut half = vec![Complex::ZERO; n / 2 + 1];
        half[..=degree].copy_from_slice(polynomial.coefficients());
        let mut values = vec![0.0; n];
        RealFft::with(n, Butterflies::Scalar).and_then(|fft| fft.inverse(&half, &mut values)).expect(NODES);
        // positions as parts of the period: nothing to be checked, and nothing lost far from zero
        let axis = Axis::new(0.0, 1.0 / n as f64, n).expect("a whole number of nodes between zero and one");
        let kernel = Regularised::for_band(RADIUS, 0.5).expect("a radius and a band within their ranges");
        Self { polynomial, nodes: Some((Samples::trusted(axis, values), kernel)) }
    }

    /// The values at many places, on all threads.
    pub fn at_all(&self, places: &[f64]) -> Vec<f64> {
        parallel::map(places.len(), |i| self.at(places[i]))
    }

    /// The polynomial itself.
    pub fn polynomial(&self) -> &TrigPolynomial {
        &self.polynomial
    }
}

impl Signal for Dense {
    fn at(&self, x: f64) -> f64 {
        match &self.nodes {
            None => self.polynomial.at(x),
            Some((samples, kernel)) => {
                let part = (x - self.polynomial.start()) / self.polynomial.period();
                reconstruct(samples, *kernel).edge(Edge::Wrap).at(part - part.floor())
            }
        }
    }
}
