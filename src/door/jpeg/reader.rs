//! JPEG in.

use crate::door::carried::{Carried, Density, Depth, Light, Opened, Space};
use crate::door::exif::Exif;
use crate::door::files::{Limits, Samples, checked_grid, picture, refused};
use crate::door::icc;
use crate::door::jpeg::segments::Segments;
use crate::door::orientation::turned;
use crate::door::transfer::Transfer;
use crate::error::Result;
use jpeg_decoder::{Decoder, PixelFormat, UnsupportedFeature as Feature};

pub(in crate::door) fn read(name: &str, bytes: &[u8], limits: Limits, light: Light) -> Result<Opened> {
    let damaged = |error: jpeg_decoder::Error| refused(name, in_words(error));
    let mut decoder = Decoder::new(bytes);
    decoder.read_info().map_err(damaged)?;
    let info = decoder.info().ok_or_else(|| refused(name, "there is no header"))?;
    let grid = checked_grid(name, u64::from(info.width), u64::from(info.height), limits)?;
    let segments = Segments::of(bytes);
    let (channels, depth) = match (info.pixel_format, segments.precision()) {
        (PixelFormat::L8, _) => (1, Depth::Eight),
        (PixelFormat::L16, Some(bits @ 9..=15)) => {
            // the decoder leaves them as they are, so that white would not be the highest code
            return Err(damaged(jpeg_decoder::Error::Unsupported(Feature::SamplePrecision(bits))));
        }
        (PixelFormat::L16, _) => (1, Depth::Sixteen),
        (PixelFormat::RGB24, _) => (3, Depth::Eight),
        (PixelFormat::CMYK32, _) => {
            return Err(refused(
                name,
                "CMYK, whose colours are known only with a printer's profile: convert it to RGB",
            ));
        }
    };
    let size = grid.len() * info.pixel_format.pixel_bytes();
    decoder.set_max_decoding_buffer_size(size);
    let mut samples = decoder.decode().map_err(damaged)?;
    if samples.len() != size || runs_out(bytes, &segments, &samples) {
        return Err(refused(name, "the data do not have the size that the header says"));
    }
    if depth == Depth::Sixteen {
        // the decoder keeps 16 bits in the machine's order
        samples.chunks_exact_mut(2).for_each(|pair| {
            let code = u16::from_ne_bytes([pair[0], pair[1]]).to_be_bytes();
            pair.copy_from_slice(&code);
        });
    }
    let mut remarks = Vec::new();
    let profile = decoder.icc_profile();
    if segments.profiled() && profile.is_none() {
        remarks.push("the colour profile is damaged and is not carried over".into());
    }
    let transfer = profile.as_deref().map_or(Transfer::Srgb, |profile| icc::transfer_or_srgb(profile, &mut remarks));
    let exif = segments.exif().map(Exif::new);
    let upright = exif.as_ref().map_or(1, Exif::orientation);
    let mut density = segments.density().or_else(|| exif.as_ref().and_then(Exif::density));
    if upright != 1 {
        remarks.push(format!("turned upright, as the camera says (EXIF orientation {upright})"));
    }
    if upright >= 5 {
        density = density.map(|Density { x, y, per }| Density { x: y, y: x, per });
    }
    let space = profile.map_or(Space::Unmarked, Space::Profile);
    let carried = Carried { depth, space, transfer, light, density };
    let stored = picture(grid, &Samples { bytes: &samples, channels, depth }, carried.curve())?;
    Ok(Opened { picture: turned(stored, upright)?, carried, skipped: segments.skipped(), remarks })
}

/// What the decoder met.
fn in_words(error: jpeg_decoder::Error) -> String {
    match error {
        jpeg_decoder::Error::Io(error) if error.kind() == std::io::ErrorKind::UnexpectedEof => {
            "the JPEG ends in the middle".into()
        }
        jpeg_decoder::Error::Format(what) => format!("the JPEG is damaged: {what}"),
        jpeg_decoder::Error::Unsupported(feature) => {
            let kind = match feature {
                Feature::Hierarchical => "hierarchical".into(),
                Feature::ArithmeticEntropyCoding => "with arithmetic coding".into(),
                Feature::SamplePrecision(bits) => format!("of {bits} bits a channel"),
                Feature::ComponentCount(channels) => format!("of {channels} channels"),
                Feature::DNL => "with its height behind the data".into(),
                Feature::SubsamplingRatio | Feature::NonIntegerSubsamplingRatio => {
                    "with such a subsampling of colours".into()
                }
                Feature::ColorTransform(_) => "with such a transform of colours".into(),
            };
            format!("a JPEG {kind} is not read")
        }
        other => other.to_string(),
    }
}

/// Whether the picture goes on where the data have ended.
///
/// A decoder that meets the end of a scan too early goes on with zeros, and says nothing: a header that claims twice the
/// height gets a lower half that nobody photographed. So the file is decoded once more with other bits in place of these
/// zeros; a picture that depends on them is made of them. Only for files with a single scan, as cameras write them: the
/// others have markers within, which a decoder must meet in their places.
fn runs_out(bytes: &[u8], segments: &Segments<'_>, samples: &[u8]) -> bool {
    let Some(end) = segments.end_of_single_scan() else { return false };
    let other = [&bytes[..end], &[0x5a; 256], &bytes[end..]].concat();
    Decoder::new(&other[..]).decode().map_or(true, |again| again != samples)
}
