//! Averaged power spectra of long records (Welch 1967).

use crate::error::{Error, Result, positive};
use crate::sampled::segments::{Periodograms, Segments};

/// The mean power spectrum of the segments of a record, of any number of channels, while their frames come in: memory
/// holds a few segments, however long the record is.
///
/// Of a record shorter than a segment the whole is one segment. SciPy's `welch` is the same function
/// (`detrend='constant'`, one-sided), to rounding.
///
/// ```
/// use nyquist::num::sin_pi;
/// use nyquist::sampled::segments::Segments;
/// use nyquist::sampled::welch::Welch;
/// use nyquist::sampled::window::Window;
/// // a sine of amplitude 0.1 at 1000 Hz, on a bin
/// let samples: Vec<f64> = (0..48_000).map(|i| 0.1 * sin_pi(2.0 * 1000.0 * f64::from(i) / 48_000.0)).collect();
/// let mut welch = Welch::new(48_000.0, 1, Segments::new(4800, 2400, Window::Hann)?)?;
/// welch.push(&samples[..10_000])?;
/// welch.push(&samples[10_000..])?;
/// let spectrum = &welch.finish()?[0];
/// assert_eq!((spectrum.segments(), spectrum.frequency(100)), (19, 1000.0));
/// assert!((spectrum.amplitude(100) - 0.1).abs() < 1e-14);
/// // the density holds the power of the sine, ½·0.1², whatever the window
/// assert!((spectrum.power(900.0, 1100.0) - 0.005).abs() < 1e-15);
/// # Ok::<(), nyquist::error::Error>(())
/// ```
#[derive(Debug)]
pub struct Welch {
    rate: f64,
    channels: usize,
    periodograms: Periodograms,
    sums: Vec<Vec<f64>>,
    count: u64,
    /// The frames so far, while they are fewer than a segment.
    short: Vec<f64>,
}

impl Welch {
    /// For frames of so many channels at a rate.
    ///
    /// # Errors
    /// A rate that is not positive and finite; no channels.
    pub fn new(rate: f64, channels: usize, segments: Segments) -> Result<Self> {
        positive("the sampling rate", rate)?;
        let periodograms = Periodograms::new(segments, channels)?;
        let sums = vec![vec![0.0; segments.length() / 2 + 1]; channels];
        Ok(Self { rate, channels, periodograms, sums, count: 0, short: Vec::new() })
    }

    /// Takes whole frames, one value for each channel in turn.
    ///
    /// # Errors
    /// [`Error::Length`] for a part of a frame, [`Error::NotFiniteAt`], values beyond 10¹⁴⁰; nothing has been taken
    /// then.
    pub fn push(&mut self, frames: &[f64]) -> Result<()> {
        let Self { periodograms, sums, count, .. } = self;
        periodograms.push(frames, |channel, powers| add(sums, count, channel, powers))?;
        let segment = periodograms.segments().length() * self.channels;
        if self.short.len() < segment {
            self.short.extend(&frames[..frames.len().min(segment - self.short.len())]);
        }
        Ok(())
    }

    /// Ends the record; a spectrum for each channel.
    ///
    /// # Errors
    /// [`Error::TooFew`] where there was no frame.
    pub fn finish(self) -> Result<Vec<PowerSpectrum>> {
        let Self { rate, channels, periodograms, mut sums, mut count, short } = self;
        let mut segments = periodograms.segments();
        let frames = short.len() / channels;
        if frames == 0 {
            return Err(Error::TooFew { what: "samples of a power spectrum", least: 1, got: 0 });
        }
        let mut all = periodograms;
        if frames < segments.length() {
            segments = segments.shortened(frames);
            sums = vec![vec![0.0; frames / 2 + 1]; channels];
            all = Periodograms::new(segments, channels)?;
            all.push(&short, |channel, powers| add(&mut sums, &mut count, channel, powers))?;
        }
        all.finish(|channel, powers| add(&mut sums, &mut count, channel, powers));
        Ok(sums.into_iter().map(|sum| PowerSpectrum::new(rate, segments, count, sum)).collect())
    }
}

/// One more segment; those of the first channel are counted.
fn add(sums: &mut [Vec<f64>], count: &mut u64, channel: usize, powers: &[f64]) {
    *count += u64::from(channel == 0);
    sums[channel].iter_mut().zip(powers).for_each(|(sum, power)| *sum += power);
}

/// [`Welch`] of a record of one channel.
///
/// ```
/// use nyquist::sampled::segments::Segments;
/// use nyquist::sampled::welch::welch;
/// use nyquist::sampled::window::Window;
/// // ±1 in turn is all at the Nyquist frequency, and its mean square is 1
/// let spectrum = welch(&[1.0, -1.0].repeat(64), 2.0, Segments::new(32, 16, Window::Rectangular)?)?;
/// assert_eq!(spectrum.amplitude(16), 1.0);
/// assert_eq!(spectrum.power(0.0, 1.0), 1.0);
/// # Ok::<(), nyquist::error::Error>(())
/// ```
///
/// # Errors
/// Those of [`Welch`].
pub fn welch(values: &[f64], rate: f64, segments: Segments) -> Result<PowerSpectrum> {
    let mut welch = Welch::new(rate, 1, segments)?;
    welch.push(values)?;
    welch.finish()?.pop().ok_or(Error::TooFew { what: "channels", least: 1, got: 0 })
}

