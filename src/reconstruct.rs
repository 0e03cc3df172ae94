//! From samples back to a signal: the lower arrow of the square.

use crate::axis::{Axis, Edge};
use crate::kernel::Kernel;
use crate::sampled::Samples;
use crate::signal::Signal;

/// The reconstruction `f̃(x) = Σ_i f(x_i) k((x − x_i)/T)`: samples and a kernel, again a [`Signal`].
///
/// A value costs `2·radius` evaluations of a kernel of finite radius, and the whole record for the ideal one. Beyond its
/// ends the record goes on as its [`Edge`] says. It is a value for every finite `x`, and NaN for any other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reconstruction<'a, K> {
    samples: &'a Samples,
    kernel: K,
    edge: Edge,
}

/// The reconstruction of `samples` by `kernel`, with nothing beyond the record's ends ([`Edge::Zero`]).
///
/// The weights are not divided by their sum: a kernel that does not claim to reproduce constants ripples, and it shows.
///
/// The lecture writes `f̃ = T Σ f(iT) r(x − iT)` (slide «Реконструированная функция»); with `r(x) = k(x/T)/T` the factor
/// `T` cancels.
///
/// ```
/// use nyquist::prelude::*;
/// // the square closes: f(x) = (3/2)·sinc²(3x/2) has nothing above 1.5, and comes back from samples at the rate 4
/// let f = from_fn(|x| 1.5 * nyquist::num::sinc(1.5 * x).powi(2));
/// let samples = Samples::of(&f, Axis::centered(0.25, 2001)?);
/// let back = reconstruct(&samples, Ideal);
/// let tail = 1.5 / (1.5f64 * std::f64::consts::PI * 250.0).powi(2); // |f| beyond the record
/// assert!((back.at(0.3) - f.at(0.3)).abs() < tail);
/// # Ok::<(), Error>(())
/// ```
pub fn reconstruct<K: Kernel>(samples: &Samples, kernel: K) -> Reconstruction<'_, K> {
    Reconstruction { samples, kernel, edge: Edge::Zero }
}

impl<'a, K: Kernel> Reconstruction<'a, K> {
    /// The same, with the record continued as `edge` says.
    ///
    /// With the ideal kernel all four are exact sums over infinitely many samples, in the symmetric sense: `Wrap` by
    /// Dirichlet's kernel (exact for periodic signals below Nyquist), `Mirror` as the wrap of the record followed by its
    /// reflection, `Clamp` by the closed form of a constant tail.
    ///
    /// ```
    /// use nyquist::prelude::*;
    /// let samples = Samples::new(Axis::new(0.0, 1.0, 2)?, vec![1.0, 3.0])?;
    /// let at_minus_half = Edge::ALL.map(|edge| reconstruct(&samples, TentKernel).edge(edge).at(-0.5));
    /// assert_eq!(at_minus_half, [0.5, 1.0, 2.0, 1.0]); // zero, clamp, wrap, mirror
    /// # Ok::<(), Error>(())
    /// ```
    #[must_use]
    pub fn edge(self, edge: Edge) -> Self {
        Self { edge, ..self }
    }

    /// The samples.
    pub fn samples(&self) -> &'a Samples {
        self.samples
    }

    /// The kernel.
    pub fn kernel(&self) -> &K {
        &self.kernel
    }

    /// The weights `k((x − x_i)/T)` of the samples of the record itself, as (index, weight), without those beyond its ends:
    /// what a figure draws as scaled kernels.
    pub fn weights(&self, x: f64) -> impl Iterator<Item = (usize, f64)> + '_ {
        let u = self.samples.axis().index_of(x);
        let (first, last) = self.reach(u);
        let (first, last) = (first.max(0), last.min(self.samples.axis().len() as i64 - 1));
        (first..=last).map(move |i| (i as usize, self.kernel.at(u - i as f64)))
    }

    /// Resampled: the values at the positions of `axis`.
    ///
    /// ```
    /// use nyquist::prelude::*;
    /// let samples = Samples::new(Axis::new(0.0, 1.0, 3)?, vec![0.0, 1.0, 4.0])?;
    /// let finer = reconstruct(&samples, TentKernel).onto(Axis::new(0.0, 0.5, 5)?);
    /// assert_eq!(finer.values(), [0.0, 0.5, 1.0, 2.5, 4.0]);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn onto(&self, axis: Axis) -> Samples {
        Samples::of(self, axis)
    }

    /// The indices `i` with `|u − i| ≤ radius`; all of the record for an infinite radius.
    fn reach(&self, u: f64) -> (i64, i64) {
        let radius = self.kernel.radius();
        match radius.is_finite() {
            true => ((u - radius).ceil() as i64, (u + radius).floor() as i64),
            false => (0, self.samples.axis().len() as i64 - 1),
        }
    }

    /// The sum over the samples within the radius.
    fn near(&self, u: f64) -> f64 {
        let values = self.samples.values();
        let value = |i: i64| self.edge.index(i, values.len()).map_or(0.0, |j| values[j]);
        let (first, last) = self.reach(u);
        (first..=last).map(|i| value(i) * self.kernel.at(u - i as f64)).sum()
    }

    /// The sum over infinitely many samples, in closed form beyond the record.
    fn everywhere(&self, u: f64) -> f64 {
        let values = self.samples.values();
        let (n, last) = (values.len(), values.len() - 1);
        let each =
            |weight: &dyn Fn(f64) -> f64| -> f64 { values.iter().enumerate().map(|(i, v)| v * weight(i as f64)).sum() };
        match self.edge {
            Edge::Zero => each(&|i| self.kernel.at(u - i)),
            Edge::Clamp => {
                let before = values[0] * self.kernel.step_response(-1.0 - u);
                let after = values[last] * self.kernel.step_response(u - n as f64);
                each(&|i| self.kernel.at(u - i)) + before + after
            }
            Edge::Wrap => each(&|i| self.kernel.periodic(u - i, n)),
            Edge::Mirror => {
                let reflected = |i: f64| (2 * n - 1) as f64 - i;
                each(&|i| self.kernel.periodic(u - i, 2 * n) + self.kernel.periodic(u - reflected(i), 2 * n))
            }
        }
    }
}

impl<K: Kernel> Signal for Reconstruction<'_, K> {
    fn at(&self, x: f64) -> f64 {
        let u = self.samples.axis().index_of(x);
        match u.is_finite() {
            false => f64::NAN,
            true if self.kernel.radius().is_finite() => self.near(u),
            true => self.everywhere(u),
        }
    }
}
