//! The first and the last moments of a sound, which long segments hardly cover.

use crate::engine::fft::{Butterflies, RealFft};
use crate::inspect::sound::window::{BETA, lobe, width};
use crate::num::mean::weighted_mean;
use crate::sampled::welch::PowerSpectrum;
use crate::sampled::window::Window;
use num_complex::Complex;

/// How many times shorter windows are from one level to the next, and how many hops a window is long.
const PART: usize = 8;
/// The shortest window that tells frequencies apart at all.
const LEAST: usize = 32;
/// What is not worth another window: less than a millionth of what sounds there, where the windows before add up to one but
/// for 0.3 % (0.013 dB) anyway.
const COVERED: f64 = 1e-6;

const LENGTH: &str = "rooms are as long as their window";

/// The frames at both ends, kept while others pass.
#[derive(Debug)]
pub(super) struct Ends {
    channels: usize,
    /// So many values of all channels are kept at either end.
    room: usize,
    first: Vec<f64>,
    last: Vec<f64>,
}

impl Ends {
    /// Beside segments of so many samples.
    pub(super) fn new(channels: usize, segment: usize) -> Self {
        let room = (segment + segment / PART) * channels;
        Self { channels, room, first: Vec::new(), last: Vec::new() }
    }

    pub(super) fn push(&mut self, frames: &[f64]) {
        let missing = self.room.saturating_sub(self.first.len());
        self.first.extend(&frames[..missing.min(frames.len())]);
        self.last.extend(&frames[frames.len().saturating_sub(self.room)..]);
        // now and then, so that each frame is moved a few times and not every time
        if self.last.len() > 4 * self.room {
            self.last.drain(..self.last.len() - self.room);
        }
    }

    /// The spectrum of a whole channel, from that of the long segments: in the ends what these leave out is heard through
    /// windows an eighth as long, and what those leave out through windows an eighth as long again. What such a window finds
    /// in one of its wide bins is shared among the narrow ones that it can have come from, as these share their power in
    /// the rest of the sound: so a tone that is cut off stays a line, and a burst at the beginning counts.
    ///
    /// `frames` is the length of the sound. At either end the mean under the window of the long segment there is taken away,
    /// as it is from that segment: the plain mean of a tone is not zero. Of the whole the power is right, but for
    /// the last hundred samples or so at either end; a line is no more exact than a bin.
    pub(super) fn complete(&self, channel: usize, spectrum: &PowerSpectrum, frames: u64) -> PowerSpectrum {
        let cut = spectrum.cut();
        let weights = Window::Kaiser(BETA).values(cut.length());
        let of = |values: &[f64], reversed: bool| {
            let mut values: Vec<f64> = values.iter().skip(channel).step_by(self.channels).copied().collect();
            if reversed {
                values.reverse();
            }
            // there are at least as many frames as a segment has
            let mean = weighted_mean(&values[..cut.length()], &weights);
            values.iter_mut().for_each(|v| *v -= mean);
            values
        };
        // power does not know the direction of time
        let (first, last) = (of(&self.first, false), of(&self.last, true));
        let rest = frames - cut.length() as u64 - (spectrum.segments() - 1) * cut.hop() as u64;
        let half = usize::try_from(frames / 2).unwrap_or(usize::MAX);
        let mut factors = vec![(spectrum.segments() * cut.hop() as u64) as f64; spectrum.density().len()];
        for (values, offset) in [(first, 0), (last, rest as usize)] {
            share(&values, offset, half, spectrum, &mut factors);
        }
        let density = spectrum.density().iter().zip(&factors).map(|(p, factor)| p * factor / frames as f64);
        spectrum.with_density(density.collect())
    }
}

/// Adds to the factors of all bins what one end has beyond the long segments, whose first one starts at `offset`; all in
/// squared values, summed.
fn share(values: &[f64], offset: usize, half: usize, spectrum: &PowerSpectrum, factors: &mut [f64]) {
    let cut = spectrum.cut();
    let reached = values.len().min(half).min(cut.length());
    let mut covered = vec![0.0; values.len()];
    let starts = (0..spectrum.segments() as usize).map(|j| offset + j * cut.hop()).take_while(|s| *s < reached);
    let long = squared(cut.length(), cut.hop());
    starts.for_each(|start| cover(&mut covered, start, &long, 1.0));
    let mut length = cut.length() / PART;
    while length >= LEAST {
        let hop = length / PART;
        let weights = Window::Kaiser(BETA).values(length);
        let squares = squared(length, hop);
        let fft = RealFft::with(length, Butterflies::Scalar).expect(LENGTH);
        let mut half = vec![Complex::default(); length / 2 + 1];
        let (mut powers, mut more) = (vec![0.0; length / 2 + 1], covered.clone());
        for start in (0..reached).step_by(hop) {
            let Some(piece) = values.get(start..start + length).filter(|_| start + length / 2 < reached) else { break };
            let part = 1.0 - covered[start + length / 2];
            if part < COVERED {
                continue;
            }
            let windowed: Vec<f64> = piece.iter().zip(&weights).map(|(v, w)| v * w).collect();
            fft.forward(&windowed, &mut half).expect(LENGTH);
            // one-sided, and as much as the squared windows of one hop add up to
            let scale = 2.0 * part * squares[length / 2] / (weights[length / 2].powi(2) * length as f64);
            powers.iter_mut().zip(&half).for_each(|(sum, z)| *sum += scale * z.norm_sqr());
            cover(&mut more, start, &squares, part);
        }
        distribute(&powers, spectrum, factors);
        covered = more;
        length /= PART;
    }
}

/// Squared windows that, a hop apart, add up to one.
fn squared(length: usize, hop: usize) -> Vec<f64> {
    let weights = Window::Kaiser(BETA).values(length);
    let scale = hop as f64 / weights.iter().map(|w| w * w).sum::<f64>();
    weights.iter().map(|w| w * w * scale).collect()
}

fn cover(covered: &mut [f64], start: usize, squares: &[f64], part: f64) {
    covered[start..].iter_mut().zip(squares).for_each(|(sum, square)| *sum += part * square);
}

/// Shares the power of wide bins among the narrow ones around, by what these hold otherwise and by the shape of a line: a
/// step of the method of Richardson (1972) and Lucy (1974) from there.
fn distribute(powers: &[f64], spectrum: &PowerSpectrum, factors: &mut [f64]) {
    let density = spectrum.density();
    let narrow = spectrum.cut().length() / (2 * (powers.len() - 1));
    let far = (width() * narrow as f64) as usize;
    let shape: Vec<f64> = (0..=far).map(|k| lobe(k as f64 / narrow as f64).powi(2)).collect();
    for (j, power) in powers.iter().enumerate() {
        let middle = j * narrow;
        let around = middle.saturating_sub(far)..(middle + far + 1).min(density.len());
        let found: f64 = around.clone().map(|k| density[k] * shape[k.abs_diff(middle)]).sum();
        if found > 0.0 {
            let share = power / (found * spectrum.step());
            around.for_each(|k| factors[k] += share * shape[k.abs_diff(middle)]);
        }
    }
}
