//! The sine and cosine of multiples of π, and the sinc.

use std::f64::consts::PI;

/// `sin(πt)`, exact (zero, ±1) at every multiple of ½.
///
/// The argument is reduced before it is multiplied by π, so that integers give exactly zero: `(π·t).sin()` is off by
/// `ε·π·|t|` there.
///
/// ```
/// assert_eq!(nyquist::num::sin_pi(1e6), 0.0);
/// assert_eq!(nyquist::num::sin_pi(-2.5), -1.0);
/// assert_ne!((1e6 * std::f64::consts::PI).sin(), 0.0);
/// ```
pub fn sin_pi(t: f64) -> f64 {
    let whole = t.round();
    let rest = t - whole; // exact: Sterbenz
    let s = if rest.abs() <= 0.25 { (PI * rest).sin() } else { rest.signum() * (PI * (0.5 - rest.abs())).cos() };
    if whole.rem_euclid(2.0) == 0.0 { s } else { -s }
}

/// `cos(πt)`, exact (zero, ±1) at every multiple of ½.
///
/// ```
/// assert_eq!(nyquist::num::cos_pi(0.5), 0.0);
/// assert_eq!(nyquist::num::cos_pi(7.0), -1.0);
/// ```
pub fn cos_pi(t: f64) -> f64 {
    let whole = t.round();
    let rest = (t - whole).abs();
    let c = if rest <= 0.25 { (PI * rest).cos() } else { (PI * (0.5 - rest)).sin() };
    if whole.rem_euclid(2.0) == 0.0 { c } else { -c }
}

/// `sinc(t) = sin(πt)/(πt)`, one at zero and exactly zero at every other integer.
///
/// The transform of the unit box, and the ideal reconstruction kernel (Whittaker 1915, Kotelnikov 1933, Shannon 1949;
/// slide "Преобразования Фурье для некоторых функций").
///
/// ```
/// use nyquist::num::sinc;
/// assert_eq!((sinc(0.0), sinc(3.0), sinc(-1e9)), (1.0, 0.0, 0.0));
/// assert_eq!(sinc(0.5), 2.0 / std::f64::consts::PI);
/// ```
pub fn sinc(t: f64) -> f64 {
    // Below 1e-8 the next term (πt)²/6 is under ε/2.
    if t.abs() < 1e-8 { 1.0 } else { sin_pi(t) / (PI * t) }
}

/// The derivative `sinc′(t) = (cos(πt) − sinc(t))/t`, zero at zero.
///
/// Within ¼ of zero the difference cancels, and its Taylor series `−π²t/3 + π⁴t³/30 − …` is summed instead.
///
/// ```
/// use nyquist::num::{sinc, sinc_slope};
/// assert_eq!((sinc_slope(0.0), sinc_slope(1.0), sinc_slope(2.0)), (0.0, -1.0, 0.5));
/// ```
pub fn sinc_slope(t: f64) -> f64 {
    if t.abs() >= 0.25 {
        return (cos_pi(t) - sinc(t)) / t;
    }
    // sinc t = Σ (−1)^m (πt)^{2m}/(2m+1)!, differentiated term by term; nine terms reach ε at ¼
    let square = (PI * t) * (PI * t);
    let mut power = -PI * PI * t / 3.0;
    let mut sum = 0.0;
    for m in 1..10 {
        sum += power;
        let m = f64::from(m);
        // from m to m + 1: (2m+2)/(2m) over (2m+2)(2m+3)
        power *= -square / (2.0 * m * (2.0 * m + 3.0));
    }
    sum
}
