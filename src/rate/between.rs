//! Values of an oversampled signal at any times.

use crate::engine::fft::Pool;
use crate::engine::real::Real;
use crate::engine::simd::{Loop, vectorised};
use crate::parallel;
use crate::rate::design::LowPass;
use crate::rate::frames::Frames;
use crate::rate::time::Time;

/// The signal has no frequencies above this, in cycles a sample: it is oversampled at least twice.
const BAND: f64 = 0.25;
/// Rejection of images, in dB: more than any quality promises.
const REJECTION: f64 = 215.0;
/// Rows of the table a sample, two to the power of this. A cubic between four rows `h` apart errs by at most
/// `3/128·h⁴·max|k⁗|` (Lagrange); the kernel's fourth derivative is below `(2π·¾)⁴/5 ≈ 99`, of frequencies up to ¾ with
/// weight as `ν⁴`: 2·10⁻¹² a tap.
const ROWS: u32 = 10;
/// Samples before and after a time: the kernel's radius is 15.6.
const REACH: usize = 16;
const TAPS: usize = 2 * REACH;
/// How many frames are a piece of work.
const PIECE: usize = 2048;

/// A kernel, tabulated for all phases, and samples with the time of the next value among them.
pub(super) struct Between<T> {
    /// The first row is for the phase `−2⁻ᴿᴼᵂˢ`; in each a value for every tap.
    table: Vec<[T; TAPS]>,
    channels: usize,
    pub(super) samples: Vec<T>,
    start: u64,
    next: Time,
    step: Time,
    rooms: Pool<T>,
}

impl<T: Real> Between<T> {
    /// How many samples are needed before and after a time.
    pub(super) const REACH: usize = REACH;

    /// The first value stands at sample number `start`.
    pub(super) fn new(channels: usize, start: usize, step: Time) -> Self {
        let kernel = LowPass::new(BAND, 1.0 - BAND, REJECTION);
        debug_assert!(kernel.radius() <= REACH as f64);
        let rows = f64::from(1 << ROWS);
        let phases = (0..(1 << ROWS) + 3).map(|row| (f64::from(row) - 1.0) / rows);
        let tap = |phase: f64, j: usize| T::of(kernel.at(phase - (j as f64 - (REACH as f64 - 1.0))));
        let table = phases.map(|phase| std::array::from_fn(|j| tap(phase, j))).collect();
        let start = start as u64;
        let next = Time { whole: start, fraction: 0 };
        Self { table, channels, samples: Vec::new(), start, next, step, rooms: Pool::new() }
    }

    /// How many more samples the next `count` values need.
    pub(super) fn missing(&self, count: usize) -> usize {
        let Some(before) = count.checked_sub(1) else { return 0 };
        let last = self.next.after(before as u64, self.step).whole as usize;
        (last + REACH + 1).saturating_sub(self.samples.len() / self.channels)
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
        let gone = (self.next.whole as usize).saturating_sub(REACH - 1).min(there);
        self.samples.drain(..gone * self.channels);
        self.next.whole -= gone as u64;
    }

    /// Forgets all samples.
    pub(super) fn reset(&mut self) {
        self.samples.clear();
        self.next = Time { whole: self.start, fraction: 0 };
    }

    /// The values at the next times; their samples are there.
    pub(super) fn fill(&self, out: &mut [T]) {
        let channels = self.channels;
        let frames = Frames { kept: &self.samples, came: &[], channels };
        parallel::chunks(out, PIECE * channels, |piece, out| {
            let start = self.next.after((piece * PIECE) as u64, self.step);
            let end = start.after((out.len() / channels) as u64 - 1, self.step);
            let length = (end.whole - start.whole) as usize + TAPS;
            let first = start.whole as usize - (REACH - 1);
            self.rooms.lend((length * channels).div_ceil(2), |room| {
                let lines: &mut [T] = bytemuck::cast_slice_mut(room);
                let lines = &mut lines[..length * channels];
                for (i, pair) in lines.chunks_mut(2 * length).enumerate() {
                    frames.read(2 * i, first, length, pair);
                }
                let (table, step) = (&self.table, self.step);
                let time = Time { whole: 0, fraction: start.fraction };
                vectorised(Values { table, lines, length, channels, time, step, out });
            });
        });
    }
}

/// Frames at times that are a step apart, the first near the beginning of each channel's line.
struct Values<'a, T> {
    table: &'a [[T; TAPS]],
    lines: &'a [T],
    length: usize,
    channels: usize,
    time: Time,
    step: Time,
    out: &'a mut [T],
}

impl<T: Real> Loop for Values<'_, T> {
    #[inline(always)]
    fn run(self) {
        let mut time = self.time;
        for frame in self.out.chunks_exact_mut(self.channels) {
            let row = (time.fraction >> (128 - ROWS)) as usize;
            let x = (time.fraction << ROWS >> 75) as u64 as f64 * 0.5f64.powi(53);
            // Lagrange's cubic through −1, 0, 1, 2
            let (a, b, c) = (x + 1.0, x - 1.0, x - 2.0);
            let weights = [-x * b * c / 6.0, a * b * c / 2.0, -a * x * c / 2.0, a * x * b / 6.0].map(T::of);
            let mut kernel = [T::zero(); TAPS];
            if let Some([first, second, third, fourth]) = self.table[row..].first_chunk() {
                for j in 0..TAPS {
                    let (outer, inner) = (weights[0] * first[j] + weights[3] * fourth[j], weights[1] * second[j]);
                    kernel[j] = outer + (inner + weights[2] * third[j]);
                }
            }
            let from = time.whole as usize;
            for (value, line) in frame.iter_mut().zip(self.lines.chunks_exact(self.length)) {
                if let Some(samples) = line[from..].first_chunk() {
                    *value = product(&kernel, samples);
                }
            }
            time = time.after(1, self.step);
        }
    }
}

/// `Σ k_j v_j`, in eight sums.
#[inline(always)]
fn product<T: Real>(kernel: &[T; TAPS], samples: &[T; TAPS]) -> T {
    let mut sums = [T::zero(); 8];
    for (k, v) in kernel.chunks_exact(8).zip(samples.chunks_exact(8)) {
        for i in 0..8 {
            sums[i] += k[i] * v[i];
        }
    }
    let [a, b, c, d, e, f, g, h] = sums;
    ((a + e) + (c + g)) + ((b + f) + (d + h))
}
