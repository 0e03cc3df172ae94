//! Tones in a spectrum.

use crate::inspect::sound::floor::{ceiling, median};
use crate::inspect::sound::window::{lobe, reach};
use crate::sampled::welch::PowerSpectrum;

/// How many times the median of its surroundings a line stands out at least: 10 dB. Of so strong a line one segment knows the
/// amplitude to a fifth, `1/√20`.
const LEAST: f64 = 10.0;
/// The lowest bin that a line can stand in: what drifts within a segment reads as a line in the second.
const LOWEST: usize = 3;
/// How many times all that is beside it a line stands out that has no room below it: 30 dB, more than noise rises towards
/// zero across the width of a line: from the twelfth bin to the third 24 dB where it rises by 12 dB an octave.
const LEAST_LOW: f64 = 1000.0;

/// A line of the spectrum: a tone, or what is as narrow as one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Line {
    /// Its frequency in Hz.
    pub frequency: f64,
    /// The amplitude of the sine that would read the same; full scale is 1.
    pub amplitude: f64,
}

impl Line {
    /// Its mean square.
    pub fn power(&self) -> f64 {
        0.5 * self.amplitude * self.amplitude
    }
}

/// The lines of a spectrum under Kaiser's window, the strongest first.
///
/// A line is a bin that is the largest within the width of a line and at least 10 dB above the median of its surroundings
/// (and above what white noise does once in a thousand records). Where it stands between two bins follows from the
/// quotient of its neighbours and the transform of the window, `sinh √(β²−π²δ²)/√(β²−π²δ²)`: of a steady tone alone both
/// frequency and amplitude are exact to rounding. Lines within the window's width of the Nyquist frequency meet their own
/// mirror images and are left out; of two within that width of each other only the stronger is seen. Within that width of
/// zero they meet mirror images too, and the mean that is taken away: they are known to a bin or so, have to stand 30 dB
/// above what lies beyond, and below [`lowest`] are not told apart from the mean.
pub(super) fn lines(spectrum: &PowerSpectrum, averages: f64) -> Vec<Line> {
    let density = spectrum.density();
    let (reach, bins) = (reach(), density.len());
    let prominent = LEAST.max(ceiling(averages, bins));
    let around = 8 * reach;
    let mut found = Vec::new();
    for k in LOWEST..bins.saturating_sub(reach) {
        let here = density[k];
        let largest = density[k.saturating_sub(reach)..k].iter().all(|p| *p < here)
            && density[k + 1..=k + reach].iter().all(|p| *p <= here);
        if here == 0.0 || !largest {
            continue;
        }
        let left = &density[k.saturating_sub(around)..k.saturating_sub(reach)];
        let right = &density[k + reach + 1..(k + around + 1).min(bins)];
        let surroundings = [left, right].concat();
        if surroundings.is_empty() || here < prominent * median(&surroundings) {
            continue;
        }
        if k < reach && right.iter().take(reach).any(|p| here < LEAST_LOW * p) {
            continue;
        }
        let offset = offset(density[k - 1], density[k + 1]);
        let amplitude = (2.0 * spectrum.tone_power(k)).sqrt() / lobe(offset);
        found.push(Line { frequency: (k as f64 + offset) * spectrum.step(), amplitude });
    }
    found.sort_by(|a, b| b.amplitude.total_cmp(&a.amplitude));
    found
}

/// The frequency below which no line is told apart from the mean and its drift.
pub(super) fn lowest(spectrum: &PowerSpectrum) -> f64 {
    spectrum.frequency(LOWEST)
}

/// Where between −½ and ½ of a bin a line stands whose neighbours have these powers.
pub(super) fn offset(before: f64, after: f64) -> f64 {
    let wanted = (after / before).sqrt();
    let (mut low, mut high) = (-0.5, 0.5);
    // the quotient rises with the offset; 2⁻⁵² of a bin
    for _ in 0..52 {
        let middle = 0.5 * (low + high);
        if lobe(1.0 - middle) < wanted * lobe(1.0 + middle) { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}
