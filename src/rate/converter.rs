//! Blocks in, blocks out.

use crate::error::{Error, Result};
use crate::parallel;
use crate::rate::between::{Between, Steps};
use crate::rate::blocks::{Blocks, Lane};
use crate::rate::quality::Quality;
use crate::rate::ratio::{Ratio, too_much};
use crate::sampled::segments::whole_frames;

/// The most values that all channels may keep between blocks: 4 GB.
const MOST_ROOM: usize = 1 << 29;
/// Windows longer than this are avoided where there is another way.
const LONG: usize = 1 << 23;

/// A conversion of rates under way, of any number of channels.
///
/// ```
/// use nyquist::num::sin_pi;
/// use nyquist::rate::{Converter, Quality};
/// // a tone of 20 kHz, in blocks
/// let tone = |rate: f64, i: usize| sin_pi(2.0 * 20_000.0 * i as f64 / rate);
/// let mut converter = Converter::new(44_100.0, 48_000.0, 1, Quality::Best)?;
/// let mut converted = Vec::new();
/// for block in 0..10 {
///     let samples: Vec<f64> = (0..4410).map(|i| tone(44_100.0, 4410 * block + i)).collect();
///     converter.push(&samples, &mut converted)?;
/// }
/// converter.finish(&mut converted);
/// assert_eq!(converted.len(), 48_000);
/// // in the middle it is the same tone, at the same phase, to 200 dB
/// let worst = (8_000..40_000).map(|i| (converted[i] - tone(48_000.0, i)).abs()).fold(0.0, f64::max);
/// assert!(worst < 1e-10);
/// # Ok::<(), nyquist::error::Error>(())
/// ```
pub struct Converter {
    ratio: Ratio,
    way: Way,
    channels: Vec<Channel>,
    /// Frames that came, and that went.
    taken: u64,
    given: u64,
}

/// What is the same for all channels.
enum Way {
    /// Equal rates.
    Copy,
    /// Through the spectrum.
    Whole(Blocks),
    /// Through the spectrum to an oversampled signal, and from there to any times.
    Real(Blocks, Between),
}

struct Channel {
    lane: Option<Lane>,
    steps: Option<Steps>,
    /// Values that are done.
    ready: Vec<f64>,
}

impl std::fmt::Debug for Converter {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let (ratio, channels) = (self.ratio, self.channels.len());
        write!(f, "Converter {{ {ratio:?}, channels: {channels}, taken: {}, given: {} }}", self.taken, self.given)
    }
}

impl Converter {
    /// From one rate to another (in the same unit), for frames of so many channels.
    ///
    /// # Errors
    /// Rates that are not positive or more than a factor of 1000 apart ([`Ratio::new`]); no channels; so many that their
    /// windows do not fit into 4 GB.
    pub fn new(from: f64, to: f64, channels: usize, quality: Quality) -> Result<Self> {
        let ratio = Ratio::new(from, to)?;
        if channels == 0 {
            return Err(Error::TooFew { what: "channels", least: 1, got: 0 });
        }
        let fits = |room: usize| match room.saturating_mul(channels) {
            room if room > MOST_ROOM => Err(too_much(room as f64, MOST_ROOM as f64)),
            _ => Ok(()),
        };
        let (way, lead, step) = match ratio.terms() {
            Some((1, 1)) => (Way::Copy, 0, None),
            Some((up, down)) if up < down || Blocks::room(up, down, 1.0, quality) <= LONG => {
                fits(Blocks::room(up, down, 1.0, quality))?;
                (Way::Whole(Blocks::new(up, down, 1.0, quality)), 0, None)
            }
            _ => {
                // twice the rate, or the least whole fraction of it that is at least twice the new one
                let down = (0.5 / ratio.value()).floor().max(1.0) as usize;
                let up = if down == 1 { 2 } else { 1 };
                let between = up as f64 / down as f64;
                let scale = ratio.value().min(1.0) / between.min(1.0);
                fits(Blocks::room(up, down, scale, quality))?;
                let (blocks, between) = (Blocks::new(up, down, scale, quality), Between::new());
                // the filter rings before the first sample: so much silence first
                let lead = between.reach().div_ceil(up);
                let step = Some((lead * up, ratio.step(up, down)));
                (Way::Real(blocks, between), lead * down, step)
            }
        };
        let channel = || {
            let lane = match &way {
                Way::Copy => None,
                Way::Whole(blocks) | Way::Real(blocks, _) => Some(blocks.lane()),
            };
            let lane = lane.map(|mut lane| {
                lane.queue.resize(lane.queue.len() + lead, 0.0);
                lane
            });
            Channel { lane, steps: step.map(|(start, step)| Steps::new(start, step)), ready: Vec::new() }
        };
        let channels = (0..channels).map(|_| channel()).collect();
        Ok(Self { ratio, way, channels, taken: 0, given: 0 })
    }

