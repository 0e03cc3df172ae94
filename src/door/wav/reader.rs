//! WAV in.

use crate::door::skipped::Skipped;
use crate::door::wav::encoding::Encoding;
use crate::door::wav::header::WavFormat;
use crate::error::{Error, Result};
use std::io::{self, ErrorKind, Read};

/// What sox and espeak write as the length of data into a pipe, rounded down to whole frames.
const OPEN_LENGTH: u64 = 0x7fff_f000;
/// Bytes that are read at a time.
const ROOM: usize = 1 << 16;

/// A WAV file that is being read, from any source of bytes.
///
/// ```
/// use nyquist::door::wav::{Dither, Encoding, WavFormat, WavReader, WavWriter};
/// let format = WavFormat::new(48_000, 2, Encoding::Int24)?;
/// let mut writer = WavWriter::new("memory", Vec::new(), format, Some(2), Dither::None)?;
/// writer.write(&[0.5, -0.5, 0.25, -1.0])?; // two frames of two channels
/// let (bytes, clipping) = writer.finish()?;
/// assert_eq!(clipping.samples, 0);
///
/// let mut reader = WavReader::new("memory", &bytes[..])?;
/// assert_eq!(reader.frames(), Some(2));
/// let mut block = Vec::new();
/// assert_eq!(reader.read(1, &mut block)?, 1);
/// assert_eq!(block, [0.5, -0.5]);
///
/// let error = WavReader::new("notes.txt", &b"no sound in here"[..]).unwrap_err();
/// assert_eq!(error.to_string(), "notes.txt: not a WAV file, by its first bytes");
/// # Ok::<(), nyquist::error::Error>(())
/// ```
#[derive(Debug)]
pub struct WavReader<R> {
    name: String,
    source: R,
    format: WavFormat,
    /// Bytes of data still to come; `None` up to the end of the source.
    left: Option<u64>,
    frames: Option<u64>,
    done: u64,
    /// Whether the data have been read to their end, and what follows them has been looked at.
    finished: bool,
    skipped: Vec<Skipped>,
    trailing: u64,
    byte_rate_fits: bool,
}

impl<R: Read> WavReader<R> {
    /// Reads the head of a file up to its data; `name` is what errors call it.
    ///
    /// # Errors
    /// [`Error::Format`] for what is no WAV file, ends too early, contradicts itself, or is of a kind that is not read;
    /// [`Error::Io`] where reading fails.
    pub fn new(name: &str, source: R) -> Result<Self> {
        let mut head = Head { name, source, at: 0, skipped: Vec::new() };
        let first: [u8; 4] = match head.bytes("") {
            Err(Error::Format { .. }) => return Err(head.refused("not a WAV file, by its first bytes")),
            first => first?,
        };
        let large = matches!(&first, b"RF64" | b"BW64");
        if &first == b"RIFX" {
            return Err(head.refused("a WAV file in big-endian order (RIFX), which is not read"));
        }
        if !large && &first != b"RIFF" {
            return Err(head.refused("not a WAV file, by its first bytes"));
        }
        let mut riff = u64::from(u32::from_le_bytes(head.bytes("its header")?));
        if &head.bytes::<4>("its header")? != b"WAVE" {
            return Err(head.refused("a RIFF file, but not of sound (WAVE)"));
        }
        let (mut format, mut long_data) = (None, None);
        loop {
            let id: [u8; 4] = head.bytes("its header, before any data")?;
            let size = u64::from(u32::from_le_bytes(head.bytes("its header, before any data")?));
            match &id {
                b"ds64" if large => {
                    if size < 28 {
                        return Err(head.refused(format!("its chunk \"ds64\" has {size} bytes and needs 28")));
                    }
                    riff = u64::from_le_bytes(head.bytes("its chunk \"ds64\"")?);
                    long_data = Some(u64::from_le_bytes(head.bytes("its chunk \"ds64\"")?));
                    head.skip(&id, size - 16)?;
                }
                b"fmt " => {
                    if format.is_some() {
                        return Err(head.refused("there are two chunks \"fmt \""));
                    }
                    let mut fmt = [0; 40];
                    let fmt = &mut fmt[..size.min(40) as usize];
                    head.fill(fmt, "its chunk \"fmt \"")?;
                    format = Some(WavFormat::parse(fmt).map_err(|reason| head.refused(reason))?);
                    head.skip(&id, size - fmt.len() as u64)?;
                }
                b"data" => {
                    let Some((format, byte_rate_fits)) = format else {
                        return Err(head.refused("its data stand before the chunk \"fmt \" that explains them"));
                    };
                    let Head { source, at, skipped, .. } = head;
                    let frame = format.frame_bytes() as u64;
                    let sox = OPEN_LENGTH - OPEN_LENGTH % frame;
                    // zero is open where the file claims to end here: nobody came back to fill it in
                    let unfinished = size == 0 && (riff + 8 <= at || riff >= sox);
                    let open = size == u64::from(u32::MAX) || size == sox || size == OPEN_LENGTH || unfinished;
                    let left = match long_data {
                        Some(n) if size == u64::from(u32::MAX) && n != u64::MAX => Some(n),
                        _ => (!open).then_some(size),
                    };
                    if let Some(bytes) = left.filter(|bytes| bytes % frame != 0) {
                        let reason = format!(
                            "the header says {bytes} bytes of data, which is no whole number of frames of {frame} bytes"
                        );
                        return Err(refused(name, reason));
                    }
                    return Ok(Self {
                        name: name.to_owned(),
                        source,
                        format,
                        left,
                        frames: left.map(|bytes| bytes / frame),
                        done: 0,
                        finished: false,
                        skipped,
                        trailing: 0,
                        byte_rate_fits,
                    });
                }
                _ => {
                    head.note(&id, size);
                    head.skip(&id, size)?;
                }
            }
        }
    }

