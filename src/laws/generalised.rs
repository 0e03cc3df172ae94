//! Sampling that is neither uniform nor of a low band: values with slopes, pairs, pass bands (V22, V23).

use crate::axis::Axis;
use crate::beyond::bandpass::BandPass;
use crate::beyond::derivative::DerivativeSamples;
use crate::beyond::interlaced::Interlaced;
use crate::error::Result;
use crate::laws::Law;
use crate::num::sin_pi;
use crate::residual::Residual;
use crate::sampled::Samples;
use crate::signal::raised_cosine::RaisedCosine;
use crate::signal::theorem::Modulated;
use crate::signal::{Differentiable, Signal};
use crate::text::Text;
use std::f64::consts::PI;
use std::ops::Range;

/// The largest difference of two signals over `places`.
fn largest_difference(f: &impl Signal, g: &impl Signal, places: &[f64]) -> f64 {
    places.iter().map(|&x| (f.at(x) - g.at(x)).abs()).fold(0.0, f64::max)
}

/// What rounding does to `Σ v_k ψ(x/T − k)` over `n` terms: the index `x/T` and every sum are known to `ε·n`, and a
/// kernel of band 1 that nowhere exceeds `peak` is nowhere steeper than `2π·peak` (Bernstein).
fn series_rounding(n: usize, size: f64, peak: f64) -> f64 {
    f64::EPSILON * n as f64 * 2.0 * PI * peak * size
}

/// `|RC(B)(x)| ≤ c·|2Bx|⁻³` for `|2Bx| ≥ 2`, with this `c = 4B/(3π)`: there `1 − 1/u² ≥ ¾`.
fn raised_cosine_reach(band: f64) -> f64 {
    4.0 * band / (3.0 * PI)
}

/// What [`derivative_sampling`] leaves out of a raised cosine of that band over `|k| > terms`, for places within half of
/// the record.
///
/// With `u = 2Bx ≥ 2`, `|f| ≤ (4B/3π)u⁻³` and `|f′| ≤ 2B²(4/3 + 8/3π)u⁻³`; the kernel is at most `4/(π²k²)`, and
/// `|x − kT|` times it at most `2T/(π²k)`. `Σ_{k>N} k⁻⁵ ≤ 1/(4N⁴)`, `Σ_{k>N} k⁻⁴ ≤ 1/(3N³)`, on both sides.
pub fn derivative_tail(band: f64, step: f64, terms: usize) -> f64 {
    let (n, cube) = (terms as f64, (2.0 * band * step).powi(3));
    let values = raised_cosine_reach(band) * 4.0 / (PI * PI) / (4.0 * n.powi(4));
    let slopes = 2.0 * band * band * (4.0 / 3.0 + 8.0 / (3.0 * PI)) * 2.0 * step / (PI * PI) / (3.0 * n.powi(3));
    2.0 * (values + slopes) / cube
}

/// Values and slopes at rate `B` restore a signal of band `B` (V22): `f(x) = Σ[f(kT) + (x − kT)f′(kT)]sinc²(x/T − k)`.
///
/// Measured: the largest error over `places`, from samples at `|k| ≤ terms`. Allowed: rounding, and `tail`, the
/// caller's bound for the terms left out. Papoulis 1977.
///
/// ```
/// use nyquist::laws::generalised::{derivative_sampling, derivative_tail};
/// use nyquist::prelude::*;
/// let rc = RaisedCosine::new(1.0)?; // band 1, which plain samples ask a rate of 2 for
/// let residual = derivative_sampling(&rc, 1.0, 1000, &[0.1, 0.5, 7.3], derivative_tail(1.0, 1.0, 1000))?;
/// assert!(residual.holds() && residual.measured < 1e-9);
/// # Ok::<(), Error>(())
/// ```
///
/// # Errors
/// A step that is not positive and finite.
pub fn derivative_sampling(
    f: &impl Differentiable,
    step: f64,
    terms: usize,
    places: &[f64],
    tail: f64,
) -> Result<Residual> {
    let n = 2 * terms + 1;
    let samples = DerivativeSamples::of(f, Axis::centered(step, n)?);
    let pairs = samples.values().iter().zip(samples.slopes());
    let size: f64 = pairs.map(|(value, slope)| value.abs() + step * slope.abs()).sum();
    let measured = largest_difference(&samples, f, places);
    Ok(Residual::at_most(
        "values and slopes at rate B restore the signal",
        measured,
        series_rounding(n, size, 1.0) + tail,
    ))
}

