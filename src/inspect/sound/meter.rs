//! Frames in, findings out.

use crate::error::{Error, Result, positive, within};
use crate::inspect::sound::channel::Channel;
use crate::inspect::sound::ends::Ends;
use crate::inspect::sound::levels::Gauge;
use crate::inspect::sound::moment::Moments;
use crate::inspect::sound::window::BETA;
use crate::sampled::segments::{Detrend, LARGEST, Segments, peak, whole_frames};
use crate::sampled::welch::Welch;
use crate::sampled::window::Window;

/// Sound of fewer frames has no band that could be told.
pub const LEAST_FRAMES: usize = 64;
/// The longest segment, in samples.
const MOST_SEGMENT: usize = 1 << 14;
/// Segments of all channels together have at most so many samples, or as many as the shortest have.
const MOST_VALUES: usize = 1 << 19;
/// Segments are at most this part of the sound, hops this part of a segment.
const PART: usize = 8;

/// Looks into sound that comes in frames, in blocks of any size.
///
/// ```
/// use nyquist::inspect::sound::{Ending, Meter};
/// use nyquist::num::sin_pi;
/// use nyquist::rate::{Quality, convert};
/// // noise at 16 kHz, and as it is after conversion to 48 kHz: its top is empty
/// let noise: Vec<f64> = (0..32_000).map(|i| nyquist::num::random::uniform(1, i, 0) - 0.5).collect();
/// let mut meter = Meter::new(48_000.0, 1)?;
/// meter.push(&convert(&noise, 16_000.0, 48_000.0, Quality::Fast)?)?;
/// let sound = meter.finish()?;
/// let ending = sound.channels()[0].ending();
/// assert!(matches!(ending, Some(Ending::Cut { at, drop }) if at > 7_500.0 && at < 8_000.0 && drop > 60.0));
/// assert_eq!(ending.and_then(|ending| ending.enough()), Some(16_000));
/// # Ok::<(), nyquist::error::Error>(())
/// ```
#[derive(Debug)]
pub struct Meter {
    rate: f64,
    channels: usize,
    frames: u64,
    /// The size of the largest value.
    peak: f64,
    gauges: Vec<Gauge>,
    /// The first frames, until there are enough to choose how long segments are.
    head: Vec<f64>,
    spectra: Option<Spectra>,
}

/// What needs to know how long segments are.
#[derive(Debug)]
struct Spectra {
    welch: Welch,
    moments: Moments,
    ends: Ends,
}

impl Spectra {
    fn push(&mut self, frames: &[f64]) -> Result<()> {
        self.welch.push(frames)?;
        self.moments.push(frames)?;
        self.ends.push(frames);
        Ok(())
    }
}

impl Meter {
    /// For frames of so many channels at a rate in Hz.
    ///
    /// # Errors
    /// A rate that is not positive and finite; no channels.
    pub fn new(rate: f64, channels: usize) -> Result<Self> {
        positive("the sampling rate", rate)?;
        if channels == 0 {
            return Err(Error::TooFew { what: "channels", least: 1, got: 0 });
        }
        Ok(Self { rate, channels, frames: 0, peak: 0.0, gauges: Vec::new(), head: Vec::new(), spectra: None })
    }

    /// The longest segment for so many channels: a power of two.
    fn longest(&self) -> usize {
        let fits = MOST_VALUES / self.channels;
        1 << fits.clamp(LEAST_FRAMES, MOST_SEGMENT).ilog2()
    }

    /// Takes whole frames, one value for each channel in turn.
    ///
    /// # Errors
    /// [`Error::Length`] for a part of a frame, [`Error::NotFiniteAt`], values beyond 10¹⁴⁰; nothing has been taken then.
    pub fn push(&mut self, frames: &[f64]) -> Result<()> {
        whole_frames(frames, self.channels)?;
        self.peak = peak(self.peak, frames)?;
        if self.gauges.is_empty() {
            self.gauges = frames.iter().take(self.channels).map(|first| Gauge::new(*first)).collect();
        }
        for (channel, gauge) in self.gauges.iter_mut().enumerate() {
            gauge.add(frames.iter().skip(channel).step_by(self.channels).copied());
        }
        self.frames += (frames.len() / self.channels) as u64;
        match &mut self.spectra {
            Some(spectra) => spectra.push(frames),
            None => {
                self.head.extend(frames);
                if self.head.len() >= PART * self.longest() * self.channels {
                    self.choose(self.longest())
                } else {
                    Ok(())
                }
            }
        }
    }

    /// Segments of so many samples, from the first frame on.
    fn choose(&mut self, length: usize) -> Result<()> {
        let segments = Segments::new(length, length / PART, Window::Kaiser(BETA))?.detrend(Detrend::WindowedMean);
        let welch = Welch::new(self.rate, self.channels, segments)?;
        let moments = Moments::new(self.rate, self.channels, (length / PART).max(LEAST_FRAMES))?;
        let ends = Ends::new(self.channels, length);
        let head = std::mem::take(&mut self.head);
        self.spectra.insert(Spectra { welch, moments, ends }).push(&head)
    }

    /// Ends the sound.
    ///
    /// # Errors
    /// Fewer than [`LEAST_FRAMES`] frames; a sound that is no silence, but nowhere above 10⁻¹⁴⁰.
    pub fn finish(mut self) -> Result<Sound> {
        if self.spectra.is_none() {
            let frames = self.frames as usize;
            if frames < LEAST_FRAMES {
                let what = "frames of a sound that is to be looked into";
                return Err(Error::TooFew { what, least: LEAST_FRAMES, got: frames });
            }
            // the largest power of two that is at most an eighth of all
            let eighth = (frames / PART).max(LEAST_FRAMES);
            self.choose(1 << eighth.ilog2())?;
        }
        if self.peak > 0.0 {
            within("the size of the largest sample, whose square is needed", self.peak, 1.0 / LARGEST, LARGEST)?;
        }
        let Self { rate, frames, gauges, spectra, .. } = self;
        let Spectra { welch, moments, ends } = spectra.expect("segments have been chosen by now");
        let spectra = welch.finish()?;
        let averages = spectra.first().map_or(1.0, |s| s.cut().independent(s.segments()));
        let heard = gauges.iter().zip(spectra).zip(moments.finish()).enumerate();
        let channels = heard.map(|(i, ((gauge, spectrum), lane))| {
            let levels = gauge.read();
            let whole = ends.complete(i, &spectrum, frames);
            Channel::new(levels, spectrum, whole, averages, lane)
        });
        Ok(Sound { rate, frames, channels: channels.collect() })
    }
}

/// What a [`Meter`] has heard.
#[derive(Debug, Clone)]
pub struct Sound {
    rate: f64,
    frames: u64,
    channels: Vec<Channel>,
}

impl Sound {
    /// Frames a second, in Hz.
    pub fn rate(&self) -> f64 {
        self.rate
    }

    /// How many frames there were.
    pub fn frames(&self) -> u64 {
        self.frames
    }

    /// The channels, at least one.
    pub fn channels(&self) -> &[Channel] {
        &self.channels
    }
}
