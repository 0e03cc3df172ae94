//! Irregular values extended to steps, and what of them lies within a band.

use crate::engine::fft::Butterflies;
use crate::engine::nonuniform::{Nufft, Placed};
use crate::error::Result;
use crate::num::{cos_pi, sin_pi, sinc};
use crate::signal::Signal;
use crate::signal::trigonometric::TrigPolynomial;
use num_complex::Complex;
use std::f64::consts::TAU;

/// Products of a direct sum that is as quick as spreading and a transform.
const SHORT: usize = 1 << 18;
/// The error of the longer ones, as a part of the sum of the sizes.
const TOLERANCE: f64 = 1e-13;

/// Steps around positions of a period, each as wide as the way half to both neighbours, and their harmonics up to a degree.
///
/// Few by the direct sum; many in `O(n + K log K)`: a step function is made of its jumps, whose harmonics a
/// [non-uniform transform](Nufft) has, over `2πik`.
pub(super) struct Staircase {
    degree: usize,
    positions: Vec<f64>,
    /// Twice where steps have their middles, and how wide they are, as parts of the period.
    steps: Vec<[f64; 2]>,
    fast: Option<Fast>,
}

struct Fast {
    nufft: Nufft<f64>,
    positions: Placed<1>,
    jumps: Placed<1>,
}

impl Staircase {
    /// Around positions that rise through the period from `start` on.
    pub(super) fn new(positions: &[f64], [start, period]: [f64; 2], degree: usize) -> Result<Self> {
        let n = positions.len();
        let gap = |i: usize| match positions.get(i + 1) {
            Some(next) => next - positions[i],
            None => positions[0] + period - positions[i],
        };
        let step = |i: usize| {
            let (before, after) = (0.5 * gap((i + n - 1) % n), 0.5 * gap(i));
            let middle = positions[i] + 0.5 * (after - before) - start;
            [2.0 * (middle / period), (before + after) / period]
        };
        let steps: Vec<[f64; 2]> = (0..n).map(step).collect();
        let fast = if n.saturating_mul(degree + 1) <= SHORT {
            None
        } else {
            let nufft = Nufft::with(degree, 1, TOLERANCE, Butterflies::Scalar)?;
            let parts: Vec<f64> = positions.iter().map(|x| (x - start) / period).collect();
            let jumps: Vec<f64> = steps.iter().map(|[twice, width]| 0.5 * (twice - width)).collect();
            Some(Fast { positions: nufft.place(&parts)?, jumps: nufft.place(&jumps)?, nufft })
        };
        Ok(Self { degree, positions: positions.to_vec(), steps, fast })
    }

    /// The values of a polynomial of that degree at the positions.
    pub(super) fn values(&self, signal: &TrigPolynomial) -> Result<Vec<f64>> {
        match &self.fast {
            Some(fast) => fast.nufft.values(signal.coefficients(), &fast.positions),
            None => Ok(self.positions.iter().map(|&x| signal.at(x)).collect()),
        }
    }

    /// The coefficients, from zero to the degree, of steps of these heights.
    pub(super) fn coefficients(&self, heights: &[f64]) -> Result<Vec<Complex<f64>>> {
        let Some(fast) = &self.fast else {
            let coefficient = |k: usize| {
                let k = k as f64;
                let step = |([angle, width], height): (&[f64; 2], &f64)| {
                    Complex::new(cos_pi(k * angle), -sin_pi(k * angle)) * (height * width * sinc(k * width))
                };
                self.steps.iter().zip(heights).map(step).sum()
            };
            return Ok((0..=self.degree).map(coefficient).collect());
        };
        let before = heights.iter().cycle().skip(heights.len() - 1);
        let jumps: Vec<f64> = heights.iter().zip(before).map(|(height, before)| height - before).collect();
        let mut coefficients = fast.nufft.spectrum(&fast.jumps, &jumps)?;
        for (k, c) in coefficients.iter_mut().enumerate().skip(1) {
            let over = 1.0 / (TAU * k as f64);
            *c = Complex::new(c.im * over, -c.re * over);
        }
        coefficients[0] = self.steps.iter().zip(heights).map(|([_, width], height)| width * height).sum::<f64>().into();
        Ok(coefficients)
    }
}
