//! Ratios of whole numbers: window by window, through the spectrum.

use crate::engine::fft::{Butterflies, RealFft, fast_length};
use crate::rate::design::LowPass;
use crate::rate::quality::Quality;
use num_complex::Complex;

/// Windows are at least so long, at the lower rate.
const LEAST_WINDOW: usize = 2048;
/// Windows are not made longer than this only to throw away less of them.
const MOST_WINDOW: usize = 1 << 20;

const WINDOW: &str = "rooms are as long as their windows";

/// A conversion by `up/down`, low-passed: what all channels share.
pub(super) struct Blocks {
    forward: RealFft<f64>,
    inverse: RealFft<f64>,
    /// The filter at the frequencies that both windows have, over the length of the input's window.
    gains: Vec<f64>,
    up: usize,
    down: usize,
    /// A window is so many times `down` samples, and becomes as many times `up`.
    window: usize,
    /// So many of them at either side are touched by the neighbouring windows' samples.
    side: usize,
}

impl Blocks {
    /// Up and down without a common divisor; the band ends at `scale ≤ 1` of the lower Nyquist frequency of both rates.
    pub(super) fn new(up: usize, down: usize, scale: f64, quality: Quality) -> Self {
        let (filter, window, side) = plan(up, down, scale, quality);
        let low = up.min(down) * window;
        let reach = filter.radius().floor() as usize;
        // the filter at the samples of the lower rate, those before zero at the end
        let mut taps = vec![0.0; low];
        for i in 0..=reach {
            taps[i] = filter.at(i as f64);
            taps[(low - i) % low] = taps[i];
        }
        let mut spectrum = vec![Complex::default(); low / 2 + 1];
        let real_fft = |n| RealFft::with(n, Butterflies::Scalar).expect(WINDOW);
        real_fft(low).forward(&taps, &mut spectrum).expect(WINDOW);
        // divided by the sum of the taps, so that a constant stays one
        let scale = 1.0 / (spectrum[0].re * (down * window) as f64);
        let gains = spectrum[..low / 2].iter().map(|z| z.re * scale).collect();
        let (forward, inverse) = (real_fft(down * window), real_fft(up * window));
        Self { forward, inverse, gains, up, down, window, side }
    }

    /// How many values a channel keeps at a time.
    pub(super) fn room(up: usize, down: usize, scale: f64, quality: Quality) -> usize {
        let (_, window, _) = plan(up, down, scale, quality);
        window.saturating_mul(up.max(down)).saturating_mul(4)
    }

    /// A channel before its first sample, with silence before it.
    pub(super) fn lane(&self) -> Lane {
        let longest = self.up.max(self.down) * self.window;
        Lane {
            queue: vec![0.0; self.side * self.down],
            spectrum: vec![Complex::default(); longest / 2 + 1],
            window: vec![0.0; self.up * self.window],
        }
    }

    /// Appends to `out` what the samples of the queue allow.
    pub(super) fn run(&self, lane: &mut Lane, out: &mut Vec<f64>) {
        let (length, kept) = (self.window * self.down, self.window - 2 * self.side);
        let mut at = 0;
        while lane.queue.len() - at >= length {
            let half = &mut lane.spectrum[..length / 2 + 1];
            self.forward.forward(&lane.queue[at..at + length], half).expect(WINDOW);
            let half = &mut lane.spectrum[..self.window * self.up / 2 + 1];
            let common = self.gains.len();
            half[..common].iter_mut().zip(&self.gains).for_each(|(z, gain)| *z *= gain);
            half[common..].fill(Complex::default());
            self.inverse.inverse(half, &mut lane.window).expect(WINDOW);
            out.extend_from_slice(&lane.window[self.side * self.up..][..kept * self.up]);
            at += kept * self.down;
        }
        lane.queue.drain(..at);
    }

    /// Silence for one more window.
    pub(super) fn flush(&self, lane: &mut Lane, out: &mut Vec<f64>) {
        let length = self.window * self.down;
        lane.queue.resize(lane.queue.len().max(length), 0.0);
        self.run(lane, out);
    }
}

/// The filter in samples of the lower rate, the length of windows and of their sides.
fn plan(up: usize, down: usize, scale: f64, quality: Quality) -> (LowPass, usize, usize) {
    let filter = quality.low_pass(0.5 * scale);
    let reach = filter.radius().ceil() as usize + 1;
    let (low, high) = (up.min(down), up.max(down));
    let side = reach.div_ceil(low);
    let long = (8 * side).max(LEAST_WINDOW.div_ceil(low));
    let window = if long.saturating_mul(high) <= MOST_WINDOW { long } else { 4 * side };
    (filter, fast_length(window), side)
}

/// One channel: samples that wait for their window, and room to work in.
pub(super) struct Lane {
    pub(super) queue: Vec<f64>,
    spectrum: Vec<Complex<f64>>,
    window: Vec<f64>,
}
