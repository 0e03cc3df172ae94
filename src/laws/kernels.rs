//! What kernels claim, and what they are silent about; and that their responses are their transforms (V04, V05).

use crate::kernel::catalog;
use crate::kernel::cubic::Cubic;
use crate::kernel::gaussian::GaussianKernel;
use crate::kernel::lanczos::Lanczos;
use crate::kernel::tent::TentKernel;
use crate::kernel::{Claims, Kernel};
use crate::laws::Law;
use crate::num::quadrature::{Integral, even_breaks, integrate_pieces};
use crate::residual::Residual;
use crate::signal::Signal;
use crate::text::Text;
use std::f64::consts::PI;

/// How many samples to either side are summed for a kernel of infinite radius.
const TERMS: i64 = 4000;

/// Places within one step at which sums over all samples are looked at; they do not hit the symmetric ones only.
pub(crate) fn places() -> impl Iterator<Item = f64> {
    (0..=48).map(|i| f64::from(i) / 96.0)
}

/// `∫ k(t)·g(t) dt` by quadrature, with breaks on every kink of the library's kernels (halves of the radius) and at most
/// half a period of `cos(2πνt)` a piece.
fn integral(kernel: &(impl Kernel + ?Sized), nu: f64, g: impl Fn(f64) -> f64) -> Integral {
    let radius = kernel.radius();
    let pieces = 2.0 * (radius * (1.0 + nu.abs())).ceil();
    integrate_pieces(|t| kernel.at(t) * g(t), &even_breaks(-radius, radius, radius / pieces), 1e-15)
}

/// `Σ_i i^p k(x−i)` and its rounding: `ε·n·Σ|i^p k|` for `n` terms, each of which is wrong by a few ε itself (Higham 2002,
/// §4.2). For an infinite radius the symmetric sum over `|i| ≤ 4000`; of `Σ sinc(x−i)` the pairs left out alternate and
/// fall, so their sum is below the first, `2|x|/(π·4000²)`.
pub(crate) fn moment(kernel: &(impl Kernel + ?Sized), power: i32, x: f64) -> (f64, f64) {
    let radius = kernel.radius();
    let (reach, tail) = if radius.is_finite() {
        (radius.ceil() as i64 + 1, 0.0)
    } else {
        (TERMS, 2.0 * x.abs() / (PI * (TERMS as f64).powi(2)))
    };
    let term = |i: i64| (i as f64).powi(power) * kernel.at(x - i as f64);
    let sum: f64 = (-reach..=reach).map(term).sum();
    let size: f64 = (-reach..=reach).map(|i| term(i).abs()).sum();
    (sum, 4.0 * f64::EPSILON * (2.0 * radius.min(16.0) + 2.0) * size.max(1.0) + tail)
}

/// `max_x |Σ_i i^p k(x−i) − x^p|` over the places of a step.
fn order(law: &'static str, kernel: &(impl Kernel + ?Sized), power: i32) -> Residual {
    let (mut measured, mut bound) = (0.0f64, 0.0f64);
    for x in places() {
        let (sum, rounding) = moment(kernel, power, x);
        measured = measured.max((sum - x.powi(power)).abs());
        bound = bound.max(rounding);
    }
    Residual::at_most(law, measured, bound)
}

/// `k(−t) = k(t)`, without any rounding.
pub fn even(kernel: &(impl Kernel + ?Sized)) -> Residual {
    let worst =
        (0..=500).map(|i| f64::from(i) / 97.0).map(|t| (kernel.at(t) - kernel.at(-t)).abs()).fold(0.0, f64::max);
    Residual::at_most("k(−t) = k(t)", worst, 0.0)
}

/// `k(t) = 0` for `|t|` beyond a finite radius, exactly.
pub fn zero_past_radius(kernel: &(impl Kernel + ?Sized)) -> Residual {
    let radius = kernel.radius();
    let beyond = (1..=100).map(|i| radius * (1.0 + f64::EPSILON) + f64::from(i - 1) / 17.0);
    let worst = beyond.map(|t| kernel.at(t).abs()).fold(0.0, f64::max);
    Residual::at_most("k = 0 past the radius", worst, 0.0)
}

