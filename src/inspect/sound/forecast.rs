//! What would happen at another rate.

use crate::error::Result;
use crate::inspect::sound::channel::Channel;
use crate::inspect::sound::levels::dbfs;
use crate::inspect::sound::line::Line;
use crate::inspect::sound::meter::Sound;
use crate::inspect::sound::moment::Moment;
use crate::inspect::sound::standard::smallest_standard;
use crate::nyquist::{self, Landing, landings};
use crate::rate::{Quality, Response};

/// How a sound gets to another rate.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Way {
    /// By taking its values at the new times, and nothing else: every third sample, say; between samples those of its
    /// band-limited interpolation. Whatever lies beyond the new Nyquist frequency folds as strong as it is.
    Plain,
    /// Low-passed before, as [`Converter`](crate::rate::Converter) does.
    Filtered(Quality),
}

impl Way {
    /// All of them.
    pub const ALL: [Self; 4] =
        [Self::Plain, Self::Filtered(Quality::Fast), Self::Filtered(Quality::High), Self::Filtered(Quality::Best)];

    /// `plain`, or the name of the quality.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Plain => "plain",
            Self::Filtered(quality) => quality.name(),
        }
    }
}

/// What comes of a channel in one way.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Outcome {
    /// The way.
    pub way: Way,
    /// The mean square of what stays where it is: below the new Nyquist frequency.
    pub signal: f64,
    /// The mean square of what folds; of filtered ways the most that it can be.
    pub aliases: f64,
}

impl Outcome {
    /// The signal-to-alias ratio in dB; infinite where nothing folds.
    pub fn ratio(&self) -> f64 {
        if self.aliases == 0.0 { f64::INFINITY } else { dbfs(self.signal) - dbfs(self.aliases) }
    }
}

/// A line beyond the new Nyquist frequency, and what becomes of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Folded {
    /// The line as it is.
    pub line: Line,
    /// Where it lands.
    pub alias: nyquist::Alias,
    /// The most that its amplitude is multiplied by, for each of [`Way::ALL`].
    pub gains: [f64; 4],
}

/// A stretch of frequencies beyond the new Nyquist frequency.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stretch {
    /// From where to where, and where its ends land.
    pub landing: Landing,
    /// Its mean square.
    pub power: f64,
}

/// What sampling a channel at another rate would do.
#[derive(Debug, Clone, PartialEq)]
pub struct Forecast {
    /// The new rate, Hz.
    pub rate: f64,
    /// What comes of it, for each of [`Way::ALL`].
    pub outcomes: [Outcome; 4],
    /// The lines that fold, the strongest first.
    pub folded: Vec<Folded>,
    /// All that folds, in stretches that each land in one piece, rising.
    pub stretches: Vec<Stretch>,
    /// The moment at which what folds is loudest, where it is louder then than in the mean.
    pub loudest: Option<Moment>,
    /// Of [`Quality::ALL`].
    responses: [Response; 3],
}

impl Forecast {
    /// The most that the amplitude of a tone of this frequency is multiplied by on a way.
    pub fn gain(&self, way: Way, frequency: f64) -> f64 {
        gain(&self.responses, way, frequency)
    }
}

fn gain(responses: &[Response; 3], way: Way, frequency: f64) -> f64 {
    match way {
        Way::Plain => 1.0,
        Way::Filtered(quality) => responses[quality as usize].gain(frequency),
    }
}

/// Stretches are cut smaller where there are fewer.
const LEAST_STRETCHES: usize = 4;

impl Sound {
    /// What sampling at another rate (in Hz) would do to each channel.
    ///
    /// ```
    /// use nyquist::inspect::sound::Meter;
    /// use nyquist::num::sin_pi;
    /// // a tone, and one of a tenth of its amplitude beyond the Nyquist frequency of 16 kHz
    /// let tone = |f: f64, i: u32| sin_pi(2.0 * (f / 48_000.0 * f64::from(i)).fract());
    /// let mut meter = Meter::new(48_000.0, 1)?;
    /// meter.push(&(0..96_000).map(|i| 0.5 * tone(1_000.0, i) + 0.05 * tone(9_100.0, i)).collect::<Vec<_>>())?;
    /// let forecast = &meter.finish()?.sampled_at(16_000.0)?[0];
    /// let folded = &forecast.folded[0];
    /// assert!((folded.line.frequency - 9_100.0).abs() < 1e-6);
    /// assert!((folded.alias.frequency() - 6_900.0).abs() < 1e-6); // 16000 − 9100
    /// // plainly sampled it is there at −26 dB, 20 below the signal; converted, it is gone
    /// assert!((forecast.outcomes[0].ratio() - 20.0).abs() < 0.02);
    /// assert!(forecast.outcomes[2].ratio() > 170.0);
    /// # Ok::<(), nyquist::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// What [`Ratio::new`](crate::rate::Ratio::new) refuses: rates that are not positive and finite, or more than a factor
    /// of 1000 away.
    pub fn sampled_at(&self, rate: f64) -> Result<Vec<Forecast>> {
        let responses = Quality::ALL.map(|quality| Response::new(self.rate(), rate, quality));
        let [fast, high, best] = responses;
        let responses = [fast?, high?, best?];
        self.channels().iter().map(|channel| forecast(channel, rate, &responses)).collect()
    }

