//! The loudest moments of a sound beyond any frequency: a mean over all of it would drown a short burst.

use crate::error::Result;
use crate::inspect::sound::window::{BETA, reach};
use crate::sampled::segments::{Detrend, Periodograms, Segments};
use crate::sampled::window::Window;

/// A short stretch of sound.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Moment {
    /// Its middle, in seconds from the first frame.
    pub time: f64,
    /// The mean square beyond the frequency asked for and the width of a line there, eight bins of the stretch: nearer, a
    /// tone below that frequency could not be told from what is beyond.
    pub beyond: f64,
    /// The mean square of all.
    pub total: f64,
}

/// The loudest moments of each channel, while frames come in.
#[derive(Debug)]
pub(super) struct Moments {
    rate: f64,
    periodograms: Periodograms,
    lanes: Vec<Lane>,
    /// From a sum of squared magnitudes to a mean square.
    scale: f64,
}

/// The loudest segments of a channel beyond bin `k`, for every `k`.
#[derive(Debug, Clone)]
pub(super) struct Lane {
    best: Vec<Moment>,
    sums: Vec<f64>,
    count: u64,
    step: f64,
}

impl Moments {
    /// Of segments of so many samples.
    pub(super) fn new(rate: f64, channels: usize, length: usize) -> Result<Self> {
        let window = Window::Kaiser(BETA);
        let segments = Segments::new(length, length / 4, window)?.detrend(Detrend::WindowedMean);
        let periodograms = Periodograms::new(segments, channels)?;
        let power: f64 = window.values(length).iter().map(|w| w * w).sum();
        let bins = length / 2 + 1;
        let step = rate / length as f64;
        let lane = Lane { best: vec![Moment::default(); bins], sums: vec![0.0; bins], count: 0, step };
        Ok(Self { rate, periodograms, lanes: vec![lane; channels], scale: 1.0 / (length as f64 * power) })
    }

    pub(super) fn push(&mut self, frames: &[f64]) -> Result<()> {
        let Self { periodograms, lanes, rate, scale } = self;
        let segments = periodograms.segments();
        periodograms.push(frames, |channel, powers| lanes[channel].add(powers, segments, *rate, *scale))
    }

    pub(super) fn finish(self) -> Vec<Lane> {
        let Self { rate, periodograms, mut lanes, scale } = self;
        let segments = periodograms.segments();
        periodograms.finish(|channel, powers| lanes[channel].add(powers, segments, rate, scale));
        lanes
    }
}

impl Lane {
    fn add(&mut self, powers: &[f64], segments: Segments, rate: f64, scale: f64) {
        let last = powers.len() - 1;
        let mut sum = 0.0;
        for (k, power) in powers.iter().enumerate().rev() {
            sum += power * if k == 0 || k == last { scale } else { 2.0 * scale };
            self.sums[k] = sum;
        }
        let time = (self.count as f64 * segments.hop() as f64 + 0.5 * segments.length() as f64) / rate;
        for (best, beyond) in self.best.iter_mut().zip(&self.sums) {
            if *beyond > best.beyond {
                *best = Moment { time, beyond: *beyond, total: sum };
            }
        }
        self.count += 1;
    }

    /// The loudest moment beyond a frequency, from where no line below it reaches; `None` where nothing is there.
    pub(super) fn beyond(&self, frequency: f64) -> Option<Moment> {
        let k = ((frequency / self.step).ceil().max(0.0) as usize).saturating_add(reach());
        self.best.get(k).copied().filter(|moment| moment.beyond > 0.0)
    }
}
