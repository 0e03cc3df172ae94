//! A low-pass from its promise: Kaiser's window computed, not looked up.
//!
//! The error of a windowed ideal low-pass at the distance `u` from its edge is `E(x) = ½ − (1/π)∫₀ˣ W`, where `x = 2πru`
//! for a window of radius `r`, and `W(x) = sinh(√(β²−x²))/(I₀(β)·√(β²−x²))` is the transform of Kaiser's window. It falls
//! from ½ to its first zero and beyond, down to `−δ(β)` at the first zero of `W`, `x₀ = √(β²+π²)`, and no later ripple is
//! larger. So the rejection gives `β`, by `δ(β)`, and the width of the transition gives `r = x₀/(2πu)`. Kaiser's own
//! formulas (1974) were fitted up to 100 dB; at 200 dB they miss by 12.

use crate::num::sinc;
use crate::num::special::bessel_i0;
use std::f64::consts::PI;

/// A symmetric low-pass `k(t)`, in units of one step and normalised to `∫k = 1`.
///
/// ```
/// use nyquist::rate::design::LowPass;
/// // passes up to 0.45 cycles a step, rejects 120 dB from 0.5 on
/// let filter = LowPass::new(0.45, 0.5, 120.0);
/// let gain = |nu: f64| {
///     // the transform of samples at four a step
///     let n = (4.0 * filter.radius()).ceil() as i32;
///     let taps = (-n..=n).map(|i| f64::from(i) / 4.0);
///     taps.map(|t| 0.25 * filter.at(t) * (2.0 * std::f64::consts::PI * nu * t).cos()).sum::<f64>()
/// };
/// assert!((gain(0.45) - 1.0).abs() < 1.1e-6 && gain(0.5).abs() < 1.1e-6 && gain(0.7).abs() < 1e-6);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LowPass {
    edge: f64,
    beta: f64,
    radius: f64,
    peak: f64,
}

impl LowPass {
    /// Passes up to `pass`, stops from `stop` on (cycles a step, `0 ≤ pass < stop`), and errs by less than `rejection` dB in
    /// both; rejections are taken to lie within 20 and 280 dB.
    pub fn new(pass: f64, stop: f64, rejection: f64) -> Self {
        let wanted = 10f64.powf(-rejection.clamp(20.0, 280.0) / 20.0);
        let (mut low, mut high) = (0.0, 40.0);
        while high - low > 1e-3 {
            let middle = 0.5 * (low + high);
            if overshoot(middle) > wanted { low = middle } else { high = middle }
        }
        let (beta, half) = (high, 0.5 * (stop - pass));
        let radius = (beta * beta + PI * PI).sqrt() / (2.0 * PI * half);
        Self { edge: 0.5 * (pass + stop), beta, radius, peak: bessel_i0(beta) }
    }

    /// Its value is zero from here on, in steps.
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// The parameter of Kaiser's window.
    pub fn beta(&self) -> f64 {
        self.beta
    }

    /// The most that a tone of `nu` cycles a step is multiplied by: the response `1 − E` below the edge and `E` above it, up
    /// to where `E` has fallen to its first ripple, and from there a bound of its ripples, `δ(β)·x₀/x`.
    ///
    /// The ripples are `E = (1/π)∫ₓ^∞ W`, an alternating sum whose terms fall as `1/x`.
    ///
    /// ```
    /// use nyquist::rate::design::LowPass;
    /// let filter = LowPass::new(0.45, 0.5, 120.0);
    /// assert!((filter.gain(0.475) - 0.5).abs() < 1e-9); // in the middle of the transition
    /// assert!((filter.gain(0.4) - 1.0).abs() < 1e-6);
    /// assert!(filter.gain(0.5) < 1e-6 && filter.gain(0.7) < 0.3e-6);
    /// ```
    pub fn gain(&self, nu: f64) -> f64 {
        let x = 2.0 * PI * self.radius * (nu.abs() - self.edge);
        let first = (self.beta * self.beta + PI * PI).sqrt();
        let ripple = overshoot(self.beta);
        match x {
            _ if x <= -first => 1.0 + ripple * first / -x,
            _ if x <= 0.0 => 1.0 - error(self.beta, -x),
            _ if x <= first => error(self.beta, x).max(ripple),
            _ => ripple * first / x,
        }
    }

    /// `k(t) = 2ν_c·sinc(2ν_c t)·I₀(β√(1−(t/r)²))/I₀(β)`.
    pub fn at(&self, t: f64) -> f64 {
        let inside = 1.0 - (t / self.radius) * (t / self.radius);
        if inside <= 0.0 {
            return 0.0;
        }
        2.0 * self.edge * sinc(2.0 * self.edge * t) * bessel_i0(self.beta * inside.sqrt()) / self.peak
    }
}

/// `δ(β) = (1/π)∫₀^{x₀} W − ½`.
fn overshoot(beta: f64) -> f64 {
    -error(beta, (beta * beta + PI * PI).sqrt())
}

/// `E(x) = ½ − (1/π)∫₀ˣ W`, by Simpson's rule: `W` is entire, and no narrower than `√β`.
fn error(beta: f64, end: f64) -> f64 {
    const PANELS: u32 = 1024;
    let window = |i: u32| {
        let x = end * f64::from(i) / f64::from(PANELS);
        let square = beta * beta - x * x;
        let root = square.abs().sqrt();
        match square {
            _ if root < 1e-4 => 1.0 + square / 6.0,
            _ if square > 0.0 => root.sinh() / root,
            _ => root.sin() / root,
        }
    };
    let inner: f64 = (1..PANELS).map(|i| if i % 2 == 1 { 4.0 } else { 2.0 } * window(i)).sum();
    let integral = (window(0) + inner + window(PANELS)) * end / (3.0 * f64::from(PANELS));
    0.5 - integral / (PI * bessel_i0(beta))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn overshoots_are_those_of_the_window() {
        // β = 0 is the truncated sinc: Gibbs' overshoot Si(π)/π − ½ (Wilbraham 1848)
        assert!((overshoot(0.0) - 0.089_489_872_236_083_6).abs() < 1e-12);
        // Oppenheim & Schafer, table 7.2: β = 7.857 has a peak error of −80 dB
        assert!((20.0 * overshoot(7.857).log10() + 80.0).abs() < 0.2);
    }
}
