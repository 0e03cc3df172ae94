//! What resizing an axis is: for every new position the old ones that it reads, and their weights.

use crate::axis::{Axis, Edge};
use crate::engine::resize;
use crate::error::{Error, Result};
use crate::kernel::Kernel;
use crate::num::{cos_pi, sin_pi};
use num_complex::Complex;

/// The weights of a resampling along one axis: `f̃(y_k) = Σ_i w_{ki} f(x_i)` with `Σ_i w_{ki} = 1`.
///
/// They are all there is to a resampling, so they also say what it does to a frequency: [`gain`](Self::gain).
#[derive(Debug, Clone, PartialEq)]
pub struct Weights {
    old: Axis,
    new: Axis,
    /// For every new position the first old index that it reads, which may lie outside, and the weights from there on.
    taps: Vec<(i64, Vec<f64>)>,
}

impl Weights {
    /// Those of a kernel, `k((y − x_i)/cT) / Σ k((y − x_i)/cT)`.
    ///
    /// Where the new step is longer than the old one `T`, `c` is their ratio: the kernel widens and becomes the prefilter
    /// of the new rate; otherwise it is 1. A kernel so narrow that no old position lies within its radius takes the nearest.
    ///
    /// # Errors
    /// A kernel of infinite radius; more than 2²⁸ weights (a step many times the old one).
    pub fn of(old: Axis, new: Axis, kernel: &dyn Kernel) -> Result<Self> {
        if kernel.radius().is_infinite() {
            let what = "a resampling with the ideal kernel, which needs every pixel: filter in frequency instead";
            return Err(Error::Unsupported(what));
        }
        let stretch = (new.step() / old.step()).max(1.0);
        let radius = kernel.radius() * stretch;
        let (value, most) = ((2.0 * radius + 1.0) * new.len() as f64, 268_435_456.0);
        // not a number counts as too many
        if !matches!(value.partial_cmp(&most), Some(std::cmp::Ordering::Less)) {
            return Err(Error::Overflow { what: "the number of weights of a resampling", value, most });
        }
        let of = |y: f64| {
            let at = place(old, y);
            let (first, last) = ((at - radius).ceil() as i64, (at + radius).floor() as i64);
            let read: Vec<f64> = (first..=last).map(|i| kernel.at((at - i as f64) / stretch)).collect();
            let sum: f64 = read.iter().sum();
            if sum == 0.0 { nearest(at) } else { (first, read.into_iter().map(|w| w / sum).collect()) }
        };
        Ok(Self { old, new, taps: new.iter().map(of).collect() })
    }

    /// Every new position takes the old one nearest to it: no filter at all. Half-way between two it takes the later one.
    ///
    /// With a step of a whole number of old ones this is decimation; otherwise the places read are up to half an old step
    /// off, and what comes of it is that of the box kernel, not widened.
    pub fn nearest(old: Axis, new: Axis) -> Self {
        Self { old, new, taps: new.iter().map(|y| nearest(place(old, y))).collect() }
    }

    /// The old positions.
    pub fn old(&self) -> Axis {
        self.old
    }

    /// The new positions.
    pub fn new_axis(&self) -> Axis {
        self.new
    }

