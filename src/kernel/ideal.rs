//! The ideal kernel: the sinc, whose response is the box that cuts out one copy of the spectrum.
//!
//! | | |
//! | --- | --- |
//! | formula | `k(t) = sinc(t)` |
//! | response | `K(ν) = 1` for `\|ν\| < ½`, `½` at Nyquist itself (E05), `0` beyond |
//! | parameters | none |
//! | use it | as the theorem: exact for band-limited signals; in practice for periodic records, where the infinite sum has a closed form (Dirichlet's kernel) |
//! | artefacts | needs all samples: cut off after `N` its error falls like `1/N` only; a sampled step rings and overshoots by 14.1 % (not Gibbs's 8.9 %, E15) |
//! | source | Whittaker 1915, Kotelnikov 1933, Shannon 1949; slides «Реконструкция функции в пространственной области», «Идеальная реконструкция – проблемы» |
//!
//! Its sums over infinitely many samples are meant symmetrically, `lim Σ_{|i| ≤ N}`: they do not converge absolutely.

use crate::kernel::{Claims, Kernel};
use crate::num::special::stirling_beta;
use crate::num::{cos_pi, sin_pi, sinc};
use crate::signal::Signal;
use crate::spectrum::low_pass;
use std::f64::consts::PI;

/// The sinc; see the [page](self).
///
/// ```
/// use nyquist::prelude::*;
/// // a periodic record below Nyquist comes back exactly: Dirichlet's kernel is the sinc, repeated
/// let tone = from_fn(|x| (2.0 * std::f64::consts::PI * 2.0 * x).cos());
/// let samples = Samples::of(&tone, Axis::nodes(0.0..1.0, 5)?);
/// let back = reconstruct(&samples, Ideal).edge(Edge::Wrap);
/// assert!((back.at(0.123) - tone.at(0.123)).abs() < 1e-14);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Ideal;

impl Signal for Ideal {
    fn at(&self, t: f64) -> f64 {
        if t.is_infinite() { 0.0 } else { sinc(t) }
    }
}

impl Kernel for Ideal {
    fn name(&self) -> String {
        "ideal".into()
    }
    fn radius(&self) -> f64 {
        f64::INFINITY
    }
    /// Lines are not reproduced: `Σ i·sinc(x−i)` does not converge.
    fn claims(&self) -> Claims {
        Claims {
            interpolating: true,
            unit_gain: true,
            reproduces_constants: true,
            reproduces_lines: false,
            nonnegative: false,
        }
    }
    fn response(&self, nu: f64) -> f64 {
        if nu.is_nan() { nu } else { low_pass(nu, 0.5) }
    }
    /// Dirichlet's kernel: `sin(πu)/(n·sin(πu/n))` for odd `n`, `sin(πu)/(n·tan(πu/n))` for even `n`. The even one lets
    /// the tone at Nyquist through with half of its two lines each, so that a cosine comes back with the gain `cos φ`
    /// (E05).
    fn periodic(&self, u: f64, n: usize) -> f64 {
        let n = n.max(1);
        let period = n as f64;
        let u = u - period * (u / period).round();
        let slow = sin_pi(u / period);
        // below 1e-8 of a step the kernel is 1 − (πu)²/6 at least
        match u.abs() < 1e-8 {
            true => 1.0,
            false if n.is_multiple_of(2) => sin_pi(u) * cos_pi(u / period) / (period * slow),
            false => sin_pi(u) / (period * slow),
        }
    }
    /// `1 + sin(πx)/π·β(1+x)` with Stirling's beta function; equally
    /// `−(sin πx/2π)·[ψ((1−x)/2) − ψ(−x/2)]`, and from `x = −½` down by the symmetry `s(x) = 1 − s(−1−x)`.
    fn step_response(&self, x: f64) -> f64 {
        if x < -0.5 { 1.0 - self.step_response(-1.0 - x) } else { 1.0 + sin_pi(x) / PI * stirling_beta(1.0 + x) }
    }
}
