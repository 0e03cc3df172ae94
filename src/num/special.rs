//! Special functions of sampling theory: the sine integral, the digamma function and its alternating sister, the
//! Bessel function I₀.

use crate::num::{cos_pi, sin_pi};
use num_complex::Complex;
use std::f64::consts::{FRAC_PI_2, PI};

/// The sine integral `Si(x) = ∫₀ˣ sin(t)/t dt`; odd, and `±π/2` at infinity.
///
/// It is what ringing is made of: the partial sums of a square wave peak at `(2/π)·Si(π)` (Wilbraham 1848), and the
/// response of a Lanczos kernel is a sum of eight of it.
///
/// Up to `|x| = 4` the power series `Σ (−1)ⁿ x²ⁿ⁺¹/((2n+1)(2n+1)!)`, whose terms stay below 3.6 there; beyond,
/// `π/2 + Im E₁(ix)` with the continued fraction of the exponential integral (DLMF 6.9.1) by Lentz's method (1976).
/// Absolute error below 4ε.
///
/// ```
/// use nyquist::num::special::si;
/// let gibbs = 2.0 / std::f64::consts::PI * si(std::f64::consts::PI);
/// assert!((gibbs - 1.178_979_744_472_167).abs() < 1e-15);
/// ```
pub fn si(x: f64) -> f64 {
    if x.is_infinite() {
        return FRAC_PI_2.copysign(x);
    }
    if x.abs() <= 4.0 {
        let (mut power, mut sum) = (x, x); // power = (−1)ⁿ x²ⁿ⁺¹/(2n+1)!
        for n in 1..24 {
            let odd = f64::from(2 * n + 1);
            power *= -x * x / (odd * (odd - 1.0));
            sum += power / odd;
        }
        return sum;
    }
    if x.is_nan() {
        return x;
    }
    let ix = Complex::new(0.0, x.abs());
    let e1 = Complex::cis(-x.abs()) * e1_fraction(ix);
    (FRAC_PI_2 + e1.im).copysign(x)
}

/// `e^z E₁(z) = 1/(z+1 − 1/(z+3 − 4/(z+5 − …)))`, for `|z| ≥ 4` away from the negative real axis.
fn e1_fraction(z: Complex<f64>) -> Complex<f64> {
    let mut b = z + 1.0;
    let mut d = b.inv();
    let (mut c, mut h) = (Complex::from(1e300), d);
    for i in 1..200 {
        let a = -f64::from(i * i);
        b += 2.0;
        d = (d * a + b).inv();
        c = b + a / c;
        let factor = c * d;
        h *= factor;
        if (factor - 1.0).norm() < f64::EPSILON {
            break;
        }
    }
    h
}

/// The digamma function `ψ(x) = Γ′(x)/Γ(x)`; NaN at its poles `0, −1, −2, …`.
///
/// The recurrence `ψ(x) = ψ(x+1) − 1/x` up to `x ≥ 12`, then the asymptotic series `ln x − 1/2x − Σ B₂ₖ/(2k x²ᵏ)` with
/// seven terms, of which the next is `3·10⁻¹⁸` (Abramowitz & Stegun 6.3.5, 6.3.18); for negative arguments the reflection
/// `ψ(1−x) = ψ(x) + π·cot(πx)` (6.3.7). Absolute error below `16ε·max(1, |ψ|)` away from the poles.
///
/// ```
/// use nyquist::num::special::digamma;
/// assert!((digamma(1.0) + 0.577_215_664_901_532_9).abs() < 1e-15); // −γ, Euler's constant
/// assert!(digamma(-3.0).is_nan());
/// ```
pub fn digamma(x: f64) -> f64 {
    if x <= 0.0 {
        let (s, c) = (sin_pi(x), cos_pi(x));
        return if s == 0.0 { f64::NAN } else { digamma(1.0 - x) - PI * c / s };
    }
    let (mut x, mut sum) = (x, 0.0);
    while x < 12.0 {
        sum -= 1.0 / x;
        x += 1.0;
    }
    // B₂ₖ/2k for k = 1…7
    const TERMS: [f64; 7] =
        [1.0 / 12.0, -1.0 / 120.0, 1.0 / 252.0, -1.0 / 240.0, 1.0 / 132.0, -691.0 / 32_760.0, 1.0 / 12.0];
    let u = 1.0 / (x * x);
    let series = TERMS.iter().rev().fold(0.0, |tail, term| (tail + term) * u);
    sum + x.ln() - 0.5 / x - series
}