    /// What is left of the amplitude of `e^{2πiνx}`, and by how much its phase is turned:
    /// `G_m(ν) = mean_k Σ_i w_{ki} e^{2πiν(x_i − y_k)} e^{−2πim(y_k − x_0)/T}`, for `m = 0` at the frequency `ν` itself.
    ///
    /// The resampled tone is `Σ_m G_m e^{2πi(ν + m/T)y}` up to a phase: the tone and its images, the copies of the old rate
    /// `1/T`, which the kernel should have removed. At a step of a whole number of old ones all images fall onto the same
    /// place, and `G_0` is the whole. Unlike the kernel's response `K(cν)` this counts that the kernel is sampled and that its
    /// weights are divided by their sum; the mean is over all new positions, as if nothing were cut at the ends.
    ///
    /// ```
    /// use nyquist::prelude::*;
    /// use nyquist::image::weights::Weights;
    /// // pairs of pixels: cos πν of a tone is left, and not the sinc(2ν) of the continuous box
    /// let (old, new) = (Axis::cells(0.0..8.0, 8)?, Axis::cells(0.0..8.0, 4)?);
    /// let gain = Weights::of(old, new, &BoxKernel)?.gain(0.25, 0);
    /// assert!((gain.re - 0.5f64.sqrt()).abs() < 1e-15 && gain.im.abs() < 1e-15);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn gain(&self, nu: f64, image: i64) -> Complex<f64> {
        let step = self.old.step();
        let one = turn(nu * step);
        let of = |(y, (first, weights)): (f64, &(i64, Vec<f64>))| -> Complex<f64> {
            let at = place(self.old, y);
            let mut wave = turn(nu * step * (*first as f64 - at));
            let mut sum = Complex::<f64>::ZERO;
            for &w in weights {
                sum += wave * w;
                wave *= one;
            }
            sum * turn(-(image as f64) * (at - at.floor()))
        };
        self.new.iter().zip(&self.taps).map(of).sum::<Complex<f64>>() / self.taps.len() as f64
    }

    /// The energy that is left of `e^{2πiνx}`, at its own frequency and at all images: `mean_k |Σ_i w_{ki} e^{2πiνx_i}|²`,
    /// which is `Σ_m |G_m|²`.
    ///
    /// ```
    /// use nyquist::prelude::*;
    /// use nyquist::image::weights::Weights;
    /// let (old, new) = (Axis::cells(0.0..8.0, 8)?, Axis::cells(0.0..8.0, 3)?);
    /// assert_eq!(Weights::nearest(old, new).power(0.3), 1.0); // nothing is lost, whatever it is taken for
    /// # Ok::<(), Error>(())
    /// ```
    pub fn power(&self, nu: f64) -> f64 {
        let one = turn(nu * self.old.step());
        let of = |(_, weights): &(i64, Vec<f64>)| -> f64 {
            let (mut wave, mut sum) = (Complex::ONE, Complex::<f64>::ZERO);
            for &w in weights {
                sum += wave * w;
                wave *= one;
            }
            sum.norm_sqr()
        };
        self.taps.iter().map(of).sum::<f64>() / self.taps.len() as f64
    }

    /// The same sums for the engine, [`Resizer`](resize::Resizer), with what lies outside from where `edge` says.
    ///
    /// # Errors
    /// More than [`Taps::MOST`](resize::Taps::MOST) positions, old or new.
    pub fn taps(&self, edge: Edge) -> Result<resize::Taps> {
        resize::Taps::new(self.old.len(), edge, self.taps.iter().map(|(first, weights)| (*first, weights.as_slice())))
    }

    /// The weights as they are used on a record that ends: what lies outside comes from where `edge` says.
    pub(super) fn within(&self, edge: Edge) -> Vec<Taps> {
        let n = self.old.len();
        let of = |(y, (first, weights)): (f64, &(i64, Vec<f64>))| {
            let inside = (*first..).zip(weights).filter_map(|(i, &w)| edge.index(i, n).map(|i| (i, w)));
            let read: Vec<(usize, f64)> = inside.filter(|(_, w)| *w != 0.0).collect();
            let whole = if edge == Edge::Zero { read.iter().map(|(_, w)| w).sum() } else { 1.0 };
            let base = (place(self.old, y).round() as i64).clamp(0, n as i64 - 1) as usize;
            Taps { base, whole, read }
        };
        self.new.iter().zip(&self.taps).map(of).collect()
    }
}

/// `e^{2πi·cycles}`.
fn turn(cycles: f64) -> Complex<f64> {
    Complex::new(cos_pi(2.0 * cycles), sin_pi(2.0 * cycles))
}

/// The index of a position among the old ones, whole or half where it is so but for the rounding of both axes, `4ε·n`: on
/// the edge of a box, and half-way between two pixels, rounding must not decide.
fn place(old: Axis, y: f64) -> f64 {
    let at = old.index_of(y);
    let half = 0.5 * (2.0 * at).round();
    let scale = at.abs() + old.len() as f64 + old.start().abs() / old.step();
    if (at - half).abs() <= 4.0 * f64::EPSILON * scale { half } else { at }
}

fn nearest(at: f64) -> (i64, Vec<f64>) {
    ((at + 0.5).floor() as i64, vec![1.0])
}

/// For one new position: `whole·f_base + Σ w_i (f_i − f_base)`, which is `Σ w_i f_i`.
///
/// Written so, a constant comes back as itself to the last bit: the differences are zero, and one times it is it.
pub(super) struct Taps {
    /// The old position that others are compared with.
    pub base: usize,
    /// The sum of all weights: one, unless some stand on nothing.
    pub whole: f64,
    /// Old positions and their weights.
    pub read: Vec<(usize, f64)>,
}
