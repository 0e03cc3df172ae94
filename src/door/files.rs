//! Bytes to pictures and back.

use crate::door::picture::Picture;
use crate::door::{jpeg, png, srgb};
use crate::error::{Error, Result};
use crate::grid::Grid;
use crate::image::{Image, Rgb};
use std::path::Path;

/// How large a picture may be that a file of a few bytes asks for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Limits {
    /// The most pixels; more are refused before anything is decoded.
    pub pixels: u64,
}

impl Default for Limits {
    /// 2²⁶ = 67 million pixels, which as colour fill 1.6 GB.
    fn default() -> Self {
        Self { pixels: 1 << 26 }
    }
}

/// Bits a channel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Depth {
    /// 256 codes.
    Eight,
    /// 65536 codes.
    Sixteen,
}

/// The picture in the bytes of a PNG or JPEG file, told apart by their first bytes; `name` is what errors call it.
///
/// sRGB becomes linear light; a pixel is of size one, the first one around (½, ½). A JPEG is turned as its camera says
/// (EXIF orientation).
///
/// ```
/// use nyquist::prelude::*;
/// let grey = Image::new(Grid::pixels(2, 1)?, vec![0.0, srgb_to_linear(188.0 / 255.0)])?;
/// let bytes = png_bytes(&grey.clone().into(), Depth::Eight)?;
/// assert_eq!(read_picture("grey.png", &bytes, Limits::default())?, Picture::from(grey));
/// let error = read_picture("notes.txt", b"no picture", Limits::default()).unwrap_err();
/// assert_eq!(error.to_string(), "notes.txt: neither a PNG nor a JPEG file, by its first bytes");
/// # Ok::<(), Error>(())
/// ```
///
/// # Errors
/// [`Error::Format`] for other files, truncated ones, sizes that are zero or do not agree with the data, more pixels than
/// `limits` allow, and kinds that are not read (CMYK).
pub fn read_picture(name: &str, bytes: &[u8], limits: Limits) -> Result<Picture> {
    if bytes.is_empty() {
        return Err(refused(name, "the file is empty"));
    }
    if bytes.starts_with(b"\x89PNG\r\n\x1a\n") {
        png::read(name, bytes, limits)
    } else if bytes.starts_with(b"\xff\xd8\xff") {
        jpeg::read(name, bytes, limits)
    } else {
        Err(refused(name, "neither a PNG nor a JPEG file, by its first bytes"))
    }
}

/// [`read_picture`] of a file.
///
/// # Errors
/// [`Error::Io`] where it cannot be read, and what [`read_picture`] refuses.
pub fn open_picture(path: &Path, limits: Limits) -> Result<Picture> {
    let file = path.display().to_string();
    match std::fs::read(path) {
        Ok(bytes) => read_picture(&file, &bytes, limits),
        Err(error) => Err(Error::Io { file, reason: error.to_string() }),
    }
}

/// The bytes of a PNG file in sRGB: every value becomes the nearest code, those below 0 and above 1 the ends of the range.
///
/// A picture that was read from 8 or 16 bits comes back code for code. The same bytes for the same picture.
///
/// # Errors
/// Values that are not numbers; a width or height above 2³¹ − 1.
pub fn png_bytes(picture: &Picture, depth: Depth) -> Result<Vec<u8>> {
    png::write(picture, depth)
}

/// The error for a file that is not taken.
pub(super) fn refused(name: &str, reason: impl Into<String>) -> Error {
    Error::Format { file: name.to_owned(), reason: reason.into() }
}

/// The grid of a picture whose header says this size.
pub(super) fn checked_grid(name: &str, width: u64, height: u64, limits: Limits) -> Result<Grid> {
    if width == 0 || height == 0 {
        return Err(refused(name, format!("the header says {width} × {height} pixels: nothing")));
    }
    let pixels = width.saturating_mul(height);
    if pixels > limits.pixels {
        let reason =
            format!("the header says {width} × {height} = {pixels} pixels, more than the {} allowed", limits.pixels);
        return Err(refused(name, reason));
    }
    let size = |n: u64| usize::try_from(n).map_err(|_| refused(name, format!("{n} pixels in a row do not fit")));
    Grid::pixels(size(width)?, size(height)?).map_err(|error| refused(name, error.to_string()))
}

/// How codes stand for light.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Transfer {
    /// The curve of sRGB.
    Srgb,
    /// A plain power: light = code^exponent.
    Power(f64),
}

/// The picture of interleaved samples of 1 (grey), 2 (grey and alpha), 3 (colour) or 4 (colour and alpha) channels, each of
/// one byte or of two, the high one first.
pub(super) fn picture(grid: Grid, samples: &[u8], channels: usize, wide: bool, transfer: Transfer) -> Result<Picture> {
    let most = if wide { 65_535 } else { 255u32 };
    let scale = f64::from(most);
    let light: Vec<f64> = (0..=most)
        .map(|code| match (f64::from(code) / scale, transfer) {
            (v, Transfer::Srgb) => srgb::srgb_to_linear(v),
            (v, Transfer::Power(exponent)) => v.powf(exponent),
        })
        .collect();
    let bytes = if wide { 2 } else { 1 };
    let code = |at: &[u8]| if wide { usize::from(at[0]) << 8 | usize::from(at[1]) } else { usize::from(at[0]) };
    let plane = |channel: usize, of: &dyn Fn(usize) -> f64| {
        let pixels = samples.chunks_exact(channels * bytes);
        Image::new(grid, pixels.map(|pixel| of(code(&pixel[channel * bytes..]))).collect())
    };
    let color = |channel: usize| plane(channel, &|code| light[code]);
    let opaque =
        if channels < 3 { Picture::from(color(0)?) } else { Rgb::new([color(0)?, color(1)?, color(2)?])?.into() };
    if channels.is_multiple_of(2) {
        opaque.with_alpha(plane(channels - 1, &|code| code as f64 / scale)?)
    } else {
        Ok(opaque)
    }
}