    /// What the samples are.
    pub fn format(&self) -> WavFormat {
        self.format
    }

    /// How many frames the header claims; `None` where a stream left it open. A claim: the data may end earlier, and then
    /// [`read`](Self::read) says so.
    pub fn frames(&self) -> Option<u64> {
        self.frames
    }

    /// How many frames have been read.
    pub fn position(&self) -> u64 {
        self.done
    }

    /// The chunks that were skipped so far, by name; complete when [`read`](Self::read) has returned 0. Fillers (`JUNK`,
    /// `PAD `, `FLLR`) and `fact` hold nothing and are not listed.
    pub fn skipped(&self) -> &[Skipped] {
        &self.skipped
    }

    /// Bytes after the data that are no chunk.
    pub fn trailing(&self) -> u64 {
        self.trailing
    }

    /// Whether the header's bytes a second are frames times rate; nothing depends on them.
    pub fn byte_rate_fits(&self) -> bool {
        self.byte_rate_fits
    }

    /// As many frames as fill about half a megabyte, at least one: a good size of blocks.
    pub fn block(&self) -> usize {
        (ROOM / self.format.channels()).max(1)
    }

    /// Appends up to `frames` frames to `block`, channel after channel in each, and returns how many: fewer than asked for
    /// only at the end, and 0 from there on.
    ///
    /// # Errors
    /// [`Error::Format`] where the data end before the header says, in the middle of a frame, or hold a value that is not
    /// finite (with its frame, counted from 0); [`Error::Io`] where reading fails.
    pub fn read(&mut self, frames: usize, block: &mut Vec<f64>) -> Result<usize> {
        let frame = self.format.frame_bytes();
        let encoding = self.format.encoding();
        let mut bytes = vec![0; (ROOM / frame).max(1).min(frames) * frame];
        let mut got = 0;
        while got < frames && !self.finished {
            let wanted = bytes.len().min((frames - got).saturating_mul(frame));
            let wanted = self.left.map_or(wanted, |left| wanted.min(usize::try_from(left).unwrap_or(wanted)));
            let here = self.fill(&mut bytes[..wanted])?;
            let whole = here / frame;
            let at = block.len();
            encoding.decode(&bytes[..whole * frame], block);
            if encoding.is_float() {
                self.all_finite(encoding, &block[at..])?;
            }
            self.done += whole as u64;
            got += whole;
            if let Some(left) = &mut self.left {
                *left -= here as u64;
                if here < wanted {
                    let claimed = self.frames.unwrap_or_default();
                    let reason =
                        format!("the data end after {} of the {claimed} frames that the header says", self.done);
                    return Err(refused(&self.name, reason));
                }
            } else if here % frame != 0 {
                return Err(refused(&self.name, format!("the data end in the middle of frame {}", self.done)));
            }
            if here < wanted || self.left == Some(0) {
                self.finish();
            }
        }
        Ok(got)
    }

