//! The spectrum of samples at any positions.

use crate::error::Result;
use crate::inspect::table::frame::Frame;
use crate::record::Sampling;
use crate::sampled::window::Window;

/// At every multiple `ν_m = m/L` of the record's resolution the sinusoid that, with a constant, is nearest to the samples
/// in the mean square, weighted by a window: the generalised periodogram of Lomb and Scargle (Lomb 1976; Scargle 1982; with
/// the constant and weights Zechmeister and Kürster 2009).
///
/// For equally spaced samples it is the discrete Fourier transform under the window (up to the two or three lowest and
/// highest frequencies, where a sinusoid overlaps with its mirror image). For others a sinusoid is found with its
/// amplitude, whatever the positions; what else is there spreads over all frequencies as the positions make it.
///
/// ```
/// use nyquist::inspect::table::LeastSquaresSpectrum;
/// use nyquist::num::cos_pi;
/// use nyquist::record::Sampling;
/// use nyquist::sampled::window::Window;
/// let times: Vec<f64> = (0..64).map(f64::from).collect();
/// let sampling = Sampling::of(&times, &[0.0; 64])?;
/// let values: Vec<f64> = times.iter().map(|t| 3.0 * cos_pi(2.0 * t / 8.0)).collect();
/// let spectrum = LeastSquaresSpectrum::of(&sampling, &values, Window::Hann, None)?;
/// let [frequency, amplitude] = spectrum.amplitudes().nth(7).unwrap(); // 8/64; the first is 1/64
/// assert!(frequency == 0.125 && (amplitude - 3.0).abs() < 1e-13);
/// # Ok::<(), nyquist::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct LeastSquaresSpectrum {
    length: f64,
    /// `[a, b]` of `a cos(2πν_m t) + b sin(2πν_m t)`, `t` from the first sample on, for `m = 1, 2, …`.
    waves: Vec<[f64; 2]>,
    noise_bins: f64,
    mean: f64,
}

impl LeastSquaresSpectrum {
    /// Of values at the positions of a record ([its main stretch](Sampling::main_stretch)), under a window over it, up to a
    /// frequency or, if none is said, to half the rate of the grid or of the mean step; where there is no step, to the
    /// density.
    ///
    /// # Errors
    /// Values of another number than positions, or not finite; a frequency that is not positive or below `1/L`; sums that
    /// are too long ([`Places::harmonics`](crate::sampled::harmonics::Places::harmonics)).
    pub fn of(sampling: &Sampling, values: &[f64], window: Window, up_to: Option<f64>) -> Result<Self> {
        let main = sampling.main_stretch();
        if main.len() < sampling.positions().len() && values.len() == sampling.positions().len() {
            return Self::of(&sampling.part(main.clone()), &values[main], window, up_to);
        }
        Self::in_frame(&Frame::new(sampling, window, up_to)?, values)
    }

    pub(super) fn in_frame(frame: &Frame, values: &[f64]) -> Result<Self> {
        let (transform, mean) = frame.transform(values)?;
        let waves = (1..=frame.order).map(|m| frame.fitted(m, transform[m]).0).collect();
        Ok(Self { length: frame.length, waves, noise_bins: frame.noise_bins(), mean })
    }

    /// `1/L`: the distance of the frequencies, and about how far lines must be apart to be two.
    pub fn resolution(&self) -> f64 {
        1.0 / self.length
    }

    /// The highest frequency.
    pub fn highest(&self) -> f64 {
        self.waves.len() as f64 / self.length
    }

    /// The mean under the window: the amplitude at frequency zero.
    pub fn mean(&self) -> f64 {
        self.mean
    }

    /// Frequencies and amplitudes of the sinusoids, from `1/L` on.
    pub fn amplitudes(&self) -> impl ExactSizeIterator<Item = [f64; 2]> + '_ {
        self.waves.iter().enumerate().map(|(i, [a, b])| [(i + 1) as f64 / self.length, a.hypot(*b)])
    }

    /// Frequencies and phases `φ` of `A cos(2πν(t − t_0) + φ)`, in radians, `t_0` the first position.
    pub fn phases(&self) -> impl ExactSizeIterator<Item = [f64; 2]> + '_ {
        self.waves.iter().enumerate().map(|(i, [a, b])| [(i + 1) as f64 / self.length, (-b).atan2(*a)])
    }

    /// Frequencies and one-sided power densities `A²/2` per bin of noise, `L(Σw)²/(nΣw²)`: for noise, whatever the window,
    /// the mean square per unit of frequency.
    pub fn densities(&self) -> impl ExactSizeIterator<Item = [f64; 2]> + '_ {
        let scale = 0.5 * self.length / self.noise_bins;
        self.amplitudes().map(move |[frequency, a]| [frequency, scale * a * a])
    }
}
