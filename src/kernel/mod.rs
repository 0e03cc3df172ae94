//! Reconstruction kernels: what is put in place of every sample.
//!
//! One kernel, one file, and the file is its manual page: formula, parameters, when to use it, what artefacts it makes.
//! [`catalog`] knows them all by name, [`metrics`] says in numbers what they do to a signal.

pub mod box_kernel;
pub mod catalog;
pub mod cubic;
pub mod gaussian;
pub mod hamming;
pub mod ideal;
pub mod kaiser;
pub mod lanczos;
pub mod metrics;
pub mod pbrt_sinc;
pub mod regularised;
pub mod tent;
pub mod widened;
mod windowed;

use crate::signal::Signal;

/// The widest kernel that can be made, in sampling steps: wider ones would cost more than a Fourier transform.
pub const MOST_RADIUS: f64 = 4096.0;

/// What a kernel claims of itself. The laws check every claim, and every silence: what is not claimed must fail.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Claims {
    /// `k(0) = 1` and `k(i) = 0` at all other integers: the reconstruction passes through the samples.
    pub interpolating: bool,
    /// `∫ k = 1`: the mean is kept.
    pub unit_gain: bool,
    /// `Σ_i k(x − i) = 1` for every `x`: constants are reproduced without ripple.
    pub reproduces_constants: bool,
    /// `Σ_i i·k(x − i) = x`: straight lines are reproduced.
    pub reproduces_lines: bool,
    /// `k ≥ 0`: a reconstruction never leaves the range of its samples.
    pub nonnegative: bool,
}

/// A reconstruction kernel `k(t)`, written in units of the sampling step: `f̃(x) = Σ f(x_i) k((x − x_i)/T)`, so that the
/// lecture's filter is `r(x) = k(x/T)/T` with `∫ r = 1` (E06). Even: `k(−t) = k(t)`.
///
/// ```
/// use nyquist::prelude::*;
/// // a kernel of one's own: value, radius, claims and response; the laws check them
/// struct Parabola; // Welch's window, of unit area
/// impl Signal for Parabola {
///     fn at(&self, t: f64) -> f64 { if t.abs() < 1.0 { 0.75 * (1.0 - t * t) } else { 0.0 * t } }
/// }
/// impl Kernel for Parabola {
///     fn name(&self) -> String { "parabola".into() }
///     fn radius(&self) -> f64 { 1.0 }
///     fn claims(&self) -> Claims {
///         Claims { interpolating: false, unit_gain: true, reproduces_constants: false, reproduces_lines: false, nonnegative: true }
///     }
///     fn response(&self, nu: f64) -> f64 {
///         let p = 2.0 * std::f64::consts::PI * nu;
///         if p.abs() < 1e-2 { 1.0 - p * p / 10.0 } else { 3.0 * (p.sin() - p * p.cos()) / p.powi(3) }
///     }
/// }
/// let samples = Samples::of(&from_fn(|_| 1.0), Axis::nodes(0.0..8.0, 8)?);
/// let ripple = reconstruct(&samples, Parabola);
/// assert_eq!((ripple.at(4.0), ripple.at(4.5)), (0.75, 1.125)); // a constant comes back with ripple: none was claimed
/// # Ok::<(), Error>(())
/// ```
pub trait Kernel: Signal + Send + Sync {
    /// The field's name for it, as the command line takes it: `mitchell`, `lanczos-3`.
    fn name(&self) -> String;

    /// `k(t) = 0` for `|t| > radius`; infinite for the ideal kernel.
    fn radius(&self) -> f64;

    /// What it claims of itself.
    fn claims(&self) -> Claims;

    /// The transform `K(ν) = ∫ k(t) e^{−2πiνt} dt`, real because `k` is even, in cycles per sample.
    fn response(&self, nu: f64) -> f64;

    /// `Σ_j k(u − jn)`: the kernel repeated with period `n`, which is what every sample of a periodic record is replaced
    /// by. With `n = 1` it is the answer to a constant: one everywhere if constants are reproduced.
    ///
    /// A kernel of infinite radius must say it in closed form; this sum looks no farther than [`MOST_RADIUS`].
    fn periodic(&self, u: f64, n: usize) -> f64 {
        let (period, radius) = (n.max(1) as f64, self.radius().min(MOST_RADIUS));
        let u = u - period * (u / period).round(); // exact in f64 where |u| is within a factor two of a multiple
        let (first, last) = (((u - radius) / period).ceil() as i64, ((u + radius) / period).floor() as i64);
        if u.is_nan() { u } else { (first..=last).map(|j| self.at(u - j as f64 * period)).sum() }
    }

    /// `Σ_{i≥0} k(x − i)`: the answer to samples that are zero before index 0 and one from there on.
    ///
    /// A kernel of infinite radius must say it in closed form; this sum looks no farther than [`MOST_RADIUS`].
    fn step_response(&self, x: f64) -> f64 {
        let radius = self.radius().min(MOST_RADIUS);
        if x.is_nan() || x > radius + 1.0 {
            return self.periodic(x, 1);
        }
        let last = (x + radius).floor() as i64;
        (0..=last).map(|i| self.at(x - i as f64)).sum()
    }
}

/// A reference to a kernel and a boxed kernel are kernels too.
macro_rules! forward {
    ($of:ty) => {
        impl<K: Kernel + ?Sized> Kernel for $of {
            fn name(&self) -> String {
                (**self).name()
            }
            fn radius(&self) -> f64 {
                (**self).radius()
            }
            fn claims(&self) -> Claims {
                (**self).claims()
            }
            fn response(&self, nu: f64) -> f64 {
                (**self).response(nu)
            }
            fn periodic(&self, u: f64, n: usize) -> f64 {
                (**self).periodic(u, n)
            }
            fn step_response(&self, x: f64) -> f64 {
                (**self).step_response(x)
            }
        }
    };
}
forward!(&K);
forward!(Box<K>);
