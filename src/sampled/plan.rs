//! Plans of Fourier transforms: the only place that knows rustfft.

use crate::num::{cos_pi, sin_pi};
use num_complex::Complex;
use rustfft::{Fft, FftDirection, FftPlannerScalar};
use std::sync::Arc;

/// A complex transform of one length, the plain sum in either direction, not divided by anything.
///
/// Plans are scalar: with AVX, NEON or neither the last bits would differ.
pub(crate) struct Plan(Arc<dyn Fft<f64>>);

impl Plan {
    /// `X_k = Σ_j x_j e^{−2πijk/n}`.
    pub(crate) fn forward(n: usize) -> Self {
        Self(FftPlannerScalar::new().plan_fft(n, FftDirection::Forward))
    }

    /// `x_j = Σ_k X_k e^{+2πijk/n}`.
    pub(crate) fn inverse(n: usize) -> Self {
        Self(FftPlannerScalar::new().plan_fft(n, FftDirection::Inverse))
    }

    /// Transforms the values in place; as many records as there are, one after another.
    pub(crate) fn run(&self, values: &mut [Complex<f64>]) {
        self.0.process(values);
    }
}

/// A transform between `n` real values and the `n/2 + 1` values of their spectrum that its symmetry does not repeat.
///
/// An even number of real values is as many complex numbers as half of it, `z_j = x_{2j} + i·x_{2j+1}`, whose transform
/// holds those of the even and the odd samples as its Hermitian and anti-Hermitian parts (Sorensen et al. 1987).
pub(crate) struct RealPlan {
    n: usize,
    plan: Plan,
    /// `e^{−2πik/n}` for `k ≤ n/2`; empty for odd `n`.
    turns: Vec<Complex<f64>>,
}

impl RealPlan {
    /// For [`transform`](Self::transform).
    pub(crate) fn forward(n: usize) -> Self {
        Self::new(n, Plan::forward)
    }

    /// For [`restore`](Self::restore).
    pub(crate) fn inverse(n: usize) -> Self {
        Self::new(n, Plan::inverse)
    }

    fn new(n: usize, plan: fn(usize) -> Plan) -> Self {
        if n % 2 == 1 {
            return Self { n, plan: plan(n), turns: Vec::new() };
        }
        let turn = |k: usize| {
            let angle = 2.0 * k as f64 / n as f64;
            Complex::new(cos_pi(angle), -sin_pi(angle))
        };
        Self { n, plan: plan(n / 2), turns: (0..=n / 2).map(turn).collect() }
    }

    /// `X_k` for `0 ≤ k ≤ n/2` into `half`; `work` is room that is used again.
    pub(crate) fn transform(&self, values: &[f64], half: &mut [Complex<f64>], work: &mut Vec<Complex<f64>>) {
        debug_assert!(values.len() == self.n && half.len() == self.n / 2 + 1);
        work.clear();
        if self.n % 2 == 1 {
            work.extend(values.iter().map(|&v| Complex::from(v)));
            self.plan.run(work);
            half.copy_from_slice(&work[..half.len()]);
            return;
        }
        let middle = self.n / 2;
        work.extend(values.chunks_exact(2).map(|p| Complex::new(p[0], p[1])));
        self.plan.run(work);
        for (k, (value, turn)) in half.iter_mut().zip(&self.turns).enumerate() {
            let (z, mirrored) = (work[k % middle], work[(middle - k) % middle].conj());
            let even = 0.5 * (z + mirrored);
            let odd = Complex::new(0.0, -0.5) * (z - mirrored);
            *value = even + turn * odd;
        }
    }

    /// `x_j = Σ_k X_k e^{+2πijk/n}` over all `n` frequencies, of which `half` has those up to `n/2`; the imaginary parts
    /// at zero and, for even `n`, at `n/2`, which no real signal has, are not looked at.
    pub(crate) fn restore(&self, half: &[Complex<f64>], values: &mut [f64], work: &mut Vec<Complex<f64>>) {
        debug_assert!(values.len() == self.n && half.len() == self.n / 2 + 1);
        let real_ends = |k: usize| if k == 0 || 2 * k == self.n { half[k].re.into() } else { half[k] };
        work.clear();
        if self.n % 2 == 1 {
            work.extend((0..half.len()).map(real_ends));
            work.extend((1..half.len()).rev().map(|k| half[k].conj()));
            self.plan.run(work);
            values.iter_mut().zip(work.iter()).for_each(|(v, z)| *v = z.re);
            return;
        }
        let middle = self.n / 2;
        work.extend((0..middle).map(|k| {
            let (z, mirrored) = (real_ends(k), real_ends(middle - k).conj());
            let (even, odd) = (z + mirrored, self.turns[k].conj() * (z - mirrored));
            even + Complex::new(-odd.im, odd.re)
        }));
        self.plan.run(work);
        for (pair, z) in values.chunks_exact_mut(2).zip(work.iter()) {
            (pair[0], pair[1]) = (z.re, z.im);
        }
    }
}

/// The least even length from `n` on whose only prime factors are 2, 3 and 5: transforms of it are fast, and those of
/// real values cost half.
pub(crate) fn fast_length(n: usize) -> usize {
    let smooth = |mut m: usize| {
        for p in [2, 3, 5] {
            while m.is_multiple_of(p) {
                m /= p;
            }
        }
        m == 1
    };
    let mut even = n.max(2).next_multiple_of(2);
    while !smooth(even) {
        even += 2;
    }
    even
}
