//! Boxes in time and in sampling: sample and hold (V28), the shutter (V29), uniform supersampling (V30).

use crate::axis::Axis;
use crate::error::Result;
use crate::kernel::Kernel;
use crate::kernel::box_kernel::BoxKernel;
use crate::kernel::tent::TentKernel;
use crate::laws::Law;
use crate::num::quadrature::{even_breaks, integrate_pieces};
use crate::num::{cos_pi, sin_pi, sinc};
use crate::reconstruct::reconstruct;
use crate::residual::Residual;
use crate::sampled::Samples;
use crate::signal::tone::Cosine;
use crate::signal::{Signal, from_fn};
use crate::text::Text;
use num_complex::Complex;
use std::f64::consts::PI;

/// V28: a tone at `f = cycles/samples` of the rate, sampled and held, has its first image at `1 − f` with the amplitude
/// `f/(1−f)` of the base: `sinc(1−f)/sinc(f)`, exactly.
///
/// Measured on the reconstruction by `kernel` itself: the ratio of its Fourier coefficients over one period of `samples`
/// steps, by quadrature between the halves of the steps, against the hold's `f/(1−f)`. Allowed: the errors of both
/// integrals, relative to the base.
///
/// ```
/// use nyquist::laws::hold::held_image;
/// use nyquist::prelude::*;
/// assert!(held_image(&BoxKernel, 1, 10)?.holds()); // 1/9
/// assert!(!held_image(&TentKernel, 1, 10)?.holds()); // 1/81
/// # Ok::<(), Error>(())
/// ```
///
/// # Errors
/// No samples, no cycles.
pub fn held_image(kernel: &(impl Kernel + ?Sized), cycles: u32, samples: u32) -> Result<Residual> {
    let n = f64::from(samples);
    let f = f64::from(cycles) / n;
    let record = Samples::of(&Cosine::with_phase(f, 0.3)?, Axis::new(0.0, 1.0, samples as usize)?);
    let held = reconstruct(&record, kernel).edge(crate::axis::Edge::Wrap);
    let breaks = even_breaks(0.0, n, 0.5);
    let coefficient = |nu: f64| {
        let wave = |x: f64| Complex::new(cos_pi(2.0 * nu * x), -sin_pi(2.0 * nu * x)) * held.at(x);
        integrate_pieces(wave, &breaks, 1e-14)
    };
    let (base, image) = (coefficient(f), coefficient(1.0 - f));
    let size = base.value.norm();
    let bound = 2.0 * (base.error + image.error) / size;
    let law = format!("image/base of a tone at {f} = f/(1−f)");
    Ok(Residual::near(law, image.value.norm() / size, f / (1.0 - f), bound))
}

/// V29: a shutter open for `tau` is a prefilter in time: of a tone at `frequency` it keeps `sinc(frequency·tau)`.
///
/// Measured: the amplitude of `(1/τ)∫_{t−τ/2}^{t+τ/2} cos(2πfs) ds` by quadrature at two times a quarter period apart,
/// against the closed form. Allowed: the error of both integrals.
///
/// ```
/// // a wheel's spokes at 23.2 Hz before 24 frames a second with half-open shutter: 0.658 is left, and folds to −0.8 Hz
/// let residual = nyquist::laws::hold::shutter(23.2, 1.0 / 48.0, nyquist::num::sinc(23.2 / 48.0))?;
/// assert!(residual.holds() && (nyquist::num::sinc(23.2 / 48.0) - 0.658).abs() < 5e-4);
/// # Ok::<(), nyquist::error::Error>(())
/// ```
///
/// # Errors
/// A frequency or an opening time that is not positive and finite.
pub fn shutter(frequency: f64, tau: f64, expected: f64) -> Result<Residual> {
    let tone = Cosine::new(frequency)?;
    crate::error::positive("the opening time of a shutter", tau)?;
    let exposed = |t: f64| {
        let breaks = even_breaks(t - 0.5 * tau, t + 0.5 * tau, 0.25 / frequency);
        let light = integrate_pieces(|s| tone.at(s), &breaks, 1e-16 * tau);
        (light.value / tau, light.error / tau)
    };
    // the mean is real and even: the whole amplitude shows at t = 0, and nothing a quarter period later
    let ((top, error), (zero, other)) = (exposed(0.0), exposed(0.25 / frequency));
    let law = format!("a shutter of {tau} keeps sinc(fτ) of a tone at {frequency}");
    Ok(Residual::at_most(law, (top - expected).abs().max(zero.abs()), error.max(other) + 4.0 * f64::EPSILON))
}

/// `D(ν) = sin(πν)/(n·sin(πν/n))`: the transfer of `n` equally weighted samples a cell, ν in cycles per cell. One at the
/// multiples of `n` (but for the sign), where its replicas leave everything through.
///
/// ```
/// use nyquist::laws::hold::uniform_transfer;
/// use nyquist::num::sinc;
/// // four samples a pixel let 3.9 cycles a pixel pass almost untouched, which the pixel's box would stop (E13)
/// assert!((uniform_transfer(4, 3.9) + 0.98464).abs() < 5e-6 && (sinc(3.9) + 0.02522).abs() < 5e-6);
/// ```
pub fn uniform_transfer(n: u32, nu: f64) -> f64 {
    let n = f64::from(n.max(1));
    let turns = (nu / n).round();
    let rest = nu - turns * n; // to the nearest multiple of n
    let sign = if (turns * (n - 1.0)).rem_euclid(2.0) == 0.0 { 1.0 } else { -1.0 };
    sign * sinc(rest) / sinc(rest / n)
}

