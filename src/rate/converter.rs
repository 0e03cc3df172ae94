//! Blocks in, blocks out.

use crate::engine::Arithmetic;
use crate::engine::fft::Butterflies;
use crate::engine::real::Real;
use crate::error::{Error, Result};
use crate::rate::between::{Between, Oversampling};
use crate::rate::blocks::{Blocks, Design};
use crate::rate::quality::Quality;
use crate::rate::ratio::{Ratio, too_much};
use crate::sampled::segments::{finite, whole, whole_frames};

/// The most values that all channels may keep between blocks: 4 GB.
const MOST_ROOM: usize = 1 << 29;
/// How many frames of a whole record are converted at a time, where they pass another rate.
const BLOCK: usize = 1 << 17;

/// A conversion of rates under way, of any number of channels, in `f64` or `f32`.
///
/// Its windows are converted on all threads of the current pool, so large blocks are converted fastest. It keeps the
/// memory that it needs, and allocates no more after the first blocks of the same length, unless `out` must grow.
///
/// ```
/// use nyquist::num::sin_pi;
/// use nyquist::rate::{Converter, Quality};
/// // a tone of 20 kHz, in blocks
/// let tone = |rate: f64, i: usize| sin_pi(2.0 * 20_000.0 * i as f64 / rate);
/// let mut converter = Converter::new(44_100.0, 48_000.0, 1, Quality::Best)?;
/// let mut converted = Vec::new();
/// for block in 0..10 {
///     let samples: Vec<f64> = (0..4410).map(|i| tone(44_100.0, 4410 * block + i)).collect();
///     converter.push(&samples, &mut converted)?;
/// }
/// converter.finish(&mut converted)?;
/// assert_eq!(converted.len(), 48_000);
/// // in the middle it is the same tone, at the same phase, to 200 dB
/// let worst = (8_000..40_000).map(|i| (converted[i] - tone(48_000.0, i)).abs()).fold(0.0, f64::max);
/// assert!(worst < 1e-10);
/// # Ok::<(), nyquist::error::Error>(())
/// ```
pub struct Converter<T = f64> {
    ratio: Ratio,
    way: Way<T>,
    channels: usize,
    /// Frames that came, and that went.
    taken: u64,
    given: u64,
}

enum Way<T> {
    /// Equal rates.
    Copy,
    /// Through the spectrum.
    Whole(Blocks<T>),
    /// Through the spectrum to an oversampled signal, and from there to any times.
    Real(Blocks<T>, Between<T>),
}

impl<T> std::fmt::Debug for Converter<T> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let (ratio, channels) = (self.ratio, self.channels);
        write!(f, "Converter {{ {ratio:?}, channels: {channels}, taken: {}, given: {} }}", self.taken, self.given)
    }
}

impl<T: Real> Converter<T> {
    /// From one rate to another (in the same unit), for frames of so many channels; the same bits on every processor.
    ///
    /// # Errors
    /// Rates that are not positive or more than a factor of 1000 apart ([`Ratio::new`]); no channels; so many that their
    /// windows do not fit into 4 GB.
    pub fn new(from: f64, to: f64, channels: usize, quality: Quality) -> Result<Self> {
        Self::with(from, to, channels, quality, Butterflies::Scalar)
    }