/// The response is the transform: `K(ν) = ∫ k(t) cos(2πνt) dt`, by quadrature.
///
/// Allowed: the quadrature's error estimate and the rounding of the closed forms, `64ε(1 + |ν|·radius)`. For a kernel of
/// infinite radius the way back is checked, `k(t) = ∫_{−8}^{8} K(ν) cos(2πνt) dν` at `t = ν`.
///
/// ```
/// use nyquist::laws::kernels::response_is_transform;
/// use nyquist::prelude::*;
/// assert!(response_is_transform(&Lanczos::new(3.0)?, &[0.0, 0.5, 1.3]).holds());
/// # Ok::<(), Error>(())
/// ```
pub fn response_is_transform(kernel: &(impl Kernel + ?Sized), frequencies: &[f64]) -> Residual {
    let (mut measured, mut bound) = (0.0f64, 0.0f64);
    for &nu in frequencies {
        let wave = |t: f64| (2.0 * PI * nu * t).cos();
        let (sum, value, reach) = if kernel.radius().is_finite() {
            (integral(kernel, nu, wave), kernel.response(nu), kernel.radius())
        } else {
            let breaks = even_breaks(-8.0, 8.0, 0.5 / nu.abs().max(1.0).ceil());
            (integrate_pieces(|f| kernel.response(f) * wave(f), &breaks, 1e-15), kernel.at(nu), 8.0)
        };
        measured = measured.max((sum.value - value).abs());
        bound = bound.max(sum.error + 64.0 * f64::EPSILON * (1.0 + nu.abs() * reach));
    }
    Residual::at_most("response = transform of the value", measured, bound)
}

/// `k(0) = 1` and `k(i) = 0`: the reconstruction passes through the samples. Allowed: ε.
pub fn interpolating(kernel: &(impl Kernel + ?Sized)) -> Residual {
    let reach = kernel.radius().min(64.0).ceil() as i64;
    let deviation = |i: i64| (kernel.at(i as f64) - if i == 0 { 1.0 } else { 0.0 }).abs();
    Residual::at_most("k(i) = δ", (-reach..=reach).map(deviation).fold(0.0, f64::max), f64::EPSILON)
}

/// `∫ k = 1`: the mean is kept. Allowed: the error of the quadrature; for an infinite radius the response at zero is taken
/// at its word.
pub fn unit_gain(kernel: &(impl Kernel + ?Sized)) -> Residual {
    let law = "∫k = 1";
    if kernel.radius().is_infinite() {
        return Residual::near(law, kernel.response(0.0), 1.0, 0.0);
    }
    let sum = integral(kernel, 0.0, |_| 1.0);
    Residual::near(law, sum.value, 1.0, sum.error + 4.0 * f64::EPSILON)
}

/// `Σ_i k(x−i) = 1`: constants are reproduced. For the cubics it holds for all `(B, C)` (Mitchell & Netravali 1988).
pub fn reproduces_constants(kernel: &(impl Kernel + ?Sized)) -> Residual {
    order("Σk(x−i) = 1", kernel, 0)
}

/// `Σ_i i·k(x−i) = x`: straight lines are reproduced. For the cubics if and only if `B + 2C = 1` (Strang & Fix 1971; Keys
/// 1981).
///
/// ```
/// use nyquist::laws::kernels::reproduces_lines;
/// use nyquist::prelude::*;
/// assert!(reproduces_lines(&Cubic::new(0.4, 0.3)?).holds());
/// assert!((reproduces_lines(&Cubic::new(0.0, 0.0)?).measured - 0.096).abs() < 5e-4);
/// # Ok::<(), Error>(())
/// ```
pub fn reproduces_lines(kernel: &(impl Kernel + ?Sized)) -> Residual {
    order("Σi·k(x−i) = x", kernel, 1)
}

/// `k ≥ 0`, at 997 places within the radius.
pub fn nonnegative(kernel: &(impl Kernel + ?Sized)) -> Residual {
    let radius = kernel.radius().min(16.0);
    let least = (0..=997).map(|i| kernel.at(radius * f64::from(i) / 997.0)).fold(f64::INFINITY, f64::min);
    Residual::at_most("k ≥ 0", (-least).max(0.0), 0.0)
}

/// The five claims in the order of [`Claims`], each with what is measured.
fn checks(kernel: &(impl Kernel + ?Sized)) -> [(bool, Residual); 5] {
    let Claims { interpolating: a, unit_gain: b, reproduces_constants: c, reproduces_lines: d, nonnegative: e } =
        kernel.claims();
    [
        (a, interpolating(kernel)),
        (b, unit_gain(kernel)),
        (c, reproduces_constants(kernel)),
        (d, reproduces_lines(kernel)),
        (e, nonnegative(kernel)),
    ]
}

