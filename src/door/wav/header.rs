//! The chunk `fmt `, and the head of a file that is written.

use crate::door::wav::encoding::Encoding;
use crate::error::{Error, Result};

/// What follows the two bytes of the kind in the name of a kind of `WAVE_FORMAT_EXTENSIBLE`.
const GUID_TAIL: [u8; 14] = [0, 0, 0, 0, 0x10, 0, 0x80, 0, 0, 0xaa, 0, 0x38, 0x9b, 0x71];
const PCM: u16 = 1;
const FLOAT: u16 = 3;
const EXTENSIBLE: u16 = 0xfffe;

/// What the samples of a file are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct WavFormat {
    rate: u32,
    channels: u16,
    encoding: Encoding,
    valid_bits: u16,
    speakers: Option<u32>,
}

impl WavFormat {
    /// Frames a second, channels, kind of samples.
    ///
    /// ```
    /// use nyquist::door::wav::{Encoding, WavFormat};
    /// let disc = WavFormat::new(44_100, 2, Encoding::Int16)?;
    /// assert_eq!(disc.frame_bytes(), 4);
    /// # Ok::<(), nyquist::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// A rate or a number of channels that is zero.
    pub fn new(rate: u32, channels: u16, encoding: Encoding) -> Result<Self> {
        if rate == 0 {
            return Err(Error::NotPositive { what: "the rate of a WAV file", value: 0.0 });
        }
        if channels == 0 {
            return Err(Error::NotPositive { what: "the number of channels of a WAV file", value: 0.0 });
        }
        Ok(Self { rate, channels, encoding, valid_bits: encoding.bits(), speakers: None })
    }

    /// The same channels at another rate and in another encoding.
    ///
    /// # Errors
    /// A rate of zero.
    pub fn with(self, rate: u32, encoding: Encoding) -> Result<Self> {
        Ok(Self { speakers: self.speakers, ..Self::new(rate, self.channels, encoding)? })
    }

    /// Frames a second, Hz.
    pub fn rate(&self) -> u32 {
        self.rate
    }

    /// The number of channels.
    pub fn channels(&self) -> usize {
        usize::from(self.channels)
    }

    /// The kind of samples.
    pub fn encoding(&self) -> Encoding {
        self.encoding
    }

    /// How many upper bits of an integer are used: 20 of 24, say.
    pub fn valid_bits(&self) -> u16 {
        self.valid_bits
    }

    /// Which loudspeakers the channels are for, a bit each, as an extensible header says.
    pub fn speakers(&self) -> Option<u32> {
        self.speakers
    }

    /// Bytes a frame.
    pub fn frame_bytes(&self) -> usize {
        self.channels() * self.encoding.bytes()
    }

    /// Reads a chunk `fmt ` (its first 40 bytes; shorter if it is). The error is a reason, without the name of the file;
    /// beside the format whether the byte rate fits.
    pub(super) fn parse(fmt: &[u8]) -> std::result::Result<(Self, bool), String> {
        let short = || format!("its chunk \"fmt \" has {} bytes and needs more", fmt.len());
        let u16_at = |at: usize| fmt.get(at..at + 2).map(|b| u16::from_le_bytes([b[0], b[1]])).ok_or_else(short);
        let u32_at = |at: usize| Ok::<_, String>(u32::from(u16_at(at)?) | u32::from(u16_at(at + 2)?) << 16);
        let (mut kind, channels, rate, byte_rate) = (u16_at(0)?, u16_at(2)?, u32_at(4)?, u32_at(8)?);
        let (align, bits) = (u16_at(12)?, u16_at(14)?);
        let (mut valid, mut speakers) = (bits, None);
        if kind == EXTENSIBLE {
            let (extension, inside) = (u16_at(16)?, u16_at(18)?);
            if extension < 22 || fmt.len() < 40 {
                return Err("its header is called extensible and has no extension".into());
            }
            if fmt[26..40] != GUID_TAIL {
                return Err("its samples are of a kind that is not known (by the extensible header)".into());
            }
            valid = if inside == 0 { bits } else { inside };
            speakers = Some(u32_at(20)?);
            kind = u16_at(24)?;
        }
        if channels == 0 {
            return Err("the header says 0 channels".into());
        }
        if rate == 0 {
            return Err("the header says a rate of 0 Hz".into());
        }
        let encoding = match (kind, bits) {
            (PCM, 1..=8) => Encoding::Int8,
            (PCM, 9..=16) => Encoding::Int16,
            (PCM, 17..=24) => Encoding::Int24,
            (PCM, 25..=32) => Encoding::Int32,
            (FLOAT, 32) => Encoding::Float32,
            (FLOAT, 64) => Encoding::Float64,
            (PCM, _) => return Err(format!("integers of {bits} bits are not read, only of 1 to 32")),
            (FLOAT, _) => return Err(format!("floating-point samples of {bits} bits are not read, only of 32 or 64")),
            _ => return Err(format!("its samples are compressed ({}): convert it to PCM", compressed(kind))),
        };
        if valid > encoding.bits() {
            return Err(format!("the header says {valid} valid bits in samples of {}", encoding.bits()));
        }
        let valid = if encoding.is_float() { bits } else { valid };
        let format = Self { rate, channels, encoding, valid_bits: valid, speakers };
        if usize::from(align) != format.frame_bytes() {
            let (frame, bytes) = (format.frame_bytes(), encoding.bytes());
            return Err(format!(
                "the header contradicts itself: {channels} channels of {bytes} bytes are frames of {frame} bytes, not of {align}"
            ));
        }
        Ok((format, u64::from(byte_rate) == u64::from(rate) * format.frame_bytes() as u64))
    }