/// What [`interlaced_sampling`] leaves out of a raised cosine of that band over `|k| > terms`, for places within half of
/// the record: two combs, two sides, `|f| ≤ (4B/3π)(2BkT)⁻³`, `|ψ| ≤ 2/(πk sin πa)`, and `Σ_{k>N} k⁻⁴ ≤ 1/(3N³)`.
pub fn interlaced_tail(band: f64, step: f64, terms: usize, offset: f64) -> f64 {
    let n = terms as f64 - 1.0; // the second comb stands nearer by less than a step
    let sum = 1.0 / (3.0 * n.powi(3)) / (2.0 * band * step).powi(3);
    4.0 * raised_cosine_reach(band) * 2.0 / (PI * sin_pi(offset)) * sum
}

/// Pairs of samples at `kT` and `kT + aT` restore a signal of band `1/T`, for every `a` (V22).
///
/// Measured: the largest error over `places`. Allowed: rounding, which grows as the kernels' peak `1/sin πa`, and
/// `tail`. Yen 1956; Papoulis 1977.
///
/// # Errors
/// A step that is not positive and finite; an offset outside `0 < a < 1`.
pub fn interlaced_sampling(
    f: &impl Signal,
    step: f64,
    terms: usize,
    offset: f64,
    places: &[f64],
    tail: f64,
) -> Result<Residual> {
    let n = 2 * terms + 1;
    let samples = Interlaced::of(f, Axis::centered(step, n)?, offset)?;
    let size: f64 = samples.points().map(|p| p[1].abs()).sum();
    let bound = series_rounding(2 * n, size, 1.0 / sin_pi(offset)) + tail;
    Ok(Residual::at_most("pairs of samples restore the signal", largest_difference(&samples, f, places), bound))
}

/// The price of bunching: independent errors of power one in pairs `aT` apart make an error of mean power `gain =
/// 1/sin²(πa)` (V22: 1, 2, 10.5, 1014 for `a` = ½, ¼, 0.1, 0.01).
///
/// Measured: `∫ψ_a² + ∫ψ_{−a}²` of the reconstruction of a single one, by the trapezoid rule with step ¼ (exact, as
/// `ψ²` has band 2) over `|x/T| ≤ terms`, against `gain`. Allowed: the tails, `|ψ| ≤ 1/(π|x| sin πa)`, hence
/// `4/(π² sin²(πa)(terms − 1))` for two kernels with two sides, and the rounding of the sum.
///
/// # Errors
/// An offset outside `0 < a < 1`.
pub fn interlaced_noise(offset: f64, terms: usize, gain: f64) -> Result<Residual> {
    let one = Axis::new(0.0, 1.0, 1)?;
    let kernels =
        [Interlaced::new(one, offset, vec![1.0], vec![0.0])?, Interlaced::new(one, offset, vec![0.0], vec![1.0])?];
    let n = 4 * terms as i64;
    let power: f64 = (-n..=n).map(|j| kernels.iter().map(|k| k.at(j as f64 / 4.0).powi(2) / 4.0).sum::<f64>()).sum();
    let peak = sin_pi(offset).powi(2).recip();
    let bound = 4.0 * peak / (PI * PI * (terms as f64 - 1.0)) + f64::EPSILON * n as f64 * peak;
    Ok(Residual::near("noise of pairs grows by 1/sin²(πa)", power, gain, bound))
}

/// What [`band_pass`] leaves out of a raised cosine of band `half_width` on a carrier, over `|k| > terms` and for places
/// within half of the record: `|k(x)| ≤ 2T/(π|x|)`, `|f| ≤ (4B/3π)(2BkT)⁻³`, `Σ_{k>N} k⁻⁴ ≤ 1/(3N³)`, two sides.
pub fn band_pass_tail(half_width: f64, step: f64, terms: usize) -> f64 {
    let sum = 1.0 / (3.0 * (terms as f64).powi(3)) / (2.0 * half_width * step).powi(3);
    2.0 * raised_cosine_reach(half_width) * 4.0 / PI * sum
}

