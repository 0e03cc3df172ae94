//! WAV out.

use crate::door::wav::encoding::{Clipping, Encoding};
use crate::door::wav::header::WavFormat;
use crate::error::{Error, Result};
use crate::num::random;
use std::io::{self, Seek, SeekFrom, Write};

/// What is added to values before they are rounded to integers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Dither {
    /// Nothing: values on the codes stay what they are; the error of all others depends on the signal, and a quiet tone
    /// gets harmonics.
    None,
    /// The difference of two random numbers from one step (triangular density, TPDF): mean and power of the error, ¼ of a
    /// squared step, then do not depend on the signal (Lipshitz, Wannamaker, Vanderkooy 1992). A function of seed, frame
    /// and channel.
    Triangular {
        /// Equal seeds give equal files.
        seed: u64,
    },
}

/// A WAV file that is being written, into any sink of bytes.
///
/// ```
/// use nyquist::door::wav::{Dither, Encoding, WavFormat, WavWriter};
/// let format = WavFormat::new(8_000, 1, Encoding::Int8)?;
/// let mut writer = WavWriter::new("memory", Vec::new(), format, None, Dither::None)?;
/// writer.write(&[0.0, 1.5])?;
/// let (bytes, clipping) = writer.finish()?;
/// assert_eq!(bytes[bytes.len() - 2..], [128, 255]);
/// assert_eq!((clipping.samples, clipping.first_frame, clipping.peak), (1, Some(1), 1.5));
/// # Ok::<(), nyquist::error::Error>(())
/// ```
#[derive(Debug)]
pub struct WavWriter<W> {
    name: String,
    sink: W,
    format: WavFormat,
    frames: Option<u64>,
    values: u64,
    key: Option<u64>,
    clipping: Clipping,
    bytes: Vec<u8>,
}

impl<W: Write> WavWriter<W> {
    /// Writes the head; `name` is what errors call the file. Without a number of frames the length is left open, as
    /// streams do (0xFFFFFFFF), until [`finish_seek`](Self::finish_seek). From 4 GiB on the file is an RF64. Dither is for
    /// integers: floats get none.
    ///
    /// # Errors
    /// [`Error::Io`] where writing fails, [`Error::Overflow`] where frames have more than 65535 bytes.
    pub fn new(name: &str, sink: W, format: WavFormat, frames: Option<u64>, dither: Dither) -> Result<Self> {
        if format.frame_bytes() > usize::from(u16::MAX) {
            let value = format.frame_bytes() as f64;
            return Err(Error::Overflow { what: "the size of a frame of a WAV file", value, most: 65_535.0 });
        }
        let key = match dither {
            Dither::Triangular { seed } if !format.encoding().is_float() => Some(random::bits(seed, 0, 0)),
            _ => None,
        };
        let (name, clipping) = (name.to_owned(), Clipping::default());
        let mut writer = Self { name, sink, format, frames, values: 0, key, clipping, bytes: Vec::new() };
        let head = format.head(frames, false);
        writer.sink.write_all(&head).map_err(|error| writer.failed(&error))?;
        Ok(writer)
    }

    fn failed(&self, error: &io::Error) -> Error {
        Error::Io { file: self.name.clone(), reason: error.to_string() }
    }

    /// Writes whole frames, channel after channel in each.
    ///
    /// # Errors
    /// [`Error::Length`] for a part of a frame or more frames than announced, [`Error::NotFiniteAt`], and [`Error::Io`].
    pub fn write(&mut self, block: &[f64]) -> Result<()> {
        let channels = self.format.channels();
        if !block.len().is_multiple_of(channels) {
            let expected = block.len().next_multiple_of(channels);
            return Err(Error::Length { what: "the values of whole frames", expected, got: block.len() });
        }
        if let Some(index) = block.iter().position(|v| !v.is_finite()) {
            return Err(Error::NotFiniteAt { what: "the samples of a sound", index, value: block[index] });
        }
        let encoding: Encoding = self.format.encoding();
        // pieces, so that the bytes of a large block do not stand beside it
        for piece in block.chunks(1 << 13) {
            self.bytes.clear();
            for &value in piece {
                let dither = self.key.map_or(0.0, |key| triangular(random::word(key, self.values)));
                if encoding.encode(value, dither, &mut self.bytes) {
                    self.clipping.samples += 1;
                    self.clipping.first_frame.get_or_insert(self.values / channels as u64);
                }
                self.clipping.peak = self.clipping.peak.max(value.abs());
                self.values += 1;
            }
            self.sink.write_all(&self.bytes).map_err(|error| self.failed(&error))?;
        }
        self.as_announced(|written, announced| written <= announced)
    }

    fn as_announced(&self, fits: impl Fn(u64, u64) -> bool) -> Result<()> {
        let written = self.values / self.format.channels() as u64;
        match self.frames {
            Some(announced) if !fits(written, announced) => Err(Error::Length {
                what: "the frames of a WAV file",
                expected: usize::try_from(announced).unwrap_or(usize::MAX),
                got: usize::try_from(written).unwrap_or(usize::MAX),
            }),
            _ => Ok(()),
        }
    }

    /// Ends the file and returns the sink, and what was clipped.
    ///
    /// # Errors
    /// [`Error::Length`] for fewer frames than announced, [`Error::Io`].
    pub fn finish(mut self) -> Result<(W, Clipping)> {
        self.end()?;
        Ok((self.sink, self.clipping))
    }

    fn end(&mut self) -> Result<()> {
        self.as_announced(|written, announced| written == announced)?;
        let bytes = self.values.saturating_mul(self.format.encoding().bytes() as u64);
        let padding = if self.frames.is_none() || bytes.is_multiple_of(2) { &[][..] } else { &[0] };
        let ended = self.sink.write_all(padding).and_then(|()| self.sink.flush());
        ended.map_err(|error| self.failed(&error))
    }
}

impl<W: Write + Seek> WavWriter<W> {
    /// [`finish`](Self::finish), and a length that was left open is written into the head.
    ///
    /// # Errors
    /// Those of [`finish`](Self::finish).
    pub fn finish_seek(mut self) -> Result<(W, Clipping)> {
        let open = self.frames.is_none();
        let frames = self.values / self.format.channels() as u64;
        self.frames = Some(frames);
        self.end()?;
        if open {
            let head = self.format.head(Some(frames), true);
            let sink = &mut self.sink;
            let patched = sink.seek(SeekFrom::Start(0)).and_then(|_| sink.write_all(&head)).and_then(|()| {
                sink.seek(SeekFrom::End(0))?;
                sink.flush()
            });
            patched.map_err(|error| self.failed(&error))?;
        }
        Ok((self.sink, self.clipping))
    }
}

/// The difference of the two halves of a word, in `(−1, 1)`.
fn triangular(word: u64) -> f64 {
    const SCALE: f64 = 1.0 / (1u64 << 32) as f64;
    ((word >> 32) as f64 - (word & 0xffff_ffff) as f64) * SCALE
}
