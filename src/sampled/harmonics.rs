//! The spectrum of weights at the harmonics of a period: the sums that all work with irregular samples consists of.

use crate::engine::fft::{Butterflies, RealFft};
use crate::error::{Error, Result};
use crate::num::{cos_pi, sin_pi};
use crate::parallel;
use num_complex::Complex;

const NODES: &str = "rooms are as long as their transform";

/// Where weights stand in a period.
#[derive(Debug, Clone, PartialEq)]
pub enum Places {
    /// Anywhere: positions as parts of the period.
    Anywhere(Vec<f64>),
    /// On a grid, some of whose nodes may be empty.
    Grid {
        /// How many nodes the period has.
        nodes: usize,
        /// On which of them weights stand.
        taken: Vec<usize>,
    },
}

/// The most products of the direct sum, 2³⁴: some 20 s of one processor.
pub const MOST_PRODUCTS: f64 = (1u64 << 34) as f64;

impl Places {
    /// How many weights there are.
    pub fn len(&self) -> usize {
        match self {
            Self::Anywhere(parts) => parts.len(),
            Self::Grid { taken, .. } => taken.len(),
        }
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The position of weight `i` as a part of the period.
    pub fn part(&self, i: usize) -> f64 {
        match self {
            Self::Anywhere(parts) => parts[i],
            Self::Grid { nodes, taken } => taken[i] as f64 / *nodes as f64,
        }
    }

    /// `Σ_j w_j e^{−2πimu_j}` for `0 ≤ m ≤ order`, `u_j` the positions as parts of the period.
    ///
    /// On a grid by the fast transform, exact to rounding at any order. Anywhere by the direct sum in `O(n·order)`: waves
    /// are computed as powers, from a fresh one every 512 harmonics, so that each is off by at most about `10³ε` and the
    /// rounding `mε` of its argument. The same bits for any number of threads.
    ///
    /// ```
    /// use nyquist::sampled::harmonics::Places;
    /// // three of four equally spaced weights, said in both ways
    /// let grid = Places::Grid { nodes: 4, taken: vec![0, 1, 3] };
    /// let anywhere = Places::Anywhere(vec![0.0, 0.25, 0.75]);
    /// let [a, b] = [grid, anywhere].map(|places| places.harmonics(&[1.0; 3], 1000).unwrap());
    /// assert!(a.iter().zip(&b).all(|(a, b)| (a - b).norm() < 1e-12));
    /// assert!((a[4].re - 3.0).abs() < 1e-15 && (a[2].re + 1.0).abs() < 1e-15);
    /// ```
    ///
    /// # Errors
    /// A number of weights other than that of places; [`Error::Overflow`] for a direct sum of more than
    /// [`MOST_PRODUCTS`].
    pub fn harmonics(&self, weights: &[f64], order: usize) -> Result<Vec<Complex<f64>>> {
        if weights.len() != self.len() {
            return Err(Error::Length { what: "weights at places", expected: self.len(), got: weights.len() });
        }
        match self {
            Self::Grid { nodes, taken } => Ok(on_grid(*nodes, taken, weights, order)),
            Self::Anywhere(parts) => {
                let value = parts.len() as f64 * (order + 1) as f64;
                if value > MOST_PRODUCTS {
                    let what = "the product of irregular samples and frequencies";
                    return Err(Error::Overflow { what, value, most: MOST_PRODUCTS });
                }
                Ok(directly(parts, weights, order))
            }
        }
    }
}

fn on_grid(nodes: usize, taken: &[usize], weights: &[f64], order: usize) -> Vec<Complex<f64>> {
    let mut values = vec![0.0; nodes.max(1)];
    for (&node, &weight) in taken.iter().zip(weights) {
        values[node % nodes.max(1)] += weight;
    }
    let n = values.len();
    let mut half = vec![Complex::ZERO; n / 2 + 1];
    RealFft::with(n, Butterflies::Scalar).and_then(|fft| fft.forward(&values, &mut half)).expect(NODES);
    let at = |m: usize| if m % n <= n / 2 { half[m % n] } else { half[n - m % n].conj() };
    (0..=order).map(at).collect()
}

/// Harmonics that share one fresh wave.
const BLOCK: usize = 512;
/// Points whose powers are multiplied side by side: they need not wait for each other.
const LANES: usize = 4;

fn directly(parts: &[f64], weights: &[f64], order: usize) -> Vec<Complex<f64>> {
    let mut sums = vec![Complex::ZERO; order + 1];
    let turn = |turns: f64| Complex::new(cos_pi(2.0 * turns), -sin_pi(2.0 * turns));
    parallel::chunks(&mut sums, BLOCK, |block, sums| {
        let first = (block * BLOCK) as f64;
        for (parts, weights) in parts.chunks(LANES).zip(weights.chunks(LANES)) {
            let (mut waves, mut powers) = ([Complex::ZERO; LANES], [Complex::ZERO; LANES]);
            for (i, (part, weight)) in parts.iter().zip(weights).enumerate() {
                waves[i] = turn(*part);
                powers[i] = turn(first * part) * weight;
            }
            for sum in &mut *sums {
                *sum += (powers[0] + powers[1]) + (powers[2] + powers[3]);
                for (power, wave) in powers.iter_mut().zip(&waves) {
                    *power *= wave;
                }
            }
        }
    });
    sums
}
