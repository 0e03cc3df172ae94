//! The noise floor of a spectrum.

use crate::inspect::sound::window::reach;
use crate::sampled::welch::PowerSpectrum;

/// What the window may leave beside a line, as a part of the line's power in one bin: 190 dB,
/// about the mean of the first side lobe, whose top is 188 dB down.
const LEAKAGE: f64 = 1e-19;
/// Bands that the spectrum is cut into at most, and bins in one at least.
const MOST_BANDS: usize = 64;
const LEAST_BINS: usize = 16;

/// The noise floor: the median density of the quietest of up to 64 equal bands (of at least 16 bins) of the spectrum, as
/// the mean that white noise of this median has.
///
/// A median, so that lines do not count; the quietest band, so that sound elsewhere does not. It is not taken to be lower
/// than 190 dB below the strongest bin: there the window's own side lobes begin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Floor {
    /// Mean square per Hz.
    pub density: f64,
    /// The Nyquist frequency.
    nyquist: f64,
}

impl Floor {
    pub(super) fn of(spectrum: &PowerSpectrum, averages: f64) -> Self {
        let density = spectrum.density();
        // what the mean leaves, and lines at its place, is not asked
        let bins = &density[reach().min(density.len() / 4)..];
        let count = (bins.len() / LEAST_BINS).clamp(1, MOST_BANDS);
        let band = |i: usize| &bins[i * bins.len() / count..(i + 1) * bins.len() / count];
        let quietest = (0..count).map(|i| median(band(i))).fold(f64::INFINITY, f64::min);
        // of a mean of K exponential variables (Wilson and Hilferty 1931)
        let of_mean = (1.0 - 1.0 / (9.0 * averages)).powi(3);
        let strongest = density.iter().copied().fold(0.0, f64::max);
        Self { density: (quietest / of_mean).max(LEAKAGE * strongest), nyquist: 0.5 * spectrum.rate() }
    }

    /// Its mean square, were it the same at all frequencies.
    pub fn power(&self) -> f64 {
        self.density * self.nyquist
    }

    /// How many bits integers have whose rounding, `q²/12` with `q = 2^{1−bits}`, has this power.
    ///
    /// Noise of 16 bits with triangular dither, three times as much, reads as 15.2.
    pub fn bits(&self) -> f64 {
        1.0 - 0.5 * (12.0 * self.power()).log2()
    }
}

/// The ratio to its mean that no bin of white noise exceeds, of a spectrum of so many bins and independent averages, but in
/// one record of a thousand: `P(x > t) ≤ (t·e^{1−t})^K` for a mean of `K` exponential variables (Chernoff).
pub(super) fn ceiling(averages: f64, bins: usize) -> f64 {
    let wanted = (1000.0 * bins as f64).ln() / averages;
    let (mut low, mut high) = (1.0, 2.0 + 2.0 * wanted);
    while high - low > 1e-6 * high {
        let middle = 0.5 * (low + high);
        if middle - 1.0 - middle.ln() < wanted { low = middle } else { high = middle }
    }
    high
}

/// The middle one; of an even number, the upper.
pub(super) fn median(values: &[f64]) -> f64 {
    let mut sorted = values.to_vec();
    let middle = sorted.len() / 2;
    *sorted.select_nth_unstable_by(middle, f64::total_cmp).1
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ceilings_bound_exponential_noise() {
        // K = 1: e^{1−t}·t = 1/(1000·n)
        let t = ceiling(1.0, 8192);
        assert!((t * (1.0 - t).exp() * 8_192_000.0 - 1.0).abs() < 1e-4);
        assert!(ceiling(1000.0, 8192) < 1.3);
    }
}