/// Everything that the kernel claims of itself, measured.
///
/// ```
/// use nyquist::laws::kernels::claims;
/// use nyquist::prelude::*;
/// assert_eq!(claims(&TentKernel).len(), 5); // it claims everything
/// assert!(claims(&TentKernel).iter().all(|claim| claim.holds()));
/// ```
pub fn claims(kernel: &(impl Kernel + ?Sized)) -> Vec<Residual> {
    let named = |r: Residual| Residual { law: format!("{} claims {}", kernel.name(), r.law).into(), ..r };
    checks(kernel).into_iter().filter(|check| check.0).map(|check| named(check.1)).collect()
}

/// Everything that the kernel does not claim: it must fail, by more than rounding, or the kernel is too modest.
///
/// Measured: by how much the deviation falls short of the bound that it must exceed.
pub fn silences(kernel: &(impl Kernel + ?Sized)) -> Vec<Residual> {
    let must_fail = |r: Residual| {
        let least = (2.0 * r.bound).max(f64::MIN_POSITIVE);
        Residual::at_least(format!("{} does not claim {}, and it fails", kernel.name(), r.law), r.measured, least)
    };
    checks(kernel).into_iter().filter(|check| !check.0).map(|check| must_fail(check.1)).collect()
}

/// A kernel that says something else about itself: what the laws must catch.
struct Saying<K> {
    kernel: K,
    claims: Claims,
    shift: f64,
    gain: f64,
}

impl<K: Kernel> Signal for Saying<K> {
    fn at(&self, t: f64) -> f64 {
        self.kernel.at(t + self.shift)
    }
}

impl<K: Kernel> Kernel for Saying<K> {
    fn name(&self) -> String {
        format!("false {}", self.kernel.name())
    }
    fn radius(&self) -> f64 {
        self.kernel.radius()
    }
    fn claims(&self) -> Claims {
        self.claims
    }
    fn response(&self, nu: f64) -> f64 {
        self.kernel.response(nu) * self.gain
    }
}

const NOTHING: Claims = Claims {
    interpolating: false,
    unit_gain: false,
    reproduces_constants: false,
    reproduces_lines: false,
    nonnegative: false,
};

fn lanczos3() -> Lanczos {
    Lanczos::new(3.0).expect("three lobes are allowed")
}

/// Frequencies at which responses are compared: nearly zero, Nyquist, the rate, and far beyond.
pub(crate) const FREQUENCIES: [f64; 9] = [0.0, 1e-3, 0.25, 0.5, 0.75, 1.0, 1.5, 2.7, 10.3];

/// The laws of this theme.
pub static LAWS: &[Law] = &[
    Law {
        name: "kernel-claims",
        inventory: &["V05"],
        says: &Text::fixed(
            "What a kernel claims of itself is true: interpolation, unit gain, constants, lines, sign",
            "То, что ядро о себе заявляет, верно: интерполяция, единичное усиление, константы, прямые, знак",
        ),
        holds: || catalog::all().iter().flat_map(|kernel| claims(&**kernel)).collect(),
        breaks: || {
            vec![
                interpolating(&Cubic::mitchell()),
                unit_gain(&lanczos3()),
                reproduces_constants(&GaussianKernel::pbrt4()),
                reproduces_lines(&Cubic::new(0.0, 0.0).expect("B and C are small")),
                nonnegative(&Cubic::catmull_rom()),
            ]
        },
    },
    Law {
        name: "kernel-silences",
        inventory: &["V05"],
        says: &Text::fixed(
            "What a kernel does not claim of itself is false: no kernel is too modest",
            "То, чего ядро о себе не заявляет, неверно: лишней скромности нет",
        ),
        holds: || catalog::all().iter().flat_map(|kernel| silences(&**kernel)).collect(),
        breaks: || silences(&Saying { kernel: TentKernel, claims: NOTHING, shift: 0.0, gain: 1.0 }),
    },
    Law {
        name: "kernel-response",
        inventory: &["V04"],
        says: &Text::fixed(
            "A kernel's response is the transform of its value, and outside its radius it is zero",
            "Отклик ядра есть преобразование его значений, а за радиусом ядро равно нулю",
        ),
        holds: || {
            let kernels = catalog::all();
            let shapes = kernels.iter().flat_map(|k| [even(&**k), response_is_transform(&**k, &FREQUENCIES)]);
            let ends = kernels.iter().filter(|k| k.radius().is_finite()).map(|k| zero_past_radius(&**k));
            shapes.chain(ends).collect()
        },
        breaks: || {
            let moved = Saying { kernel: TentKernel, claims: NOTHING, shift: -0.1, gain: 1.0 };
            let louder = Saying { kernel: lanczos3(), claims: NOTHING, shift: 0.0, gain: 1.0 / 0.997 };
            vec![even(&moved), zero_past_radius(&moved), response_is_transform(&louder, &FREQUENCIES)]
        },
    },
];