/// Stirling's beta function `β(a) = Σ_{k≥0} (−1)ᵏ/(a+k) = ½[ψ((a+1)/2) − ψ(a/2)]` for `a > 0`; NaN elsewhere.
///
/// The tail of every cardinal series of constant samples: `Σ_{k≥0} sinc(x−k) = 1 + sin(πx)/π·β(1+x)` for `x > −1`.
/// Computed by the recurrence `β(a) = 1/a − β(a+1)` up to `a ≥ 25` and Boole's summation formula there (DLMF 24.17.1),
/// whose next term is 10⁻¹⁸; the difference of two digammas would lose `log a` digits to cancellation. Relative error
/// below 16ε.
///
/// ```
/// use nyquist::num::special::stirling_beta;
/// assert!((stirling_beta(1.0) - 2.0f64.ln()).abs() < 1e-15); // 1 − 1/2 + 1/3 − …
/// assert!((stirling_beta(0.5) - std::f64::consts::FRAC_PI_2).abs() < 1e-15); // 2(1 − 1/3 + 1/5 − …), Leibniz
/// ```
pub fn stirling_beta(a: f64) -> f64 {
    if !matches!(a.partial_cmp(&0.0), Some(std::cmp::Ordering::Greater)) {
        return f64::NAN;
    }
    if a == f64::INFINITY {
        return 0.0;
    }
    let steps = (25.0 - a).ceil().max(0.0);
    let top = a + steps;
    // ½·Eₙ(0)·(−1)ⁿ for n = 13, 11, …, 1: Euler polynomials at zero
    const TERMS: [f64; 7] = [5461.0 / 4.0, -691.0 / 8.0, 31.0 / 4.0, -17.0 / 16.0, 0.25, -0.125, 0.25];
    let u = 1.0 / (top * top);
    let tail = 0.5 / top + TERMS.iter().fold(0.0, |sum, term| (sum * u) + term) * u;
    // from the smallest term up: β(a) = 1/a − (1/(a+1) − (… − β(top)))
    (0..steps as usize).rev().fold(tail, |beta, k| 1.0 / (a + k as f64) - beta)
}