/// V30: the mean of `n` equally spaced samples a cell, of a tone at `nu` cycles a cell, is `D(ν)` times the tone at the middle.
///
/// Measured: the difference between that mean, taken at the places `(j+½)/n − ½`, and the closed form. Allowed: the rounding
/// of `n` cosines and of their sum.
pub fn supersampled_tone(n: u32, nu: f64, transfer: f64) -> Residual {
    let count = f64::from(n.max(1));
    let mean = (0..n).map(|j| cos_pi(2.0 * nu * ((f64::from(j) + 0.5) / count - 0.5))).sum::<f64>() / count;
    let bound = f64::EPSILON * (count + 4.0 * PI * nu.abs() + 8.0);
    Residual::near(format!("{n} taps at {nu}"), mean, transfer, bound)
}

/// V30: for fixed `ν` the transfer of `n` taps converges to the box's `sinc(ν)`, like `n⁻²`.
///
/// `D = sinc(ν)/sinc(ν/n)`, and with `y = πν/n ≤ π/2`, `y/sin y − 1 ≤ (4/π²)(π/2 − 1)·y²`, because `(y/sin y − 1)/y²` rises.
/// Measured: `|D − sinc ν|`; allowed: that, and rounding.
pub fn taps_converge(n: u32, nu: f64) -> Residual {
    let y = PI * nu / f64::from(n.max(1));
    let bound = sinc(nu).abs() * 4.0 / (PI * PI) * (0.5 * PI - 1.0) * y * y + 8.0 * f64::EPSILON;
    Residual::near(format!("{n} taps at {nu} → sinc"), uniform_transfer(n, nu), sinc(nu), bound)
}

/// The laws of this theme.
pub static LAWS: &[Law] = &[
    Law {
        name: "hold-image",
        inventory: &["V28", "F02"],
        says: &Text::fixed(
            "Sample and hold leaves the first image of a tone at f with f/(1−f) of its amplitude",
            "Выборка с удержанием оставляет первую копию тона f с долей f/(1−f) его амплитуды",
        ),
        holds: || [(1, 10), (1, 4), (2, 5), (3, 16)].map(|(p, q)| held_image(&BoxKernel, p, q).expect("q > p")).into(),
        breaks: || [(1, 10), (1, 4), (2, 5)].map(|(p, q)| held_image(&TentKernel, p, q).expect("q > p")).into(),
    },
    Law {
        name: "shutter",
        inventory: &["V29", "F03"],
        says: &Text::fixed(
            "An open shutter damps a tone by sinc(fτ): motion blur lessens strobing and does not remove it",
            "Открытый затвор ослабляет тон в sinc(fτ) раз: смаз уменьшает стробоскопический эффект, но не устраняет",
        ),
        holds: || {
            [(23.2, 1.0 / 48.0), (23.2, 1.0 / 24.0), (5.0, 0.1), (5.0, 0.2)]
                .map(|(f, tau)| shutter(f, tau, sinc(f * tau)).expect("positive"))
                .into()
        },
        breaks: || {
            vec![
                // strobing removed altogether
                shutter(23.2, 1.0 / 48.0, 0.0).expect("positive"),
                // the shutter's opening taken for the time between frames
                shutter(23.2, 1.0 / 48.0, sinc(23.2 / 24.0)).expect("positive"),
            ]
        },
    },
    Law {
        name: "uniform-supersampling",
        inventory: &["V30", "F33", "E13"],
        says: &Text::fixed(
            "n equal samples a pixel have the transfer sin(πν)/(n·sin(πν/n)): near the box for small ν, one at ν = n",
            "n равных отсчётов на пиксель имеют передачу sin(πν)/(n·sin(πν/n)): при малых ν как прямоугольник, при ν = n единица",
        ),
        holds: || {
            let taps = [1, 2, 4, 5, 16];
            let each = |n| [0.3, 1.0, 3.9, 4.0, 17.3].map(|nu| supersampled_tone(n, nu, uniform_transfer(n, nu)));
            let mut measured: Vec<Residual> = taps.into_iter().flat_map(each).collect();
            measured.extend([2, 4, 16, 64].into_iter().map(|n| taps_converge(n, 0.9)));
            measured.push(Residual::near("D(3.9), n = 4", uniform_transfer(4, 3.9), -0.984_64, 5e-6));
            measured.push(Residual::near("sinc(3.9)", sinc(3.9), -0.025_22, 5e-6));
            measured
        },
        breaks: || {
            // supersampling taken for area sampling; and the limit taken where it is none
            let area = from_fn(sinc);
            let mut measured: Vec<Residual> = [3.9, 17.3].map(|nu| supersampled_tone(4, nu, area.at(nu))).into();
            measured.extend([4, 16].map(|n| {
                let replica = uniform_transfer(n, f64::from(n)).abs();
                Residual::near(format!("{n} taps at {n} → sinc"), replica, sinc(f64::from(n)), 8.0 * f64::EPSILON)
            }));
            measured
        },
    },
];
