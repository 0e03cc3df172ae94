//! Poisson summation: sampling replicates the spectrum (V03).

use crate::axis::Axis;
use crate::comb::Comb;
use crate::error::Result;
use crate::laws::Law;
use crate::residual::Residual;
use crate::sampled::dft::forward;
use crate::sampled::dtft::dtft;
use crate::sampled::{Bins, Samples};
use crate::signal::constant::Constant;
use crate::signal::gaussian::Gaussian;
use crate::signal::raised_cosine::RaisedCosine;
use crate::signal::theorem::Scaled;
use crate::signal::{FourierPair, Signal};
use crate::text::Text;

/// The error that rounding puts into a sum of `n` terms of total size `size`: `ε·n·size/2` at worst (Higham,
/// *Accuracy and Stability of Numerical Algorithms*, 2002, §4.2), and as much again for the rounding of each term.
pub fn sum_rounding(n: usize, size: f64) -> f64 {
    f64::EPSILON * n as f64 * size
}

/// `T Σ_k f(kT) e^{−2πiνkT} = Σ_k F(ν − k/T)`: the DTFT of the samples is the sum of the shifted copies.
///
/// Measured: the largest difference over `frequencies`, the left side summed over `|k| ≤ terms`, the right over
/// `|k| ≤ order`. Allowed: the rounding of the left sum; of the arguments, `νkT` on the left and `ν − k/T` on the right,
/// each to two or three roundings, `4ε·|ν|·2πT Σ|kT·f(kT)|` on both sides since `|F′| ≤ 2π∫|x·f|`; plus `tail`, the
/// caller's bound for what the two sums leave out (zero for a signal that has decayed below rounding at `terms·T`, and
/// whose copies end before `order/T`).
///
/// ```
/// use nyquist::laws::poisson::poisson_summation;
/// use nyquist::prelude::*;
/// let residual = poisson_summation(&Gaussian::with_spectrum(8.0)?, 1.0, 20, 4, &[0.0, 0.25, 0.5], 0.0)?;
/// assert!(residual.holds() && residual.measured < 1e-14);
/// # Ok::<(), Error>(())
/// ```
///
/// # Errors
/// A step that is not positive and finite.
pub fn poisson_summation(
    pair: &impl FourierPair,
    step: f64,
    terms: usize,
    order: usize,
    frequencies: &[f64],
    tail: f64,
) -> Result<Residual> {
    let samples = Samples::of(pair, Axis::centered(step, 2 * terms + 1)?);
    let copies = pair.spectrum().replicated(1.0 / step, order)?;
    let differences = frequencies.iter().map(|&nu| (dtft(&samples, nu) - copies.density(nu)).norm());
    let measured = differences.fold(0.0, f64::max);
    let size: f64 = step * samples.values().iter().map(|v| v.abs()).sum::<f64>();
    let farthest = frequencies.iter().fold(0.0, |far: f64, nu| far.max(nu.abs()));
    let moment: f64 = step * samples.points().map(|[x, v]| (x * v).abs()).sum::<f64>();
    let arguments = 4.0 * f64::EPSILON * farthest * 2.0 * std::f64::consts::PI * moment;
    let bound = sum_rounding(2 * terms + 1, size) + 2.0 * arguments + tail;
    Ok(Residual::at_most("Poisson summation: DTFT of the samples = sum of the copies", measured, bound))
}

/// The same copies a third way: the bins of a long record, `forward(samples)`, at their own frequencies.
///
/// Measured: the largest difference to the sum of copies over all bins. Allowed: the rounding of an FFT,
/// `ε·log₂n` relative to the spectrum's size `T Σ|f|` with a factor 8 for the real-input packing and the phases, plus
/// `tail`.
///
/// # Errors
/// A step that is not positive and finite.
pub fn copies_by_fft(pair: &impl FourierPair, axis: Axis, order: usize, tail: f64) -> Result<Residual> {
    let samples = Samples::of(pair, axis);
    let bins: Bins = forward(&samples);
    let copies = pair.spectrum().replicated(axis.rate(), order)?;
    let differences = bins.axis().iter().zip(bins.values()).map(|(nu, v)| (v - copies.density(nu)).norm());
    let measured = differences.fold(0.0, f64::max);
    let size: f64 = axis.step() * samples.values().iter().map(|v| v.abs()).sum::<f64>();
    let bound = 8.0 * f64::EPSILON * (axis.len() as f64).log2().max(1.0) * size + tail;
    Ok(Residual::at_most("FFT of a long record = sum of the copies", measured, bound))
}

/// `⟨Ш_T, φ⟩ = Σ_k φ̂(k/T)`: the comb's transform has lines of weight 1 at `k/T` (E02).
///
/// The pairing of the comb with a test function φ, `T Σ φ(iT)`, must equal the sum of `line_weight·φ̂(k/T)`. With the
/// right weight 1 it does for every `T`; with the printed `1/T` only for `T = 1`. Allowed: rounding of both sums.
///
/// # Errors
/// A step that is not positive and finite.
pub fn comb_pairing(test: &impl FourierPair, step: f64, terms: usize, line_weight: f64) -> Result<Residual> {
    let comb = Comb::new(step)?;
    let n = terms as i64;
    let left: f64 = comb.times(test, -n..=n).iter().map(|i| i.weight.re).sum();
    let spectrum = test.spectrum();
    let right: f64 = (-n..=n).map(|k| line_weight * spectrum.density(comb.line(k).at).re).sum();
    let bound = sum_rounding(2 * terms + 1, left.abs().max(right.abs()));
    Ok(Residual::near("⟨comb, φ⟩ = Σ weight·φ̂(k/T)", left, right, bound))
}

