//! The cardinal series cut off: how much the samples left out can do (V09).

use crate::axis::Axis;
use crate::kernel::ideal::Ideal;
use crate::kernel::regularised::Regularised;
use crate::laws::Law;
use crate::laws::poisson::sum_rounding;
use crate::num::faddeeva::faddeeva;
use crate::num::quadrature::{even_breaks, integrate_pieces};
use crate::num::special::si;
use crate::num::{cos_pi, sin_pi, sinc};
use crate::reconstruct::reconstruct;
use crate::residual::Residual;
use crate::sampled::Samples;
use crate::signal::sinc::SincSquared;
use crate::signal::tone::Cosine;
use crate::signal::{FourierPair, Signal};
use crate::text::Text;
use num_complex::Complex;
use std::f64::consts::{FRAC_1_SQRT_2, PI};

/// The samples `f(k)`, `|k| ≤ terms`, one apart.
fn record(signal: &impl Signal, terms: usize) -> Samples {
    let axis = Axis::centered(1.0, 2 * terms + 1).expect("a centred record of odd length is finite");
    Samples::of(signal, axis)
}

/// The largest ratio of an error to what is allowed for it: at most one.
fn worst_ratio(law: String, signal: &impl Signal, kept: &Samples, allowed: impl Fn(f64) -> f64, x: &[f64]) -> Residual {
    let back = reconstruct(kept, Ideal);
    let size: f64 = kept.values().iter().map(|v| v.abs()).sum();
    // every sinc is wrong by 2ε, and so is the tone itself
    let rounding = sum_rounding(4, size);
    let ratio = |&x: &f64| (back.at(x) - signal.at(x)).abs() / (allowed(x) + rounding);
    Residual::at_most(law, x.iter().map(ratio).fold(0.0, f64::max), 1.0)
}

/// V09a: for a signal of finite energy below Nyquist, sampled one apart, the series of `|k| ≤ N` errs at `|x| < N` by at most
/// `(|sin πx|/π)·√(1/(N−|x|) + 1/(N+|x|))·√(Σ_{|k|>N} f(k)²)`.
///
/// Cauchy–Schwarz on the terms left out: `sinc²(x−k) = sin²πx/(π(x−k))²`, and `Σ_{k>N} (k−x)⁻² < 1/(N−x)`. The energy of the
/// samples left out is `∫|F|² − Σ_{|k|≤N} f(k)²` (Parseval for the orthonormal `sinc(x−k)`).
///
/// Measured: the largest ratio of error to bound over the places `x`; one is allowed, with the rounding of the sum.
///
/// ```
/// use nyquist::laws::truncation::truncated_energy;
/// use nyquist::prelude::*;
/// assert!(truncated_energy(&SincSquared::new(0.5)?, 8, &[0.5, 3.3, 7.2]).holds());
/// # Ok::<(), Error>(())
/// ```
pub fn truncated_energy(pair: &impl FourierPair, terms: usize, x: &[f64]) -> Residual {
    let kept = record(pair, terms);
    let spectrum = pair.spectrum();
    let whole = spectrum.energy(-spectrum.extent(), spectrum.extent());
    let inside: f64 = kept.values().iter().map(|v| v * v).sum();
    let beyond = (whole - inside).max(0.0) + 64.0 * f64::EPSILON * whole;
    let n = terms as f64;
    let allowed = |x: f64| sin_pi(x).abs() / PI * (1.0 / (n - x.abs()) + 1.0 / (n + x.abs())).sqrt() * beyond.sqrt();
    worst_ratio(format!("energy bound, N = {terms}"), pair, &kept, allowed, x)
}

