//! PNG in.

use crate::door::carried::{Carried, Density, Depth, Light, Opened, Per, Space};
use crate::door::files::{Limits, Samples, checked_grid, picture, refused};
use crate::door::icc;
use crate::door::png::SRGB_GAMMA;
use crate::door::png::chunks::{Chunks, fault};
use crate::door::transfer::Transfer;
use crate::error::Result;
use png::{BitDepth, ColorType, Decoder, Info, SourceChromaticities, Transformations, Unit};
use std::io::Cursor;

pub(in crate::door) fn read(name: &str, bytes: &[u8], limits: Limits, light: Light) -> Result<Opened> {
    let damaged = |error: png::DecodingError| refused(name, fault(bytes).unwrap_or_else(|| in_words(&error)));
    // room for one picture of 16-bit colour with alpha, and for a profile
    let room = limits.pixels.saturating_mul(8).saturating_add(1 << 24);
    let limit = png::Limits { bytes: usize::try_from(room).unwrap_or(usize::MAX) };
    let mut decoder = Decoder::new_with_limits(Cursor::new(bytes), limit);
    decoder.set_ignore_text_chunk(true);
    let header = decoder.read_header_info().map_err(damaged)?;
    let grid = checked_grid(name, u64::from(header.width), u64::from(header.height), limits)?;
    let indexed = header.color_type == ColorType::Indexed;
    // 1, 2, 4 bits become bytes, a transparent colour becomes alpha; palettes are looked up here, where a bad index is seen
    decoder.set_transformations(if indexed { Transformations::IDENTITY } else { Transformations::EXPAND });
    let mut reader = decoder.read_info().map_err(damaged)?;
    let size = reader.output_buffer_size().ok_or_else(|| refused(name, "its pixels do not fit into memory"))?;
    let mut samples = vec![0; size];
    let frame = reader.next_frame(&mut samples).map_err(damaged)?;
    reader.finish().map_err(damaged)?;
    samples.truncate(frame.buffer_size());
    let info = reader.info();
    let channels = match frame.color_type {
        ColorType::Grayscale => 1,
        ColorType::GrayscaleAlpha => 2,
        ColorType::Rgb => 3,
        ColorType::Rgba => 4,
        ColorType::Indexed => {
            samples = looked_up(name, info, &samples)?;
            if info.trns.is_some() { 4 } else { 3 }
        }
    };
    let depth = if frame.bit_depth == BitDepth::Sixteen { Depth::Sixteen } else { Depth::Eight };
    let sample = usize::from(depth.bits() / 8);
    if samples.len() != grid.len() * channels * sample {
        return Err(refused(name, "the data do not have the size that the header says"));
    }
    let chunks = Chunks::of(bytes);
    let mut remarks = Vec::new();
    if let Some(animation) = info.animation_control() {
        let frames = animation.num_frames;
        remarks.push(format!("an animation of {frames} frames: only its still picture is read"));
    }
    match chunks.beyond {
        0 => {}
        1 => remarks.push("1 byte after the end of the PNG ignored".into()),
        n => remarks.push(format!("{n} bytes after the end of the PNG ignored")),
    }
    if chunks.has(b"iCCP") && info.icc_profile.is_none() {
        remarks.push("the colour profile is damaged and is not carried over".into());
    }
    let space = space(info);
    let transfer = transfer(&space, &mut remarks);
    let density = info.pixel_dims.map(|d| {
        let per = if d.unit == Unit::Meter { Per::Metre } else { Per::Shape };
        Density { x: f64::from(d.xppu), y: f64::from(d.yppu), per }
    });
    let carried = Carried { depth, space, transfer, light, density };
    let picture = picture(grid, &Samples { bytes: &samples, channels, depth }, carried.curve())?;
    Ok(Opened { picture, carried, skipped: chunks.skipped, remarks })
}

/// What the decoder met in a file whose chunks are whole.
fn in_words(error: &png::DecodingError) -> String {
    match error {
        png::DecodingError::LimitsExceeded => return "it needs more memory than a picture of the allowed size".into(),
        png::DecodingError::IoError(_) => return "the PNG ends in the middle".into(),
        _ => {}
    }
    // the decoder tells these apart in words alone
    let said = error.to_string();
    if said.starts_with("Corrupt deflate stream") {
        return "the pixels are damaged (they cannot be decompressed)".into();
    }
    if said.starts_with("IDAT or fDAT chunk does not have enough data") {
        return "there are fewer pixels than the header says".into();
    }
    format!("the PNG is damaged: {}", named(&said))
}

