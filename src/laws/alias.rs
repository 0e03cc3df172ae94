//! What leaks: the energy and the height of the alias (V07, V08).

use crate::axis::Axis;
use crate::comb::Comb;
use crate::error::Result;
use crate::laws::Law;
use crate::num::quadrature::{even_breaks, integrate_pieces};
use crate::residual::Residual;
use crate::sampled::Samples;
use crate::signal::FourierPair;
use crate::signal::raised_cosine::RaisedCosine;
use crate::spectrum::Spectrum;
use crate::text::Text;

/// The two halves of the reconstruction error `‖f̃ − f‖²` of ideal reconstruction from samples `step` apart.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AliasEnergy {
    /// What the low-pass cut off: `∫_{|ν| > 1/2T} |F|²`.
    pub lost: f64,
    /// What folded into the band: `∫_{|ν| < 1/2T} |Σ_{k≠0} F(ν − k/T)|²`.
    pub folded: f64,
    /// The energy of the signal, `∫|F|²`.
    pub total: f64,
}

impl AliasEnergy {
    /// `‖f̃ − f‖²/‖f‖²`.
    pub fn relative(&self) -> f64 {
        (self.lost + self.folded) / self.total
    }
}

/// The energy lost and folded when a band-limited signal is sampled with that step, by quadrature of its spectrum.
///
/// The error `f̃ − f` has the spectrum `Σ_{k≠0} F(ν − k/T)` inside the band and `−F` outside, so its energy is the sum
/// of both (Parseval). RC(1) at `T = 0.8`: 0.0153049 each.
///
/// ```
/// use nyquist::laws::alias::alias_energy;
/// use nyquist::prelude::*;
/// let energy = alias_energy(&RaisedCosine::new(1.0)?.spectrum(), 0.8)?;
/// assert!((energy.lost - 0.0153049).abs() < 1e-7 && (energy.folded - energy.lost).abs() < 1e-14);
/// # Ok::<(), Error>(())
/// ```
///
/// # Errors
/// A step that is not positive and finite.
pub fn alias_energy(spectrum: &Spectrum, step: f64) -> Result<AliasEnergy> {
    let rate = Comb::new(step)?.rate();
    let half = 0.5 * rate;
    let extent = spectrum.extent();
    let order = ((extent + half) / rate).ceil() as usize;
    let copies = spectrum.replicated(rate, order)?;
    let alias = |nu: f64| (copies.density(nu) - spectrum.density(nu)).norm_sqr();
    // the neighbours end inside the band, at ±(k/T − B): smooth between those breaks
    let mut breaks = even_breaks(-half, half, half / 8.0);
    let ends = (1..=order as i64).flat_map(|k| [k as f64 * rate - extent, extent - k as f64 * rate]);
    breaks.extend(ends.filter(|e| e.abs() < half));
    breaks.sort_by(f64::total_cmp);
    Ok(AliasEnergy {
        lost: spectrum.energy(-extent, -half) + spectrum.energy(half, extent),
        folded: integrate_pieces(alias, &breaks, 1e-16).value,
        total: spectrum.energy(-extent, extent),
    })
}

/// V07: if `F` is supported in `[−B, B]` and `1/T ≥ B`, the folded half equals the lost half:
/// `‖f̃ − f‖² = 2∫_{|ν| > 1/2T} |F|²`.
///
/// The pieces beyond `±1/2T` fold to disjoint sets, so they keep their energy; below `1/T = B` they overlap, and their
/// cross terms spoil the equality. Measured: `|folded − lost|`. Allowed: the error of the two quadratures, which ask for
/// 1e-15 and 1e-16 and are limited by rounding, `64ε` of the total energy.
///
/// # Errors
/// A step that is not positive and finite.
pub fn alias_energy_identity(spectrum: &Spectrum, step: f64) -> Result<Residual> {
    let energy = alias_energy(spectrum, step)?;
    let bound = 64.0 * f64::EPSILON * energy.total + 2e-15;
    Ok(Residual::near("folded energy = lost energy", energy.folded, energy.lost, bound))
}

