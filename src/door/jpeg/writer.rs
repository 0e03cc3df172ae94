//! JPEG out.

use crate::door::carried::{Carried, Density, Depth, Per, Space};
use crate::door::files::{Interleaved, interleaved, refused};
use crate::door::picture::Picture;
use crate::door::transfer::Transfer;
use crate::error::{Error, Result};
use jpeg_encoder::{ColorType, Encoder, PixelDensity, PixelDensityUnit, SamplingFactor};

/// The bytes, at a quality from 1 to 100. Colour is not subsampled: that would be another resize, with a box.
///
/// JPEG has no opacity: the picture stands before white. It has no place for a gamma either: light is encoded as sRGB then.
pub(in crate::door) fn write(picture: &Picture, carried: &Carried, quality: u8) -> Result<Vec<u8>> {
    let size = |n: usize, what: &'static str| {
        let most = f64::from(u16::MAX);
        u16::try_from(n).map_err(|_| Error::Overflow { what, value: n as f64, most })
    };
    let grid = picture.grid();
    let (width, height) =
        (size(grid.width(), "the width of a JPEG file")?, size(grid.height(), "the height of a JPEG file")?);
    let mut carried = Carried { depth: Depth::Eight, ..carried.clone() };
    if matches!(carried.space, Space::Measured { .. } | Space::CodePoints(_)) {
        carried.transfer = Transfer::Srgb;
    }
    let Interleaved { bytes: samples, channels, .. } = interleaved(&picture.over(1.0), &carried)?;
    let failed = |error: jpeg_encoder::EncodingError| refused("a JPEG file in memory", error.to_string());
    let mut bytes = Vec::new();
    let mut encoder = Encoder::new(&mut bytes, quality.clamp(1, 100));
    encoder.set_sampling_factor(SamplingFactor::R_4_4_4);
    encoder.set_optimized_huffman_tables(true);
    if let Some(density) = carried.density.and_then(header) {
        encoder.set_density(density);
    }
    if let Space::Profile(profile) = &carried.space {
        encoder.add_icc_profile(profile).map_err(failed)?;
    }
    let color = if channels == 1 { ColorType::Luma } else { ColorType::Rgb };
    encoder.encode(&samples, width, height, color).map_err(failed)?;
    Ok(bytes)
}

/// A density as JFIF has it: whole numbers of 16 bits.
fn header(density: Density) -> Option<PixelDensity> {
    let (Density { x, y, .. }, unit) = match density.per {
        Per::Shape => (density, PixelDensityUnit::PixelAspectRatio),
        Per::Centimetre => (density, PixelDensityUnit::Centimeters),
        Per::Metre | Per::Inch => (density.per_inch(), PixelDensityUnit::Inches),
    };
    // a shape in large numbers would have to be reduced first: rather nothing
    let whole = |v: f64| (0.5..=65_535.0).contains(&v).then(|| v.round() as u16);
    Some(PixelDensity { density: (whole(x)?, whole(y)?), unit })
}
