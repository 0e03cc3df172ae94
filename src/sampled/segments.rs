//! Records cut into overlapping segments, each under a window and transformed: what averaged spectra and spectrograms are
//! made of.

use crate::engine::fft::{Butterflies, RealFft};
use crate::engine::real::Real;
use crate::error::{Error, Result, within};
use crate::num::mean::{mean, weighted_mean};
use crate::parallel;
use crate::sampled::window::Window;
use num_complex::Complex;

/// The longest segment: its transform and its work fill half a gigabyte.
const MOST: usize = 1 << 24;
/// Segments that are transformed at a time, each in a room of its own.
const BENCHES: usize = 8;
/// How many values are looked at together.
const PIECE: usize = 1024;

const LENGTH: &str = "rooms are as long as their segment";

/// What is taken away from a segment before it is transformed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Detrend {
    /// Nothing.
    None,
    /// Its mean, so that a constant does not leak into the lowest bins.
    #[default]
    Mean,
    /// Its mean under the window, `Σwx/Σw`, so that the bin at zero is empty. The plain mean of a tone that does not end
    /// with a period is not zero; taken away before the window, it leaves a line at zero that stands far above the side
    /// lobes of a good window.
    WindowedMean,
}

/// How records are cut: the length of segments, how far one starts after another, the window over each.
///
/// ```
/// use nyquist::sampled::segments::Segments;
/// use nyquist::sampled::window::Window;
/// let segments = Segments::new(1024, 512, Window::Hann)?;
/// assert_eq!(segments.count(10_000), 18);
/// // Hann's window at half overlap: 18 segments are worth 17.1 that do not overlap (Welch 1967)
/// assert!((segments.independent(18) - 17.1).abs() < 0.05);
/// # Ok::<(), nyquist::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Segments {
    length: usize,
    hop: usize,
    window: Window,
    detrend: Detrend,
}

impl Segments {
    /// Segments of so many samples, one every `hop` samples. The mean of each is taken away.
    ///
    /// # Errors
    /// A length below 2 or above 2²⁴, a hop that is zero or above the length.
    pub fn new(length: usize, hop: usize, window: Window) -> Result<Self> {
        if length < 2 {
            return Err(Error::TooFew { what: "samples in a segment", least: 2, got: length });
        }
        if length > MOST {
            let what = "the length of a segment";
            return Err(Error::Overflow { what, value: length as f64, most: MOST as f64 });
        }
        if hop == 0 || hop > length {
            let (what, high) = ("the distance of segments, in samples,", length as f64);
            return Err(Error::OutOfRange { what, value: hop as f64, low: 1.0, high });
        }
        Ok(Self { length, hop, window, detrend: Detrend::default() })
    }

    /// With something else taken away.
    #[must_use]
    pub fn detrend(mut self, detrend: Detrend) -> Self {
        self.detrend = detrend;
        self
    }

    /// One segment over a whole record of `length` samples, which is shorter than these. One sample alone has weight 1.
    pub(crate) fn shortened(self, length: usize) -> Self {
        let window = if length == 1 { Window::Rectangular } else { self.window };
        Self { length, hop: length, window, ..self }
    }

    /// Samples in a segment.
    pub fn length(&self) -> usize {
        self.length
    }

    /// Samples from the start of one to the start of the next.
    pub fn hop(&self) -> usize {
        self.hop
    }

    /// The window over each.
    pub fn window(&self) -> Window {
        self.window
    }

    /// How many whole segments `samples` samples hold.
    pub fn count(&self, samples: u64) -> u64 {
        samples.checked_sub(self.length as u64).map_or(0, |rest| rest / self.hop as u64 + 1)
    }

    /// How many segments of white noise that do not overlap have a mean that varies as little as that of `count` of these:
    /// `K/(1 + 2Σ_j ρ_j²(1 − j/K))`, where `ρ_j` is the correlation of the window with itself `j` hops later (Welch 1967).
    pub fn independent(&self, count: u64) -> f64 {
        let w = self.window.values(self.length);
        let power: f64 = w.iter().map(|w| w * w).sum();
        let lags = (self.length.div_ceil(self.hop) as u64).min(count);
        let shared = |j: u64| {
            let rho = w.iter().zip(&w[j as usize * self.hop..]).map(|(a, b)| a * b).sum::<f64>() / power;
            rho * rho * (1.0 - j as f64 / count as f64)
        };
        count as f64 / (1.0 + 2.0 * (1..lags).map(shared).sum::<f64>())
    }
}

/// The squared magnitudes `|Σ_j w_j x_j e^{−2πijk/n}|²`, `0 ≤ k ≤ n/2`, of the segments of any number of channels, while
/// their frames come in.
///
/// ```
/// use nyquist::sampled::segments::{Periodograms, Segments};
/// use nyquist::sampled::window::Window;
/// // a cosine of two periods a segment, and a constant, whose mean is taken away
/// let mut periodograms = Periodograms::new(Segments::new(8, 8, Window::Rectangular)?, 2)?;
/// let frames: Vec<f64> = (0..8).flat_map(|j| [[1.0, 0.0, -1.0, 0.0][j % 4], 7.0]).collect();
/// let mut seen = Vec::new();
/// periodograms.push(&frames, |channel, powers| seen.push((channel, powers.to_vec())))?;
/// periodograms.finish(|channel, powers| seen.push((channel, powers.to_vec())));
/// assert_eq!(seen, [(0, vec![0.0, 0.0, 16.0, 0.0, 0.0]), (1, vec![0.0; 5])]);
/// # Ok::<(), nyquist::error::Error>(())
/// ```
pub struct Periodograms {
    segments: Segments,
    weights: Vec<f64>,
    fft: RealFft<f64>,
    /// Samples of each channel that wait for their segments.
    queues: Vec<Vec<f64>>,
    benches: Vec<Bench>,
}

