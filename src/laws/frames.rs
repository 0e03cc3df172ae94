//! Irregular positions: how far they may stray, and what can be recovered from them (V24, V25).

use crate::beyond::irregular::Irregular;
use crate::beyond::weighted::Weighted;
use crate::error::{Result, all_finite, within};
use crate::laws::Law;
use crate::num::random::{normal, uniform};
use crate::num::svd::Svd;
use crate::num::{cos_pi, sin_pi, sinc};
use crate::residual::Residual;
use crate::sampled::harmonics::Places;
use crate::signal::trigonometric::TrigPolynomial;
use crate::text::Text;
use ndarray::Array2;
use num_complex::Complex;

/// The Gram matrix `sinc(λ_m − λ_n)` of the shifted sincs at `positions`, or of the exponentials `e^{2πiλ_n ν}` on the
/// band `|ν| < ½`: its eigenvalues say how near they are to losing their independence.
///
/// # Errors
/// No positions, or ones that are not finite.
pub fn gram(positions: &[f64]) -> Result<Array2<f64>> {
    all_finite("the positions of a frame", positions)?;
    let n = positions.len();
    Ok(Array2::from_shape_fn((n, n), |(i, j)| sinc(positions[i] - positions[j])))
}

/// The least and the greatest eigenvalue of [`gram`]: bounds `A, B` of `A Σ|a_n|² ≤ ‖Σ a_n e_n‖² ≤ B Σ|a_n|²`.
///
/// ```
/// use nyquist::laws::frames::riesz_bounds;
/// assert_eq!(riesz_bounds(&[-1.0, 0.0, 1.0, 2.0])?, [1.0, 1.0]); // whole numbers: orthonormal
/// # Ok::<(), nyquist::error::Error>(())
/// ```
///
/// # Errors
/// As [`gram`].
pub fn riesz_bounds(positions: &[f64]) -> Result<[f64; 2]> {
    let svd = Svd::of(&gram(positions)?)?;
    let values = svd.values(); // of a Gram matrix the singular values are the eigenvalues
    Ok([values[values.len() - 1], values[0]])
}

/// Kadec's bounds for positions within `L < ¼` of the whole numbers: `(cos πL − sin πL)²` and
/// `(2 − cos πL + sin πL)²`. The lower one reaches zero at `L = ¼`, and ¼ is sharp.
///
/// Kadec, *The exact value of the Paley–Wiener constant*, 1964.
///
/// ```
/// use nyquist::laws::frames::kadec_bounds;
/// assert_eq!(kadec_bounds(0.0)?, [1.0, 1.0]);
/// assert!((kadec_bounds(0.1)?[0] - 0.412).abs() < 5e-4); // from the inventory
/// # Ok::<(), nyquist::error::Error>(())
/// ```
///
/// # Errors
/// An `L` outside `0 ..= ¼`.
pub fn kadec_bounds(deviation: f64) -> Result<[f64; 2]> {
    within("how far positions may stray from the whole numbers", deviation, 0.0, 0.25)?;
    let (cosine, sine) = (cos_pi(deviation), sin_pi(deviation));
    Ok([(cosine - sine).powi(2), (2.0 - cosine + sine).powi(2)])
}

/// Positions within `deviation < ¼` of the whole numbers keep a Riesz basis: eigenvalues of [`gram`] stay within
/// [`kadec_bounds`] (V24), for any number of positions, as a section's eigenvalues lie within those of the whole.
///
/// Measured: by how much the least eigenvalue falls below the lower bound, and the greatest rises above the upper one.
/// Allowed: the rounding of the decomposition, `ε·n` of the largest eigenvalue.
///
/// # Errors
/// As [`gram`] and [`kadec_bounds`].
pub fn kadec(positions: &[f64], deviation: f64) -> Result<Residual> {
    let ([low, high], [least, most]) = (riesz_bounds(positions)?, kadec_bounds(deviation)?);
    let outside = (least - low).max(high - most).max(0.0);
    Ok(Residual::at_most(
        "Kadec: |λ_n − n| ≤ L < ¼ is a Riesz basis",
        outside,
        f64::EPSILON * positions.len() as f64 * high,
    ))
}

/// Levinson's positions `λ_n = n − L·sgn n` for `|n| ≤ half`: of all within `L` the ones that lose independence first.
pub fn levinson(half: i32, deviation: f64) -> Vec<f64> {
    (-half..=half).map(|n| f64::from(n) - deviation * f64::from(n.signum())).collect()
}