/// The sentence with names of chunks where the decoder prints what it knows of them: `ChunkType { type: IDAT, … }`.
fn named(said: &str) -> String {
    let (mut words, mut rest) = (String::new(), said);
    while let Some((before, after)) = rest.split_once("ChunkType {") {
        let (fields, behind) = after.split_once('}').unwrap_or((after, ""));
        let name = fields.split_once("type: ").map_or(fields, |(_, name)| name);
        words += before;
        words += name.split(',').next().unwrap_or(name).trim();
        rest = behind;
    }
    (words + rest).trim_end_matches('.').to_owned()
}

/// What the codes are the colours of: of several answers the one that counts (PNG, third edition, §4.3).
fn space(info: &Info<'_>) -> Space {
    if let Some(points) = info.coding_independent_code_points {
        let range = u8::from(points.is_video_full_range_image);
        return Space::CodePoints([
            points.color_primaries,
            points.transfer_function,
            points.matrix_coefficients,
            range,
        ]);
    }
    if let Some(profile) = &info.icc_profile {
        return Space::Profile(profile.to_vec());
    }
    if let Some(intent) = info.srgb {
        return Space::Srgb(intent as u8);
    }
    let gamma = info.gama_chunk.map(png::ScaledFloat::into_scaled).filter(|gamma| *gamma > 0);
    let chromaticities = info.chrm_chunk.map(|SourceChromaticities { white, red, green, blue }| {
        [white.0, white.1, red.0, red.1, green.0, green.1, blue.0, blue.1].map(png::ScaledFloat::into_scaled)
    });
    match (gamma, chromaticities) {
        (None, None) => Space::Unmarked,
        _ => Space::Measured { gamma, chromaticities },
    }
}

fn transfer(space: &Space, remarks: &mut Vec<String>) -> Transfer {
    match space {
        Space::Unmarked | Space::Srgb(_) => Transfer::Srgb,
        // a gamma of sRGB's own size means sRGB, whose curve is no plain power
        Space::Measured { gamma: Some(gamma), .. } if gamma.abs_diff(SRGB_GAMMA) > 100 => {
            Transfer::Power(100_000.0 / f64::from(*gamma))
        }
        Space::Measured { .. } => Transfer::Srgb,
        Space::Profile(profile) => icc::transfer_or_srgb(profile, remarks),
        Space::CodePoints([_, 8, ..]) => Transfer::Power(1.0),
        Space::CodePoints([_, 4, ..]) => Transfer::Power(2.2),
        Space::CodePoints([_, 5, ..]) => Transfer::Power(2.8),
        Space::CodePoints([_, 13, ..]) => Transfer::Srgb,
        Space::CodePoints([_, other, ..]) => {
            remarks
                .push(format!("transfer characteristics {other} (cICP) are not known: the curve of sRGB is assumed"));
            Transfer::Srgb
        }
    }
}

/// The colours of packed indices, interleaved, with alpha if the palette has any.
fn looked_up(name: &str, info: &Info<'_>, packed: &[u8]) -> Result<Vec<u8>> {
    let palette = info.palette.as_deref().ok_or_else(|| refused(name, "there is no palette"))?;
    let (width, bits) = (info.width as usize, usize::from(info.bit_depth as u8));
    let mut samples = Vec::with_capacity(width * info.height as usize * 4);
    for (y, row) in packed.chunks_exact((width * bits).div_ceil(8)).enumerate() {
        for x in 0..width {
            let (byte, shift) = (row[x * bits / 8], 8 - bits - x * bits % 8);
            let index = usize::from(byte >> shift) & ((1 << bits) - 1);
            let Some(color) = palette.get(3 * index..3 * index + 3) else {
                let entries = palette.len() / 3;
                return Err(refused(name, format!("pixel {x}, {y} has colour {index} of a palette of {entries}")));
            };
            samples.extend_from_slice(color);
            if let Some(opacity) = &info.trns {
                samples.push(opacity.get(index).copied().unwrap_or(255));
            }
        }
    }
    Ok(samples)
}