    fn fmt_chunk(&self) -> Vec<u8> {
        let kind = if self.encoding.is_float() { FLOAT } else { PCM };
        // more than two channels or more than 16 bits of integers need the extensible header to be understood
        let extensible = self.channels > 2 || self.speakers.is_some() || (self.encoding.bytes() > 2 && kind == PCM);
        let mut fmt = Vec::with_capacity(40);
        fmt.extend(if extensible { EXTENSIBLE } else { kind }.to_le_bytes());
        fmt.extend(self.channels.to_le_bytes());
        fmt.extend(self.rate.to_le_bytes());
        let byte_rate = u64::from(self.rate) * self.frame_bytes() as u64;
        fmt.extend(u32::try_from(byte_rate).unwrap_or(u32::MAX).to_le_bytes());
        fmt.extend((self.frame_bytes() as u16).to_le_bytes());
        fmt.extend(self.encoding.bits().to_le_bytes());
        if extensible {
            fmt.extend(22u16.to_le_bytes());
            fmt.extend(self.valid_bits.to_le_bytes());
            fmt.extend(self.speakers.unwrap_or(default_speakers(self.channels)).to_le_bytes());
            fmt.extend(kind.to_le_bytes());
            fmt.extend(GUID_TAIL);
        } else if kind == FLOAT {
            fmt.extend(0u16.to_le_bytes());
        }
        fmt
    }

    /// All bytes before the data.
    ///
    /// A length that is not known yet is left open, as streams do, with room for the 64-bit one: a head of a known length
    /// `patched` has the same size.
    pub(super) fn head(&self, frames: Option<u64>, patched: bool) -> Vec<u8> {
        let fmt = self.fmt_chunk();
        let facts = self.encoding.is_float();
        let data = frames.map(|f| f.saturating_mul(self.frame_bytes() as u64));
        let body = (4 + 8 + fmt.len() + if facts { 12 } else { 0 } + 8) as u64;
        let room = frames.is_none() || patched;
        let large = data.is_some_and(|d| d.saturating_add(body + 37) >= u64::from(u32::MAX));
        let extra = if room || large { 36 } else { 0 };
        let riff = data.map(|d| d.saturating_add(d % 2).saturating_add(body + extra));
        let small = |n: Option<u64>| match n {
            Some(n) if !large => n as u32,
            _ => u32::MAX,
        };
        let mut head = Vec::with_capacity(128);
        head.extend(if large { b"RF64" } else { b"RIFF" });
        head.extend(small(riff).to_le_bytes());
        head.extend(b"WAVE");
        if large {
            head.extend(b"ds64\x1c\0\0\0");
            for n in [riff, data, frames] {
                head.extend(n.unwrap_or(0).to_le_bytes());
            }
            head.extend([0; 4]);
        } else if room {
            head.extend(b"JUNK\x1c\0\0\0");
            head.extend([0; 28]);
        }
        head.extend(b"fmt ");
        head.extend((fmt.len() as u32).to_le_bytes());
        head.extend(fmt);
        if facts {
            head.extend(b"fact\x04\0\0\0");
            head.extend(frames.and_then(|f| u32::try_from(f).ok()).unwrap_or(u32::MAX).to_le_bytes());
        }
        head.extend(b"data");
        head.extend(small(data).to_le_bytes());
        head
    }
}

/// Front left and right, front centre for one channel, nothing in particular for more.
fn default_speakers(channels: u16) -> u32 {
    match channels {
        1 => 4,
        2 => 3,
        _ => 0,
    }
}

fn compressed(kind: u16) -> String {
    let name = match kind {
        2 => "Microsoft ADPCM",
        6 => "A-law",
        7 => "µ-law",
        0x11 => "IMA ADPCM",
        0x31 => "GSM 6.10",
        0x50 => "MPEG layer 2",
        0x55 => "MP3",
        0xff => "AAC",
        _ => return format!("kind 0x{kind:04x}"),
    };
    name.into()
}
