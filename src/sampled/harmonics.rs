//! The spectrum of weights at the harmonics of a period: the sums that all work with irregular samples consists of.

use crate::engine::fft::{Butterflies, RealFft, fast_length};
use crate::error::{Error, Result};
use crate::num::{cos_pi, sin_pi};
use crate::parallel;
use num_complex::Complex;
use std::f64::consts::PI;

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

/// The highest order of sums over places anywhere, 2²⁴: their grid takes a gigabyte.
pub const MOST_ORDER: usize = 1 << 24;

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
    /// On a grid by the fast transform, exact to rounding at any order. Anywhere by the direct sum while that is short:
    /// waves are computed as powers, from a fresh one every 512 harmonics, so that each is off by at most about `10³ε` and
    /// the rounding `πmε` of its argument. Longer ones by the fast transform of weights that Gaussians spread over a grid of
    /// at least `N = 4(order + 1)` nodes (Dutt and Rokhlin 1993; Greengard and Lee 2004): `O(n + N log N)`, off by at most
    /// `(4e^{−2π·17/3} + 90 ε log₂ N) Σ|w_j|` beside the same `πmε` and the `nε` of adding up `n` terms. The first part is
    /// the bound of Steidl (*A note on fast Fourier transforms for nonequispaced grids*, 1998) for Gaussians cut off 17
    /// nodes from their middle and twofold oversampling; in the second the rounding of the transform is divided by a
    /// Gaussian that falls to 1/86. The same bits for any number of threads.
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
    /// A number of weights other than that of places; [`Error::Overflow`] for places anywhere and an order above
    /// [`MOST_ORDER`].
    pub fn harmonics(&self, weights: &[f64], order: usize) -> Result<Vec<Complex<f64>>> {
        if weights.len() != self.len() {
            return Err(Error::Length { what: "weights at places", expected: self.len(), got: weights.len() });
        }
        match self {
            Self::Grid { nodes, taken } => Ok(on_grid(*nodes, taken, weights, order)),
            Self::Anywhere(_) if order > MOST_ORDER => {
                let (what, value) = ("the number of frequencies over irregular samples", order as f64);
                Err(Error::Overflow { what, value, most: MOST_ORDER as f64 })
            }
            Self::Anywhere(parts) if parts.len() as f64 * (order + 1) as f64 <= SHORT => {
                Ok(directly(parts, weights, order))
            }
            Self::Anywhere(parts) => Ok(gridded(parts, weights, order)),
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

/// Products of a direct sum that is as quick as spreading and a transform.
const SHORT: f64 = (1 << 18) as f64;
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

/// Nodes to either side of a weight over which it is spread.
const REACH: usize = 17;

/// The transform of the weights convolved with `e^{−(Nu)²/b}/√(πb)` on `N` nodes, over `e^{−b(πm/N)²}`; with twofold
/// oversampling `b = 4·17/(3π)` makes what folds as small as what is cut off.
fn gridded(parts: &[f64], weights: &[f64], order: usize) -> Vec<Complex<f64>> {
    let b = 4.0 * REACH as f64 / (3.0 * PI);
    let n = fast_length((4 * (order + 1)).max(2 * REACH + 2));
    let aside: [f64; REACH + 1] = std::array::from_fn(|l| (-((l * l) as f64) / b).exp() / (PI * b).sqrt());
    let mut nodes = vec![0.0; n];
    let mut spread = [0.0; 2 * REACH + 1];
    for (part, weight) in parts.iter().zip(weights) {
        let place = part.rem_euclid(1.0) * n as f64;
        let nearest = place.round();
        // e^{−(d − l)²/b} is the product of e^{−d²/b}, of (e^{2d/b})^l and of e^{−l²/b}, which is the same for all weights
        let off = place - nearest;
        let (middle, turn) = (weight * (-off * off / b).exp(), (2.0 * off / b).exp());
        let (mut up, mut down, back) = (middle, middle, 1.0 / turn);
        spread[REACH] = middle * aside[0];
        for l in 1..=REACH {
            up *= turn;
            down *= back;
            spread[REACH + l] = up * aside[l];
            spread[REACH - l] = down * aside[l];
        }
        let first = (nearest as usize + n - REACH) % n;
        // what passes the end of the period comes in at its start
        let whole = (n - first).min(spread.len());
        nodes[first..first + whole].iter_mut().zip(&spread).for_each(|(node, v)| *node += v);
        nodes.iter_mut().zip(&spread[whole..]).for_each(|(node, v)| *node += v);
    }
    let mut half = vec![Complex::ZERO; n / 2 + 1];
    RealFft::with(n, Butterflies::Scalar).and_then(|fft| fft.forward(&nodes, &mut half)).expect(NODES);
    half.truncate(order + 1);
    half.iter_mut().enumerate().for_each(|(m, sum)| *sum *= (b * (PI * m as f64 / n as f64).powi(2)).exp());
    half
}