/// Irregular samples restore a band-limited signal of a period to rounding (V25, E12).
///
/// Measured: the distance (root mean square) of the recovered polynomial from `f`. Allowed: with `κ` the condition
/// number of the equations, `κ·ε·n·(rms f)`: every value has an error of a few ε from its own evaluation, by Horner's
/// rule `2Kε·Σ|c_k| ≤ 2Kε·√(2K + 1)·rms`, and the decomposition one of `ε√n`; least squares multiply them by `κ` at most.
///
/// # Errors
/// Positions outside the period or not distinct, a band above the one that their number supports, or a condition number
/// above `most_condition`.
pub fn irregular_recovery(f: &TrigPolynomial, positions: &[f64], band: f64, most_condition: f64) -> Result<Residual> {
    let period = f.start()..f.start() + f.period();
    let recovery = Irregular::of(f, period, positions)?.least_squares(band, most_condition)?;
    let degree = f.degree() as f64;
    let values = 2.0 * degree * (2.0 * degree + 1.0).sqrt();
    let bound = recovery.condition() * f64::EPSILON * (values + (positions.len() as f64).sqrt()) * f.rms();
    Ok(Residual::at_most("irregular samples restore the signal", distance(f, recovery.polynomial()), bound))
}

/// Gröchenig's iteration loses at least the factor `2Bδ` a step where the largest gap `δ` is below `1/(2B)` (V25).
///
/// Measured: the distance (root mean square) after `steps` steps. Allowed: `(2Bδ)^steps·rms f`, and rounding as in
/// [`irregular_recovery`] summed over the steps, `1/(1 − 2Bδ)`.
///
/// # Errors
/// As [`Irregular::iterate`].
pub fn grochenig(f: &TrigPolynomial, positions: &[f64], band: f64, steps: usize) -> Result<Residual> {
    let samples = Irregular::of(f, f.start()..f.start() + f.period(), positions)?;
    let factor = samples.contraction(band)?;
    let degree = f.degree() as f64;
    let rounding = f64::EPSILON * 2.0 * degree * (2.0 * degree + 1.0).sqrt() / (1.0 - factor);
    let left = distance(f, &samples.iterate(band, steps)?);
    let bound = (factor.powi(i32::try_from(steps).unwrap_or(i32::MAX)) + rounding) * f.rms();
    Ok(Residual::at_most("Gröchenig: every step loses the factor 2Bδ", left, bound))
}

/// Equations weighted by gaps are well conditioned where the largest gap is at most `gap < 1/(2B)` (V25), however the
/// positions crowd elsewhere: `κ ≤ (1 + 2Bδ)/(1 − 2Bδ)` (Feichtinger, Gröchenig and Strohmer 1995).
///
/// Measured: the condition number that [`Weighted`] finds. Allowed: the bound.
///
/// # Errors
/// As [`Weighted::new`] and [`Weighted::condition`]; a gap that is too long for the band.
pub fn weighted_condition(period: f64, positions: &[f64], degree: usize, gap: f64) -> Result<Residual> {
    let factor = 2.0 * gap * degree as f64 / period;
    within("twice the band times the largest gap", factor, 0.0, 1.0 - f64::EPSILON)?;
    let places = Places::Anywhere(positions.iter().map(|x| x / period).collect());
    let condition = Weighted::new(0.0..period, places, degree)?.condition(degree, f64::INFINITY)?;
    let bound = (1.0 + factor) / (1.0 - factor);
    Ok(Residual::at_most("weights by gaps bound the condition number", condition, bound))
}

/// `‖f − g‖`, the root mean square over a period, by Parseval.
fn distance(f: &TrigPolynomial, g: &TrigPolynomial) -> f64 {
    let at = |p: &TrigPolynomial, k: usize| p.coefficients().get(k).copied().unwrap_or(Complex::ZERO);
    let count = f.degree().max(g.degree()) + 1;
    let square = |k: usize| (at(f, k) - at(g, k)).norm_sqr() * if k == 0 { 1.0 } else { 2.0 };
    (0..count).map(square).sum::<f64>().sqrt()
}

/// A polynomial of period `period` from zero on, up to `degree`, with random coefficients.
///
/// # Errors
/// A period that is not positive and finite.
pub fn random_polynomial(seed: u64, period: f64, degree: usize) -> Result<TrigPolynomial> {
    let coefficient = |k: u64| Complex::new(normal(seed, k, 0), if k == 0 { 0.0 } else { normal(seed, k, 1) });
    TrigPolynomial::new(0.0..period, (0..=degree as u64).map(coefficient).collect())
}

