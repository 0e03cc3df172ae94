//! Ratios of whole numbers: window by window, through the spectrum.

use crate::engine::fft::{Butterflies, Pool, RealFft};
use crate::engine::real::Real;
use crate::parallel;
use crate::rate::between::Oversampling;
use crate::rate::design::LowPass;
use crate::rate::frames::{Frames, write};
use crate::rate::quality::Quality;
use crate::rate::ratio::Ratio;
use bytemuck::cast_slice_mut;
use num_complex::Complex;
use std::sync::atomic::{AtomicBool, Ordering::Relaxed};

/// Windows are at least so long, at the lower rate.
const LEAST_WINDOW: usize = 2048;
/// Windows are not made longer than this only to throw away less of them.
const MOST_WINDOW: usize = 1 << 20;
/// Windows longer than this are avoided where there is another way.
const LONG: usize = 1 << 23;

const WINDOW: &str = "rooms are as long as their windows";

/// A conversion by `up/down`, low-passed, and the frames that wait for their window.
pub(super) struct Blocks<T> {
    forward: RealFft<T>,
    inverse: RealFft<T>,
    /// The filter at the frequencies that both windows have, over the length of the input's window.
    gains: Vec<T>,
    up: usize,
    down: usize,
    /// A window is so many times `down` samples, and becomes as many times `up`.
    window: usize,
    /// So many of them at either side are touched by the neighbouring windows' samples.
    side: usize,
    channels: usize,
    /// So many frames of silence come before the first.
    lead: usize,
    kept: Vec<T>,
    rooms: Pool<T>,
}

impl<T: Real> Blocks<T> {
    /// With `lead` frames of silence before the first.
    pub(super) fn new(design: Design, channels: usize, lead: usize, butterflies: Butterflies) -> Self {
        let Design { up, down, filter, over, window, side } = design;
        let low = up.min(down) * window;
        let reach = filter.radius().floor() as usize;
        // the filter at the samples of the lower rate, those before zero at the end
        let mut taps = vec![0.0; low];
        for i in 0..=reach {
            taps[i] = filter.at(i as f64);
            taps[(low - i) % low] = taps[i];
        }
        let mut spectrum = vec![Complex::default(); low / 2 + 1];
        let real_fft = RealFft::<f64>::with(low, Butterflies::Scalar).expect(WINDOW);
        real_fft.forward(&taps, &mut spectrum).expect(WINDOW);
        // divided by the sum of the taps, so that a constant stays one
        let scale = 1.0 / (spectrum[0].re * (down * window) as f64);
        let over = over.map(Oversampling::gain);
        let gain = |k: usize| over.as_ref().map_or(1.0, |gain| gain(k as f64 / (up * window) as f64));
        let gains = spectrum[..low / 2].iter().enumerate().map(|(k, z)| T::of(z.re * scale * gain(k))).collect();
        let plan = |n| RealFft::with(n, butterflies).expect(WINDOW);
        let (forward, inverse, rooms) = (plan(down * window), plan(up * window), Pool::new());
        let kept = Vec::with_capacity(down * window * channels);
        let mut blocks = Self { forward, inverse, gains, up, down, window, side, channels, lead, kept, rooms };
        blocks.reset();
        blocks
    }

    /// How many frames a window uses up.
    fn used(&self) -> usize {
        (self.window - 2 * self.side) * self.down
    }

    /// How many frames they become.
    fn made(&self) -> usize {
        (self.window - 2 * self.side) * self.up
    }

    /// How many frames come, at most, after the time of a frame before it is made.
    pub(super) fn delay(&self) -> usize {
        (self.window - self.side) * self.down
    }

    /// The same, if `more` frames after it must be made, too.
    pub(super) fn delay_with(&self, more: usize) -> usize {
        self.delay() + (more * self.down).div_ceil(self.up)
    }

    /// Takes frames, and appends to `out` what they decide; false if a sum of values was not finite.
    pub(super) fn push(&mut self, frames: &[T], out: &mut Vec<T>) -> bool {
        let there = (self.kept.len() + frames.len()) / self.channels;
        let windows = there.checked_sub(self.window * self.down).map_or(0, |more| more / self.used() + 1);
        let start = out.len();
        out.resize(start + windows * self.made() * self.channels, T::zero());
        let finite = self.fill(frames, &mut out[start..]);
        let gone = windows * self.used() * self.channels;
        let new = gone.saturating_sub(self.kept.len());
        self.kept.drain(..gone - new);
        self.kept.extend_from_slice(&frames[new..]);
        finite
    }