    /// The signal-to-alias ratio in dB of plain sampling at a rate, of the channel where it is least; infinite where
    /// nothing folds.
    pub fn plain_ratio(&self, rate: f64) -> f64 {
        let ratio = |channel: &Channel| outcome(channel, rate, Way::Plain, |_| 1.0).ratio();
        self.channels().iter().filter(|channel| !channel.silent()).map(ratio).fold(f64::INFINITY, f64::min)
    }

    /// The least standard rate below that of the sound at which plain sampling keeps all aliases at least `tolerance` dB
    /// below the signal; `None` where none does.
    pub fn smallest_rate(&self, tolerance: f64) -> Option<u32> {
        smallest_standard(|rate| self.plain_ratio(rate) >= tolerance).filter(|rate| f64::from(*rate) < self.rate())
    }
}

fn forecast(channel: &Channel, rate: f64, responses: &[Response; 3]) -> Result<Forecast> {
    let gain = |way: Way, frequency: f64| gain(responses, way, frequency);
    let nyquist = 0.5 * rate;
    let lines = channel.lines().into_iter().filter(|line| line.frequency >= nyquist);
    let folded = lines.map(|line| {
        let gains = Way::ALL.map(|way| gain(way, line.frequency));
        Ok(Folded { line, alias: nyquist::Alias::of(line.frequency, rate)?, gains })
    });
    let outcomes = Way::ALL.map(|way| outcome(channel, rate, way, |frequency| gain(way, frequency)));
    let louder = |moment: &Moment| rate < channel.spectrum().rate() && moment.beyond > outcomes[0].aliases;
    Ok(Forecast {
        rate,
        outcomes,
        folded: folded.collect::<Result<_>>()?,
        stretches: stretches(channel, rate)?,
        loudest: channel.loudest_beyond(nyquist).filter(louder),
        responses: *responses,
    })
}

/// What is below the new Nyquist frequency and what beyond, weighted by the gain; a bin on both sides by its parts.
fn outcome(channel: &Channel, rate: f64, way: Way, gain: impl Fn(f64) -> f64) -> Outcome {
    let spectrum = channel.whole();
    let nyquist = 0.5 * rate;
    let (mut signal, mut aliases) = (0.0, 0.0);
    if channel.silent() {
        return Outcome { way, signal, aliases };
    }
    let scale = channel.scale();
    for (k, density) in spectrum.density().iter().enumerate() {
        let (frequency, power) = (spectrum.frequency(k), density * spectrum.step() * scale);
        let below = ((nyquist - frequency) / spectrum.step() + 0.5).clamp(0.0, 1.0);
        // at its own rate nothing lies beyond
        let below = if rate >= spectrum.rate() { 1.0 } else { below };
        if below > 0.0 {
            signal += below * power * gain(frequency.min(nyquist)).powi(2);
        }
        if below < 1.0 {
            aliases += (1.0 - below) * power * gain(frequency.max(nyquist)).powi(2);
        }
    }
    Outcome { way, signal, aliases }
}

fn stretches(channel: &Channel, rate: f64) -> Result<Vec<Stretch>> {
    let top = 0.5 * channel.spectrum().rate();
    if rate >= channel.spectrum().rate() || channel.silent() {
        return Ok(Vec::new());
    }
    let pieces = &landings(top, rate)?[1..];
    let parts = LEAST_STRETCHES.div_ceil(pieces.len());
    let part = |piece: &Landing, i: usize| {
        let between = |[a, b]: [f64; 2]| [i, i + 1].map(|i| a + (b - a) * i as f64 / parts as f64);
        Landing { from: between(piece.from), to: between(piece.to) }
    };
    let cut = pieces.iter().flat_map(|piece| (0..parts).map(move |i| part(piece, i)));
    let power = |landing: &Landing| channel.power_within(landing.from[0], landing.from[1]);
    Ok(cut.map(|landing| Stretch { power: power(&landing), landing }).collect())
}
