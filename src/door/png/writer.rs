//! PNG out.

use crate::door::carried::{Carried, Density, Depth, Per, Space};
use crate::door::files::{Interleaved, interleaved, refused};
use crate::door::picture::Picture;
use crate::error::{Error, Result};
use png::chunk::ChunkType;
use png::{
    BitDepth, ColorType, Encoder, EncodingError, Info, PixelDimensions, ScaledFloat, SourceChromaticities,
    SrgbRenderingIntent, Unit,
};

pub(in crate::door) fn write(picture: &Picture, carried: &Carried) -> Result<Vec<u8>> {
    let grid = picture.grid();
    let size = |n: usize, what: &'static str| match u32::try_from(n) {
        Ok(n) if n < 1 << 31 => Ok(n),
        _ => Err(Error::Overflow { what, value: n as f64, most: f64::from(i32::MAX) }),
    };
    let (width, height) =
        (size(grid.width(), "the width of a PNG file")?, size(grid.height(), "the height of a PNG file")?);
    let Interleaved { bytes: samples, channels, .. } = interleaved(picture, carried)?;
    let mut info = Info::with_size(width, height);
    info.color_type = match channels {
        1 => ColorType::Grayscale,
        2 => ColorType::GrayscaleAlpha,
        3 => ColorType::Rgb,
        _ => ColorType::Rgba,
    };
    info.bit_depth = if carried.depth == Depth::Eight { BitDepth::Eight } else { BitDepth::Sixteen };
    info.pixel_dims = carried.density.map(dimensions);
    let mut points = None;
    match &carried.space {
        Space::Unmarked => {}
        Space::Srgb(intent) => info.srgb = Some(intent_of(*intent)),
        Space::Measured { gamma, chromaticities } => {
            info.source_gamma = gamma.map(ScaledFloat::from_scaled);
            info.source_chromaticities = chromaticities.map(|c| {
                let at = |i: usize| (ScaledFloat::from_scaled(c[i]), ScaledFloat::from_scaled(c[i + 1]));
                SourceChromaticities { white: at(0), red: at(2), green: at(4), blue: at(6) }
            });
        }
        Space::Profile(profile) => info.icc_profile = Some(profile.into()),
        Space::CodePoints(four) => points = Some(four),
    }
    let failed = |error: EncodingError| refused("a PNG file in memory", error.to_string());
    let mut bytes = Vec::new();
    let mut writer = Encoder::with_info(&mut bytes, info).and_then(Encoder::write_header).map_err(failed)?;
    if let Some(four) = points {
        writer.write_chunk(ChunkType(*b"cICP"), four).map_err(failed)?;
    }
    writer.write_image_data(&samples).map_err(failed)?;
    writer.finish().map_err(failed)?;
    Ok(bytes)
}

fn dimensions(density: Density) -> PixelDimensions {
    let Density { x, y, per } = density.per_metre();
    let whole = |v: f64| v.round().clamp(1.0, f64::from(i32::MAX)) as u32;
    let unit = if per == Per::Shape { Unit::Unspecified } else { Unit::Meter };
    PixelDimensions { xppu: whole(x), yppu: whole(y), unit }
}

fn intent_of(code: u8) -> SrgbRenderingIntent {
    match code {
        1 => SrgbRenderingIntent::RelativeColorimetric,
        2 => SrgbRenderingIntent::Saturation,
        3 => SrgbRenderingIntent::AbsoluteColorimetric,
        _ => SrgbRenderingIntent::Perceptual,
    }
}