    /// The ratio of both rates.
    pub fn ratio(&self) -> Ratio {
        self.ratio
    }

    /// Takes whole frames, one value for each channel in turn, and appends to `out` those frames that they decide.
    ///
    /// # Errors
    /// [`Error::Length`] for a part of a frame, [`Error::NotFiniteAt`]; nothing has been taken then.
    pub fn push(&mut self, frames: &[f64], out: &mut Vec<f64>) -> Result<()> {
        let count = self.channels.len();
        whole_frames(frames, count)?;
        self.taken += (frames.len() / count) as u64;
        let way = &self.way;
        parallel::chunks(&mut self.channels, 1, |i, channel| {
            channel[0].push(way, frames.iter().skip(i).step_by(count).copied());
        });
        self.give(u64::MAX, out);
        Ok(())
    }

    /// Ends the input, and appends to `out` all that is left: in all there come `round(n·R/R₀)` frames.
    pub fn finish(mut self, out: &mut Vec<f64>) {
        let total = self.ratio.frames(self.taken);
        let way = &self.way;
        let missing = (total - self.given) as usize;
        parallel::chunks(&mut self.channels, 1, |_, channel| {
            while channel[0].ready.len() < missing {
                channel[0].flush(way);
            }
        });
        self.give(total, out);
    }

    /// Moves what all channels have into frames, up to frame `most` of all.
    fn give(&mut self, most: u64, out: &mut Vec<f64>) {
        let ready = self.channels[0].ready.len();
        // what lies beyond the frames taken so far is not given before the end: there may be none
        let allowed = self.ratio.frames(self.taken).min(most) - self.given;
        let count = ready.min(usize::try_from(allowed).unwrap_or(usize::MAX));
        out.reserve(count * self.channels.len());
        for frame in 0..count {
            out.extend(self.channels.iter().map(|channel| channel.ready[frame]));
        }
        self.channels.iter_mut().for_each(|channel| drop(channel.ready.drain(..count)));
        self.given += count as u64;
    }
}

impl Channel {
    fn push(&mut self, way: &Way, values: impl Iterator<Item = f64>) {
        match &mut self.lane {
            None => self.ready.extend(values),
            Some(lane) => lane.queue.extend(values),
        }
        self.run(way, Blocks::run);
    }

    fn flush(&mut self, way: &Way) {
        self.run(way, Blocks::flush);
    }

    fn run(&mut self, way: &Way, blocks_run: fn(&Blocks, &mut Lane, &mut Vec<f64>)) {
        match (way, &mut self.lane, &mut self.steps) {
            (Way::Whole(blocks), Some(lane), _) => blocks_run(blocks, lane, &mut self.ready),
            (Way::Real(blocks, between), Some(lane), Some(steps)) => {
                blocks_run(blocks, lane, &mut steps.samples);
                between.run(steps, &mut self.ready);
            }
            _ => {}
        }
    }
}

/// A whole record of one channel at another rate.
///
/// ```
/// use nyquist::rate::{Quality, convert};
/// let down = convert(&[1.0; 96_000], 96_000.0, 44_100.0, Quality::High)?;
/// assert_eq!(down.len(), 44_100);
/// assert!(down[1_000..43_000].iter().all(|v| (v - 1.0).abs() < 1e-7));
/// # Ok::<(), nyquist::error::Error>(())
/// ```
///
/// # Errors
/// Those of [`Converter::new`]; values that are not finite.
pub fn convert(values: &[f64], from: f64, to: f64, quality: Quality) -> Result<Vec<f64>> {
    let mut converter = Converter::new(from, to, 1, quality)?;
    let mut out = Vec::new();
    converter.push(values, &mut out)?;
    converter.finish(&mut out);
    Ok(out)
}
