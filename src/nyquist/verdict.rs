//! Whether a rate suffices.

use crate::error::{Error, Result, positive};
use crate::spectrum::Spectrum;

/// The Nyquist rate `2B` of a signal with band limit `B`: the rate that samples must exceed (E36).
///
/// ```
/// use nyquist::nyquist::{nyquist_frequency, nyquist_rate};
/// assert_eq!(nyquist_rate(20e3), 40e3); // of hearing, which ends at 20 kHz
/// assert_eq!(nyquist_frequency(44.1e3), 22.05e3); // of the compact disc
/// ```
pub fn nyquist_rate(band: f64) -> f64 {
    2.0 * band
}

/// The Nyquist frequency `f_s/2` of a sampling rate: the least frequency that is *not* told apart from all lower ones.
/// A supremum of what can be reproduced, not attained (E09).
pub fn nyquist_frequency(rate: f64) -> f64 {
    0.5 * rate
}

/// Whether samples at some rate determine a signal with a given band.
///
/// The condition of the theorem is `f_s > 2B`. Where the spectrum has no line at `B` equality suffices as well (the
/// Paley–Wiener space has the sinc functions as an orthogonal basis); where it has one, the samples of
/// `A cos(2πBx + φ)` are `A cos φ·(−1)^k`, so that amplitude and phase cannot be told apart (E08).
///
/// ```
/// use nyquist::nyquist::Verdict;
/// assert_eq!(Verdict::of(1.0, false, 2.5)?, Verdict::Recoverable { margin: 0.5 });
/// assert_eq!(Verdict::of(1.0, false, 2.0)?, Verdict::Recoverable { margin: 0.0 }); // a density
/// assert_eq!(Verdict::of(1.0, true, 2.0)?, Verdict::Critical); // a tone
/// assert_eq!(Verdict::of(1.0, false, 1.25)?, Verdict::Aliased { overlap: [0.25, 1.0] });
/// # Ok::<(), nyquist::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Verdict {
    /// The samples determine the signal.
    Recoverable {
        /// The gap `f_s − 2B` between the copies of the spectrum: what a reconstruction filter may use to fall off in.
        margin: f64,
    },
    /// The rate is exactly `2B` and a line stands at `B`: the samples do not determine the signal.
    Critical,
    /// The copies of the spectrum overlap.
    Aliased {
        /// The frequencies `|ν|` at which they do: from `f_s − B` (or zero) to `B`.
        overlap: [f64; 2],
    },
}

impl Verdict {
    /// The verdict on a band limit, possibly infinite, at a sampling rate; `line_at_band` says whether the spectrum has
    /// a line exactly at the limit.
    ///
    /// Rates that differ from `2B` by no more than `4ε·f_s` count as equal: a rate often comes as `1/T`, and a line that
    /// close to the Nyquist frequency is lost in rounding anyway.
    ///
    /// # Errors
    /// A band that is negative or NaN; a rate that is not positive and finite.
    pub fn of(band: f64, line_at_band: bool, rate: f64) -> Result<Self> {
        if band.is_nan() || band < 0.0 {
            return Err(Error::OutOfRange { what: "the band", value: band, low: 0.0, high: f64::INFINITY });
        }
        positive("the sampling rate", rate)?;
        let margin = rate - nyquist_rate(band);
        let equal = margin.abs() <= 4.0 * f64::EPSILON * rate;
        Ok(match (equal, line_at_band) {
            (true, true) => Self::Critical,
            (true, false) => Self::Recoverable { margin: 0.0 },
            (false, _) if margin > 0.0 => Self::Recoverable { margin },
            _ => Self::Aliased { overlap: [(rate - band).max(0.0), band] },
        })
    }

    /// The verdict on a spectrum at a sampling rate.
    ///
    /// ```
    /// use nyquist::prelude::*;
    /// // a tone at 3 and its alias at 1 have the same samples at rate 4
    /// let tone = Spectrum::of_lines([Impulse::new(-3.0, 0.5), Impulse::new(3.0, 0.5)])?;
    /// assert_eq!(Verdict::on(&tone, 4.0)?, Verdict::Aliased { overlap: [1.0, 3.0] });
    /// assert_eq!(Verdict::on(&tone, 6.0)?, Verdict::Critical);
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    /// A rate that is not positive and finite.
    pub fn on(spectrum: &Spectrum, rate: f64) -> Result<Self> {
        Self::of(spectrum.band(), spectrum.has_line_at_band(), rate)
    }

    /// Whether the samples determine the signal.
    pub fn recoverable(&self) -> bool {
        matches!(self, Self::Recoverable { .. })
    }
}