/// A signal on the band `low < |ν| < high` is restored from samples at a rate in one of the intervals
/// `2f_H/n ≤ f_s ≤ 2f_L/(n − 1)` (V23), by the kernel `T[2f_H sinc(2f_H x) − 2f_L sinc(2f_L x)]`.
///
/// Measured: the largest error over `places`. Allowed: rounding (the kernel's peak is `2T(f_H − f_L)`, its band `f_H`),
/// and `tail`. Vaughan, Scott, White 1991.
///
/// # Errors
/// A rate that is not positive and finite, or a band that does not rise from zero or above.
pub fn band_pass(
    f: &impl Signal,
    band: Range<f64>,
    rate: f64,
    terms: usize,
    places: &[f64],
    tail: f64,
) -> Result<Residual> {
    let n = 2 * terms + 1;
    let step = 1.0 / rate;
    let samples = Samples::of(f, Axis::centered(step, n)?);
    let size: f64 = samples.values().iter().map(|v| v.abs()).sum();
    // in steps the kernel's band is f_H·T, and so is its steepness
    let peak = 2.0 * step * (band.end - band.start) * (band.end * step).max(1.0);
    let restored = BandPass::new(samples, band)?;
    let bound = series_rounding(n, size, peak) + tail;
    Ok(Residual::at_most("band-pass samples restore the signal", largest_difference(&restored, f, places), bound))
}

fn places() -> Vec<f64> {
    (-40..=40).map(|i| f64::from(i) * 0.1 + 0.03).collect()
}

fn rc(band: f64) -> RaisedCosine {
    RaisedCosine::new(band).expect("the band is positive")
}

/// The lecture companion's band-pass example: the band (21, 24), a raised cosine of band 1.4 on a carrier at 22.5.
fn carried(rate: f64) -> Residual {
    let f = Modulated::new(22.5, rc(1.4)).expect("the carrier is finite");
    let tail = band_pass_tail(1.4, 1.0 / rate, 4000);
    band_pass(&f, 21.0..24.0, rate, 4000, &places(), tail).expect("the band rises")
}

/// The laws of this theme.
pub static LAWS: &[Law] = &[
    Law {
        name: "derivative-sampling",
        inventory: &["V22"],
        says: &Text::fixed(
            "Values and slopes at half the Nyquist rate restore the signal",
            "Значения и производные с половинной частотой Найквиста восстанавливают сигнал",
        ),
        holds: || {
            let check = |band: f64, step| {
                derivative_sampling(&rc(band), step, 1000, &places(), derivative_tail(band, step, 1000))
            };
            [check(1.0, 1.0), check(0.7, 1.0), check(2.0, 0.5)].map(|r| r.expect("the step is positive")).into()
        },
        breaks: || {
            // a band above the rate
            vec![
                derivative_sampling(&rc(1.5), 1.0, 1000, &places(), derivative_tail(1.5, 1.0, 1000))
                    .expect("the step is positive"),
            ]
        },
    },
    Law {
        name: "interlaced-sampling",
        inventory: &["V22"],
        says: &Text::fixed(
            "Two combs at half the Nyquist rate, however close, restore the signal; noise grows by 1/sin²(πa)",
            "Две гребёнки с половинной частотой Найквиста, сколь угодно близкие, восстанавливают сигнал; шум растёт в 1/sin²(πa) раз",
        ),
        holds: || {
            let exact = |a| interlaced_sampling(&rc(1.0), 1.0, 2000, a, &places(), interlaced_tail(1.0, 1.0, 2000, a));
            let noise = |a: f64| interlaced_noise(a, 1000, sin_pi(a).powi(-2));
            let all = [0.5, 0.25, 0.1, 0.01, 0.9].into_iter().flat_map(|a| [exact(a), noise(a)]);
            all.map(|r| r.expect("the offset is inside the cell")).collect()
        },
        breaks: || {
            [
                interlaced_sampling(&rc(1.5), 1.0, 2000, 0.25, &places(), interlaced_tail(1.5, 1.0, 2000, 0.25)),
                interlaced_noise(0.1, 1000, 1.0), // the noise of uniform samples
            ]
            .map(|r| r.expect("the offset is inside the cell"))
            .into()
        },
    },
    Law {
        name: "band-pass",
        inventory: &["V23"],
        says: &Text::fixed(
            "A band (f_{L}, f_{H}) is restored at rates 2f_{H}/n ≤ f_{s} ≤ 2f_{L}/(n−1), and at no others",
            "Полоса (f_{L}, f_{H}) восстанавливается при частотах 2f_{H}/n ≤ f_{s} ≤ 2f_{L}/(n−1) и только при них",
        ),
        holds: || [8.2, 10.0, 13.0, 50.0].map(carried).into(),
        breaks: || [9.0, 7.5, 6.5].map(carried).into(),
    },
];
