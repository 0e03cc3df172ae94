//! Transforms between points and harmonics: as near to the sums they stand for as they promise.

use crate::engine::nonuniform::{Nufft, PeriodicInterpolator, Placed};
use crate::error::Result;
use crate::laws::Law;
use crate::laws::frames::random_polynomial;
use crate::num::random::{normal, uniform};
use crate::num::{cos_pi, sin_pi};
use crate::residual::Residual;
use crate::sampled::nonuniform::transform;
use crate::signal::Signal;
use crate::signal::trigonometric::TrigPolynomial;
use crate::text::Text;
use num_complex::Complex;

/// `n` positions anywhere in a period of one, and a weight for each.
pub fn impulses(seed: u64, n: usize) -> Vec<[f64; 2]> {
    (0..n as u64).map(|i| [uniform(seed, i, 0), normal(seed, i, 1)]).collect()
}

/// The window keeps its promise: a transform made for `tolerance` finds every harmonic of impulses to `promised` times
/// the sum of their weights (Potts and Tasche 2021).
///
/// Measured: the largest difference from the [direct sum](transform), as a part of `Σ|w|`. Allowed: `promised`, and the
/// rounding of the direct sum's own waves, `2kε` for the powers and `πkε` for the turn, together below `2πkε`, and of `n`
/// terms, `ε√n`.
///
/// # Errors
/// As [`Nufft::new`].
pub fn harmonics_agree(impulses: &[[f64; 2]], degree: usize, tolerance: f64, promised: f64) -> Result<Residual> {
    let (nufft, positions, weights) = plan(impulses, degree, tolerance)?;
    let found = nufft.spectrum(&positions, &weights)?;
    let size: f64 = weights.iter().map(|w| w.abs()).sum();
    let known = transform(impulses, 1.0, degree);
    let errors = found.iter().zip(known).map(|(found, known)| (found - known).norm() / size);
    let worst = errors.fold(0.0, f64::max);
    let rounding = f64::EPSILON * (std::f64::consts::TAU * degree as f64 + (impulses.len() as f64).sqrt());
    Ok(Residual::at_most("non-uniform harmonics are the sums over the points", worst, promised + rounding))
}

/// From points to harmonics is the adjoint of from harmonics to points: `⟨A c, w⟩ = ⟨c, A* w⟩`, to rounding, whatever
/// the tolerance, when `A` takes values `at` the points of the weights.
///
/// Measured: the difference, as a part of `√(2K + 1)·‖c‖·Σ|w|`, which both sides are below. Allowed: the rounding of two
/// transforms, `ε` for each of the `log₂` stages and of the sums over windows, times the gains that undo the window,
/// below `16`.
///
/// # Errors
/// As [`Nufft::new`].
pub fn adjoint(impulses: &[[f64; 2]], at: &[[f64; 2]], degree: usize, tolerance: f64) -> Result<Residual> {
    let (nufft, positions, weights) = plan(impulses, degree, tolerance)?;
    let modes = random_polynomial(5, 1.0, degree)?;
    let (spectrum, there) = (nufft.spectrum(&positions, &weights)?, plan(at, degree, tolerance)?.1);
    let values = nufft.values(modes.coefficients(), &there)?;
    let left: f64 = values.iter().zip(&weights).map(|(v, w)| v * w).sum();
    let products = modes.coefficients().iter().zip(&spectrum).map(|(c, f)| (c * f.conj()).re);
    let right = products.enumerate().map(|(k, p)| if k == 0 { p } else { 2.0 * p }).sum::<f64>();
    let size = modes.rms() * (2.0 * degree as f64 + 1.0).sqrt() * weights.iter().map(|w| w.abs()).sum::<f64>();
    let rounding = 16.0 * f64::EPSILON * (4.0 * degree as f64).log2();
    Ok(Residual::at_most("non-uniform transforms: ⟨A c, w⟩ = ⟨c, A* w⟩", (left - right).abs() / size, rounding))
}

/// The sampling theorem of a period: `n` samples of a polynomial of degree below `n/2` have its values everywhere.
///
/// Measured: the largest difference at 200 places. Allowed: `tolerance·Σ|c|`, and the rounding of the polynomial's own
/// values, `2Kε·Σ|c|` in the samples and again at the places, and of positions up to two periods away, `5πKε·Σ|c|`: `ε/2` of
/// the period in the samples, twice that at the places, and twice that in the step.
///
/// # Errors
/// As [`PeriodicInterpolator::new`].
pub fn period_is_sampled(f: &TrigPolynomial, n: usize, tolerance: f64) -> Result<Residual> {
    let step = f.period() / n as f64;
    let samples: Vec<f64> = (0..n).map(|i| f.at(f.start() + i as f64 * step)).collect();
    let between = PeriodicInterpolator::new(n, tolerance)?;
    let places: Vec<f64> = (0..200).map(|i| n as f64 * (3.0 * uniform(9, i, 0) - 1.0)).collect();
    let values = between.values(&samples, &between.place(&places)?)?;
    let differences = places.iter().zip(values).map(|(x, v)| (v - f.at(f.start() + x * step)).abs());
    let size: f64 = f.coefficients().iter().map(|c| 2.0 * c.norm()).sum();
    let bound = (tolerance + 20.0 * f.degree() as f64 * f64::EPSILON) * size;
    Ok(Residual::at_most("samples of a period have its values everywhere", differences.fold(0.0, f64::max), bound))
}

