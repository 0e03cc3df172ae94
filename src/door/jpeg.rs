//! JPEG, in: the only place that knows the decoder.

use crate::door::files::{Limits, Transfer, checked_grid, picture, refused};
use crate::door::orientation::{orientation, turned};
use crate::door::picture::Picture;
use crate::error::Result;
use jpeg_decoder::{Decoder, PixelFormat};

pub(super) fn read(name: &str, bytes: &[u8], limits: Limits) -> Result<Picture> {
    let damaged = |error: jpeg_decoder::Error| refused(name, error.to_string());
    let mut decoder = Decoder::new(bytes);
    decoder.read_info().map_err(damaged)?;
    let info = decoder.info().ok_or_else(|| refused(name, "there is no header"))?;
    let grid = checked_grid(name, u64::from(info.width), u64::from(info.height), limits)?;
    let (channels, wide) = match info.pixel_format {
        PixelFormat::L8 => (1, false),
        PixelFormat::L16 => (1, true),
        PixelFormat::RGB24 => (3, false),
        PixelFormat::CMYK32 => {
            return Err(refused(
                name,
                "CMYK, whose colours are known only with a printer's profile: convert it to RGB",
            ));
        }
    };
    let size = grid.len() * info.pixel_format.pixel_bytes();
    decoder.set_max_decoding_buffer_size(size);
    let mut samples = decoder.decode().map_err(damaged)?;
    if samples.len() != size || runs_out(bytes, &samples) {
        return Err(refused(name, "the data do not have the size that the header says"));
    }
    if wide {
        // the decoder keeps 16 bits in the machine's order
        samples.chunks_exact_mut(2).for_each(|pair| {
            let code = u16::from_ne_bytes([pair[0], pair[1]]).to_be_bytes();
            pair.copy_from_slice(&code);
        });
    }
    let upright = decoder.exif_data().map_or(1, orientation);
    turned(&picture(grid, &samples, channels, wide, Transfer::Srgb)?, upright)
}

/// Whether the picture goes on where the data have ended.
///
/// A decoder that meets the end of a scan too early goes on with zeros, and says nothing: a header that claims twice the
/// height gets a lower half that nobody photographed. So the file is decoded once more with other bits in place of these
/// zeros; a picture that depends on them is made of them. Only for files with a single scan, as cameras write them: the
/// others have markers within, which a decoder must meet in their places.
fn runs_out(bytes: &[u8], samples: &[u8]) -> bool {
    let Some(end) = end_of_single_scan(bytes) else { return false };
    let other = [&bytes[..end], &[0x5a; 256], &bytes[end..]].concat();
    Decoder::new(&other[..]).decode().map_or(true, |again| again != samples)
}

/// Where the marker stands that ends the picture, if its data are one piece without restarts.
fn end_of_single_scan(bytes: &[u8]) -> Option<usize> {
    const START_OF_SCAN: u8 = 0xda;
    const END_OF_IMAGE: u8 = 0xd9;
    let mut at = 2;
    // segments: a marker, and a length of two bytes that counts itself
    loop {
        let (mark, kind) = (*bytes.get(at)?, *bytes.get(at + 1)?);
        if mark != 0xff {
            return None;
        }
        if kind == 0xff {
            at += 1; // a marker may be preceded by any number of these
            continue;
        }
        let length = usize::from(*bytes.get(at + 2)?) << 8 | usize::from(*bytes.get(at + 3)?);
        at += 2 + length;
        if kind == START_OF_SCAN {
            break;
        }
    }
    let data = bytes.get(at..)?;
    // within the data 0xff is always followed by zero
    let next = data.windows(2).position(|pair| pair[0] == 0xff && pair[1] != 0)?;
    (data[next + 1] == END_OF_IMAGE).then_some(at + next)
}
