//! Fresnel integrals: the integrals of a chirp.

use crate::num::faddeeva::faddeeva;
use crate::num::{cos_pi, sin_pi};
use num_complex::Complex;
use std::f64::consts::{FRAC_PI_2, PI};

/// `C(x) + i·S(x) = ∫₀ˣ e^{iπt²/2} dt`, the Fresnel integrals as one complex number; odd, and `±(1+i)/2` at infinity.
///
/// The zone plate's mean over a pixel is made of them. Up to `|x| = 1.25` the power series
/// `x Σ (iπx²/2)ᵏ/(k!(2k+1))`, beyond `(1+i)/2·[1 − e^{iπx²/2} w((1+i)√π x/2)]` with the
/// [Faddeeva function](faddeeva) (DLMF 7.5.9 and 7.5.1). Absolute error below `(8 + 2x²)·ε`, of which the second part is
/// the rounding of the phase.
///
/// ```
/// use nyquist::num::fresnel::fresnel;
/// let at_one = fresnel(1.0); // Abramowitz & Stegun, table 7.7
/// assert!((at_one.re - 0.779_893_400_376_822_8).abs() < 1e-15);
/// assert!((at_one.im - 0.438_259_147_390_354_8).abs() < 1e-15);
/// ```
pub fn fresnel(x: f64) -> Complex<f64> {
    let t = x.abs();
    let value = if x.is_nan() {
        Complex::new(x, x)
    } else if t <= 1.25 {
        series(t)
    } else if t > 1e8 {
        // what is missing is at most 1/(πt)
        Complex::new(0.5, 0.5)
    } else {
        let turns = 0.5 * t * t;
        let wave = Complex::new(cos_pi(turns), sin_pi(turns));
        let tail = wave * faddeeva(Complex::new(0.5, 0.5) * (PI.sqrt() * t));
        Complex::new(0.5, 0.5) * (Complex::from(1.0) - tail)
    };
    if x < 0.0 { -value } else { value }
}

fn series(t: f64) -> Complex<f64> {
    // (iπt²/2)ᵏ/k!: |πt²/2| ≤ 2.5, so that term 24 is below 10⁻¹⁶
    let turn = Complex::new(0.0, FRAC_PI_2 * t * t);
    let (mut power, mut sum) = (Complex::from(t), Complex::from(t));
    for k in 1..26 {
        power *= turn / f64::from(k);
        sum += power / f64::from(2 * k + 1);
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Values to 20 digits by mpmath 1.3, functions `fresnelc` and `fresnels`.
    #[test]
    fn agrees_with_published_values() {
        let table = [
            (0.001, 0.0009999999999997533, 5.235987755982066e-10),
            (0.1, 0.09999753262708508, 0.0005235895476122107),
            (0.5, 0.4923442258714464, 0.06473243285999927),
            (1.2, 0.7154377229230734, 0.6234009185462497),
            (1.25, 0.6800907410754551, 0.6586555116366791),
            (1.3, 0.6385504547270292, 0.6863332855346501),
            (2.0, 0.48825340607534073, 0.34341567836369824),
            (3.7, 0.5419456621544874, 0.5749803498874729),
            (8.0, 0.49980218037719715, 0.46021421439301446),
            (11.31, 0.49623226855520886, 0.4721096679948501),
            (31.4, 0.5006397897427961, 0.51011704529959),
            (1000.5, 0.5001217509508101, 0.4997060669389542),
        ];
        for (x, c, s) in table {
            let (value, expected) = (fresnel(x), Complex::new(c, s));
            let bound = (8.0 + 2.0 * x * x) * f64::EPSILON;
            assert!((value - expected).norm() <= bound, "fresnel({x}) = {value} ≠ {expected}");
            assert_eq!(fresnel(-x), -value);
        }
        assert_eq!(fresnel(f64::INFINITY), Complex::new(0.5, 0.5));
        assert!(fresnel(f64::NAN).re.is_nan());
    }
}
