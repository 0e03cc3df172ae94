//! Where a frequency goes when it is sampled too slowly.

use crate::error::{Error, Result, finite, positive};

/// The frequency in `[0, rate/2]` whose cosine has the same samples as the one at `freq`: the distance from `freq` to
/// the nearest multiple of the rate, `|f − f_s·round(f/f_s)|`.
///
/// Exact: the remainder of a division is, and so is the difference of two numbers within a factor of two. A rate that
/// is not positive and finite folds nothing, and a frequency that is not finite goes nowhere: NaN.
/// For the phase see [`Alias`]. Slide "Заворачивание частот".
///
/// ```
/// use nyquist::nyquist::fold;
/// // a triangle wave of period f_s: up to the Nyquist frequency, down to zero, and again
/// assert_eq!([0.0, 1.0, 4.0, 7.0, 8.0, 9.0, 12.0, 15.0].map(|f| fold(f, 8.0)), [0.0, 1.0, 4.0, 1.0, 0.0, 1.0, 4.0, 1.0]);
/// assert_eq!(fold(-3.0, 8.0), fold(3.0, 8.0));
/// assert!(fold(1.0, 0.0).is_nan());
/// ```
pub fn fold(freq: f64, rate: f64) -> f64 {
    if !(rate > 0.0 && rate.is_finite()) {
        return f64::NAN;
    }
    let rest = freq.abs() % rate;
    rest.min(rate - rest)
}

/// What a tone looks like after sampling: samples of `A cos(2πνx + φ)` at `x = k/f_s` are the samples of
/// `A cos(2π·frequency·x ± φ)`, with the minus where the phase is [conjugated](Alias::conjugated).
///
/// ```
/// use nyquist::nyquist::Alias;
/// let alias = Alias::of(0.75, 1.0)?;
/// assert_eq!((alias.signed(), alias.frequency(), alias.conjugated(), alias.order()), (-0.25, 0.25, true, 1.0));
/// // so a cosine comes back as a cosine, and a sine with its sign flipped
/// for k in 0..8 {
///     let turn = 2.0 * std::f64::consts::PI * k as f64;
///     assert!(((0.75 * turn).cos() - (0.25 * turn).cos()).abs() < 1e-14);
///     assert!(((0.75 * turn).sin() + (0.25 * turn).sin()).abs() < 1e-14);
/// }
/// # Ok::<(), nyquist::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Alias {
    signed: f64,
    order: f64,
    rate: f64,
}

impl Alias {
    /// The alias of `freq` at sampling rate `rate`.
    ///
    /// # Errors
    /// A frequency that is not finite; a rate that is not positive and finite.
    pub fn of(freq: f64, rate: f64) -> Result<Self> {
        finite("a frequency", freq)?;
        positive("the sampling rate", rate)?;
        let rest = freq % rate; // exact, with the sign of freq
        let signed = if rest > 0.5 * rate {
            rest - rate
        } else if rest <= -0.5 * rate {
            rest + rate
        } else {
            rest
        };
        Ok(Self { signed, order: ((freq - signed) / rate).round(), rate })
    }

    /// The alias with its sign, in `(−f_s/2, f_s/2]`: `e^{2πiνx}` and `e^{2πi·signed·x}` have the same samples.
    pub fn signed(&self) -> f64 {
        self.signed
    }

    /// The frequency seen, in `[0, f_s/2]`; equal to [`fold`].
    pub fn frequency(&self) -> f64 {
        self.signed.abs()
    }

    /// Which copy of the spectrum it comes from: `ν = signed + order·f_s`, a whole number.
    pub fn order(&self) -> f64 {
        self.order
    }

    /// Whether the phase comes back with its sign flipped: cosines stay, sines turn over.
    pub fn conjugated(&self) -> bool {
        self.signed < 0.0
    }

    /// The phase in turns, from `[0, 1)`, that samples at `start + k/f_s` add: there `e^{2πiνx}` equals
    /// `e^{2πi·phase}·e^{2πi·signed·x}` with `phase = order·f_s·start`. Zero where a sample stands at `x = 0`.
    ///
    /// ```
    /// use nyquist::nyquist::Alias;
    /// // pixels are sampled at their middles: every odd order comes back negative
    /// assert_eq!(Alias::of(0.9, 1.0)?.phase(0.5), 0.5);
    /// # Ok::<(), nyquist::error::Error>(())
    /// ```
    pub fn phase(&self, start: f64) -> f64 {
        (self.order * self.rate * start).rem_euclid(1.0)
    }
}

/// A stretch of frequencies and where it lands after sampling.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Landing {
    /// From where to where, rising.
    pub from: [f64; 2],
    /// Where those two ends land; falling where the stretch is mirrored.
    pub to: [f64; 2],
}

/// The frequencies `0..band` cut at the multiples of `rate/2`, and where each piece lands: what would alias, and where.
/// The first piece stays where it is.
///
/// ```
/// use nyquist::nyquist::{Landing, landings};
/// let pieces = landings(11.0, 8.0)?;
/// assert_eq!(pieces[1], Landing { from: [4.0, 8.0], to: [4.0, 0.0] });
/// assert_eq!(pieces[2], Landing { from: [8.0, 11.0], to: [0.0, 3.0] });
/// # Ok::<(), nyquist::error::Error>(())
/// ```
///
/// # Errors
/// A band or rate that is not positive and finite; more than a million pieces.
pub fn landings(band: f64, rate: f64) -> Result<Vec<Landing>> {
    const MOST: f64 = 1e6;
    positive("the band", band)?;
    positive("the sampling rate", rate)?;
    let half = 0.5 * rate;
    let pieces = (band / half).ceil();
    if pieces > MOST {
        return Err(Error::Overflow { what: "the number of times that the band is folded", value: pieces, most: MOST });
    }
    let piece = |i: usize| {
        let from = [i as f64 * half, ((i + 1) as f64 * half).min(band)];
        let length = from[1] - from[0];
        let to = if i.is_multiple_of(2) { [0.0, length] } else { [half, half - length] };
        Landing { from, to }
    };
    Ok((0..pieces as usize).map(piece).collect())
}