/// V08: `|f̃ − f| ≤ 2∫_{|ν| > 1/2T} |F| dν` at every point (Weiss 1963, Brown 1967; the constant is sharp).
///
/// Measured: the largest error of the ideal reconstruction over `points`; the reconstruction is the integral of the
/// samples' DTFT over the band, evaluated as the cardinal series of `2·terms + 1` samples. Allowed: the integral, plus
/// `tail` for the terms left out.
///
/// # Errors
/// A step that is not positive and finite.
pub fn pointwise_alias(
    pair: &impl FourierPair,
    step: f64,
    terms: usize,
    points: &[f64],
    tail: f64,
) -> Result<Residual> {
    let samples = Samples::of(pair, Axis::centered(step, 2 * terms + 1)?);
    let series = |x: f64| samples.points().map(|[at, v]| v * crate::num::sinc((x - at) / step)).sum::<f64>();
    let error = points.iter().map(|&x| (series(x) - pair.at(x)).abs()).fold(0.0, f64::max);
    let spectrum = pair.spectrum();
    let (half, extent) = (0.5 / step, spectrum.extent());
    let beyond = if extent > half {
        let breaks = even_breaks(half, extent, (extent - half) / 8.0);
        2.0 * integrate_pieces(|nu| spectrum.density(nu).norm(), &breaks, 1e-15).value
    } else {
        0.0
    };
    Ok(Residual::at_most("|f̃ − f| ≤ 2∫|F| beyond the band", error, 2.0 * beyond + tail))
}

/// The spectrum of an ideal reconstruction: the low-passed sum of all copies, not the central copy cut off (E30).
///
/// # Errors
/// A step that is not positive and finite.
pub fn leaked_spectrum(spectrum: &Spectrum, step: f64) -> Result<Spectrum> {
    let rate = Comb::new(step)?.rate();
    let order = ((spectrum.extent() + 0.5 * rate) / rate).ceil() as usize;
    spectrum.replicated(rate, order)?.low_passed(0.5 * rate)
}

fn rc() -> RaisedCosine {
    RaisedCosine::new(1.0).expect("the band is positive")
}

/// The laws of this theme.
pub static LAWS: &[Law] = &[
    Law {
        name: "alias-energy",
        inventory: &["V07", "F28"],
        says: &Text::fixed(
            "For 1/T ≥ B the energy folded into the band equals the energy lost beyond it",
            "При 1/T ≥ B энергия, завернувшаяся в полосу, равна энергии, потерянной за её краем",
        ),
        holds: || [0.4, 0.6, 0.8, 1.0].map(|t| alias_energy_identity(&rc().spectrum(), t).expect("t > 0")).into(),
        breaks: || [1.25, 1.6].map(|t| alias_energy_identity(&rc().spectrum(), t).expect("t > 0")).into(),
    },
    Law {
        name: "pointwise-alias",
        inventory: &["V08"],
        says: &Text::fixed(
            "Ideal reconstruction errs nowhere by more than 2∫|F| beyond the band",
            "Идеальная реконструкция нигде не ошибается больше чем на 2∫|F| за краем полосы",
        ),
        holds: || {
            let points: Vec<f64> = (0..=64).map(|i| f64::from(i) / 16.0).collect();
            [0.5, 0.8, 1.0]
                .map(|t| {
                    let tail = crate::laws::poisson::raised_cosine_tail(1.0, t, 400) / t;
                    pointwise_alias(&rc(), t, 400, &points, tail).expect("t > 0")
                })
                .into()
        },
        breaks: || {
            // a series cut off after three terms to either side is no ideal reconstruction
            let points: Vec<f64> = (0..=64).map(|i| f64::from(i) / 16.0).collect();
            vec![pointwise_alias(&rc(), 0.25, 1, &points, 0.0).expect("t > 0")]
        },
    },
];
