//! What is known of one channel.

use crate::error::Result;
use crate::inspect::sound::ending::Ending;
use crate::inspect::sound::floor::Floor;
use crate::inspect::sound::levels::Levels;
use crate::inspect::sound::line::{Line, lines, lowest};
use crate::inspect::sound::moment::{Lane, Moment};
use crate::sampled::welch::PowerSpectrum;

/// The part of the spectrum below the Nyquist frequency that says how much may lie beyond.
const EDGE: f64 = 1.0 / 16.0;
/// The part of the power above the end of a spectrum that is not passed over: that of aliases at the
/// [tolerance](super::TOLERANCE) where none is given, 60 dB.
const MISSED: f64 = 1e-6;
/// The part of the power below which no spectrum is said to end, unless the rest is its noise: that of the last of the bands
/// that are reported, so that no end stands below a band.
const NEARLY_ALL: f64 = 0.9999;

/// What a [`Meter`](super::Meter) has heard of one channel.
#[derive(Debug, Clone)]
pub struct Channel {
    levels: Levels,
    spectrum: PowerSpectrum,
    whole: PowerSpectrum,
    averages: f64,
    moments: Lane,
}

impl Channel {
    pub(super) fn new(
        levels: Levels,
        spectrum: PowerSpectrum,
        whole: PowerSpectrum,
        averages: f64,
        moments: Lane,
    ) -> Self {
        Self { levels, spectrum, whole, averages, moments }
    }

    /// Peak, mean, mean square.
    pub fn levels(&self) -> Levels {
        self.levels
    }

    /// Whether there is no sound: all values are the same. Then there is no band, no floor, no ending.
    pub fn silent(&self) -> bool {
        self.levels.constant()
    }

    /// Its averaged spectrum, without its mean: Welch's, in which what lies within a third of a segment from either end of the
    /// sound counts less than 5 %, and all that lies farther inside than six tenths of one fully. Lines are exact in it.
    pub fn spectrum(&self) -> &PowerSpectrum {
        &self.spectrum
    }

    /// The same of the whole, with the ends as heard through shorter windows: powers are right in it, and bands.
    pub fn whole(&self) -> &PowerSpectrum {
        &self.whole
    }

    /// The least frequency below which `fraction` of the power lies; `None` of silence.
    ///
    /// # Errors
    /// A fraction that is not strictly between zero and one.
    pub fn occupied(&self, fraction: f64) -> Result<Option<f64>> {
        let occupied = self.whole.occupied(fraction)?;
        Ok(occupied.filter(|_| !self.silent()))
    }

    /// The noise floor; `None` of silence.
    pub fn floor(&self) -> Option<Floor> {
        (!self.silent()).then(|| Floor::of(&self.spectrum, self.averages))
    }

    /// How the spectrum ends; `None` of silence. Where a part of 10⁻⁶ of the power lies above that and is in the first or the
    /// last moment only, how that of the whole does.
    pub fn ending(&self) -> Option<Ending> {
        let floor = self.floor()?;
        let band = self.occupied(NEARLY_ALL).ok().flatten().unwrap_or_default();
        let ending = Ending::of(&self.spectrum, &floor, self.averages, band);
        let above = |spectrum: &PowerSpectrum, at: f64| spectrum.power(at, 0.5 * spectrum.rate()) / spectrum.total();
        let missed = ending.at().is_some_and(|at| {
            let here = above(&self.whole, at);
            here > MISSED && here > 2.0 * above(&self.spectrum, at)
        });
        Some(if missed { Ending::of(&self.whole, &floor, self.averages, band) } else { ending })
    }

    /// The lines of the spectrum, the strongest first.
    ///
    /// ```
    /// use nyquist::inspect::sound::Meter;
    /// use nyquist::num::sin_pi;
    /// let tone = |f: f64, i: u32| sin_pi(2.0 * (f / 48_000.0 * f64::from(i)).fract());
    /// let mut meter = Meter::new(48_000.0, 1)?;
    /// meter.push(&(0..96_000).map(|i| 0.5 * tone(997.3, i) + 1e-4 * tone(12_345.6, i)).collect::<Vec<_>>())?;
    /// let lines = meter.finish()?.channels()[0].lines();
    /// assert_eq!(lines.len(), 2);
    /// assert!((lines[0].frequency - 997.3).abs() < 1e-6 && (lines[0].amplitude - 0.5).abs() < 1e-8);
    /// assert!((lines[1].frequency - 12_345.6).abs() < 1e-5 && (lines[1].amplitude - 1e-4).abs() < 1e-10);
    /// # Ok::<(), nyquist::error::Error>(())
    /// ```
    pub fn lines(&self) -> Vec<Line> {
        if self.silent() { Vec::new() } else { lines(&self.spectrum, self.averages) }
    }

    /// The frequency in Hz, three bins, below which a tone cannot be told apart from the mean and its drift.
    pub fn lowest_line(&self) -> f64 {
        lowest(&self.spectrum)
    }

    /// The last sixteenth of the spectrum below the Nyquist frequency: from where to where, in Hz.
    pub fn edge(&self) -> [f64; 2] {
        let nyquist = 0.5 * self.spectrum.rate();
        [(1.0 - EDGE) * nyquist, nyquist]
    }

    /// The mean square of the last sixteenth of the spectrum below the Nyquist frequency. What lay as near beyond it when
    /// the sound was sampled was about as strong, and has folded, as far as no filter took it away: so it says how
    /// much of the sound may be aliases.
    pub fn edge_power(&self) -> f64 {
        let [from, to] = self.edge();
        self.power_within(from, to)
    }

    /// Whether the last sixteenth holds no more than rounding to multiples of `step` leaves there, `step²/12` over all
    /// frequencies, three times as much with triangular dither; twice that, since a sixteenth of the noise of a short
    /// record scatters. Then nothing there is known to have been sound.
    pub fn edge_is_rounding(&self, step: f64) -> bool {
        self.edge_power() <= EDGE * 0.5 * step * step
    }

    /// The mean square of what lies within frequencies `from..to`, as a part of [`Levels::power`]; zero of silence.
    pub fn power_within(&self, from: f64, to: f64) -> f64 {
        if self.silent() { 0.0 } else { self.whole.power(from, to) * self.scale() }
    }

    /// From the spectrum, which leaves out a hundred samples, to the mean square of all.
    pub(super) fn scale(&self) -> f64 {
        self.levels.power / self.whole.total()
    }

    /// The loudest moment of what lies beyond a frequency, in stretches of an eighth of a segment, at least 64 samples;
    /// `None` where there is nothing.
    pub fn loudest_beyond(&self, frequency: f64) -> Option<Moment> {
        self.moments.beyond(frequency).filter(|_| !self.silent())
    }
}