    /// What comes next, if after these frames there is silence; false if a value was not finite, or a sum of values.
    pub(super) fn fill(&self, frames: &[T], out: &mut [T]) -> bool {
        let finite = AtomicBool::new(true);
        let channels = self.channels;
        let frames = Frames { kept: &self.kept, came: frames, channels };
        let (length, longer) = (self.down * self.window, self.up * self.window);
        let halves = length.max(longer) / 2 + 1;
        let from = self.side * self.up;
        parallel::chunks(out, self.made() * channels, |number, out| {
            // both lengths are even
            self.rooms.lend(halves + length + longer, |room| {
                let (spectrum, room) = room.split_at_mut(halves);
                let (values, made) = room.split_at_mut(length);
                let (values, made): (&mut [T], &mut [T]) = (cast_slice_mut(values), cast_slice_mut(made));
                for channel in (0..channels).step_by(2) {
                    let lines = (channels - channel).min(2);
                    let (values, made) = (&mut values[..lines * length], &mut made[..lines * longer]);
                    frames.read(channel, number * self.used(), length, values);
                    for (values, made) in values.chunks_exact(length).zip(made.chunks_exact_mut(longer)) {
                        self.convert(values, spectrum, made);
                        // each is a sum over all bins, the first of real parts, the second of imaginary ones: of a value or
                        // bin that is not finite nothing finite can come
                        if !made[..2].iter().all(|v| v.is_finite()) {
                            finite.store(false, Relaxed);
                        }
                    }
                    write(made, longer, from, channel, channels, out);
                }
            });
        });
        finite.into_inner()
    }

    /// Forgets all frames.
    pub(super) fn reset(&mut self) {
        self.kept.clear();
        self.kept.resize((self.side * self.down + self.lead) * self.channels, T::zero());
    }

    /// A window at the other rate.
    fn convert(&self, values: &[T], spectrum: &mut [Complex<T>], made: &mut [T]) {
        self.forward.forward(values, &mut spectrum[..values.len() / 2 + 1]).expect(WINDOW);
        let half = &mut spectrum[..made.len() / 2 + 1];
        let (common, beyond) = half.split_at_mut(self.gains.len());
        common.iter_mut().zip(&self.gains).for_each(|(z, gain)| *z = z.scale(*gain));
        beyond.fill(Complex::default());
        self.inverse.inverse(half, made).expect(WINDOW);
    }
}

/// The shape of a conversion.
#[derive(Debug, Clone, Copy)]
pub(super) struct Design {
    up: usize,
    down: usize,
    /// In samples of the lower rate.
    filter: LowPass,
    /// What the new samples are for, if they are not all.
    over: Option<Oversampling>,
    window: usize,
    side: usize,
}

impl Design {
    /// From one rate to the other at once: a ratio of whole numbers, unless windows that have room for both are too long.
    pub(super) fn exact(ratio: Ratio, quality: Quality) -> Option<Self> {
        let (up, down) = ratio.terms()?;
        let design = Self::new(up, down, 1.0, quality, None);
        (up < down || design.room() <= LONG).then_some(design)
    }

    /// To as many times a whole fraction of the rate as an oversampled signal needs that is at least at the new one.
    pub(super) fn oversampled(over: Oversampling, ratio: Ratio, quality: Quality) -> Self {
        let part = (1.0 / ratio.value()).floor().max(1.0) as usize;
        let (up, down) =
            if part.is_multiple_of(over.up) { (1, over.down * (part / over.up)) } else { (over.up, over.down * part) };
        let scale = ratio.value().min(1.0) / (up as f64 / down as f64).min(1.0);
        Self::new(up, down, scale, quality, Some(over))
    }

    /// Up and down, without a common divisor.
    pub(super) fn terms(&self) -> [usize; 2] {
        [self.up, self.down]
    }

    /// The band ends at `scale ≤ 1` of the lower Nyquist frequency of both rates.
    fn new(up: usize, down: usize, scale: f64, quality: Quality, over: Option<Oversampling>) -> Self {
        let (stronger, more) = over.map_or((1.0, 0), |_| (Oversampling::STRONGEST, Oversampling::SPREAD));
        let filter = quality.low_pass(0.5 * scale, stronger);
        let reach = filter.radius().ceil() as usize + 1 + more;
        let (low, high) = (up.min(down), up.max(down));
        let side = reach.div_ceil(low);
        // what is thrown away against the logarithm of the length: flat from ten sides on
        let long = easy((10 * side).max(LEAST_WINDOW.div_ceil(low)));
        let window = if long.saturating_mul(high) <= MOST_WINDOW { long } else { easy(4 * side) };
        Self { up, down, filter, over, window, side }
    }

    /// How many values a channel keeps at a time.
    pub(super) fn room(&self) -> usize {
        self.window.saturating_mul(self.up.max(self.down)).saturating_mul(4)
    }
}

/// The least even `2ᵏ` or `3·2ᵏ` from `n` on: the terms of the ratio have odd factors of their own.
fn easy(n: usize) -> usize {
    let power = n.max(2).next_power_of_two();
    if power / 4 * 3 >= n && power >= 8 { power / 4 * 3 } else { power }
}