/// V09b: for a tone at `ν < ½`, of any phase, the error is at most
/// `|sin πx|/(π·cos πν)·[1/(N+1−|x|) + 1/(N+1+|x|)]`: it blows up towards Nyquist, hence guard bands.
///
/// Abel summation: the partial sums of `(−1)ᵏ cos(2πνk + φ)` are below `1/cos πν`, the factors `1/(k∓x)` fall
/// monotonically (cf. Helms & Thomas 1962).
///
/// Measured: the largest ratio of error to bound over the places; one is allowed, with the rounding of the sum.
///
/// # Errors
/// A frequency that is not positive and finite.
pub fn truncated_tone(nu: f64, phase: f64, terms: usize, x: &[f64]) -> crate::error::Result<Residual> {
    let tone = Cosine::with_phase(nu, phase)?;
    let n = terms as f64 + 1.0;
    let allowed = |x: f64| sin_pi(x).abs() / (PI * cos_pi(nu).abs()) * (1.0 / (n - x.abs()) + 1.0 / (n + x.abs()));
    let law = format!("tone at {nu}, N = {terms}");
    Ok(worst_ratio(law, &tone, &record(&tone, terms), allowed, x))
}

/// `erfc(y)` for `y ≥ 0`.
fn erfc(y: f64) -> f64 {
    (-y * y).exp() * faddeeva(Complex::new(0.0, y)).re
}

/// V09c: the Gaussian-regularised series of radius `n` with `s² = n/(π(1−r))` errs by less than `e^{−π(1−r)n/2}` for signals
/// of the band `r/2` (Qian 2003).
///
/// For a tone at `ν ≤ r/2` of amplitude one: the whole Gaussian's response `K(ν) = ½[erf a₊ + erf a₋]`, `a± = √2πs(½±ν)`, is
/// positive and its copies add up to `k(0) = 1`, so that damping and images err by at most `2(1−K(ν)) = erfc a₊ + erfc a₋`;
/// cutting it off at `n` adds at most `(2/πn)·e^{−n²/2s²}/(1 − e^{−n/s²})`. Both exponents are `−π(1−r)n/2` for the chosen
/// `s`. Measured: the largest error over the places; allowed: that sum, and the rounding of `2n` terms.
///
/// ```
/// use nyquist::laws::truncation::regularised_tone;
/// let sixteen = regularised_tone(16.0, 0.5, 0.25, &[0.3, 0.5])?;
/// assert!(sixteen.holds() && sixteen.bound < (-std::f64::consts::PI * 0.5 * 16.0 / 2.0).exp());
/// # Ok::<(), nyquist::error::Error>(())
/// ```
///
/// # Errors
/// As [`Regularised::for_band`]; a frequency that is not positive and finite.
pub fn regularised_tone(n: f64, band: f64, nu: f64, x: &[f64]) -> crate::error::Result<Residual> {
    let kernel = Regularised::for_band(n, band)?;
    let tone = Cosine::with_phase(nu, 0.7)?;
    let reach = x.iter().fold(0.0f64, |reach, x| reach.max(x.abs()));
    let samples = record(&tone, (n + reach).ceil() as usize + 1);
    let back = reconstruct(&samples, kernel);
    let measured = x.iter().map(|&x| (back.at(x) - tone.at(x)).abs()).fold(0.0, f64::max);
    let s = kernel.width();
    let edge = |sign: f64| erfc((2f64.sqrt() * PI * s * (0.5 + sign * 0.5 * band)).max(0.0));
    let cut = 2.0 / (PI * n) * (-0.5 * (n / s).powi(2)).exp() / (1.0 - (-n / (s * s)).exp());
    let bound = edge(1.0) + edge(-1.0) + cut + sum_rounding(8, 4.0 + n.ln());
    Ok(Residual::at_most(format!("regularised, n = {n}, tone at {nu}"), measured, bound))
}