/// Poisson summation: the harmonics of `n` impulses that are equally spaced from `offset` on are `n·e^{−2πik·offset}` at the
/// multiples of `n` and nothing between, whatever lies between the cells of a grid.
///
/// `offset` and `stray` are parts of the period; the last impulse stands `stray` behind its place, and then the theorem does
/// not hold. Measured: the largest difference, as a part of `n`. Allowed: `tolerance`, and the rounding `4πkε` of phases, from
/// `3ε/2` of the period in the places and `ε/2` in the turns of the lines, and `ε√n` of the sums.
///
/// # Errors
/// As [`Nufft::new`].
pub fn comb_sums_to_comb([offset, stray]: [f64; 2], n: usize, degree: usize, tolerance: f64) -> Result<Residual> {
    let place = |i: usize| (i as f64 + if i + 1 == n { stray * n as f64 } else { 0.0 }) / n as f64 + offset;
    let nufft = Nufft::new(degree, 1, tolerance)?;
    let positions: Vec<f64> = (0..n).map(place).collect();
    let found = nufft.spectrum(&nufft.place(&positions)?, &vec![1.0; n])?;
    let difference = |(k, found): (usize, &Complex<f64>)| {
        let turn = 2.0 * k as f64 * offset;
        let line = if k.is_multiple_of(n) { Complex::new(cos_pi(turn), -sin_pi(turn)) } else { Complex::ZERO };
        (found / n as f64 - line).norm()
    };
    let worst = found.iter().enumerate().map(difference).fold(0.0, f64::max);
    let rounding = f64::EPSILON * (2.0 * std::f64::consts::TAU * degree as f64 + (n as f64).sqrt());
    Ok(Residual::at_most("a comb's harmonics are a comb (Poisson)", worst, tolerance + rounding))
}

fn plan(impulses: &[[f64; 2]], degree: usize, tolerance: f64) -> Result<(Nufft<f64>, Placed<1>, Vec<f64>)> {
    let nufft = Nufft::new(degree, 1, tolerance)?;
    let positions: Vec<f64> = impulses.iter().map(|p| p[0]).collect();
    let placed = nufft.place(&positions)?;
    Ok((nufft, placed, impulses.iter().map(|p| p[1]).collect()))
}

/// The laws of this theme.
pub static LAWS: &[Law] = &[
    Law {
        name: "nonuniform-harmonics",
        inventory: &[],
        says: &Text::fixed(
            "Fast harmonics of points are as near to their sums as they promise",
            "Быстрые гармоники точек отличаются от своих сумм не больше, чем обещано",
        ),
        holds: || {
            let all = [(1, 40, 1e-2), (300, 150, 1e-4), (300, 150, 1e-6), (200, 1000, 1e-9), (500, 320, 1e-12)];
            let check = |(n, degree, tolerance)| harmonics_agree(&impulses(3, n), degree, tolerance, tolerance);
            all.map(|case| check(case).expect("tolerances that there are")).into()
        },
        breaks: || {
            // a promise that the window was not made for; one impulse, whose error nothing averages out
            let check = |(tolerance, promised)| harmonics_agree(&impulses(3, 1), 1000, tolerance, promised);
            [(1e-2, 1e-4), (1e-6, 1e-9)].map(|case| check(case).expect("tolerances that there are")).into()
        },
    },
    Law {
        name: "nonuniform-adjoint",
        inventory: &[],
        says: &Text::fixed(
            "From points to harmonics is the adjoint of from harmonics to points",
            "Преобразование от точек к гармоникам сопряжено преобразованию от гармоник к точкам",
        ),
        holds: || {
            let points = impulses(4, 500);
            [1e-2, 1e-7, 1e-12]
                .map(|tolerance| adjoint(&points, &points, 200, tolerance).expect("tolerances that there are"))
                .into()
        },
        breaks: || {
            let (points, others) = (impulses(4, 500), impulses(6, 500));
            vec![adjoint(&points, &others, 200, 1e-7).expect("a tolerance that there is")]
        },
    },
    Law {
        name: "sampled-period",
        inventory: &[],
        says: &Text::fixed(
            "Equally spaced samples of a period have its values everywhere, if its band is below half their rate",
            "Равномерные отсчёты периода задают его значения всюду, если полоса ниже половины частоты отсчётов",
        ),
        holds: || {
            let all = [(20, 41, 1e-10), (20, 50, 1e-6), (499, 1000, 1e-12)];
            let check = |(degree, n, tolerance)| period_is_sampled(&random_polynomial(7, 8.0, degree)?, n, tolerance);
            all.map(|case| check(case).expect("a period that there is")).into()
        },
        breaks: || {
            let f = random_polynomial(7, 8.0, 25).expect("a period that there is");
            vec![period_is_sampled(&f, 41, 1e-10).expect("a tolerance that there is")] // harmonics 21 … 25 fold
        },
    },
    Law {
        name: "nonuniform-poisson",
        inventory: &[],
        says: &Text::fixed(
            "Poisson summation, off the grid: the harmonics of a comb are a comb",
            "Формула суммирования Пуассона не на сетке: гармоники гребёнки образуют гребёнку",
        ),
        holds: || {
            let all = [(0.1234, 7, 1000, 1e-6), (0.9, 250, 1000, 1e-9), (1.0 / 3.0, 1000, 5000, 1e-12)];
            let check = |(offset, n, degree, tolerance)| comb_sums_to_comb([offset, 0.0], n, degree, tolerance);
            all.map(|case| check(case).expect("tolerances that there are")).into()
        },
        breaks: || {
            // one impulse of 250 a ten thousandth of the period off its place
            vec![comb_sums_to_comb([0.1, 1e-4], 250, 1000, 1e-9).expect("a tolerance that there is")]
        },
    },
];
