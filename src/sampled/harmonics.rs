//! The spectrum of weights at the harmonics of a period: the sums that all work with irregular samples consists of.

use crate::engine::fft::{Butterflies, RealFft};
use crate::engine::nonuniform::{Nufft, Placed};
use crate::error::{Error, Result};
use crate::num::{cos_pi, sin_pi};
use crate::parallel;
use num_complex::Complex;
use std::sync::Arc;

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

/// The highest order of sums over places anywhere, 2²⁴: the transform of their grid takes 1 to 1.6 gigabytes.
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
    /// the rounding `πmε` of its argument. Longer ones by the [non-uniform transform](Nufft), off by at most `10⁻¹³ Σ|w_j|`
    /// beside the same `πmε` and the `nε` of adding up `n` terms. The same bits for any number of threads.
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
    /// [`MOST_ORDER`]; places that are not finite, where there are many.
    pub fn harmonics(&self, weights: &[f64], order: usize) -> Result<Vec<Complex<f64>>> {
        self.up_to(order)?.of(weights)
    }

    /// The same for any number of weights, prepared once.
    ///
    /// # Errors
    /// As [`harmonics`](Self::harmonics).
    pub fn up_to(&self, order: usize) -> Result<Harmonics> {
        let way = match self {
            Self::Grid { nodes, taken } => Way::Grid { nodes: *nodes, taken: taken.clone() },
            Self::Anywhere(_) if order > MOST_ORDER => {
                let (what, value) = ("the number of frequencies over irregular samples", order as f64);
                return Err(Error::Overflow { what, value, most: MOST_ORDER as f64 });
            }
            Self::Anywhere(parts) if parts.len() as f64 * (order + 1) as f64 <= SHORT => Way::Direct(parts.clone()),
            Self::Anywhere(parts) => {
                let nufft = Nufft::with(order, 1, TOLERANCE, Butterflies::Scalar)?;
                Way::Fast { placed: Arc::new(nufft.place(parts)?), nufft: Arc::new(nufft) }
            }
        };
        Ok(Harmonics { len: self.len(), order, way })
    }
}

/// Places, prepared for [sums](Places::harmonics) up to one order.
#[derive(Debug, Clone)]
pub struct Harmonics {
    len: usize,
    order: usize,
    way: Way,
}

#[derive(Debug, Clone)]
enum Way {
    Grid { nodes: usize, taken: Vec<usize> },
    Direct(Vec<f64>),
    Fast { nufft: Arc<Nufft<f64>>, placed: Arc<Placed<1>> },
}

impl Harmonics {
    /// `Σ_j w_j e^{−2πimu_j}` for `0 ≤ m ≤ order`.
    ///
    /// # Errors
    /// A number of weights other than that of places.
    pub fn of(&self, weights: &[f64]) -> Result<Vec<Complex<f64>>> {
        if weights.len() != self.len {
            return Err(Error::Length { what: "weights at places", expected: self.len, got: weights.len() });
        }
        match &self.way {
            Way::Grid { nodes, taken } => Ok(on_grid(*nodes, taken, weights, self.order)),
            Way::Direct(parts) => Ok(directly(parts, weights, self.order)),
            Way::Fast { nufft, placed } => nufft.spectrum(placed, weights),
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
/// What a longer sum may be off by, as a part of that of the weights' sizes.
const TOLERANCE: f64 = 1e-13;
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
