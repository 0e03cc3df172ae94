//! PNG, in and out: the only place that knows the decoder.

use crate::door::files::{Depth, Limits, Transfer, checked_grid, picture, refused};
use crate::door::picture::{Color, Picture};
use crate::door::srgb::linear_to_srgb;
use crate::error::{Error, Result};
use crate::image::Image;
use png::{BitDepth, ColorType, Decoder, Encoder, SrgbRenderingIntent, Transformations};
use std::io::Cursor;

/// The gamma of sRGB as `gAMA` has it, in units of 10⁻⁵.
const SRGB_GAMMA: u32 = 45_455;

pub(super) fn read(name: &str, bytes: &[u8], limits: Limits) -> Result<Picture> {
    let damaged = |error: png::DecodingError| refused(name, error.to_string());
    // room for one picture of 16-bit colour with alpha, and for a profile
    let room = limits.pixels.saturating_mul(8).saturating_add(1 << 24);
    let limit = png::Limits { bytes: usize::try_from(room).unwrap_or(usize::MAX) };
    let mut decoder = Decoder::new_with_limits(Cursor::new(bytes), limit);
    decoder.set_ignore_text_chunk(true);
    // palettes and 1, 2, 4 bits become bytes, a transparent colour becomes alpha
    decoder.set_transformations(Transformations::EXPAND);
    let header = decoder.read_header_info().map_err(damaged)?;
    let grid = checked_grid(name, u64::from(header.width), u64::from(header.height), limits)?;
    let mut reader = decoder.read_info().map_err(damaged)?;
    let transfer = match reader.info() {
        info if info.srgb.is_some() || info.icc_profile.is_some() => Transfer::Srgb,
        info => match info.gama_chunk.map(png::ScaledFloat::into_scaled) {
            // a gamma of sRGB's own size means sRGB, whose curve is no plain power
            Some(gamma) if gamma > 0 && gamma.abs_diff(SRGB_GAMMA) > 100 => {
                Transfer::Power(100_000.0 / f64::from(gamma))
            }
            _ => Transfer::Srgb,
        },
    };
    let size = reader.output_buffer_size().ok_or_else(|| refused(name, "its pixels do not fit into memory"))?;
    let mut samples = vec![0; size];
    let frame = reader.next_frame(&mut samples).map_err(damaged)?;
    reader.finish().map_err(damaged)?;
    samples.truncate(frame.buffer_size());
    let channels = match frame.color_type {
        ColorType::Grayscale => 1,
        ColorType::GrayscaleAlpha => 2,
        ColorType::Rgb => 3,
        ColorType::Rgba => 4,
        ColorType::Indexed => return Err(refused(name, "a palette that was not expanded")),
    };
    let wide = frame.bit_depth == BitDepth::Sixteen;
    if samples.len() != grid.len() * channels * if wide { 2 } else { 1 } {
        return Err(refused(name, "the data do not have the size that the header says"));
    }
    picture(grid, &samples, channels, wide, transfer)
}

pub(super) fn write(picture: &Picture, depth: Depth) -> Result<Vec<u8>> {
    let grid = picture.grid();
    let size = |n: usize, what: &'static str| match u32::try_from(n) {
        Ok(n) if n < 1 << 31 => Ok(n),
        _ => Err(Error::Overflow { what, value: n as f64, most: f64::from(i32::MAX) }),
    };
    let (width, height) =
        (size(grid.width(), "the width of a PNG file")?, size(grid.height(), "the height of a PNG file")?);
    let colors: Vec<&Image> = match picture.color() {
        Color::Grey(grey) => vec![grey],
        Color::Rgb(rgb) => rgb.planes().iter().collect(),
    };
    let kind = match (colors.len(), picture.alpha().is_some()) {
        (1, false) => ColorType::Grayscale,
        (1, true) => ColorType::GrayscaleAlpha,
        (_, false) => ColorType::Rgb,
        (_, true) => ColorType::Rgba,
    };
    let most = match depth {
        Depth::Eight => 255.0,
        Depth::Sixteen => 65_535.0,
    };
    let mut planes = Vec::new();
    for plane in colors {
        planes.push(codes(plane, |v| linear_to_srgb(v) * most, most)?);
    }
    if let Some(alpha) = picture.alpha() {
        planes.push(codes(alpha, |v| v * most, most)?);
    }
    let interleaved = (0..grid.len()).flat_map(|i| planes.iter().map(move |plane| plane[i]));
    let samples: Vec<u8> = match depth {
        Depth::Eight => interleaved.map(|code| code as u8).collect(),
        Depth::Sixteen => interleaved.flat_map(u16::to_be_bytes).collect(),
    };
    let mut bytes = Vec::new();
    let mut encoder = Encoder::new(&mut bytes, width, height);
    encoder.set_color(kind);
    encoder.set_depth(if depth == Depth::Eight { BitDepth::Eight } else { BitDepth::Sixteen });
    encoder.set_source_srgb(SrgbRenderingIntent::Perceptual);
    let failed = |error: png::EncodingError| refused("a PNG file in memory", error.to_string());
    let mut writer = encoder.write_header().map_err(failed)?;
    writer.write_image_data(&samples).map_err(failed)?;
    writer.finish().map_err(failed)?;
    Ok(bytes)
}

/// The nearest codes of `scaled` values between 0 and `most`.
fn codes(plane: &Image, scaled: impl Fn(f64) -> f64, most: f64) -> Result<Vec<u16>> {
    if let Some(index) = plane.values().iter().position(|v| v.is_nan()) {
        return Err(Error::NotFiniteAt { what: "the pixels of a picture, row by row,", index, value: f64::NAN });
    }
    Ok(plane.values().iter().map(|&v| scaled(v).round().clamp(0.0, most) as u16).collect())
}
