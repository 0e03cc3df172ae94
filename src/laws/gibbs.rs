//! Ringing at a jump: of Fourier sums (V01) and of sampled steps (V02), which are not the same (E15).

use crate::kernel::Kernel;
use crate::kernel::cubic::Cubic;
use crate::kernel::ideal::Ideal;
use crate::laws::Law;
use crate::laws::poisson::sum_rounding;
use crate::num::extremum::{Extremum, maximum};
use crate::num::special::{digamma, si};
use crate::num::{sin_pi, sinc};
use crate::residual::Residual;
use crate::signal::series::{PartialSum, Wave};
use crate::signal::{Signal, from_fn};
use crate::text::Text;
use std::f64::consts::PI;

/// `(2/π)·Si(π) = 1.178979744472167`, where the partial sums of the unit square wave peak: 8.949 % of the jump above it.
pub fn wilbraham_gibbs() -> f64 {
    2.0 / PI * si(PI)
}

/// V01: the first maximum of the square wave's partial sum of `terms` terms stands at `x = 1/(4·terms)` and tends to
/// `(2/π)·Si(π)` (Wilbraham 1848, Gibbs 1899). `sum` is any candidate of period 1 that jumps from −1 to 1 at zero.
///
/// Measured: `|max sum − (2/π)Si(π)|`. Allowed: at that place the sum is the midpoint rule with `N` panels of width
/// `h = π/N` for `(2/π)∫₀^π sin t/t dt`, whose error is at most `(2/π)·π·h²/24·max|f″| = π²/(36N²)`, as `|f″| ≤ ⅓`; and the
/// rounding of the sum.
///
/// ```
/// use nyquist::laws::gibbs::fourier_peak;
/// use nyquist::prelude::*;
/// assert!(fourier_peak(&PartialSum::new(Wave::Square, 64, 1.0)?, 64).holds());
/// // equal amplitudes, as the slide's labels say, are no square wave (E16)
/// let equal = from_fn(|x| (1..=8).map(|k| (2.0 * std::f64::consts::PI * f64::from(2 * k - 1) * x).sin()).sum());
/// assert!(!fourier_peak(&equal, 8).holds());
/// # Ok::<(), Error>(())
/// ```
pub fn fourier_peak(sum: &impl Signal, terms: u32) -> Residual {
    let n = f64::from(terms.max(1));
    let peak = maximum(|x| sum.at(x), 0.0, 0.5 / n, 16).value;
    let bound = PI * PI / (36.0 * n * n) + sum_rounding(terms as usize, 2.0 * n.ln() + 2.0);
    Residual::near(format!("peak of {terms} terms → (2/π)·Si(π)"), peak, wilbraham_gibbs(), bound)
}

/// V01: the first minimum, at `x = 1/(2·terms)`, tends to `(2/π)·Si(2π) = 0.902823`.
///
/// Allowed: the midpoint rule for `(2/π)∫₀^{2π} sin t/t dt` with panels of width `2π/N`, `2π²/(9N²)`, and rounding.
pub fn fourier_dip(sum: &impl Signal, terms: u32) -> Residual {
    let n = f64::from(terms.max(1));
    let dip = -maximum(|x| -sum.at(x), 0.25 / n, 0.75 / n, 16).value;
    let bound = 2.0 * PI * PI / (9.0 * n * n) + sum_rounding(terms as usize, 2.0 * n.ln() + 2.0);
    Residual::near(format!("dip of {terms} terms → (2/π)·Si(2π)"), dip, 2.0 / PI * si(2.0 * PI), bound)
}

/// V02: the answer to a sampled step, `Σ_{i≥0} k(x−i)` in the kernel's closed form, against the sum of the first `terms`
/// samples.
///
/// Measured: the largest difference over `places`. Allowed: for the ideal kernel the terms left out alternate and fall, so
/// they amount to less than the first, `1/(π(terms − x))`; for kernels of finite radius nothing is left out; and rounding.
pub fn step_is_sum(kernel: &(impl Kernel + ?Sized), terms: usize, places: &[f64]) -> Residual {
    let (mut measured, mut bound) = (0.0f64, 0.0f64);
    for &x in places {
        let sum: f64 = (0..terms).rev().map(|i| kernel.at(x - i as f64)).sum();
        let left_out = if kernel.radius().is_finite() { 0.0 } else { 1.0 / (PI * (terms as f64 - x)) };
        measured = measured.max((kernel.step_response(x) - sum).abs());
        bound = bound.max(left_out + sum_rounding(terms.min(64), 4.0));
    }
    Residual::at_most("step response = Σk(x−i)", measured, bound)
}