    fn all_finite(&self, encoding: Encoding, values: &[f64]) -> Result<()> {
        let Some(i) = values.iter().position(|v| !v.is_finite()) else { return Ok(()) };
        let channels = self.format.channels();
        let (frame, channel) = (self.done + (i / channels) as u64, i % channels + 1);
        let bits = encoding.bits();
        let reason = format!("frame {frame}, channel {channel}: the {bits}-bit float is {}, no sound", values[i]);
        Err(refused(&self.name, reason))
    }

    /// Reads until `room` is full or the source ends.
    fn fill(&mut self, room: &mut [u8]) -> Result<usize> {
        let mut filled = 0;
        while filled < room.len() {
            match self.source.read(&mut room[filled..]) {
                Ok(0) => break,
                Ok(n) => filled += n,
                Err(error) if error.kind() == ErrorKind::Interrupted => {}
                Err(error) => return Err(Error::Io { file: self.name.clone(), reason: error.to_string() }),
            }
        }
        Ok(filled)
    }

    /// Looks at what follows the data. Whatever is wrong there is no matter of the sound.
    fn finish(&mut self) {
        self.finished = true;
        if self.frames.is_none() {
            return;
        }
        let odd = self.frames.unwrap_or_default() % 2 * (self.format.frame_bytes() % 2) as u64;
        let skipped = std::mem::take(&mut self.skipped);
        let mut head = Head { name: &self.name, source: &mut self.source, at: 0, skipped };
        if head.pass(odd).is_ok() {
            let mut end = head.at;
            while let Ok(id) = head.bytes::<4>("") {
                let Ok(size) = head.bytes("").map(u32::from_le_bytes) else { break };
                if !id.iter().all(|c| (b' '..=b'~').contains(c)) || head.skip(&id, u64::from(size)).is_err() {
                    break;
                }
                head.note(&id, u64::from(size));
                end = head.at;
            }
            // to the last byte: whoever writes into a pipe should not see it closed
            let rest = io::copy(&mut head.source, &mut io::sink()).unwrap_or_default();
            self.trailing = head.at - end + rest;
        }
        self.skipped = head.skipped;
    }
}

fn refused(name: &str, reason: impl Into<String>) -> Error {
    Error::Format { file: name.to_owned(), reason: reason.into() }
}

/// The head of a file, read piece by piece.
struct Head<'a, R> {
    name: &'a str,
    source: R,
    at: u64,
    skipped: Vec<Skipped>,
}

impl<R: Read> Head<'_, R> {
    fn refused(&self, reason: impl Into<String>) -> Error {
        refused(self.name, reason)
    }

    fn fill(&mut self, room: &mut [u8], within: &str) -> Result<()> {
        let read = self.source.read_exact(room);
        read.map_err(|error| match error.kind() {
            ErrorKind::UnexpectedEof => self.refused(format!("the file ends within {within}")),
            _ => Error::Io { file: self.name.to_owned(), reason: error.to_string() },
        })?;
        self.at += room.len() as u64;
        Ok(())
    }

    fn bytes<const N: usize>(&mut self, within: &str) -> Result<[u8; N]> {
        let mut bytes = [0; N];
        self.fill(&mut bytes, within)?;
        Ok(bytes)
    }

    /// Reads `count` bytes and forgets them.
    fn pass(&mut self, count: u64) -> io::Result<()> {
        let passed = io::copy(&mut (&mut self.source).take(count), &mut io::sink())?;
        self.at += passed;
        if passed < count { Err(ErrorKind::UnexpectedEof.into()) } else { Ok(()) }
    }

    /// Passes the rest of a chunk and the byte that makes its size even.
    fn skip(&mut self, id: &[u8; 4], count: u64) -> Result<()> {
        self.pass(count + count % 2).map_err(|error| match error.kind() {
            ErrorKind::UnexpectedEof => {
                let chunk = String::from_utf8_lossy(id).escape_debug().to_string();
                self.refused(format!("the file ends within its chunk \"{chunk}\""))
            }
            _ => Error::Io { file: self.name.to_owned(), reason: error.to_string() },
        })
    }

    fn note(&mut self, id: &[u8; 4], size: u64) {
        if matches!(id, b"JUNK" | b"junk" | b"PAD " | b"FLLR" | b"fact") {
            return;
        }
        let name = String::from_utf8_lossy(id).escape_debug().to_string();
        Skipped::count(&mut self.skipped, name, size);
    }
}
