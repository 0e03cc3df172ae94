//! One sinusoid, fitted to samples with its frequency.

use crate::inspect::table::frame::Frame;
use crate::num::svd::Svd;
use crate::num::{cos_pi, sin_pi};
use crate::parallel;
use ndarray::Array2;
use std::f64::consts::PI;

/// `cos·cos(2πνt) + sin·sin(2πνt)`, `t` from the first sample on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Tone {
    pub(super) frequency: f64,
    pub(super) cos: f64,
    pub(super) sin: f64,
}

/// Samples of one piece of work.
const CHUNK: usize = 1 << 14;
/// Steps of Gauss and Newton: they converge quadratically from within half a bin.
const MOST_STEPS: usize = 12;

impl Tone {
    pub(super) fn amplitude(&self) -> f64 {
        self.cos.hypot(self.sin)
    }

    /// `φ` of `A cos(2πνt + φ)`.
    pub(super) fn phase(&self) -> f64 {
        (-self.sin).atan2(self.cos)
    }

    /// Its values added to those at the frame's times, `scale` times.
    pub(super) fn add(&self, frame: &Frame, values: &mut [f64], scale: f64) {
        parallel::chunks(values, CHUNK, |i, values| {
            for (value, t) in values.iter_mut().zip(&frame.times[i * CHUNK..]) {
                let turns = 2.0 * (self.frequency * t);
                *value += scale * (self.cos * cos_pi(turns) + self.sin * sin_pi(turns));
            }
        });
    }

    /// The sinusoid nearest to `values` in the weighted mean square, together with a constant, by the method of Gauss and
    /// Newton from this one on; it stays within one resolution `1/L` of the frequency it began with.
    pub(super) fn refined(self, frame: &Frame, values: &[f64]) -> Self {
        let mut tone = self;
        for _ in 0..MOST_STEPS {
            let Some([cos, sin, shift]) = tone.equations(frame, values) else { return tone };
            // the linear model's frequency, no more than a quarter of a bin farther
            let shift = shift.clamp(-0.25 / frame.length, 0.25 / frame.length);
            let least = (self.frequency - 1.0 / frame.length).max(0.5 / frame.length);
            let frequency = (tone.frequency + shift).clamp(least, self.frequency + 1.0 / frame.length);
            let moved = (frequency - tone.frequency).abs();
            tone = Self { frequency, cos, sin };
            if moved * frame.length < 1e-12 {
                break;
            }
        }
        tone
    }

    /// The best amplitudes at this frequency, and by how much the frequency should change: least squares in the basis of
    /// cosine, sine, one, and the derivative with respect to frequency, made dimensionless by `L`.
    fn equations(&self, frame: &Frame, values: &[f64]) -> Option<[f64; 3]> {
        let sums = |i: usize| {
            let range = i * CHUNK..((i + 1) * CHUNK).min(values.len());
            let mut sums = [[0.0; 5]; 4];
            for j in range {
                let turns = 2.0 * (self.frequency * frame.times[j]);
                let (c, s) = (cos_pi(turns), sin_pi(turns));
                let late = 2.0 * PI * (frame.times[j] / frame.length);
                let basis = [c, s, 1.0, late * (self.sin * c - self.cos * s), values[j]];
                for (row, of_row) in sums.iter_mut().zip(basis) {
                    let weighted = frame.weights[j] * of_row;
                    row.iter_mut().zip(basis).for_each(|(sum, of_column)| *sum += weighted * of_column);
                }
            }
            sums
        };
        let parts = parallel::map(values.len().div_ceil(CHUNK), sums);
        let entry = |i: usize, j: usize| parts.iter().map(|part| part[i][j]).sum::<f64>();
        // a tone without amplitude has no derivative: its frequency stays
        let size = if self.amplitude() > 0.0 { 4 } else { 3 };
        let scales: Vec<f64> = (0..size).map(|i| entry(i, i).sqrt()).collect();
        if scales.iter().any(|s| *s <= 0.0) {
            return None;
        }
        let matrix = Array2::from_shape_fn((size, size), |(i, j)| entry(i, j) / (scales[i] * scales[j]));
        let wanted: Vec<f64> = (0..size).map(|i| entry(i, 4) / scales[i]).collect();
        let found = Svd::of(&matrix).ok()?.solve(&wanted).ok()?;
        let of = |i: usize| found.get(i).map_or(0.0, |v| v / scales[i]);
        Some([of(0), of(1), of(3) / frame.length])
    }
}
