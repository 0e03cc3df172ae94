//! Reconstruction kernels: what is put in place of every sample.

use crate::signal::Signal;

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
pub trait Kernel: Signal + Send + Sync {
    /// The field's name for it, as the command line takes it: `mitchell`, `lanczos-3`.
    fn name(&self) -> String;

    /// `k(t) = 0` for `|t| > radius`; infinite for the ideal kernel.
    fn radius(&self) -> f64;

    /// What it claims of itself.
    fn claims(&self) -> Claims;

    /// The transform `K(ν) = ∫ k(t) e^{−2πiνt} dt`, real because `k` is even, in cycles per sample.
    fn response(&self, nu: f64) -> f64;
}

impl<K: Kernel + ?Sized> Kernel for &K {
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
}

impl<K: Kernel + ?Sized> Kernel for Box<K> {
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
}
