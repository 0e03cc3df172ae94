//! The ratio of two rates, exactly.

use crate::error::{Error, Result, positive, within};
use crate::rate::time::Time;

/// The most by which rates may differ.
const MOST: f64 = 1000.0;
/// The largest term of a ratio that is done with exact phases.
const MOST_TERM: u128 = 1 << 18;

/// New rate over old rate, as two whole numbers without a common divisor.
///
/// ```
/// use nyquist::rate::Ratio;
/// let ratio = Ratio::new(44_100.0, 48_000.0)?;
/// assert_eq!(ratio.terms(), Some((160, 147)));
/// assert_eq!(ratio.frames(44_100 * 60), 48_000 * 60);
/// assert_eq!(Ratio::new(48_000.0, 48_000.0 / 1.001)?.terms(), Some((1000, 1001))); // to rounding
/// assert_eq!(Ratio::new(1.0, std::f64::consts::PI)?.terms(), None);
/// # Ok::<(), nyquist::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Ratio {
    up: u128,
    down: u128,
}

impl Ratio {
    /// From one rate to another, in the same unit.
    ///
    /// # Errors
    /// Rates that are not finite and positive; a ratio outside `1/1000..=1000`.
    pub fn new(from: f64, to: f64) -> Result<Self> {
        positive("the rate of the input", from)?;
        positive("the rate of the output", to)?;
        within("the ratio of output rate to input rate", to / from, 1.0 / MOST, MOST)?;
        let exact = Self::of_floats(from, to);
        Ok(exact.simple().or_else(|| Self::nearly(from, to)).unwrap_or(exact))
    }

    /// What both floats are to the last bit.
    fn of_floats(from: f64, to: f64) -> Self {
        let ((up, a), (down, b)) = (parts(to), parts(from));
        // the ratio of the numbers is within MOST, that of the mantissas within 2: the shift is small
        let shift = a - b;
        let (up, down) = (up << shift.max(0), down << (-shift).max(0));
        let common = divisor(up, down);
        Self { up: up / common, down: down / common }
    }

    fn simple(self) -> Option<Self> {
        (self.up <= MOST_TERM && self.down <= MOST_TERM).then_some(self)
    }

    /// The first convergent of the ratio's continued fraction that is the same to rounding, where its terms are small:
    /// 48000/1.001 is meant to be 48000·1000/1001.
    fn nearly(from: f64, to: f64) -> Option<Self> {
        let (mut before, mut now) = ((0u128, 1u128), (1u128, 0u128));
        let mut rest = to / from;
        for _ in 0..20 {
            let whole = rest.floor();
            let next = |now: u128, before: u128| (whole as u128).checked_mul(now)?.checked_add(before);
            let convergent = (next(now.0, before.0)?, next(now.1, before.1)?);
            (before, now) = (now, convergent);
            let candidate = Self { up: now.0, down: now.1 }.simple()?;
            // both rates may have been rounded, and both products; another fraction of such terms is 2⁻³⁶ away
            let (above, below) = (to * candidate.down as f64, from * candidate.up as f64);
            if (above - below).abs() <= 2.0 * f64::EPSILON * above {
                return Some(candidate);
            }
            rest = 1.0 / (rest - whole);
            if !rest.is_finite() {
                return None;
            }
        }
        None
    }

    /// Up and down, where both are at most 2¹⁸: such ratios are converted with exact phases.
    pub fn terms(&self) -> Option<(usize, usize)> {
        self.simple().map(|ratio| (ratio.up as usize, ratio.down as usize))
    }

    /// New rate over old rate.
    pub fn value(&self) -> f64 {
        self.up as f64 / self.down as f64
    }

    /// How many frames become of `n`: `round(n·up/down)`, halves up.
    pub fn frames(&self, n: u64) -> u64 {
        let exact = || {
            let twice = u128::from(n).checked_mul(self.up)?.checked_mul(2)?.checked_add(self.down)?;
            u64::try_from(twice / (2 * self.down)).ok()
        };
        exact().unwrap_or((n as f64 * self.value()).round() as u64)
    }

    /// How far one output is from the next in samples at `up/down` times the input rate.
    pub(super) fn step(&self, up: usize, down: usize) -> Time {
        let (numerator, denominator) = (self.down * up as u128, self.up * down as u128);
        let mut rest = numerator % denominator;
        let mut fraction = 0;
        for _ in 0..u128::BITS {
            rest *= 2;
            fraction = fraction << 1 | u128::from(rest >= denominator);
            rest %= denominator;
        }
        Time { whole: (numerator / denominator) as u64, fraction }
    }
}

/// Mantissa, normalised to 53 bits, and exponent.
fn parts(value: f64) -> (u128, i32) {
    let bits = value.to_bits();
    let exponent = (bits >> 52 & 0x7ff) as i32;
    (u128::from(bits & ((1 << 52) - 1) | 1 << 52), exponent)
}

fn divisor(a: u128, b: u128) -> u128 {
    if b == 0 { a } else { divisor(b, a % b) }
}

/// The error for a conversion that would need too much memory.
pub(super) fn too_much(values: f64, most: f64) -> Error {
    Error::Overflow { what: "the values that a conversion of rates must keep", value: values, most }
}
