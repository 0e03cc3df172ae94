//! What the spectra of all values at the same positions share.

use crate::error::{Error, Result, all_finite, positive};
use crate::record::{Kind, Sampling};
use crate::sampled::harmonics::{Harmonics, MOST_ORDER, Places};
use crate::sampled::window::Window;
use num_complex::Complex;

/// Positions, weights and the transform of the weights.
#[derive(Debug, Clone)]
pub(super) struct Frame {
    /// From the first position on.
    pub(super) times: Vec<f64>,
    /// Sums over the positions.
    sums: Harmonics,
    /// Of the window; their sum is one.
    pub(super) weights: Vec<f64>,
    /// The record's length `L`, one mean step after the last position.
    pub(super) length: f64,
    /// The highest frequency is `order/L`.
    pub(super) order: usize,
    /// The transform of the weights up to `2·order + 2`.
    pub(super) window: Vec<Complex<f64>>,
    /// On a grid the frequencies from `nodes/2` on repeat the lower ones.
    pub(super) nodes: Option<usize>,
}

impl Frame {
    pub(super) fn new(sampling: &Sampling, window: Window, up_to: Option<f64>) -> Result<Self> {
        let positions = sampling.positions();
        let times: Vec<f64> = positions.iter().map(|x| x - positions[0]).collect();
        let n = times.len();
        // a grid with far more nodes than samples is no help
        let on_grid = matches!(sampling.kind(), Kind::Uniform | Kind::Gaps) && sampling.main_stretch().len() == n;
        let nodes = on_grid.then(|| sampling.nodes()[n - 1] + 1);
        let step = sampling.step().unwrap_or(sampling.mean_step());
        let length = nodes.map_or(times[n - 1] + step, |nodes| nodes as f64 * step);
        let places = match nodes {
            Some(nodes) => Places::Grid { nodes, taken: sampling.nodes().to_vec() },
            None => Places::Anywhere(times.iter().map(|t| t / length).collect()),
        };
        let order = match up_to {
            Some(frequency) => {
                (positive("the highest frequency", frequency)? * length * (1.0 + 4.0 * f64::EPSILON)).floor()
            }
            None => {
                let half = 0.5 * length / step;
                // without a step lines can be told apart beyond half the density, if they are few
                let wanted = if sampling.kind() == Kind::Irregular { 2.0 * half } else { half };
                // the sums of the weights go twice as far
                if on_grid { half.floor() } else { wanted.min((MOST_ORDER / 2 - 1) as f64).floor() }
            }
        };
        if order < 1.0 {
            let (what, least) = ("the highest frequency", 1.0 / length);
            return Err(Error::OutOfRange { what, value: up_to.unwrap_or(0.0), low: least, high: f64::MAX });
        }
        let most = nodes.unwrap_or(0).max(MOST_ORDER / 2 - 1) as f64;
        if order > most {
            return Err(Error::Overflow { what: "the number of frequencies", value: order, most });
        }
        let order = order as usize;
        let mut weights: Vec<f64> = times.iter().map(|t| window.at(t / length)).collect();
        let sum: f64 = weights.iter().sum();
        weights.iter_mut().for_each(|w| *w /= sum);
        let window = places.harmonics(&weights, 2 * order + 2)?;
        let sums = places.up_to(order)?;
        Ok(Self { times, sums, weights, length, order, window, nodes })
    }

    /// The transform of values under the window, whose weighted mean is taken away first, and that mean.
    pub(super) fn transform(&self, values: &[f64]) -> Result<(Vec<Complex<f64>>, f64)> {
        if values.len() != self.times.len() {
            let what = "values at the positions of a record";
            return Err(Error::Length { what, expected: self.times.len(), got: values.len() });
        }
        all_finite("values of a record", values)?;
        let mean: f64 = values.iter().zip(&self.weights).map(|(v, w)| v * w).sum();
        let weighted: Vec<f64> = values.iter().zip(&self.weights).map(|(v, w)| (v - mean) * w).collect();
        Ok((self.sums.of(&weighted)?, mean))
    }

    /// `nΣw²/(Σw)²`: how many bins of noise pass the window.
    pub(super) fn noise_bins(&self) -> f64 {
        self.weights.iter().map(|w| w * w).sum::<f64>() * self.weights.len() as f64
    }

    /// The sinusoid and constant that fit best at harmonic `m`, from the transforms of values and weights; `[a, b]` of
    /// `a cos + b sin`, and how much of the mean square it explains.
    pub(super) fn fitted(&self, m: usize, value: Complex<f64>) -> ([f64; 2], f64) {
        let (once, twice) = (self.window[m], self.window[2 * m]);
        // sums over the samples of products of cos, sin and one, each centred
        let (cos, sin) = (once.re, -once.im);
        let cos2 = 0.5 * (1.0 + twice.re) - cos * cos;
        let sin2 = 0.5 * (1.0 - twice.re) - sin * sin;
        let cross = -0.5 * twice.im - cos * sin;
        let (with_cos, with_sin) = (value.re, -value.im);
        let determinant = cos2 * sin2 - cross * cross;
        // at the Nyquist frequency of a grid the sine vanishes at all samples: only the cosine can be seen
        let [a, b] = if determinant > SINGULAR * (cos2 + sin2) * (cos2 + sin2) {
            [with_cos * sin2 - with_sin * cross, with_sin * cos2 - with_cos * cross].map(|v| v / determinant)
        } else if cos2 >= sin2 {
            [if cos2 > 0.0 { with_cos / cos2 } else { 0.0 }, 0.0]
        } else {
            [0.0, with_sin / sin2]
        };
        ([a, b], (a * with_cos + b * with_sin).max(0.0))
    }
}

/// The determinant of the equations of a sinusoid, as a part of the square of their trace (¼ where both are independent),
/// below which one of its components is not determined: noise would grow ten thousandfold.
const SINGULAR: f64 = 1e-8;