    /// By chosen butterflies: [`Butterflies::Fastest`] takes half the time, and differs from one processor to another by the
    /// rounding of two transforms: in a window of `n` frames by at most `32ε·log₂n` of the root mean square (twice the bound
    /// of [`fft`](crate::engine::fft)'s errors for both). Between rates that are no ratio of whole numbers products are fused
    /// with sums, too, and the highest frequencies, which are made stronger on the way, round up to 80 times as much.
    ///
    /// # Errors
    /// Those of [`new`](Self::new).
    pub fn with(from: f64, to: f64, channels: usize, quality: Quality, butterflies: Butterflies) -> Result<Self> {
        let ratio = Ratio::new(from, to)?;
        if channels == 0 {
            return Err(Error::TooFew { what: "channels", least: 1, got: 0 });
        }
        let fits = |design: Design| match design.room().saturating_mul(channels) {
            room if room > MOST_ROOM => Err(too_much(room as f64, MOST_ROOM as f64)),
            _ => Ok(design),
        };
        let way = if ratio.terms() == Some((1, 1)) {
            Way::Copy
        } else if let Some(design) = Design::exact(ratio, quality) {
            Way::Whole(Blocks::new(fits(design)?, channels, 0, butterflies))
        } else {
            let over = Oversampling::of::<T>();
            let design = fits(Design::oversampled(over, ratio, quality))?;
            let [up, down] = design.terms();
            // the filter rings before the first sample: so much silence first
            let lead = over.reach().div_ceil(up);
            let arithmetic = match butterflies {
                Butterflies::Scalar => Arithmetic::Plain,
                Butterflies::Fastest => Arithmetic::Fused,
            };
            let between = Between::new(over, channels, lead * up, ratio.step(up, down), arithmetic);
            Way::Real(Blocks::new(design, channels, lead * down, butterflies), between)
        };
        Ok(Self { ratio, way, channels, taken: 0, given: 0 })
    }

    /// The ratio of both rates.
    pub fn ratio(&self) -> Ratio {
        self.ratio
    }

    /// How far what is given stays behind what was taken, at most, in frames of the input: before
    /// [`finish`](Self::finish), of `n` frames that were taken at least those of the first `n − delay` have been given.
    ///
    /// ```
    /// use nyquist::rate::{Converter, Quality};
    /// let delay = |quality| Ok::<_, nyquist::error::Error>(Converter::<f32>::new(44_100.0, 48_000.0, 2, quality)?.delay());
    /// assert!(delay(Quality::Best)? < 44_100 / 2 && delay(Quality::Fast)? < 44_100 / 16);
    /// # Ok::<(), nyquist::error::Error>(())
    /// ```
    pub fn delay(&self) -> usize {
        match &self.way {
            Way::Copy => 0,
            Way::Whole(blocks) => blocks.delay(),
            Way::Real(blocks, _) => blocks.delay_with(Oversampling::of::<T>().reach() + 1),
        }
    }

    /// Takes whole frames, one value for each channel in turn, and appends to `out` those frames that they decide.
    ///
    /// # Errors
    /// [`Error::Length`] for a part of a frame, [`Error::NotFiniteAt`]; nothing has been taken then. [`Error::Overflow`] where
    /// sums of finite samples are too large: the frames have been taken, and not all that was appended is finite.
    pub fn push(&mut self, frames: &[T], out: &mut Vec<T>) -> Result<()> {
        whole_frames(frames, self.channels)?;
        self.taken += (frames.len() / self.channels) as u64;
        let start = out.len();
        let sound = match &mut self.way {
            Way::Copy => {
                out.extend_from_slice(frames);
                true
            }
            Way::Whole(blocks) => blocks.push(frames, out),
            Way::Real(blocks, between) => {
                let sound = blocks.push(frames, &mut between.samples);
                let ready = between.ready();
                out.resize(start + ready * self.channels, T::zero());
                let finite = between.fill(&mut out[start..]);
                between.go_on(ready);
                sound & finite
            }
        };
        self.given += ((out.len() - start) / self.channels) as u64;
        if sound { Ok(()) } else { Err(too_large::<T>()) }
    }

    /// Ends the input, and appends to `out` all that is left: in all there come `round(n·R/R₀)` frames.
    ///
    /// # Errors
    /// [`Error::Overflow`] as [`push`](Self::push).
    pub fn finish(mut self, out: &mut Vec<T>) -> Result<()> {
        let (start, missing) = (out.len(), self.ratio.frames(self.taken) - self.given);
        out.resize(start + missing as usize * self.channels, T::zero());
        if self.end(&[], &mut out[start..]) { Ok(()) } else { Err(too_large::<T>()) }
    }

