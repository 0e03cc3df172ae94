//! The test signals that the lecture's figures share.

use crate::num::cos_pi;
use crate::signal::{FourierPair, Signal};
use crate::spectrum::Spectrum;
use std::f64::consts::{PI, SQRT_2};

/// PL, the lecture's low-frequency function (figures 7.2a and 7.3a): `F(ν) = 16ν² − 64ν⁴` for `|ν| ≤ ½`.
///
/// Two humps of height 1 at `|ν| = 1/(2√2)`; `f(0) = 8/15`. In space, with `a = 2πx`, `s = sin πx`, `c = cos πx`:
/// `f(x) = 2[−16c/a² + 160s/a³ + 768c/a⁴ − 1536s/a⁵]`, and near zero, where that cancels, the Taylor series
/// `8 Σ (−1)^m (πx)^{2m} / ((2m)!(2m+3)(2m+5))`.
///
/// ```
/// use nyquist::prelude::*;
/// assert!((LowBump.at(0.0) - 8.0 / 15.0).abs() < 1e-15);
/// assert!((LowBump.spectrum().density(1.0 / 8f64.sqrt()).re - 1.0).abs() < 1e-15);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct LowBump;

impl Signal for LowBump {
    fn at(&self, x: f64) -> f64 {
        let y = PI * x.abs();
        if y < 2.0 {
            return 8.0 * even_series(y, |m| 1.0 / ((2.0 * m + 3.0) * (2.0 * m + 5.0)));
        }
        let (a, s, c) = (2.0 * y, y.sin(), y.cos());
        2.0 * (-16.0 * c + (160.0 * s + (768.0 * c - 1536.0 * s / a) / a) / a) / (a * a)
    }
}

impl FourierPair for LowBump {
    fn spectrum(&self) -> Spectrum {
        Spectrum::density_of(0.5, |nu| (16.0 * nu.powi(2) - 64.0 * nu.powi(4)).into())
    }
}

/// PH, the lecture's high-frequency function (figure 7.3b): `F(ν) = 1 − ν⁸/16` for `|ν| ≤ √2`.
///
/// `f(0) = 16√2/9`. With `y = 2π√2·x`, `f(x) = 2√2·∫₀¹ (1 − t⁸) cos(yt) dt`, integrated by parts eight times, or by
/// its Taylor series near zero. (Figure 7.2b of the source is not the transform of its 7.3b, E31; this is a true pair.)
///
/// ```
/// use nyquist::prelude::*;
/// assert!((HighBump.at(0.0) - 16.0 * 2f64.sqrt() / 9.0).abs() < 1e-14);
/// assert_eq!(HighBump.spectrum().band(), 2f64.sqrt());
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct HighBump;

impl Signal for HighBump {
    fn at(&self, x: f64) -> f64 {
        let y = 2.0 * PI * SQRT_2 * x.abs();
        if y < 3.5 {
            return 16.0 * SQRT_2 * even_series(y, |m| 1.0 / ((2.0 * m + 1.0) * (2.0 * m + 9.0)));
        }
        // I_n = ∫ tⁿ cos yt = (sin y − n·J_{n−1})/y and J_n = ∫ tⁿ sin yt = (−cos y + n·I_{n−1})/y over [0, 1];
        // going up is stable for y above 3.5: the error grows by at most 8·7·6·5·4/3.5⁵ < 13
        let (sin, cos) = y.sin_cos();
        let (mut i, mut j) = (sin / y, (1.0 - cos) / y);
        for n in 1..=8 {
            let n = f64::from(n);
            (i, j) = ((sin - n * j) / y, (-cos + n * i) / y);
        }
        2.0 * SQRT_2 * (sin / y - i)
    }
}

impl FourierPair for HighBump {
    fn spectrum(&self) -> Spectrum {
        Spectrum::density_of(SQRT_2, |nu| (1.0 - nu.powi(8) / 16.0).into())
    }
}

/// `Σ_m (−1)^m y^{2m}/(2m)! · c(m)`, for `y` up to 4: at most `e⁴ε` of rounding.
fn even_series(y: f64, c: impl Fn(f64) -> f64) -> f64 {
    let (mut power, mut sum) = (1.0, 0.0);
    for m in 0..24 {
        let m = f64::from(m);
        sum += power * c(m);
        power *= -y * y / ((2.0 * m + 1.0) * (2.0 * m + 2.0));
    }
    sum
}

/// CH, the lecture's chirp: `1 + cos(4πx²)`, shown on `[0, 4]`, sampled with `T = 1/8`. Its local frequency `4x`
/// passes the Nyquist frequency 4 at `x = 1`; the samples repeat with period 2 and are mirrored about `x = 1`.
///
/// ```
/// use nyquist::prelude::*;
/// let ch = LectureChirp;
/// assert!((0..8).all(|k| ch.at(1.0 + f64::from(k) / 8.0) == ch.at(1.0 - f64::from(k) / 8.0)));
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct LectureChirp;

impl Signal for LectureChirp {
    fn at(&self, x: f64) -> f64 {
        1.0 + cos_pi(4.0 * x * x)
    }
}

/// PU, the lecture's step for filter tests: 1 on the half-open `[1, 2)`, 0 elsewhere, shown on `[0, 4]`, `T = 1/8`.
///
/// Half-open against the convention of the mean at a jump, because the figure's samples are 8 low, 8 high, 16 low: so
/// the jumps lie between samples, and sinc reconstruction overshoots by 14.1 % rather than 3.3 % (E15).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct LecturePulse;

impl Signal for LecturePulse {
    fn at(&self, x: f64) -> f64 {
        f64::from(u8::from((1.0..2.0).contains(&x)))
    }
}

/// The heights of the spikes in the source's figure 7.4(c) at `x = 0, 1, …, 8`, measured from its path data: the
/// samples of the basic figures of sampling.
pub const SPIKES: [f64; 9] = [0.385, 0.900, 0.796, 0.311, 0.512, 0.592, 0.651, 0.223, 0.521];