/// The power of a real record over the frequencies `0 ≤ ν ≤ rate/2` (one-sided: what stands at `−ν` is added at `ν`).
#[derive(Debug, Clone, PartialEq)]
pub struct PowerSpectrum {
    rate: f64,
    segments: Segments,
    count: u64,
    density: Vec<f64>,
    /// `Σw` and `Σw²`.
    sums: [f64; 2],
}

impl PowerSpectrum {
    /// From the sum of `count` periodograms.
    fn new(rate: f64, segments: Segments, count: u64, sum: Vec<f64>) -> Self {
        let weights = segments.window().values(segments.length());
        let sums = [weights.iter().sum(), weights.iter().map(|w| w * w).sum()];
        let scale = 1.0 / (rate * sums[1] * count as f64);
        let mut density = sum;
        let last = density.len() - 1;
        let middle = segments.length().is_multiple_of(2);
        for (k, power) in density.iter_mut().enumerate() {
            let alone = k == 0 || (k == last && middle);
            *power *= if alone { scale } else { 2.0 * scale };
        }
        Self { rate, segments, count, density, sums }
    }

    /// The same with another density in its bins.
    pub(crate) fn with_density(&self, density: Vec<f64>) -> Self {
        debug_assert_eq!(density.len(), self.density.len());
        Self { density, ..self.clone() }
    }

    /// The rate of the samples.
    pub fn rate(&self) -> f64 {
        self.rate
    }

    /// How the record was cut.
    pub fn cut(&self) -> Segments {
        self.segments
    }

    /// The number of segments that were averaged.
    pub fn segments(&self) -> u64 {
        self.count
    }

    /// The distance of two bins, `rate/n`.
    pub fn step(&self) -> f64 {
        self.rate / self.segments.length() as f64
    }

    /// The frequency of bin `k`, exact at whole multiples of the step.
    pub fn frequency(&self, k: usize) -> f64 {
        k as f64 * self.rate / self.segments.length() as f64
    }

    /// Power per unit of frequency in every bin, in squared units of the samples: `2⟨|X_k|²⟩/(rate·Σw²)`, at zero and at
    /// the Nyquist frequency without the 2. Its sum times the step is the mean square of what was windowed.
    pub fn density(&self) -> &[f64] {
        &self.density
    }

    /// The width of the rectangle that passes as much noise as a bin does, `rate·Σw²/(Σw)²`.
    pub fn noise_bandwidth(&self) -> f64 {
        self.rate * self.sums[1] / (self.sums[0] * self.sums[0])
    }

    /// The mean square of the sine that would read as much as bin `k` does: density times noise bandwidth.
    pub fn tone_power(&self, k: usize) -> f64 {
        self.density[k] * self.noise_bandwidth()
    }

    /// The amplitude of the cosine that would read as much as bin `k` does, exact for one on the bin: `√(2·power)`, at
    /// zero and at the Nyquist frequency `√power`.
    pub fn amplitude(&self, k: usize) -> f64 {
        let alone = k == 0 || 2 * k == self.segments.length();
        (self.tone_power(k) * if alone { 1.0 } else { 2.0 }).sqrt()
    }

    /// The mean square of what lies within frequencies `from..to`: bins as rectangles of the width of a step around their
    /// frequency, parts of them by their part.
    pub fn power(&self, from: f64, to: f64) -> f64 {
        let place = |nu: f64| (nu / self.step() + 0.5).clamp(0.0, self.density.len() as f64);
        let [from, to] = [from, to].map(|nu| match nu {
            _ if nu <= 0.0 => 0.0,
            _ if nu >= 0.5 * self.rate => self.density.len() as f64,
            _ => place(nu),
        });
        if from >= to {
            return 0.0;
        }
        let (first, last) = (from as usize, to as usize);
        let part = |k: usize| self.density.get(k).copied().unwrap_or_default();
        let inner: f64 = if last > first + 1 { self.density[first + 1..last].iter().sum() } else { 0.0 };
        let ends = if first == last {
            part(first) * (to - from)
        } else {
            part(first) * (first as f64 + 1.0 - from) + part(last) * (to - last as f64)
        };
        (inner + ends) * self.step()
    }

    /// The mean square of all.
    pub fn total(&self) -> f64 {
        self.density.iter().sum::<f64>() * self.step()
    }

    /// The least frequency below which `fraction` of the power lies: the occupied band, to a part of a bin. `None` where
    /// there is no power at all.
    ///
    /// A line is as wide as the window makes it, so the band ends up to that much beyond it.
    ///
    /// # Errors
    /// A fraction that is not strictly between zero and one.
    pub fn occupied(&self, fraction: f64) -> Result<Option<f64>> {
        if !(fraction > 0.0 && fraction < 1.0) {
            return Err(Error::OutOfRange { what: "the fraction of power", value: fraction, low: 0.0, high: 1.0 });
        }
        let total: f64 = self.density.iter().sum();
        let (mut rest, wanted) = (0.0, (1.0 - fraction) * total);
        // from the top, where the terms are small
        for (k, &power) in self.density.iter().enumerate().rev() {
            if rest + power > wanted {
                let inside = (wanted - rest) / power;
                let upper = (k as f64 + 0.5 - inside) * self.step();
                return Ok(Some(upper.clamp(0.0, 0.5 * self.rate)));
            }
            rest += power;
        }
        Ok(None)
    }
}