/// V02: `Σ_{k≥0} sinc(x−k) = −(sin πx/2π)·[ψ((1−x)/2) − ψ(−x/2)]` with the digamma function, away from the integers.
///
/// Measured: the largest difference between `step` and that formula. Allowed: the rounding of two digammas and of their
/// difference, `64ε·(1 + max|ψ|)`.
pub fn step_by_digamma(step: &impl Signal, places: &[f64]) -> Residual {
    let (mut measured, mut bound) = (0.0f64, 0.0f64);
    for &x in places {
        let (a, b) = (digamma(0.5 * (1.0 - x)), digamma(-0.5 * x));
        measured = measured.max((step.at(x) + sin_pi(x) / (2.0 * PI) * (a - b)).abs());
        bound = bound.max(64.0 * f64::EPSILON * (1.0 + a.abs().max(b.abs())));
    }
    Residual::at_most("step response by digamma", measured, bound)
}

/// The ideal reconstruction of a sampled unit step; `on_jump` is the value of the sample at zero: 1 if the jump lies
/// between the samples, ½ if a sample sits on it.
///
/// ```
/// use nyquist::laws::gibbs::sampled_step;
/// use nyquist::prelude::*;
/// let step = sampled_step(1.0);
/// assert!((step.at(0.5) - (0.5 + 2.0 / std::f64::consts::PI)).abs() < 1e-15);
/// ```
pub fn sampled_step(on_jump: f64) -> impl Signal {
    from_fn(move |x| Ideal.step_response(x) - (1.0 - on_jump) * sinc(x))
}

/// The continuous unit step, ideally low-passed at `band`: `½ + Si(2π·band·x)/π`, which overshoots by 8.949 %, the number
/// that textbooks quote for sampled steps, where it does not apply (E15).
pub fn low_passed_step(band: f64) -> impl Signal {
    from_fn(move |x| 0.5 + si(2.0 * PI * band * x) / PI)
}

/// Where a response to a step is largest, and where it is least after that: `[peak, dip]`, looked for in the first two
/// steps after the jump.
pub fn ringing(step: &impl Signal) -> [Extremum; 2] {
    let peak = maximum(|x| step.at(x), 0.0, 1.9, 64);
    let dip = maximum(|x| -step.at(x), peak.at, peak.at + 1.5, 64);
    [peak, Extremum { value: -dip.value, ..dip }]
}

/// An extremum against its known place and height. Allowed: rounding for the height, `16ε`; for the place `8√ε`, beyond
/// which no comparison of values can tell places apart.
pub fn extremum_at(name: &str, found: Extremum, expected: Extremum) -> [Residual; 2] {
    let (height, place) = (16.0 * f64::EPSILON, 8.0 * f64::EPSILON.sqrt());
    [
        Residual::near(format!("{name}: height {:.7}", expected.value), found.value, expected.value, height),
        Residual::near(format!("{name}: at {:.7}", expected.at), found.at, expected.at, place),
    ]
}

/// The first maximum of the sinc interpolation of a step whose jump lies between samples: 14.114 % above it. (This and the
/// next two: zeros of the derivative of the digamma formula, to 25 digits by mpmath.)
pub const SAMPLED_PEAK: Extremum = Extremum { at: 0.417_735_568_770_086_9, value: 1.141_141_727_887_714_3 };
/// Its first minimum after that.
pub const SAMPLED_DIP: Extremum = Extremum { at: 1.453_184_358_142_219, value: 0.923_598_964_281_256_2 };
/// The maximum if a sample with the value ½ sits on the jump: 3.289 % above it.
pub const HALF_PEAK: Extremum = Extremum { at: 1.376_991_769_203_938_9, value: 1.032_891_944_133_224 };

/// Mean of the partial sums of the square wave (Fejér 1900): it never leaves −1 … 1.
fn fejer(terms: u32) -> impl Signal {
    let mean = move |x: f64| -> f64 {
        (1..=terms)
            .map(|k| {
                let (harmonic, amplitude) = Wave::Square.term(k);
                let taper = 1.0 - f64::from(k - 1) / f64::from(terms);
                taper * amplitude * sin_pi(2.0 * f64::from(harmonic) * x)
            })
            .sum()
    };
    from_fn(mean)
}