/// `T Σ_k f(kT) = Σ_k F(k/T)`, so the trapezoid rule gives `∫f = F(0)` exactly as soon as no copy reaches zero:
/// `1/T > B`, half the rate that reconstruction needs.
///
/// Measured: `|T Σ f(kT) − F(0)|`; allowed: rounding, plus `tail` for the terms left out.
///
/// # Errors
/// A step that is not positive and finite.
pub fn trapezoid_exact(pair: &impl FourierPair, step: f64, terms: usize, tail: f64) -> Result<Residual> {
    let comb = Comb::new(step)?;
    let n = terms as i64;
    let weights = comb.times(pair, -n..=n);
    let sum: f64 = weights.iter().map(|i| i.weight.re).sum();
    let size: f64 = weights.iter().map(|i| i.weight.norm()).sum();
    let bound = sum_rounding(2 * terms + 1, size) + tail;
    Ok(Residual::near("trapezoid rule = F(0)", sum, pair.spectrum().density(0.0).re, bound))
}

/// What the sum over `|k| > terms` of `T·RC(B)(kT)` can amount to: for `|2Bx| ≥ 2` the signal is at most
/// `4/(3π)·B·|2Bx|⁻³`, and the sum of `k⁻³` beyond `N` is below `1/(2N²)`, on both sides.
pub fn raised_cosine_tail(band: f64, step: f64, terms: usize) -> f64 {
    let u = 2.0 * band * step;
    step * band * 4.0 / (3.0 * std::f64::consts::PI) / u.powi(3) / (terms as f64).powi(2)
}

/// The laws of this theme.
pub static LAWS: &[Law] = &[
    Law {
        name: "poisson-summation",
        inventory: &["V03", "F19"],
        says: &Text::fixed(
            "The DTFT of the samples is the sum of the spectrum's copies: T·Σf(kT)e^{−i2πνkT} = ΣF(ν − k/T)",
            "ДВПФ отсчётов есть сумма копий спектра: T·Σf(kT)e^{−i2πνkT} = ΣF(ν − k/T)",
        ),
        holds: || {
            let frequencies: Vec<f64> = (0..=40).map(|i| f64::from(i) / 40.0 - 0.5).collect();
            let gaussian = |a| Gaussian::with_spectrum(a).expect("the decay is positive");
            let rc = RaisedCosine::new(0.5).expect("the band is positive");
            let record = Axis::centered(1.0, 128).expect("the record is finite");
            [
                poisson_summation(&gaussian(8.0), 1.0, 20, 4, &frequencies, 0.0),
                poisson_summation(&gaussian(50.0), 1.0, 40, 4, &frequencies, 0.0),
                poisson_summation(&rc, 1.0, 4000, 2, &frequencies, raised_cosine_tail(0.5, 1.0, 4000)),
                copies_by_fft(&gaussian(8.0), record, 4, 0.0),
            ]
            .map(|r| r.expect("the steps are positive"))
            .into()
        },
        breaks: || {
            // copies with gain 1/T instead of 1 (E03), and the neighbours left out
            let gaussian = Gaussian::with_spectrum(8.0).expect("the decay is positive");
            let literal = Scaled::new(2.0, gaussian).expect("the gain is finite");
            let samples = Samples::of(&gaussian, Axis::centered(0.5, 81).expect("the record is finite"));
            let copies = literal.spectrum().replicated(2.0, 4).expect("the rate is positive");
            let gain = (dtft(&samples, 0.0) - copies.density(0.0)).norm();
            vec![
                Residual::at_most("copies of gain 1/T", gain, sum_rounding(81, 1.0)),
                poisson_summation(&gaussian, 1.0, 20, 0, &[0.5], 0.0).expect("the step is positive"),
            ]
        },
    },
    Law {
        name: "comb-pairing",
        inventory: &["V03", "E02"],
        says: &Text::fixed(
            "The transform of Ш_T = TΣδ(x − iT) is Σδ(ν − k/T): lines of weight 1",
            "Преобразование Ш_T = TΣδ(x − iT) есть Σδ(ν − k/T): линии веса 1",
        ),
        holds: || {
            let test = Gaussian::new(0.6).expect("the width is positive");
            [0.5, 1.0, 1.7, 2.5].map(|t| comb_pairing(&test, t, 60, 1.0).expect("the step is positive")).into()
        },
        breaks: || {
            let test = Gaussian::new(0.6).expect("the width is positive");
            [0.5, 1.7, 2.5].map(|t| comb_pairing(&test, t, 60, 1.0 / t).expect("the step is positive")).into()
        },
    },
    Law {
        name: "trapezoid-exact",
        inventory: &["V03", "F14"],
        says: &Text::fixed(
            "The weights T·f(iT) add up to the integral F(0) as soon as 1/T > B",
            "Веса T·f(iT) в сумме дают интеграл F(0), как только 1/T > B",
        ),
        holds: || {
            let rc = RaisedCosine::new(1.0).expect("the band is positive");
            [0.3, 0.5, 0.9]
                .map(|t| trapezoid_exact(&rc, t, 4000, raised_cosine_tail(1.0, t, 4000)).expect("the step is positive"))
                .into()
        },
        breaks: || {
            let rc = RaisedCosine::new(1.0).expect("the band is positive");
            let tail = raised_cosine_tail(1.0, 1.3, 4000);
            let one = Constant::new(1.0).expect("the value is finite");
            vec![
                trapezoid_exact(&rc, 1.3, 4000, tail).expect("the step is positive"),
                // a constant has no density at zero: its sum grows with the record
                Residual::near("sum of a constant", 9.0 * one.at(0.0), one.spectrum().density(0.0).re, 1.0),
            ]
        },
    },
];