/// F24: the energy of the sinc outside `|x| ≤ N`, for whole `N`: `1 − (2/π)·Si(2πN) ≈ 1/(π²N)`.
///
/// By parts, `∫₀^N sinc² = Si(2πN)/π`. Measured: its distance from `1/(π²N)`, by quadrature of the inside. Allowed: the next
/// term of the asymptotic series, `2/(2πN)²` of it (the series of Si envelops, DLMF 6.12), and the quadrature's error.
pub fn sinc_energy_beyond(n: u32) -> [Residual; 2] {
    let reach = f64::from(n);
    let inside = integrate_pieces(|x| sinc(x).powi(2), &even_breaks(0.0, reach, 0.5), 1e-15);
    let beyond = 1.0 - 2.0 * inside.value;
    let rough = 1.0 / (PI * PI * reach);
    let next = rough * 2.0 / (2.0 * PI * reach).powi(2);
    let exact = 1.0 - 2.0 / PI * si(2.0 * PI * reach);
    [
        Residual::near(format!("energy beyond {n} = 1 − (2/π)Si(2π{n})"), beyond, exact, 2.0 * inside.error + 1e-15),
        Residual::near(format!("energy beyond {n} ≈ 1/(π²{n})"), beyond, rough, next + 2.0 * inside.error),
    ]
}

/// Places within `|x| < n/2` and beyond it, symmetric places among them.
fn places(n: usize) -> Vec<f64> {
    (0..=40).map(|i| (f64::from(i) / 40.0 - 0.5) * 1.9 * n as f64 * FRAC_1_SQRT_2).collect()
}

fn tone(nu: f64, terms: usize) -> Residual {
    truncated_tone(nu, 0.7, terms, &places(terms)).expect("the frequency is positive")
}

/// The laws of this theme.
pub static LAWS: &[Law] = &[
    Law {
        name: "truncation-energy",
        inventory: &["V09", "F24"],
        says: &Text::fixed(
            "A cardinal series cut off after N terms errs by no more than the energy of the samples left out allows",
            "Ошибка обрезанного ряда Котельникова не больше, чем позволяет энергия отброшенных отсчётов",
        ),
        holds: || {
            let f = SincSquared::new(0.45).expect("the band is positive");
            let mut measured: Vec<Residual> = [4, 8, 32, 128].map(|n| truncated_energy(&f, n, &places(n))).into();
            measured.extend([1, 2, 8].into_iter().flat_map(sinc_energy_beyond));
            measured
        },
        breaks: || {
            // the bound knows nothing of aliasing: a signal above Nyquist exceeds it
            let f = SincSquared::new(0.9).expect("the band is positive");
            [8, 32].map(|n| truncated_energy(&f, n, &places(n))).into()
        },
    },
    Law {
        name: "truncation-tone",
        inventory: &["V09"],
        says: &Text::fixed(
            "For a tone below Nyquist the series errs by at most |sin πx|/(π·cos πν)·[1/(N+1−|x|) + 1/(N+1+|x|)]",
            "Для тона ниже частоты Найквиста ошибка не больше |sin πx|/(π·cos πν)·[1/(N+1−|x|) + 1/(N+1+|x|)]",
        ),
        holds: || {
            let each = |nu| [8, 32, 128].map(|n| tone(nu, n));
            [0.1, 0.3, 0.45, 0.49].into_iter().flat_map(each).collect()
        },
        breaks: || [0.6, 0.9].into_iter().flat_map(|nu| [32, 128].map(|n| tone(nu, n))).collect(),
    },
    Law {
        name: "regularised-series",
        inventory: &["V09"],
        says: &Text::fixed(
            "Under a Gaussian the series of an oversampled signal converges exponentially: error below e^{−π(1−r)n/2}",
            "С гауссовым множителем ряд передискретизованного сигнала сходится экспоненциально: ошибка < e^{−π(1−r)n/2}",
        ),
        holds: || {
            let x: Vec<f64> = (0..=20).map(|i| f64::from(i) / 20.0).collect();
            let each = |n| [0.05, 0.2, 0.25].map(|nu| regularised_tone(n, 0.5, nu, &x).expect("r < 1"));
            [8.0, 16.0, 24.0].into_iter().flat_map(each).collect()
        },
        breaks: || {
            let x: Vec<f64> = (0..=20).map(|i| f64::from(i) / 20.0).collect();
            // tones above the band that the width was chosen for
            [0.4, 0.48].map(|nu| regularised_tone(16.0, 0.5, nu, &x).expect("r < 1")).into()
        },
    },
];