fn square(terms: u32) -> PartialSum {
    PartialSum::new(Wave::Square, terms, 1.0).expect("there are terms and the frequency is 1")
}

const PLACES: [f64; 7] = [-3.3, -0.7, 0.25, 0.5, 1.45, 7.9, 20.1];

/// The laws of this theme.
pub static LAWS: &[Law] = &[
    Law {
        name: "gibbs",
        inventory: &["V01", "F11"],
        says: &Text::fixed(
            "The partial sums of a square wave peak at (2/π)Si(π) = 1.17898, however many terms there are",
            "Частичные суммы ряда прямоугольной волны достигают (2/π)Si(π) = 1,17898 при любом числе членов",
        ),
        holds: || {
            let peaks = [1, 2, 3, 8, 64, 512].map(|n| fourier_peak(&square(n), n));
            let dips = [8, 64, 512].map(|n| fourier_dip(&square(n), n));
            peaks.into_iter().chain(dips).collect()
        },
        breaks: || [8, 64].map(|n| fourier_peak(&fejer(n), n)).into(),
    },
    Law {
        name: "sampled-step",
        inventory: &["V02", "E15", "F48"],
        says: &Text::fixed(
            "Sinc interpolation of a sampled step overshoots by 14.114 %, or by 3.289 % with ½ on the jump, not by 8.949 %",
            "Sinc-интерполяция отсчётов ступеньки даёт выброс 14,114 %, а с ½ на скачке 3,289 %, но не 8,949 %",
        ),
        holds: || {
            let [peak, dip] = ringing(&sampled_step(1.0));
            let [half, _] = ringing(&sampled_step(0.5));
            let at_half =
                Residual::near("s(½) = ½ + 2/π", Ideal.step_response(0.5), 0.5 + 2.0 / PI, 4.0 * f64::EPSILON);
            let mut measured = vec![step_is_sum(&Ideal, 4000, &PLACES), step_by_digamma(&sampled_step(1.0), &PLACES)];
            measured.push(step_is_sum(&Cubic::mitchell(), 64, &PLACES));
            measured.push(at_half);
            measured.extend(extremum_at("first peak", peak, SAMPLED_PEAK));
            measured.extend(extremum_at("first dip", dip, SAMPLED_DIP));
            measured.extend(extremum_at("with ½ on the jump", half, HALF_PEAK));
            measured
        },
        breaks: || {
            // the number for the continuous step, and a kernel that does not ring like that
            let [textbook, _] = ringing(&low_passed_step(0.5));
            let [mitchell, _] = ringing(&from_fn(|x| Cubic::mitchell().step_response(x)));
            let mut measured = vec![step_by_digamma(&from_fn(|x| Cubic::mitchell().step_response(x)), &[0.25, 0.5])];
            measured.extend(extremum_at("low-passed step", textbook, SAMPLED_PEAK));
            measured.extend(extremum_at("Mitchell", mitchell, SAMPLED_PEAK));
            measured
        },
    },
    Law {
        name: "low-passed-step",
        inventory: &["E15", "V01"],
        says: &Text::fixed(
            "Only the ideally low-passed continuous step overshoots by 8.949 %, half a period of the cut-off after the jump",
            "Выброс 8,949 % даёт лишь идеальная фильтрация непрерывной ступеньки, через полпериода частоты среза",
        ),
        holds: || {
            let overshoot = 0.089_489_872_236_083_64;
            let peak = |band| ringing(&low_passed_step(band))[0];
            vec![
                Residual::near("(½)(2Si(π)/π − 1)", 0.5 * (wilbraham_gibbs() - 1.0), overshoot, 4.0 * f64::EPSILON),
                Residual::near("overshoot at band ½", peak(0.5).value - 1.0, overshoot, 8.0 * f64::EPSILON),
                Residual::near("overshoot at band 2", peak(2.0).value - 1.0, overshoot, 8.0 * f64::EPSILON),
                Residual::near("place at band 2", peak(2.0).at, 0.25, 8.0 * f64::EPSILON.sqrt()),
            ]
        },
        breaks: || {
            let [sampled, _] = ringing(&sampled_step(1.0));
            vec![Residual::near("a sampled step", sampled.value - 1.0, 0.089_489_872_236_083_64, 8.0 * f64::EPSILON)]
        },
    },
];