/// Refuses a part of a frame, and values that are not finite.
pub(crate) fn whole_frames<T: Real>(frames: &[T], channels: usize) -> Result<()> {
    whole(frames.len(), channels)?;
    finite(frames)
}

/// Refuses a part of a frame.
pub(crate) fn whole(values: usize, channels: usize) -> Result<()> {
    if values.is_multiple_of(channels) {
        return Ok(());
    }
    Err(Error::Length { what: "the values of whole frames", expected: values.next_multiple_of(channels), got: values })
}

/// Refuses values that are not finite.
pub(crate) fn finite<T: Real>(values: &[T]) -> Result<()> {
    // long loops without a way out are vectorised
    let all = |piece: &[T]| piece.iter().fold(true, |all, v| all & v.is_finite());
    match values.chunks(PIECE).position(|piece| !all(piece)) {
        Some(piece) => {
            let rest = &values[piece * PIECE..];
            let at = rest.iter().position(|v| !v.is_finite()).unwrap_or_default();
            let (index, value) = (piece * PIECE + at, rest[at].to_f64().unwrap_or(f64::NAN));
            Err(Error::NotFiniteAt { what: "samples", index, value })
        }
        None => Ok(()),
    }
}

/// The square of a larger value times the number of values is near the end of `f64`, and that of one over it near zero.
pub(crate) const LARGEST: f64 = 1e140;

/// The size of the largest value, or of the largest before if that is larger; refuses one whose square is too large.
pub(crate) fn peak(before: f64, values: &[f64]) -> Result<f64> {
    let peak = values.iter().fold(before, |peak, value| peak.max(value.abs()));
    within("the size of the largest sample, whose square is needed", peak, 0.0, LARGEST)
}

/// Room to transform one segment in.
#[derive(Default)]
struct Bench {
    windowed: Vec<f64>,
    half: Vec<Complex<f64>>,
    powers: Vec<f64>,
}

impl std::fmt::Debug for Periodograms {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Periodograms {{ {:?}, channels: {} }}", self.segments, self.queues.len())
    }
}

impl Periodograms {
    /// For frames of so many channels.
    ///
    /// # Errors
    /// No channels.
    pub fn new(segments: Segments, channels: usize) -> Result<Self> {
        if channels == 0 {
            return Err(Error::TooFew { what: "channels", least: 1, got: 0 });
        }
        let length = segments.length;
        Ok(Self {
            segments,
            weights: segments.window.values(length),
            fft: RealFft::with(length, Butterflies::Scalar).expect(LENGTH),
            queues: vec![Vec::new(); channels],
            benches: Vec::new(),
        })
    }

    /// How the record is cut.
    pub fn segments(&self) -> Segments {
        self.segments
    }

    /// Takes whole frames, one value for each channel in turn, and shows `each` the segments that they complete: channel
    /// after channel, those of a channel in their order.
    ///
    /// # Errors
    /// [`Error::Length`] for a part of a frame, [`Error::NotFiniteAt`], values beyond 10¹⁴⁰; nothing has been taken then.
    pub fn push(&mut self, frames: &[f64], mut each: impl FnMut(usize, &[f64])) -> Result<()> {
        let count = self.queues.len();
        whole_frames(frames, count)?;
        peak(0.0, frames)?;
        for channel in 0..count {
            self.queues[channel].extend(frames.iter().skip(channel).step_by(count));
            self.run(channel, BENCHES, &mut each);
        }
        Ok(())
    }

    /// Ends the record, and shows `each` the segments that are left. What no whole segment holds is left out.
    pub fn finish(mut self, mut each: impl FnMut(usize, &[f64])) {
        for channel in 0..self.queues.len() {
            self.run(channel, 1, &mut each);
        }
    }

    /// Transforms the segments of a channel as long as at least so many are complete: the fewer at a time, the fewer
    /// threads have work.
    fn run(&mut self, channel: usize, least: usize, each: &mut impl FnMut(usize, &[f64])) {
        let Segments { length, hop, detrend, .. } = self.segments;
        let Self { weights, fft, queues, benches, segments } = self;
        let queue = &mut queues[channel];
        let mut at = 0;
        loop {
            let complete = segments.count((queue.len() - at) as u64).min(BENCHES as u64) as usize;
            if complete < least {
                break;
            }
            benches.resize_with(complete.max(benches.len()), Bench::default);
            let samples = &queue[at..];
            parallel::chunks(&mut benches[..complete], 1, |i, bench| {
                bench[0].run(&samples[i * hop..][..length], weights, fft, detrend);
            });
            benches[..complete].iter().for_each(|bench| each(channel, &bench.powers));
            at += complete * hop;
        }
        queue.drain(..at);
    }
}

impl Bench {
    fn run(&mut self, samples: &[f64], weights: &[f64], fft: &RealFft<f64>, detrend: Detrend) {
        let away = match detrend {
            Detrend::None => 0.0,
            Detrend::Mean => mean(samples),
            Detrend::WindowedMean => weighted_mean(samples, weights),
        };
        self.windowed.clear();
        self.windowed.extend(samples.iter().zip(weights).map(|(v, w)| (v - away) * w));
        self.half.resize(samples.len() / 2 + 1, Complex::default());
        fft.forward(&self.windowed, &mut self.half).expect(LENGTH);
        self.powers.clear();
        self.powers.extend(self.half.iter().map(|z| z.norm_sqr()));
    }
}