/// The modified Bessel function of the first kind, `I₀(x) = Σ (x²/4)ᵏ/(k!)²`: the Kaiser window is made of it.
///
/// All terms of the series are positive, so nothing cancels: relative error below `(|x| + 8)·ε`. Beyond `|x| = 713` it
/// overflows to infinity, as the function does in `f64`.
///
/// ```
/// use nyquist::num::special::bessel_i0;
/// assert_eq!(bessel_i0(0.0), 1.0);
/// assert!((bessel_i0(2.0) - 2.279_585_302_336_067).abs() < 1e-15); // Abramowitz & Stegun, table 9.8
/// ```
pub fn bessel_i0(x: f64) -> f64 {
    if x.is_nan() || x.abs() > 713.9 {
        return if x.is_nan() { x } else { f64::INFINITY };
    }
    let quarter = 0.25 * x * x;
    let (mut term, mut sum, mut k) = (1.0, 1.0, 1.0);
    while term > 0.25 * f64::EPSILON * sum {
        term *= quarter / (k * k);
        sum += term;
        k += 1.0;
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Values to 20 digits by mpmath 1.3 (Johansson), functions `si`, `psi`, `besseli`; they agree with the tables of
    /// Abramowitz & Stegun (5.1, 6.1, 9.8) as far as those go.
    #[test]
    fn si_agrees_with_published_values() {
        let table = [
            (0.5, 0.493_107_418_043_066_7),
            (1.0, 0.946_083_070_367_183),
            (2.0, 1.605_412_976_802_694_8),
            (3.9, 1.776_501_360_447_805_5),
            (4.0, 1.758_203_138_949_053),
            (4.1, 1.738_743_626_491_769),
            (5.0, 1.549_931_244_944_674),
            (10.0, 1.658_347_594_218_874),
            (31.4, 1.539_033_117_894_597_8),
            (100.0, 1.562_225_466_889_056_3),
            (1e6, 1.570_795_390_043_119),
        ];
        for (x, expected) in table {
            assert!((si(x) - expected).abs() <= 4.0 * f64::EPSILON, "Si({x}) = {} ≠ {expected}", si(x));
            assert_eq!(si(-x), -si(x));
        }
        assert_eq!((si(f64::INFINITY), si(f64::NEG_INFINITY)), (FRAC_PI_2, -FRAC_PI_2));
        assert!(si(f64::NAN).is_nan());
    }

    #[test]
    fn digamma_agrees_with_published_values() {
        let table = [
            (1.0, -0.577_215_664_901_532_9),
            (0.5, -1.963_510_026_021_423_5),
            (0.1, -10.423_754_940_411_076),
            (2.5, 0.703_156_640_645_243_2),
            (10.0, 2.251_752_589_066_721),
            (1e-3, -1_000.575_571_931_810_3),
            (-0.5, 0.036_489_973_978_576_52),
            (-3.3, 3.620_353_460_592_123),
            (100.0, 4.600_161_852_738_087),
            (1.461_632_144_968_362_3, 0.0), // its positive zero, to rounding
        ];
        for (x, expected) in table {
            let bound = 16.0 * f64::EPSILON * f64::abs(expected).max(1.0);
            assert!((digamma(x) - expected).abs() <= bound, "ψ({x}) = {} ≠ {expected}", digamma(x));
        }
        assert!(digamma(0.0).is_nan() && digamma(-7.0).is_nan() && digamma(f64::NAN).is_nan());
    }

    #[test]
    fn beta_is_half_the_difference_of_two_digammas() {
        let table = [
            (0.01, 99.314_988_272_915_76),
            (1.5, 0.429_203_673_205_103_4),
            (7.25, 0.073_678_114_563_360_95),
            (100.0, 0.005_024_998_750_249_894),
        ];
        for (a, expected) in table {
            let beta = stirling_beta(a);
            assert!((beta / expected - 1.0).abs() <= 16.0 * f64::EPSILON, "β({a}) = {beta} ≠ {expected}");
            let digammas = 0.5 * (digamma(0.5 * (a + 1.0)) - digamma(0.5 * a));
            assert!((beta - digammas).abs() <= 32.0 * f64::EPSILON * digamma(0.5 * a).abs().max(1.0));
        }
        assert!(stirling_beta(0.0).is_nan() && stirling_beta(-0.5).is_nan() && stirling_beta(f64::NAN).is_nan());
        assert_eq!(stirling_beta(f64::INFINITY), 0.0);
    }

    #[test]
    fn bessel_i0_agrees_with_published_values() {
        let table = [
            (0.1, 1.002_501_562_934_095_6),
            (1.0, 1.266_065_877_752_008_4),
            (5.0, 27.239_871_823_604_447),
            (8.0, 427.564_115_721_804_8),
            (10.0, 2_815.716_628_466_254_3),
            (30.0, 781_672_297_823.977_5),
            (100.0, 1.073_751_707_131_073_8e42),
            (700.0, 1.529_593_347_671_873_7e302),
        ];
        for (x, expected) in table {
            let bound = (x + 8.0) * f64::EPSILON;
            assert!((bessel_i0(x) / expected - 1.0).abs() <= bound, "I₀({x}) = {}", bessel_i0(x));
            assert_eq!(bessel_i0(-x), bessel_i0(x));
        }
        assert!(bessel_i0(f64::NAN).is_nan() && bessel_i0(800.0).is_infinite());
    }
}
