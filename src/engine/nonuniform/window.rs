//! The window that spreads a point over the cells around it.

use crate::num::special::bessel_i0;
use std::f64::consts::PI;

/// The window of Kaiser and Bessel over `width` cells, `φ(t) = I₀(β√(1 − (2t/w)²))/I₀(β)` for `|t| ≤ w/2`, with the
/// transform `φ̂(ν) = w·sinh(s)/(s·I₀(β))`, `s² = β² − (πwν)²`, at `ν` cycles per cell.
///
/// Points spread by it over a grid that is `σ` times finer than the highest frequency asks for have a spectrum that is
/// the right one times `φ̂`, plus copies of what lies around the multiples of the grid's rate, which `φ̂` makes small
/// there. With the parameter of Beatty, Nishimura and Pauly (2005), `β² = (πw(1 − 1/(2σ)))² − 0.8π²`, the worst of all
/// frequencies up to `1/(2σ)`, at the worst of all places, is off by less than `12·e^{−πw√(1 − 1/σ)}` of itself, and by
/// `8·e^{…}` at `σ = 5/4`, down to rounding. The exponent is the theory's (Potts and Tasche, *Uniform error estimates
/// for nonequispaced fast Fourier transforms*, 2021); the factors are above the largest that are met over the widths
/// and ratios that are used, 11.6 and 7.6 (their proof allows more), and the law `nonuniform-harmonics` measures what
/// comes of them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Window {
    width: usize,
    beta: f64,
    /// `I₀(β)`.
    peak: f64,
}

/// The widths that there are, in cells.
pub(super) const WIDTHS: [usize; 7] = [4, 6, 8, 10, 12, 14, 16];

/// The least and the greatest ratio `σ` between the rate of the grid and twice the highest frequency. Below the least
/// the gains that undo the window at the highest frequency, `e^{β−s}`, would cost digits.
const RATIOS: [f64; 2] = [1.25, 2.0];

/// The factor of the error bound, and that at the least ratio.
const FACTOR: f64 = 12.0;
const LEAST_FACTOR: f64 = 8.0;

impl Window {
    /// The window of that many cells for a grid of that ratio `σ`.
    pub(crate) fn new(width: usize, ratio: f64) -> Self {
        let cutoff = PI * width as f64 * (1.0 - 0.5 / ratio);
        let beta = (cutoff * cutoff - 0.8 * PI * PI).sqrt();
        Self { width, beta, peak: bessel_i0(beta) }
    }

    /// The least ratio `σ` for which a window of that many cells errs by at most `tolerance`, if it is one that is
    /// allowed.
    pub(super) fn ratio(width: usize, tolerance: f64) -> Option<f64> {
        let ratio = |factor: f64| {
            let root = ((factor / tolerance).ln() / (PI * width as f64)).min(1.0);
            1.0 / (1.0 - root * root) // at which factor·e^{−πw√(1 − 1/σ)} is the tolerance
        };
        if ratio(LEAST_FACTOR) <= RATIOS[0] {
            return Some(RATIOS[0]);
        }
        Some(ratio(FACTOR).max(RATIOS[0])).filter(|ratio| *ratio <= RATIOS[1])
    }

    /// How many cells it covers.
    pub(super) fn width(&self) -> usize {
        self.width
    }

    /// `φ(t)`, `t` in cells.
    pub(super) fn at(&self, t: f64) -> f64 {
        let x = 2.0 * t / self.width as f64;
        let inside = (1.0 - x * x).max(0.0);
        if x.abs() <= 1.0 { bessel_i0(self.beta * inside.sqrt()) / self.peak } else { 0.0 }
    }

    /// `φ̂(ν)`, `ν` in cycles per cell, below the cutoff.
    pub(crate) fn transform(&self, nu: f64) -> f64 {
        let s = (self.beta.powi(2) - (PI * self.width as f64 * nu).powi(2)).sqrt();
        self.width as f64 * s.sinh() / (s * self.peak)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_complex::Complex;

    /// The error of the worst of nine harmonics up to the highest, at the worst of 129 places within a cell.
    fn worst(width: usize, ratio: f64) -> f64 {
        let window = Window::new(width, ratio);
        let half = width as i32 / 2;
        let error = |(nu, fraction): (f64, f64)| {
            let term = |j: i32| {
                let t = f64::from(j) - fraction;
                Complex::cis(std::f64::consts::TAU * nu * t) * window.at(t)
            };
            ((-half..=half + 1).map(term).sum::<Complex<f64>>() / window.transform(nu) - 1.0).norm()
        };
        let harmonics = (0..9).map(|i| f64::from(i) / 16.0 / ratio);
        let places = harmonics.flat_map(|nu| (0..129).map(move |i| (nu, f64::from(i) / 128.0)));
        places.map(error).fold(0.0, f64::max)
    }

    #[test]
    fn the_window_errs_by_its_bound_and_not_by_much_less() {
        for width in WIDTHS {
            for step in 0..=30 {
                let ratio = 1.25 + 0.025 * f64::from(step);
                let factor = if step == 0 { LEAST_FACTOR } else { FACTOR };
                let (s, beta) = (PI * width as f64 * (1.0 - 1.0 / ratio).sqrt(), Window::new(width, ratio).beta);
                // sums of `width` values of at most one, as parts of what the window makes of the highest harmonic
                let rounding = 2.0 * f64::EPSILON * width as f64 / Window::new(width, ratio).transform(0.5 / ratio);
                let (found, bound) = (worst(width, ratio), factor * (-s).exp());
                assert!(found <= bound + rounding, "{width} {ratio}: {found} of {bound}, β = {beta}");
                assert!(found >= 0.3 * bound, "{width} {ratio}: {found} of {bound}");
            }
        }
    }
}
