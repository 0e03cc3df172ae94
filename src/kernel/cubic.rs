//! The cubics of Mitchell and Netravali: two pieces, two parameters, between blur, ringing and echoes.
//!
//! | | |
//! | --- | --- |
//! | formula | `6k(t) = (12−9B−6C)\|t\|³ + (−18+12B+6C)t² + 6−2B` for `\|t\| < 1`, `(2−\|t\|)²·[B(2−\|t\|) − 6C(\|t\|−1)]` for `1 ≤ \|t\| < 2` |
//! | response | `(1−B)·3(πν)⁻²[sinc²ν − sinc 2ν] + B·sinc⁴ν + C·2(πν)⁻²[2 sinc 2ν + sinc 4ν − 3 sinc²2ν]` |
//! | parameters | `B` weighs the smooth B-spline, `C` the ringing part; `B + 2C = 1` is the line on which straight lines are reproduced |
//! | use it | Mitchell (⅓, ⅓) for images; Catmull–Rom (0, ½) to interpolate; the B-spline (1, 0) to smooth |
//! | artefacts | Mitchell over- and undershoots a step by 3.63 %, Catmull–Rom by 7.41 %, the B-spline by nothing, but it leaves 0.16 of a tone at Nyquist |
//! | source | Mitchell & Netravali, *Reconstruction filters in computer graphics*, SIGGRAPH 1988; Keys 1981 for (0, C); slide «Примеры работы фильтров» |

use crate::error::{Result, within};
use crate::kernel::{Claims, Kernel};
use crate::num::sinc;
use crate::signal::Signal;
use std::f64::consts::PI;

/// A cubic `(B, C)`; see the [page](self).
///
/// ```
/// use nyquist::prelude::*;
/// let mitchell = Cubic::mitchell();
/// assert!((mitchell.at(0.0) - 8.0 / 9.0).abs() < 1e-15 && (mitchell.at(1.0) - 1.0 / 18.0).abs() < 1e-15);
/// assert!(!mitchell.claims().interpolating && Cubic::catmull_rom().claims().interpolating);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cubic {
    b: f64,
    c: f64,
}

impl Cubic {
    /// Any `(B, C)`.
    ///
    /// # Errors
    /// A `B` or `C` that is not finite or outside `−10..=10`, far beyond every use.
    pub fn new(b: f64, c: f64) -> Result<Self> {
        within("B of a cubic kernel", b, -10.0, 10.0)?;
        within("C of a cubic kernel", c, -10.0, 10.0)?;
        Ok(Self { b, c })
    }

    /// `(⅓, ⅓)`, what nine observers preferred (Mitchell & Netravali 1988).
    pub fn mitchell() -> Self {
        Self { b: 1.0 / 3.0, c: 1.0 / 3.0 }
    }

    /// `(0, ½)`: interpolates, reproduces parabolas, third-order accurate (Catmull & Rom 1974; Keys 1981).
    pub fn catmull_rom() -> Self {
        Self { b: 0.0, c: 0.5 }
    }

    /// `(1, 0)`: the cubic B-spline, the box convolved with itself three times (Schoenberg 1946).
    pub fn b_spline() -> Self {
        Self { b: 1.0, c: 0.0 }
    }

    /// The parameter `B`.
    pub fn b(&self) -> f64 {
        self.b
    }

    /// The parameter `C`.
    pub fn c(&self) -> f64 {
        self.c
    }

    /// Six times the coefficients of `|t|³`, `t²` and `1` on the inner piece.
    fn inner(&self) -> [f64; 3] {
        [12.0 - 9.0 * self.b - 6.0 * self.c, -18.0 + 12.0 * self.b + 6.0 * self.c, 6.0 - 2.0 * self.b]
    }

