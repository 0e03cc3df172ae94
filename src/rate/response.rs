//! What a conversion does to tones.

use crate::error::Result;
use crate::rate::between::Oversampling;
use crate::rate::blocks::Design;
use crate::rate::design::LowPass;
use crate::rate::quality::Quality;
use crate::rate::ratio::Ratio;

/// What rounding and windows leave of any tone, −220 dB: transforms of a million samples round to `20ε`, which what windows
/// weaken makes up to 80 times as much, and windows err by `6·10⁻¹²`.
const ROUNDING: f64 = 1e-11;

/// By how much a [conversion](crate::rate::Converter) multiplies tones, at most.
///
/// ```
/// use nyquist::rate::{Quality, Response};
/// let response = Response::new(48_000.0, 16_000.0, Quality::High)?;
/// assert!((response.gain(1_000.0) - 1.0).abs() < 1e-7);
/// let edge = 20.0 * response.gain(7_840.0).log10(); // in the middle of the transition, which begins at 7680 Hz
/// assert!((edge + 6.02).abs() < 0.01);
/// assert!(20.0 * response.gain(8_000.0).log10() < -150.0);
/// # Ok::<(), nyquist::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Response {
    /// None where the rates are equal: samples are copied.
    filter: Option<LowPass>,
    /// The lower rate.
    low: f64,
}

impl Response {
    /// Of the conversion from one rate to another.
    ///
    /// # Errors
    /// Those of [`Ratio::new`].
    pub fn new(from: f64, to: f64, quality: Quality) -> Result<Self> {
        let ratio = Ratio::new(from, to)?;
        let stronger = if Design::exact(ratio, quality).is_some() { 1.0 } else { Oversampling::STRONGEST };
        let filter = (ratio.terms() != Some((1, 1))).then(|| quality.low_pass(0.5, stronger));
        Ok(Self { filter, low: from.min(to) })
    }

    /// The most that the amplitude of a tone of this frequency is multiplied by, in the unit of the rates: the response of
    /// the filter up to the lower Nyquist frequency; beyond, where what is left lands at the alias, twice the bound of its
    /// ripples (in a window a tone meets those beside it too), and rounding.
    pub fn gain(&self, frequency: f64) -> f64 {
        let Some(filter) = self.filter else { return 1.0 };
        let ripples = if frequency < 0.5 * self.low { 1.0 } else { 2.0 };
        ripples * filter.gain(frequency / self.low) + ROUNDING
    }
}
