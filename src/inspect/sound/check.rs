//! The question and its answer: is this sampled well enough, and would it be at another rate?

use crate::error::{Result, within};
use crate::inspect::sound::channel::Channel;
use crate::inspect::sound::ending::Ending;
use crate::inspect::sound::forecast::{Forecast, Way};
use crate::inspect::sound::levels::dbfs;
use crate::inspect::sound::meter::Sound;
use crate::rate::Ratio;

/// The tolerance where none is given, in dB: aliases hold a millionth of the signal's power.
///
/// Telephone filters leave about 40 dB, the noise of 16 bits lies 98 dB below a sine of full scale.
pub const TOLERANCE: f64 = 60.0;

/// A sound held against a tolerance, at its own rate or at another.
///
/// At another rate the ratio is that of the signal to its aliases under [plain](Way::Plain) sampling. At its own nobody can
/// tell from the samples what has folded; the ratio is then that of all power to that of the last sixteenth of the
/// spectrum, since what lay as near beyond the Nyquist frequency will have been about as strong.
///
/// ```
/// use nyquist::inspect::sound::{Check, Meter};
/// use nyquist::num::sin_pi;
/// let tone = |f: f64, i: u32| sin_pi(2.0 * (f / 48_000.0 * f64::from(i)).fract());
/// let mut meter = Meter::new(48_000.0, 1)?;
/// meter.push(&(0..48_000).map(|i| 0.5 * tone(1_000.0, i) + 0.005 * tone(9_100.0, i)).collect::<Vec<_>>())?;
/// let sound = meter.finish()?;
/// assert!(Check::new(sound.clone(), None, 60.0)?.fine());
/// let check = Check::new(sound, Some(16_000.0), 60.0)?;
/// // squared windows add up to a constant within 0.013 dB
/// assert!(!check.fine() && (check.ratio() - 40.0).abs() < 0.02);
/// assert_eq!(check.sound().smallest_rate(60.0), Some(22_050));
/// # Ok::<(), nyquist::error::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Check {
    sound: Sound,
    rate: Option<f64>,
    tolerance: f64,
    forecasts: Vec<Forecast>,
    worst: usize,
    ratio: f64,
    /// Whether each channel's last sixteenth holds rounding alone, and the whole is judged at its own rate.
    rounding: bool,
}

impl Check {
    /// Whether there can be a check of a sound of rate `own`, before it has been heard.
    ///
    /// # Errors
    /// Those of [`Check::new`].
    pub fn possible(own: f64, rate: Option<f64>, tolerance: f64) -> Result<()> {
        within("the tolerance in dB", tolerance, 0.0, 300.0)?;
        rate.map(|rate| Ratio::new(own, rate)).transpose()?;
        Ok(())
    }

    /// Of a sound at a rate in Hz, with a tolerance in dB.
    ///
    /// # Errors
    /// A tolerance outside 0 to 300 dB; the errors of [`Ratio::new`].
    pub fn new(sound: Sound, rate: Option<f64>, tolerance: f64) -> Result<Self> {
        Self::possible(sound.rate(), rate, tolerance)?;
        let forecasts = rate.map(|rate| sound.sampled_at(rate)).transpose()?.unwrap_or_default();
        let ratio = |i: usize| {
            let channel = &sound.channels()[i];
            match forecasts.get(i) {
                _ if channel.silent() => f64::INFINITY,
                Some(forecast) => forecast.outcomes[0].ratio(),
                None => above_edge(channel),
            }
        };
        let ratios = (0..sound.channels().len()).map(|i| (i, ratio(i)));
        let (worst, ratio) = least(ratios).unwrap_or((0, f64::INFINITY));
        Ok(Self { sound, rate, tolerance, forecasts, worst, ratio, rounding: false })
    }

