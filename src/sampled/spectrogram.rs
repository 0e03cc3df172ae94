//! Power over time and frequency, in as many cells as a picture has, however long the record is.

use crate::error::{Error, Result, positive};
use crate::sampled::segments::{Periodograms, Segments};
use ndarray::Array2;

/// A spectrogram of any number of channels, while their frames come in.
///
/// A column is the mean density of a number of segments, a row that of a number of bins. When there are more columns than
/// allowed, neighbours become one: memory does not grow with the record, and the bits do not depend on how the record is
/// cut into blocks.
///
/// ```
/// use nyquist::num::sin_pi;
/// use nyquist::sampled::segments::Segments;
/// use nyquist::sampled::spectrogram::SpectrogramWriter;
/// use nyquist::sampled::window::Window;
/// // half a second of 500 Hz, then half a second of 3000 Hz
/// let tone = |i: u32| sin_pi(2.0 * if i < 4000 { 500.0 } else { 3000.0 } * f64::from(i) / 8000.0);
/// let mut writer = SpectrogramWriter::new(8000.0, 1, Segments::new(256, 128, Window::Hann)?, 16, 129)?;
/// writer.push(&(0..8000).map(tone).collect::<Vec<_>>())?;
/// let spectrogram = &writer.finish()?[0];
/// let (rows, columns) = spectrogram.density().dim();
/// assert_eq!((rows, columns), (129, 15)); // 61 segments, four in a column, the last of fewer dropped
/// let loudest = |column: usize| (0..rows).max_by(|a, b| {
///     spectrogram.density()[[*a, column]].total_cmp(&spectrogram.density()[[*b, column]])
/// });
/// assert_eq!((loudest(2), loudest(12)), (Some(16), Some(96))); // 16·31.25 Hz = 500 Hz, 96·31.25 Hz = 3000 Hz
/// # Ok::<(), nyquist::error::Error>(())
/// ```
#[derive(Debug)]
pub struct SpectrogramWriter {
    rate: f64,
    periodograms: Periodograms,
    lanes: Vec<Lane>,
    frames: usize,
    most: usize,
    /// Bins in a row.
    bins: usize,
}

/// One channel.
#[derive(Debug, Clone)]
struct Lane {
    /// Sums over the segments of a column.
    columns: Vec<Vec<f64>>,
    /// Segments in a column, and in the last one.
    each: u64,
    last: u64,
}

impl SpectrogramWriter {
    /// For frames of so many channels at a rate, with at most `columns ≥ 2` columns and about `rows` rows, at most one a
    /// bin.
    ///
    /// # Errors
    /// A rate that is not positive and finite; no channels; fewer than two columns, or no rows.
    pub fn new(rate: f64, channels: usize, segments: Segments, columns: usize, rows: usize) -> Result<Self> {
        positive("the sampling rate", rate)?;
        if columns < 2 {
            return Err(Error::TooFew { what: "columns of a spectrogram", least: 2, got: columns });
        }
        if rows == 0 {
            return Err(Error::TooFew { what: "rows of a spectrogram", least: 1, got: 0 });
        }
        let periodograms = Periodograms::new(segments, channels)?;
        let bins = (segments.length() / 2 + 1).div_ceil(rows);
        let lane = Lane { columns: Vec::new(), each: 1, last: 0 };
        Ok(Self { rate, periodograms, lanes: vec![lane; channels], frames: 0, most: columns, bins })
    }

    /// Takes whole frames, one value for each channel in turn.
    ///
    /// # Errors
    /// [`Error::Length`] for a part of a frame, [`Error::NotFiniteAt`], values beyond 10¹⁴⁰; nothing has been taken
    /// then.
    pub fn push(&mut self, frames: &[f64]) -> Result<()> {
        let Self { periodograms, lanes, most, bins, .. } = self;
        periodograms.push(frames, |channel, powers| lanes[channel].add(powers, *bins, *most))?;
        self.frames += frames.len() / self.lanes.len();
        Ok(())
    }