/// One position in each cell of `0..cells`, anywhere within the middle `width` of it.
pub fn jittered_cells(seed: u64, cells: usize, width: f64) -> Vec<f64> {
    (0..cells as u64).map(|k| k as f64 + 0.5 + width * (uniform(seed, k, 0) - 0.5)).collect()
}

/// Positions of a period of 64 that crowd in clusters of four, no gap of which exceeds 1.25.
fn crowded() -> Vec<f64> {
    (0..256u64).map(|k| (k / 4) as f64 + 0.25 * uniform(13, k, 0).powi(4) * ((k % 4) as f64 + 1.0)).collect()
}

fn recovery_of(degree: usize, band: f64) -> Result<Residual> {
    let f = random_polynomial(11, 256.0, degree)?;
    irregular_recovery(&f, &jittered_cells(7, 256, 1.0), band, 1e3)
}

fn iteration_of(degree: usize) -> Result<Residual> {
    // gaps below 1.5, so that bands below 1/3 converge
    let f = random_polynomial(12, 64.0, degree)?;
    grochenig(&f, &jittered_cells(8, 64, 0.5), 0.25, 12)
}

/// The laws of this theme.
pub static LAWS: &[Law] = &[
    Law {
        name: "kadec",
        inventory: &["V24"],
        says: &Text::fixed(
            "Positions that stray from a regular grid by less than a quarter of the step still carry everything",
            "Позиции, отклонившиеся от сетки меньше чем на четверть шага, по-прежнему несут всё",
        ),
        holds: || {
            let random = |l: f64| (0..41u64).map(|k| k as f64 + l * (2.0 * uniform(3, k, 0) - 1.0)).collect::<Vec<_>>();
            let all = [0.1, 0.2, 0.24].into_iter().flat_map(|l| [kadec(&levinson(30, l), l), kadec(&random(l), l)]);
            all.map(|r| r.expect("positions are finite")).collect()
        },
        breaks: || {
            // positions that stray farther than is said
            let all = [kadec(&levinson(30, 0.4), 0.2), kadec(&levinson(30, 0.3), 0.1)];
            all.map(|r: Result<Residual>| r.expect("positions are finite")).into()
        },
    },
    Law {
        name: "irregular-recovery",
        inventory: &["V25", "E12"],
        says: &Text::fixed(
            "Irregular samples restore a band-limited signal exactly, if their positions are known",
            "Нерегулярные отсчёты восстанавливают сигнал с ограниченным спектром точно, если позиции известны",
        ),
        holds: || {
            [recovery_of(115, 0.45), recovery_of(64, 0.25), recovery_of(64, 0.45)]
                .map(|r| r.expect("256 positions support 0.9 of the Nyquist frequency"))
                .into()
        },
        breaks: || vec![recovery_of(80, 0.25).expect("256 positions support half of the Nyquist frequency")],
    },
    Law {
        name: "grochenig-iteration",
        inventory: &["V25"],
        says: &Text::fixed(
            "Where the largest gap δ is below 1/(2B), iteration recovers the signal and loses a factor 2Bδ a step",
            "Если наибольший промежуток δ меньше 1/(2B), итерация восстанавливает сигнал, теряя за шаг множитель 2Bδ",
        ),
        holds: || [iteration_of(16), iteration_of(5)].map(|r| r.expect("the gaps are below two cells")).into(),
        breaks: || vec![iteration_of(20).expect("the gaps are below two cells")],
    },
    Law {
        name: "weighted-condition",
        inventory: &["V25"],
        says: &Text::fixed(
            "Weighted by their gaps, irregular samples are well conditioned below 1/(2δ), however they crowd",
            "Взвешенные по промежуткам нерегулярные отсчёты хорошо обусловлены ниже 1/(2δ), как бы они ни скучивались",
        ),
        holds: || {
            let mut positions = crowded();
            positions.sort_by(f64::total_cmp);
            let of = |degree| weighted_condition(64.0, &positions, degree, 1.25);
            [of(5), of(15), of(24)].map(|r| r.expect("the gaps are below 1.25")).into()
        },
        breaks: || {
            // a gap of ten that is not said
            let mut positions = crowded();
            positions.retain(|x| !(30.0..40.0).contains(x));
            positions.sort_by(f64::total_cmp);
            vec![weighted_condition(64.0, &positions, 15, 1.25).expect("there are samples enough")]
        },
    },
];
