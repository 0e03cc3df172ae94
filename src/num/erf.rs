//! The error function: the integral of a Gaussian.

use crate::num::faddeeva::faddeeva;
use num_complex::Complex;
use std::f64::consts::PI;

/// `erf(x) = (2/√π) ∫₀ˣ e^{−t²} dt`; odd, and ±1 at infinity.
///
/// Up to `|x| = 1` the power series `(2/√π) Σ (−1)ⁿ x²ⁿ⁺¹/(n!(2n+1))`, beyond `1 − erfc(x)`. Absolute error below 4ε.
///
/// ```
/// use nyquist::num::erf::erf;
/// assert!((erf(1.0) - 0.842_700_792_949_714_9).abs() < 1e-15); // Abramowitz & Stegun, table 7.1
/// assert_eq!((erf(0.0), erf(f64::INFINITY)), (0.0, 1.0));
/// ```
pub fn erf(x: f64) -> f64 {
    if x.abs() > 1.0 {
        return (1.0 - erfc(x.abs())).copysign(x);
    }
    // power = (−1)ⁿ x²ⁿ⁺¹/n!; the twentieth term is below ε at 1
    let (mut power, mut sum) = (x, x);
    for n in 1..22 {
        let n = f64::from(n);
        power *= -x * x / n;
        sum += power / (2.0 * n + 1.0);
    }
    2.0 / PI.sqrt() * sum
}

/// `erfc(x) = 1 − erf(x)`, without the cancellation: `e^{−x²} w(ix)` with the [Faddeeva function](faddeeva) for `x > 0`.
///
/// Relative error below `ε·(4 + 2x²)`: that of the exponential's argument.
///
/// ```
/// use nyquist::num::erf::erfc;
/// assert!((erfc(5.0) / 1.537_459_794_428_035e-12 - 1.0).abs() < 1e-14);
/// ```
pub fn erfc(x: f64) -> f64 {
    if x.is_nan() {
        x
    } else if x < 0.0 {
        2.0 - erfc(-x)
    } else if x > 27.3 {
        0.0 // e^{−x²} is below the least number
    } else {
        (-x * x).exp() * faddeeva(Complex::new(0.0, x)).re
    }
}

/// The mean of `e^{−t²}` between `a` and `b`: `(√π/2)·(erf b − erf a)/(b − a)`, and `e^{−a²}` where they meet.
///
/// The difference is taken of whichever of `erf` and `erfc` is small at both ends; what rounding leaves is below
/// `8ε/|b − a|`, absolutely.
pub fn gaussian_mean(a: f64, b: f64) -> f64 {
    let (a, b) = if a <= b { (a, b) } else { (b, a) };
    if a.is_infinite() || b.is_infinite() {
        return 0.0;
    }
    // at this width the mean differs from the value in the middle by (b−a)²/12 at most, below ε/8
    if b - a < 1e-8 {
        return (-0.25 * (a + b) * (a + b)).exp();
    }
    let difference = match (a > 0.5, b < -0.5) {
        (true, _) => erfc(a) - erfc(b),
        (_, true) => erfc(-b) - erfc(-a),
        _ => erf(b) - erf(a),
    };
    0.5 * PI.sqrt() * difference / (b - a)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Values to 20 digits by mpmath 1.3.
    #[test]
    fn agrees_with_published_values() {
        let table = [
            (1e-10, 1.128_379_167_095_512_6e-10),
            (0.25, 0.276_326_390_168_236_93),
            (0.5, 0.520_499_877_813_046_5),
            (0.99, 0.838_508_069_555_369_8),
            (1.01, 0.846_810_496_228_276_8),
            (2.0, 0.995_322_265_018_952_7),
            (3.5, 0.999_999_256_901_627_6),
            (6.0, 1.0),
        ];
        for (x, expected) in table {
            assert!((erf(x) - expected).abs() <= 4.0 * f64::EPSILON, "erf({x}) = {} ≠ {expected}", erf(x));
            assert_eq!(erf(-x), -erf(x));
        }
        assert!((erfc(10.0) / 2.088_487_583_762_545e-45 - 1.0).abs() <= 204.0 * f64::EPSILON);
        assert!(erf(f64::NAN).is_nan() && erfc(f64::NAN).is_nan());
        assert_eq!((erfc(f64::INFINITY), erfc(f64::NEG_INFINITY)), (0.0, 2.0));
    }

    #[test]
    fn the_mean_of_a_gaussian_is_its_integral() {
        for (a, b) in [(-0.3, 0.1), (0.6, 2.5), (-4.0, -1.0), (1.0, 1.0 + 1e-9), (3.0, 3.001), (-30.0, 30.0)] {
            let mut breaks = crate::num::quadrature::even_breaks(a, b, 0.5);
            breaks.dedup();
            let integral = crate::num::quadrature::integrate_pieces(|t: f64| (-t * t).exp(), &breaks, 1e-16);
            let bound = (8.0 * f64::EPSILON + integral.error) / (b - a).max(1e-8);
            assert!((gaussian_mean(a, b) - integral.value / (b - a)).abs() <= bound, "{a} {b}");
            assert_eq!(gaussian_mean(a, b), gaussian_mean(b, a));
        }
    }
}
