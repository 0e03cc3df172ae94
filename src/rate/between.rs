//! Values of an oversampled signal at any times.

use crate::rate::design::LowPass;

/// The signal has no frequencies above this, in cycles a sample: it is oversampled at least twice.
const BAND: f64 = 0.25;
/// Rejection of images, in dB: more than any quality promises.
const REJECTION: f64 = 215.0;
/// Rows of the table a sample. A cubic between four rows `h` apart errs by at most `3/128·h⁴·max|k⁗|` (Lagrange); the
/// kernel's fourth derivative is below `(2π·¾)⁴/5 ≈ 99`, of frequencies up to ¾ with weight as `ν⁴`: 2·10⁻¹² a tap.
const ROWS: usize = 1024;

/// A kernel, tabulated for all phases.
pub(super) struct Between {
    /// `ROWS + 3` rows, the first for the phase `−1/ROWS`; in each a value for every tap.
    table: Vec<f64>,
    taps: usize,
}

impl Between {
    pub(super) fn new() -> Self {
        let kernel = LowPass::new(BAND, 1.0 - BAND, REJECTION);
        let reach = kernel.radius().ceil() as i32;
        let taps = 1 - reach..=reach;
        let phases = (0..ROWS + 3).map(|row| (row as f64 - 1.0) / ROWS as f64);
        let table = phases.flat_map(|phase| taps.clone().map(move |j| kernel.at(phase - f64::from(j)))).collect();
        Self { table, taps: taps.count() }
    }

    /// How many samples are needed before and after a time.
    pub(super) fn reach(&self) -> usize {
        self.taps / 2
    }

    /// The value a `fraction` of a sample after the sample in the middle of `samples`, as many as there are taps:
    /// `reach − 1` before it, `reach` after it.
    fn at(&self, samples: &[f64], fraction: f64) -> f64 {
        let place = fraction * ROWS as f64;
        let row = (place as usize).min(ROWS - 1);
        let x = place - row as f64;
        // Lagrange's cubic through −1, 0, 1, 2
        let (a, b, c) = (x + 1.0, x - 1.0, x - 2.0);
        let weights = [-x * b * c / 6.0, a * b * c / 2.0, -a * x * c / 2.0, a * x * b / 6.0];
        let rows = &self.table[row * self.taps..(row + 4) * self.taps];
        let (first, rows) = rows.split_at(self.taps);
        let (second, rows) = rows.split_at(self.taps);
        let (third, fourth) = rows.split_at(self.taps);
        let rows = first.iter().zip(second).zip(third).zip(fourth).zip(samples);
        rows.map(|((((k, l), m), n), v)| v * (weights[0] * k + weights[1] * l + weights[2] * m + weights[3] * n)).sum()
    }

    /// Appends to `out` the values at all times that the lane's samples reach.
    pub(super) fn run(&self, lane: &mut Steps, out: &mut Vec<f64>) {
        let before = self.reach() - 1;
        while let Some(samples) = lane.samples.get(lane.at - before..).and_then(|s| s.get(..self.taps)) {
            out.push(self.at(samples, lane.fraction as f64 * 0.5f64.powi(128)));
            lane.advance();
        }
        let gone = (lane.at - before).min(lane.samples.len());
        lane.samples.drain(..gone);
        lane.at -= gone;
    }
}

/// One channel: samples, and the time of the next value.
pub(super) struct Steps {
    pub(super) samples: Vec<f64>,
    at: usize,
    fraction: u128,
    step: (u64, u128),
}

impl Steps {
    /// The first value stands at sample number `start`.
    pub(super) fn new(start: usize, step: (u64, u128)) -> Self {
        Self { samples: Vec::new(), at: start, fraction: 0, step }
    }

    fn advance(&mut self) {
        let (fraction, carry) = self.fraction.overflowing_add(self.step.1);
        self.fraction = fraction;
        self.at += self.step.0 as usize + usize::from(carry);
    }
}