    /// Ends the record; a spectrogram for each channel. A last column with fewer segments than the others is dropped.
    ///
    /// # Errors
    /// [`Error::TooFew`] where the record is shorter than a segment.
    pub fn finish(self) -> Result<Vec<Spectrogram>> {
        let Self { rate, periodograms, mut lanes, frames, most, bins } = self;
        let segments = periodograms.segments();
        periodograms.finish(|channel, powers| lanes[channel].add(powers, bins, most));
        let least = segments.length();
        if lanes.iter().any(|lane| lane.columns.is_empty()) {
            return Err(Error::TooFew { what: "samples of a spectrogram: those of a segment", least, got: frames });
        }
        Ok(lanes.into_iter().map(|lane| lane.finish(rate, segments, bins)).collect())
    }
}

impl Lane {
    fn add(&mut self, powers: &[f64], bins: usize, most: usize) {
        if self.columns.is_empty() || self.last == self.each {
            if self.columns.len() == most {
                self.halve();
            }
            if self.columns.is_empty() || self.last == self.each {
                self.columns.push(vec![0.0; powers.len().div_ceil(bins)]);
                self.last = 0;
            }
        }
        let Some(column) = self.columns.last_mut() else { return };
        column.iter_mut().zip(powers.chunks(bins)).for_each(|(sum, part)| {
            *sum += part.iter().sum::<f64>() / part.len() as f64;
        });
        self.last += 1;
    }

    /// Neighbours become one.
    fn halve(&mut self) {
        let whole = self.columns.len().is_multiple_of(2);
        for i in 0..self.columns.len() / 2 {
            let second = std::mem::take(&mut self.columns[2 * i + 1]);
            let mut first = std::mem::take(&mut self.columns[2 * i]);
            first.iter_mut().zip(&second).for_each(|(a, b)| *a += b);
            self.columns[i] = first;
        }
        let left = self.columns.len() / 2;
        if !whole {
            self.columns.swap(left, 2 * left);
        }
        self.columns.truncate(self.columns.len().div_ceil(2));
        self.last = if whole { 2 * self.each } else { self.each };
        self.each *= 2;
    }

    fn finish(mut self, rate: f64, segments: Segments, bins: usize) -> Spectrogram {
        if self.last < self.each && self.columns.len() > 1 {
            self.columns.pop();
            self.last = self.each;
        }
        let weights = segments.window().values(segments.length());
        let power: f64 = weights.iter().map(|w| w * w).sum();
        let scale = 2.0 / (rate * power * self.last as f64);
        let rows = self.columns[0].len();
        let density =
            Array2::from_shape_fn((rows, self.columns.len()), |(row, column)| scale * self.columns[column][row]);
        let hop = (self.last * segments.hop() as u64) as f64 / rate;
        // segments stand for their middles
        let start = 0.5 * (segments.length() as f64 / rate - segments.hop() as f64 / rate);
        let step = bins as f64 * rate / segments.length() as f64;
        Spectrogram { density, start, hop, step, top: 0.5 * rate, bins }
    }
}

/// Power per unit of frequency, over time and frequency.
#[derive(Debug, Clone, PartialEq)]
pub struct Spectrogram {
    density: Array2<f64>,
    start: f64,
    hop: f64,
    step: f64,
    top: f64,
    bins: usize,
}

impl Spectrogram {
    /// The density `[[row, column]]` in squared units of the samples per unit of frequency, one-sided; row 0 is around zero.
    pub fn density(&self) -> &Array2<f64> {
        &self.density
    }

    /// From when to when a column lasts.
    pub fn time(&self, column: usize) -> [f64; 2] {
        [column, column + 1].map(|i| self.start + i as f64 * self.hop)
    }

    /// From where to where the frequencies of a row go: bins reach half their distance to either side.
    pub fn frequencies(&self, row: usize) -> [f64; 2] {
        let half = 0.5 * self.step / self.bins as f64;
        [row, row + 1].map(|i| (i as f64 * self.step - half).clamp(0.0, self.top))
    }
}
