//! Windows: weights that fade a record in and out.

use crate::num::cos_pi;

/// A window over a record, in its periodic form: `w_j` of `n` is the value at `j/n`, so that the next period would
/// start with `w_n = w_0`. (The symmetric form, which filters use, is the periodic one of `n − 1`.)
///
/// Formulas after Harris, *On the use of windows for harmonic analysis with the DFT*, 1978.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Window {
    /// 1: no window. First side lobe −13.3 dB.
    Rectangular,
    /// `½ − ½cos(2πt)`. First side lobe −31.5 dB, then 18 dB an octave.
    Hann,
    /// `0.54 − 0.46cos(2πt)`. First side lobe −43 dB, then 6 dB an octave.
    Hamming,
    /// `0.42 − 0.5cos(2πt) + 0.08cos(4πt)`. First side lobe −58 dB.
    Blackman,
    /// The four-term window of Blackman and Harris: side lobes under −92 dB.
    BlackmanHarris,
    /// `e^{−½((t − ½)/σ)²}` with σ as a fraction of the record.
    Gaussian(f64),
}

impl Window {
    /// The value at fraction `t` of the record, `0 ≤ t < 1`.
    pub fn at(self, t: f64) -> f64 {
        let sum = |c: &[f64]| c.iter().zip(0..).map(|(c, k)| c * cos_pi(2.0 * f64::from(k) * t)).sum();
        match self {
            Self::Rectangular => 1.0,
            Self::Hann => sum(&[0.5, -0.5]),
            Self::Hamming => sum(&[0.54, -0.46]),
            Self::Blackman => sum(&[0.42, -0.5, 0.08]),
            Self::BlackmanHarris => sum(&[0.35875, -0.48829, 0.14128, -0.01168]),
            Self::Gaussian(sigma) => (-0.5 * ((t - 0.5) / sigma).powi(2)).exp(),
        }
    }

    /// The values for a record of `n` samples.
    ///
    /// ```
    /// use nyquist::sampled::window::Window;
    /// assert_eq!(Window::Hann.values(4), [0.0, 0.5, 1.0, 0.5]);
    /// ```
    pub fn values(self, n: usize) -> Vec<f64> {
        (0..n).map(|j| self.at(j as f64 / n as f64)).collect()
    }
}