    /// Of a sound whose values are multiples of `step`. At its own rate, noise at the top that is no louder than this
    /// rounding leaves has not folded, and a channel that has nothing else there is fine.
    ///
    /// ```
    /// use nyquist::inspect::sound::{Check, Meter};
    /// use nyquist::num::sin_pi;
    /// // a tone in 8 bits: their rounding is less than 60 dB below it, at the top as everywhere
    /// let value = |i: u32| 0.1 * sin_pi(2.0 * (997.3 / 48_000.0 * f64::from(i)).fract());
    /// let mut meter = Meter::new(48_000.0, 1)?;
    /// meter.push(&(0..48_000).map(|i| (value(i) * 128.0).round() / 128.0).collect::<Vec<_>>())?;
    /// let check = Check::new(meter.finish()?, None, 60.0)?;
    /// assert!(!check.fine() && check.rounded_to(1.0 / 128.0).fine());
    /// # Ok::<(), nyquist::error::Error>(())
    /// ```
    #[must_use]
    pub fn rounded_to(mut self, step: f64) -> Self {
        if self.rate.is_some() {
            return self;
        }
        let sounding = |channel: &Channel| !channel.silent() && !channel.edge_is_rounding(step);
        let others = self.sound.channels().iter().enumerate().filter(|(_, channel)| sounding(channel));
        match least(others.map(|(i, channel)| (i, above_edge(channel)))) {
            Some((worst, ratio)) => (self.worst, self.ratio) = (worst, ratio),
            None => self.rounding = true,
        }
        self
    }

    /// The sound.
    pub fn sound(&self) -> &Sound {
        &self.sound
    }

    /// The other rate, if one was asked for.
    pub fn rate(&self) -> Option<f64> {
        self.rate
    }

    /// The tolerance in dB.
    pub fn tolerance(&self) -> f64 {
        self.tolerance
    }

    /// What would happen at the other rate, channel by channel; empty where none was asked for.
    pub fn forecasts(&self) -> &[Forecast] {
        &self.forecasts
    }

    /// The channel whose ratio is the least, counted from zero.
    pub fn worst(&self) -> usize {
        self.worst
    }

    /// Its ratio in dB; infinite where nothing folds.
    pub fn ratio(&self) -> f64 {
        self.ratio
    }

    /// Whether all channels hold at their top only what [rounding](Self::rounded_to) leaves, or nothing.
    pub fn only_rounding(&self) -> bool {
        self.rounding
    }

    /// Whether the ratio reaches the tolerance, or what would make it too small is [rounding alone](Self::only_rounding).
    pub fn fine(&self) -> bool {
        self.rounding || self.ratio >= self.tolerance
    }

    /// How many dB the aliases of a channel are, at their loudest moment, below the mean power of its signal, in the channel
    /// where that is least; only where it is less than the tolerance though no ratio of means is. A burst in a long sound is
    /// drowned in the mean and heard nevertheless.
    pub fn burst(&self) -> Option<f64> {
        self.burst_in().map(|(_, ratio)| ratio)
    }

    /// The same behind its channel, counted from zero.
    pub fn burst_in(&self) -> Option<(usize, f64)> {
        let ratio = |forecast: &Forecast| {
            forecast.loudest.map(|loudest| dbfs(forecast.outcomes[0].signal) - dbfs(loudest.beyond))
        };
        let ratios = self.forecasts.iter().enumerate().filter_map(|(i, forecast)| Some((i, ratio(forecast)?)));
        least(ratios).filter(|(_, ratio)| self.fine() && *ratio < self.tolerance)
    }

    /// How the spectrum of the sound ends: that of the channel that goes up the farthest. `None` of silence.
    pub fn ending(&self) -> Option<Ending> {
        let height = |ending: &Ending| ending.at().unwrap_or(f64::INFINITY);
        let endings = self.sound.channels().iter().filter_map(Channel::ending);
        endings.reduce(|a, b| if height(&b) > height(&a) { b } else { a })
    }

    /// The first of the filtered ways that keeps the aliases of all channels below the tolerance.
    pub fn remedy(&self) -> Option<Way> {
        let keeps = |way: usize| self.forecasts.iter().all(|f| f.outcomes[way].ratio() >= self.tolerance);
        (1..Way::ALL.len()).find(|way| keeps(*way)).map(|way| Way::ALL[way])
    }
}

/// The ratio at its own rate, in dB: of all to the last sixteenth.
fn above_edge(channel: &Channel) -> f64 {
    dbfs(channel.levels().power) - dbfs(channel.edge_power())
}

/// The channel whose ratio is the least, the first of several.
fn least(ratios: impl Iterator<Item = (usize, f64)>) -> Option<(usize, f64)> {
    ratios.reduce(|a, b| if b.1 < a.1 { b } else { a })
}
