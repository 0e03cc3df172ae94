//! Bytes to pictures and back.

use crate::door::carried::{Carried, Depth, Light, Opened};
use crate::door::picture::{Color, Picture};
use crate::door::transfer::Transfer;
use crate::door::{jpeg, png};
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

/// A kind of file that pictures are written to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// PNG: everything.
    Png,
    /// JPEG of a quality from 1 to 100: eight bits, without opacity.
    Jpeg(u8),
}

/// The picture in the bytes of a PNG or JPEG file, told apart by their first bytes; `name` is what errors call it.
///
/// Codes become linear light; a pixel is of size one, the first one around (½, ½). A JPEG is turned as its camera says
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
    Ok(read_file(name, bytes, limits, Light::Linear)?.picture)
}

/// [`read_picture`] with what the file says beside its pixels: what another file can say as well, and what is left out.
///
/// ```
/// use nyquist::door::carried::{Carried, Density, Light, Per, Space};
/// use nyquist::door::{Format, read_file, write_file};
/// use nyquist::prelude::*;
/// let grey = Picture::from(Image::of(&Flat::new(0.25)?, Grid::pixels(2, 2)?));
/// let print = Density { x: 300.0, y: 300.0, per: Per::Inch };
/// let carried = Carried { density: Some(print), space: Space::Unmarked, ..Carried::default() };
/// let bytes = write_file(&grey, &carried, Format::Jpeg(90))?;
/// let back = read_file("grey.jpg", &bytes, Limits::default(), Light::Linear)?;
/// assert_eq!(back.carried, carried);
/// # Ok::<(), Error>(())
/// ```
///
/// # Errors
/// As [`read_picture`].
pub fn read_file(name: &str, bytes: &[u8], limits: Limits, light: Light) -> Result<Opened> {
    if bytes.is_empty() {
        return Err(refused(name, "the file is empty"));
    }
    if bytes.starts_with(b"\x89PNG\r\n\x1a\n") {
        png::read(name, bytes, limits, light)
    } else if bytes.starts_with(b"\xff\xd8\xff") {
        jpeg::read(name, bytes, limits, light)
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
    png::write(picture, &Carried { depth, ..Carried::default() })
}

/// The bytes of a file with the picture and what is carried over, as far as the format has a place for it.
///
/// Values become the nearest codes, by the curve that is carried, those beyond the range its ends. A JPEG stands before
/// white and has eight bits; it has no place for a gamma. Densities become whole numbers: PNG counts pixels a metre, JPEG an
/// inch or a centimetre.
///
/// # Errors
/// Values that are not numbers; sizes that the format cannot hold (2³¹ − 1 of PNG, 65535 of JPEG).
pub fn write_file(picture: &Picture, carried: &Carried, format: Format) -> Result<Vec<u8>> {
    match format {
        Format::Png => png::write(picture, carried),
        Format::Jpeg(quality) => jpeg::write(picture, carried, quality),
    }
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

/// Interleaved samples of 1 (grey), 2 (grey and alpha), 3 (colour) or 4 (colour and alpha) channels, each of one byte or of
/// two, the high one first.
pub(super) struct Samples<'a> {
    pub(super) bytes: &'a [u8],
    pub(super) channels: usize,
    pub(super) depth: Depth,
}

/// The picture of samples.
pub(super) fn picture(grid: Grid, samples: &Samples<'_>, transfer: &Transfer) -> Result<Picture> {
    let &Samples { bytes, channels, depth } = samples;
    let wide = usize::from(depth.bits() / 8);
    let code = |at: &[u8]| if wide == 2 { usize::from(at[0]) << 8 | usize::from(at[1]) } else { usize::from(at[0]) };
    let plane = |channel: usize, light: &[f64]| {
        let pixels = bytes.chunks_exact(channels * wide);
        Image::new(grid, pixels.map(|pixel| light[code(&pixel[channel * wide..])]).collect())
    };
    let color = |channel: usize| plane(channel, &transfer.table(channel, depth.most()));
    let opaque =
        if channels < 3 { Picture::from(color(0)?) } else { Rgb::new([color(0)?, color(1)?, color(2)?])?.into() };
    if channels.is_multiple_of(2) {
        // opacity is linear as it is
        opaque.with_alpha(plane(channels - 1, &Transfer::Power(1.0).table(0, depth.most()))?)
    } else {
        Ok(opaque)
    }
}

/// A picture as samples.
pub(super) struct Interleaved {
    pub(super) bytes: Vec<u8>,
    pub(super) channels: usize,
}

/// The codes of a picture, interleaved: the way back.
pub(super) fn interleaved(picture: &Picture, carried: &Carried) -> Result<Interleaved> {
    let colors: Vec<&Image> = match picture.color() {
        Color::Grey(grey) => vec![grey],
        Color::Rgb(rgb) => rgb.planes().iter().collect(),
    };
    let most = carried.depth.most();
    let mut planes = Vec::new();
    for (channel, plane) in colors.into_iter().enumerate() {
        planes.push(carried.curve().codes(channel, most, numbers(plane)?));
    }
    if let Some(alpha) = picture.alpha() {
        planes.push(Transfer::Power(1.0).codes(0, most, numbers(alpha)?));
    }
    let codes = (0..picture.grid().len()).flat_map(|i| planes.iter().map(move |plane| plane[i]));
    let bytes = match carried.depth {
        Depth::Eight => codes.map(|code| code as u8).collect(),
        Depth::Sixteen => codes.flat_map(u16::to_be_bytes).collect(),
    };
    Ok(Interleaved { bytes, channels: planes.len() })
}

fn numbers(plane: &Image) -> Result<&[f64]> {
    match plane.values().iter().position(|v| v.is_nan()) {
        None => Ok(plane.values()),
        Some(index) => Err(Error::NotFiniteAt { what: "the pixels of a picture, row by row,", index, value: f64::NAN }),
    }
}
