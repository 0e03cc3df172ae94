//! The rates at which a band-pass signal can be sampled below twice its highest frequency.

use crate::error::{Error, Result, finite, positive};

/// One interval of rates at which the copies of a band `f_L < |ν| < f_H` do not overlap.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BandRates {
    /// The band then lies between the multiples `n − 1` and `n` of the Nyquist frequency.
    pub n: u32,
    /// The least rate, `2f_H/n`.
    pub low: f64,
    /// The greatest rate, `2f_L/(n − 1)`; infinite for `n = 1`.
    pub high: f64,
}

impl BandRates {
    /// Whether `rate` lies in the interval, ends included. At the ends the copies touch, which is enough for a density
    /// and too little for a line there (E08).
    pub fn contains(&self, rate: f64) -> bool {
        (self.low..=self.high).contains(&rate)
    }

    /// Whether the band comes down mirrored: for even `n`.
    pub fn inverted(&self) -> bool {
        self.n.is_multiple_of(2)
    }
}

/// All rates at which a signal on the band `low < |ν| < high` is determined by its samples (V23):
/// `2f_H/n ≤ f_s ≤ 2f_L/(n − 1)` for `1 ≤ n ≤ ⌊f_H/(f_H − f_L)⌋`, from the highest interval to the lowest.
///
/// Vaughan, Scott, White, *The theory of bandpass sampling*, 1991.
///
/// ```
/// use nyquist::nyquist::bandpass_rates;
/// let rates = bandpass_rates(21.0, 24.0)?;
/// let allowed = |rate: f64| rates.iter().any(|interval| interval.contains(rate));
/// // eight intervals; 8.2 will do where 9.0, although faster, will not
/// assert_eq!((rates.len(), allowed(8.2), allowed(9.0), allowed(10.0)), (8, true, false, true));
/// assert_eq!((rates[0].low, rates[0].high), (48.0, f64::INFINITY));
/// assert_eq!((rates[7].low, rates[7].high), (6.0, 6.0)); // twice the width of the band: no room at all
/// # Ok::<(), nyquist::error::Error>(())
/// ```
///
/// # Errors
/// Edges that are not finite, a negative lower edge, an upper edge not above it, or more than a million intervals.
pub fn bandpass_rates(low: f64, high: f64) -> Result<Vec<BandRates>> {
    const MOST: f64 = 1e6;
    finite("the lower edge of the band", low)?;
    if low < 0.0 {
        return Err(Error::OutOfRange { what: "the lower edge of the band", value: low, low: 0.0, high });
    }
    finite("the upper edge of the band", high)?;
    let width = positive("the width of the band", high - low)?;
    let intervals = (high / width).floor();
    if intervals > MOST {
        return Err(Error::Overflow {
            what: "the number of intervals of band-pass rates",
            value: intervals,
            most: MOST,
        });
    }
    let interval = |n: u32| BandRates {
        n,
        low: 2.0 * high / f64::from(n),
        high: if n == 1 { f64::INFINITY } else { 2.0 * low / f64::from(n - 1) },
    };
    Ok((1..=intervals as u32).map(interval).filter(|i| i.low <= i.high).collect())
}
