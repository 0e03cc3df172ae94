//! Convolution of samples, by FFT.

use crate::axis::Axis;
use crate::error::{Error, Result};
use crate::sampled::Samples;
use crate::sampled::dft::{dft, inverse_dft};

/// `(f ⊗ g)(x) ≈ T Σ_j f(x_j) g(x − x_j)`: linear convolution; the record is as long as both together less one.
///
/// The trapezoid rule for the convolution integral, so exact where the product's spectrum has no replica at zero:
/// for signals band-limited below half the rate. Computed by FFT, to a rounding error of about `ε·log n·‖f‖‖g‖`.
///
/// ```
/// use nyquist::prelude::*;
/// let f = Samples::new(Axis::new(2.0, 1.0, 3)?, vec![1.0, 2.0, 3.0])?;
/// let g = Samples::new(Axis::new(-1.0, 1.0, 2)?, vec![10.0, 1.0])?;
/// let h = convolve(&f, &g)?;
/// assert_eq!(h.axis().start(), 1.0);
/// assert!(h.values().iter().zip([10.0, 21.0, 32.0, 3.0]).all(|(a, b)| (a - b).abs() < 1e-13));
/// # Ok::<(), Error>(())
/// ```
///
/// # Errors
/// Steps that differ.
pub fn convolve(f: &Samples, g: &Samples) -> Result<Samples> {
    let step = common_step(f, g)?;
    let n = f.values().len() + g.values().len() - 1;
    let axis = Axis::new(f.axis().start() + g.axis().start(), step, n)?.in_unit(f.axis().unit());
    // an even length is transformed at half cost
    let values = circular(f.values(), g.values(), n.next_multiple_of(2), step)?;
    Samples::new(axis, values[..n].to_vec())
}

/// Circular convolution `T Σ_j f(x_j) g(x_{(i−j) mod n})` of two records of the same length: the convolution of their
/// periodic continuations over one period.
///
/// ```
/// use nyquist::prelude::*;
/// let axis = Axis::new(0.0, 1.0, 4)?;
/// let f = Samples::new(axis, vec![1.0, 2.0, 3.0, 4.0])?;
/// let shift = Samples::new(axis, vec![0.0, 1.0, 0.0, 0.0])?;
/// let turned = convolve_circular(&f, &shift)?;
/// assert!(turned.values().iter().zip([4.0, 1.0, 2.0, 3.0]).all(|(a, b)| (a - b).abs() < 1e-14));
/// # Ok::<(), Error>(())
/// ```
///
/// # Errors
/// Steps or lengths that differ.
pub fn convolve_circular(f: &Samples, g: &Samples) -> Result<Samples> {
    let step = common_step(f, g)?;
    let n = f.values().len();
    if g.values().len() != n {
        return Err(Error::Length { what: "the period of the second record", expected: n, got: g.values().len() });
    }
    let axis = Axis::new(f.axis().start() + g.axis().start(), step, n)?.in_unit(f.axis().unit());
    Samples::new(axis, circular(f.values(), g.values(), n, step)?)
}

fn common_step(f: &Samples, g: &Samples) -> Result<f64> {
    let (a, b) = (f.axis().step(), g.axis().step());
    // steps from different quotients may differ in the last bits
    if (a - b).abs() <= 4.0 * f64::EPSILON * a {
        Ok(a)
    } else {
        Err(Error::Unsupported("two records with different steps"))
    }
}

fn circular(f: &[f64], g: &[f64], n: usize, step: f64) -> Result<Vec<f64>> {
    let padded = |v: &[f64]| v.iter().copied().chain(std::iter::repeat(0.0)).take(n).collect::<Vec<_>>();
    let (f, g) = (dft(&padded(f))?, dft(&padded(g))?);
    let product: Vec<_> = f.iter().zip(&g).map(|(a, b)| a * b * step).collect();
    inverse_dft(&product)
}
