//! From samples back to a signal: the lower arrow of the square.

use crate::axis::{Axis, Edge};
use crate::kernel::Kernel;
use crate::sampled::Samples;
use crate::sampled::dtft::dtft;
use crate::signal::Signal;
use num_complex::Complex;

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
        let place = Place::of(x, self.samples.axis());
        let (first, last) = self.reach(place);
        let (first, last) = (first.max(0), last.min(self.samples.axis().len() as i64 - 1));
        (first..=last).map(move |i| (i as usize, self.kernel.at(place.minus(i))))
    }

    /// The transform of the reconstruction, `F̃(ν) = K(νT)·T Σ f(x_i) e^{−2πiνx_i}`: the copies that sampling made, through
    /// the kernel's low-pass. It is that of the record with nothing beyond its ends, whatever the edge.
    ///
    /// ```
    /// use nyquist::prelude::*;
    /// // sample and hold: the image of a tone at 0.1 stands at 0.9 with a ninth of its height
    /// let samples = Samples::of(&Cosine::new(0.1)?, Axis::nodes(0.0..100.0, 100)?);
    /// let held = reconstruct(&samples, BoxKernel);
    /// assert!((held.spectrum_at(0.9).norm() / held.spectrum_at(0.1).norm() - 1.0 / 9.0).abs() < 1e-13);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn spectrum_at(&self, nu: f64) -> Complex<f64> {
        dtft(self.samples, nu) * self.kernel.response(nu * self.samples.axis().step())
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
    fn reach(&self, place: Place) -> (i64, i64) {
        let radius = self.kernel.radius();
        let from_nearest = |distance: f64| place.nearest.saturating_add(distance as i64);
        match radius.is_finite() {
            true => (from_nearest((place.rest - radius).ceil()), from_nearest((place.rest + radius).floor())),
            false => (0, self.samples.axis().len() as i64 - 1),
        }
    }

    /// The sum over the samples within the radius.
    fn near(&self, place: Place) -> f64 {
        let values = self.samples.values();
        let value = |i: i64| self.edge.index(i, values.len()).map_or(0.0, |j| values[j]);
        let (first, last) = self.reach(place);
        (first..=last).map(|i| value(i) * self.kernel.at(place.minus(i))).sum()
    }

    /// The sum over infinitely many samples, in closed form beyond the record.
    fn everywhere(&self, place: Place) -> f64 {
        let (values, kernel) = (self.samples.values(), &self.kernel);
        let n = values.len();
        let (first, last) = (0, n as i64 - 1);
        let each =
            |weight: &dyn Fn(i64) -> f64| -> f64 { values.iter().enumerate().map(|(i, v)| v * weight(i as i64)).sum() };
        match self.edge {
            Edge::Zero => each(&|i| kernel.at(place.minus(i))),
            Edge::Clamp => {
                let before = values[0] * kernel.step_response(-place.minus(first - 1));
                let after = values[n - 1] * kernel.step_response(place.minus(last + 1));
                each(&|i| kernel.at(place.minus(i))) + before + after
            }
            Edge::Wrap => each(&|i| kernel.periodic(place.minus(i), n)),
            Edge::Mirror => each(&|i| {
                let reflected = 2 * last + 1 - i;
                kernel.periodic(place.minus(i), 2 * n) + kernel.periodic(place.minus(reflected), 2 * n)
            }),
        }
    }
}

/// A place between samples: the index of the nearest one, and the distance from it in steps.
///
/// Far from the start of a record `(x − start)/T` has lost the digits that matter; the distance from the nearest sample has
/// not, and is exactly zero on a sample.
#[derive(Clone, Copy)]
struct Place {
    nearest: i64,
    rest: f64,
}

impl Place {
    fn of(x: f64, axis: Axis) -> Self {
        let nearest = axis.index_of(x).round() as i64;
        Self { nearest, rest: (x - axis.at(nearest)) / axis.step() }
    }

    /// The distance to sample `i` in steps, `u − i`.
    fn minus(self, i: i64) -> f64 {
        self.nearest.saturating_sub(i) as f64 + self.rest
    }
}

impl<K: Kernel> Signal for Reconstruction<'_, K> {
    fn at(&self, x: f64) -> f64 {
        let place = Place::of(x, self.samples.axis());
        match place.rest.is_finite() {
            false => f64::NAN,
            true if self.kernel.radius().is_finite() => self.near(place),
            true => self.everywhere(place),
        }
    }
}