    /// A whole record, from its first frame to its last, to where it stays: what [`push`](Self::push) and
    /// [`finish`](Self::finish) would give. What was pushed before is forgotten, and one converter may convert many records.
    ///
    /// ```
    /// use nyquist::engine::fft::Butterflies;
    /// use nyquist::rate::{Converter, Quality};
    /// let mut converter = Converter::with(44_100.0, 48_000.0, 2, Quality::High, Butterflies::Fastest)?;
    /// let mut stereo = vec![0.0f32; 2 * 48_000];
    /// converter.whole(&[[0.5, -0.25]; 44_100].concat(), &mut stereo)?;
    /// assert!((stereo[48_000] - 0.5).abs() < 1e-6 && (stereo[48_001] + 0.25).abs() < 1e-6);
    /// # Ok::<(), nyquist::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// Those of [`push`](Self::push), after which `out` may hold anything; an output of another length than that of
    /// `round(n·R/R₀)` frames; [`Error::Overflow`] where sums of finite samples are too large.
    pub fn whole(&mut self, frames: &[T], out: &mut [T]) -> Result<()> {
        whole(frames.len(), self.channels)?;
        // windows say themselves whether all is finite: the record is not read for it, unless there is none
        if matches!(self.way, Way::Copy) || out.is_empty() {
            finite(frames)?;
        }
        let expected = self.ratio.frames((frames.len() / self.channels) as u64) as usize * self.channels;
        if out.len() != expected {
            return Err(Error::Length { what: "the values of the converted frames", expected, got: out.len() });
        }
        self.reset();
        let (mut frames, mut out, mut sound) = (frames, out, true);
        if let Way::Real(blocks, between) = &mut self.way {
            // what lies between is not kept as a whole
            while let Some((block, rest)) = frames.split_at_checked(BLOCK * self.channels) {
                sound &= blocks.push(block, &mut between.samples);
                let ready = between.ready();
                let (done, later) = out.split_at_mut(ready * self.channels);
                sound &= between.fill(done);
                between.go_on(ready);
                (frames, out) = (rest, later);
            }
        }
        sound &= self.end(frames, out);
        self.reset();
        if sound {
            return Ok(());
        }
        finite(frames)?;
        Err(too_large::<T>())
    }

    fn reset(&mut self) {
        (self.taken, self.given) = (0, 0);
        match &mut self.way {
            Way::Copy => {}
            Way::Whole(blocks) => blocks.reset(),
            Way::Real(blocks, between) => {
                blocks.reset();
                between.reset();
            }
        }
    }

    /// All that is left, with these last frames; false if something was not finite.
    fn end(&mut self, frames: &[T], out: &mut [T]) -> bool {
        match &mut self.way {
            Way::Copy => {
                out.copy_from_slice(frames);
                true
            }
            Way::Whole(blocks) => blocks.fill(frames, out),
            Way::Real(blocks, between) => {
                let missing = between.missing(out.len() / self.channels);
                let sound = blocks.fill(frames, between.more(missing));
                between.fill(out) & sound
            }
        }
    }
}

/// The error for finite samples whose sums are not.
fn too_large<T: Real>() -> Error {
    let most = T::max_value().to_f64().unwrap_or(f64::MAX);
    Error::Overflow { what: "a converted sample", value: f64::INFINITY, most }
}

/// A whole record of one channel at another rate; the same bits on every processor.
///
/// ```
/// use nyquist::rate::{Quality, convert};
/// let down = convert(&[1.0; 96_000], 96_000.0, 44_100.0, Quality::High)?;
/// assert_eq!(down.len(), 44_100);
/// assert!(down[1_000..43_000].iter().all(|v| (v - 1.0).abs() < 1e-7));
/// # Ok::<(), nyquist::error::Error>(())
/// ```
///
/// # Errors
/// Those of [`Converter::new`]; values that are not finite, or whose sums are too large.
pub fn convert(values: &[f64], from: f64, to: f64, quality: Quality) -> Result<Vec<f64>> {
    let mut converter = Converter::new(from, to, 1, quality)?;
    let mut out = vec![0.0; converter.ratio.frames(values.len() as u64) as usize];
    converter.whole(values, &mut out)?;
    Ok(out)
}
