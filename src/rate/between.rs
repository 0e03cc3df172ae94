//! Values of an oversampled signal at any times.

use crate::engine::Arithmetic;
use crate::engine::fft::Pool;
use crate::engine::nonuniform::Window;
use crate::engine::real::Real;
use crate::parallel;
use crate::rate::frames::Frames;
use crate::rate::phases::{Phases, TAPS};
use crate::rate::time::Time;
use std::f64::consts::PI;
use std::sync::atomic::{AtomicBool, Ordering::Relaxed};

/// How many frames are a piece of work.
const PIECE: usize = 2048;

/// How a signal is oversampled, and the window by which its values are then taken: as many times `up/down` as its highest
/// frequency asks for.
///
/// The window weakens high frequencies, up to `φ̂(0)/φ̂(1/(2σ))` times; they are made as much stronger before, and the
/// rounding of the transforms with them. So numbers of 32 bits, which have no digits to spare, get a shorter window on more
/// samples. By [`Window`]'s bound the errors are `12·e^{−πw√(1 − 1/σ)}`: 3·10⁻¹² of any tone, and 3·10⁻⁹ in 32 bits.
#[derive(Debug, Clone, Copy)]
pub(super) struct Oversampling {
    pub(super) up: usize,
    pub(super) down: usize,
    width: usize,
}

const WIDE: Oversampling = Oversampling { up: 3, down: 2, width: 16 };
const SINGLE: Oversampling = Oversampling { up: 2, down: 1, width: 10 };

impl Oversampling {
    /// By how much more the highest frequencies are made stronger than the lowest, at most. Windows meet where what they leave
    /// of these is not yet weakened again: filters must leave as much less of it.
    pub(super) const STRONGEST: f64 = 80.0;
    /// How far beyond the filter its gains reach, in samples. Where they end at the highest frequency with a slope of `s`,
    /// 19 times themselves, their response falls as `2s/(2πd)²`; all that it meets there is the end of Kaiser's window, a tenth
    /// of the filter's ripples.
    pub(super) const SPREAD: usize = 32;

    /// That for numbers of this kind.
    pub(super) const fn of<T>() -> Self {
        if size_of::<T>() == 8 { WIDE } else { SINGLE }
    }

    /// How many samples are needed before and after a time.
    pub(super) const fn reach(self) -> usize {
        self.width / 2
    }

    fn window(self) -> Window {
        Window::new(self.width, self.up as f64 / self.down as f64)
    }

    /// By how much its values err, as a part of any tone: the bound of [`Window`], and as much for its polynomials.
    fn error(self) -> f64 {
        let (width, ratio) = (self.width as f64, self.up as f64 / self.down as f64);
        12.0 * (-PI * width * (1.0 - 1.0 / ratio).sqrt()).exp()
    }

    /// By how much a tone of so many cycles a sample must be stronger for its values to be right.
    pub(super) fn gain(self) -> impl Fn(f64) -> f64 {
        let (window, highest) = (self.window(), self.highest());
        move |nu| 1.0 / window.transform(nu.min(highest))
    }

    /// The highest frequency, in cycles a sample.
    fn highest(self) -> f64 {
        0.5 * self.down as f64 / self.up as f64
    }
}

/// A window's values at all phases, and samples with the time of the next value among them.
pub(super) struct Between<T> {
    phases: Phases<T>,
    reach: usize,
    channels: usize,
    pub(super) samples: Vec<T>,
    start: u64,
    next: Time,
    step: Time,
    rooms: Pool<T>,
}

impl<T: Real> Between<T> {
    /// The first value stands at sample number `start`.
    pub(super) fn new(over: Oversampling, channels: usize, start: usize, step: Time, arithmetic: Arithmetic) -> Self {
        let allowed = over.error() / over.gain()(over.highest());
        let (phases, reach) = (Phases::new(&over.window(), allowed, arithmetic), over.reach());
        let start = start as u64;
        let next = Time { whole: start, fraction: 0 };
        Self { phases, reach, channels, samples: Vec::new(), start, next, step, rooms: Pool::new() }
    }

    /// How many more samples the next `count` values need.
    pub(super) fn missing(&self, count: usize) -> usize {
        let Some(before) = count.checked_sub(1) else { return 0 };
        let last = self.next.after(before as u64, self.step).whole as usize;
        (last + self.reach + 1).saturating_sub(self.samples.len() / self.channels)
    }

    /// Room for so many more samples.
    pub(super) fn more(&mut self, count: usize) -> &mut [T] {
        let start = self.samples.len();
        self.samples.resize(start + count * self.channels, T::zero());
        &mut self.samples[start..]
    }

    /// How many values the samples reach.
    pub(super) fn ready(&self) -> usize {
        let there = (self.samples.len() / self.channels) as f64;
        let step = self.step.whole as f64 + self.step.fraction as f64 * 0.5f64.powi(128);
        let (mut low, mut high) = (0, (there / step) as usize + 2);
        while low < high {
            let middle = (low + high).div_ceil(2);
            if self.missing(middle) == 0 { low = middle } else { high = middle - 1 }
        }
        low
    }

    /// Goes on by `count` values, and forgets the samples before the next.
    pub(super) fn go_on(&mut self, count: usize) {
        self.next = self.next.after(count as u64, self.step);
        let there = self.samples.len() / self.channels;
        let gone = (self.next.whole as usize).saturating_sub(self.reach - 1).min(there);
        self.samples.drain(..gone * self.channels);
        self.next.whole -= gone as u64;
    }

    /// Forgets all samples.
    pub(super) fn reset(&mut self) {
        self.samples.clear();
        self.next = Time { whole: self.start, fraction: 0 };
    }

    /// The values at the next times, whose samples are there; false if one is not finite.
    pub(super) fn fill(&self, out: &mut [T]) -> bool {
        let finite = AtomicBool::new(true);
        let channels = self.channels;
        let frames = Frames { kept: &self.samples, came: &[], channels };
        parallel::chunks(out, PIECE * channels, |piece, out| {
            let start = self.next.after((piece * PIECE) as u64, self.step);
            let end = start.after((out.len() / channels) as u64 - 1, self.step);
            let length = (end.whole - start.whole) as usize + TAPS;
            let first = start.whole as usize - (self.reach - 1);
            self.rooms.lend((length * channels).div_ceil(2), |room| {
                let lines: &mut [T] = bytemuck::cast_slice_mut(room);
                let lines = &mut lines[..length * channels];
                for (i, pair) in lines.chunks_mut(2 * length).enumerate() {
                    frames.read(2 * i, first, length, pair);
                }
                let time = Time { whole: 0, fraction: start.fraction };
                if !self.phases.values(time, self.step, lines, length, out) {
                    finite.store(false, Relaxed);
                }
            });
        });
        finite.into_inner()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_is_made_stronger_than_filters_know() {
        for over in [WIDE, SINGLE] {
            let most = over.gain()(over.highest()) / over.gain()(0.0);
            assert!(most <= Oversampling::STRONGEST, "{over:?}: {most}");
        }
    }

    #[test]
    fn values_that_overflow_are_told() {
        let step = Time { whole: 1, fraction: 1 << 127 };
        let mut between = Between::<f32>::new(SINGLE, 2, SINGLE.reach(), step, Arithmetic::Plain);
        for (value, finite) in [(f32::MAX, false), (0.25 * f32::MAX, true)] {
            between.reset();
            between.more(1000).fill(value);
            assert_eq!(between.fill(&mut [0.0; 200]), finite);
        }
    }
}