    /// Exactly when both pieces are nonnegative: the outer one is `u²[Bu − 6C(1−u)]` on `0 < u ≤ 1`, the inner one a cubic
    /// with one turning point inside at most.
    fn nonnegative(&self) -> bool {
        let [a3, a2, a0] = self.inner();
        let inner = |t: f64| (a3 * t + a2) * t * t + a0;
        let turn = (-2.0 * a2 / (3.0 * a3)).clamp(0.0, 1.0); // NaN if it is no cubic and constant: then at(0) says all
        let inside = inner(0.0) >= 0.0 && inner(1.0) >= 0.0 && (turn.is_nan() || inner(turn) >= 0.0);
        self.b >= 0.0 && self.c <= 0.0 && inside
    }
}

impl Signal for Cubic {
    fn at(&self, t: f64) -> f64 {
        let t = t.abs();
        if t < 1.0 {
            let [a3, a2, a0] = self.inner();
            ((a3 * t + a2) * t * t + a0) / 6.0
        } else if t >= 2.0 {
            0.0
        } else {
            let u = 2.0 - t;
            u * u * (self.b * u - 6.0 * self.c * (t - 1.0)) / 6.0
        }
    }
}

impl Kernel for Cubic {
    fn name(&self) -> String {
        match *self {
            it if it == Self::mitchell() => "mitchell".into(),
            it if it == Self::catmull_rom() => "catmull-rom".into(),
            it if it == Self::b_spline() => "b-spline".into(),
            Self { b, c } => format!("cubic:{b},{c}"),
        }
    }
    fn radius(&self) -> f64 {
        2.0
    }
    fn claims(&self) -> Claims {
        Claims {
            interpolating: self.b == 0.0,
            unit_gain: true,
            reproduces_constants: true,
            // on the line within the rounding of B and C themselves
            reproduces_lines: (self.b + 2.0 * self.c - 1.0).abs() <= 4.0 * f64::EPSILON,
            nonnegative: self.nonnegative(),
        }
    }
    fn response(&self, nu: f64) -> f64 {
        (1.0 - self.b) * plain_part(nu) + self.b * sinc(nu).powi(4) + self.c * ringing_part(nu)
    }
}

/// Below `|πν| = 1` the brackets of the response cancel, and their Taylor series in `(πν)²` are summed instead: 18 terms,
/// of which the first left out is below `16¹⁹/38! < 10⁻²¹`.
fn by_series(nu: f64, coefficient: impl Fn(f64, f64, f64) -> f64) -> f64 {
    let y2 = (PI * nu).powi(2);
    let (mut sum, mut power) = (0.0, 1.0); // power = (−1)ⁿ⁺¹ y²ⁿ⁻²
    let (mut four, mut sixteen, mut factorial) = (4.0, 16.0, 6.0); // 4ⁿ, 16ⁿ, (2n+1)!
    for n in 1..=18 {
        let m = f64::from(2 * n + 2);
        sum += power * coefficient(four / factorial, sixteen / factorial, m);
        power *= -y2;
        four *= 4.0;
        sixteen *= 16.0;
        factorial *= m * (m + 1.0);
    }
    sum
}

/// `3(πν)⁻²[sinc²ν − sinc 2ν]`, the response of `(0, 0)`; one at zero.
fn plain_part(nu: f64) -> f64 {
    if (PI * nu).abs() >= 1.0 {
        return 3.0 * (sinc(nu).powi(2) - sinc(2.0 * nu)) / (PI * nu).powi(2);
    }
    by_series(nu, |four, _, m| 3.0 * four * (1.0 - 2.0 / m))
}

/// `2(πν)⁻²[2 sinc 2ν + sinc 4ν − 3 sinc²2ν]`, what `C` adds; zero at zero.
fn ringing_part(nu: f64) -> f64 {
    if (PI * nu).abs() >= 1.0 {
        let bracket = 2.0 * sinc(2.0 * nu) + sinc(4.0 * nu) - 3.0 * sinc(2.0 * nu).powi(2);
        return 2.0 * bracket / (PI * nu).powi(2);
    }
    by_series(nu, |four, sixteen, m| -2.0 * (2.0 * four + sixteen * (1.0 - 6.0 / m)))
}
