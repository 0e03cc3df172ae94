//! Which way up a camera was held.

use crate::door::picture::Picture;
use crate::error::Result;
use crate::grid::Grid;
use crate::image::Image;

/// The orientation tag (0x0112) of EXIF data, from 1 to 8; 1, upright, where there is none or the data are damaged.
///
/// EXIF is a TIFF header, `II*\0` or `MM\0*`, then the place of a directory of twelve-byte entries (EXIF 2.3, §4.6).
pub(super) fn orientation(exif: &[u8]) -> u16 {
    let little = exif.starts_with(b"II");
    let short = |at: usize| -> Option<u16> {
        let pair = exif.get(at..at.checked_add(2)?)?.try_into().ok()?;
        Some(if little { u16::from_le_bytes(pair) } else { u16::from_be_bytes(pair) })
    };
    let long = |at: usize| -> Option<usize> {
        let four = exif.get(at..at.checked_add(4)?)?.try_into().ok()?;
        usize::try_from(if little { u32::from_le_bytes(four) } else { u32::from_be_bytes(four) }).ok()
    };
    let tag = || {
        let directory = long(4)?;
        let entries = usize::from(short(directory)?);
        let entry = (0..entries).map(|i| directory + 2 + 12 * i).find(|&at| short(at) == Some(0x0112))?;
        short(entry + 8)
    };
    tag().filter(|value| (1..=8).contains(value)).unwrap_or(1)
}

/// The picture turned and mirrored so that it stands upright.
pub(super) fn turned(picture: &Picture, orientation: u16) -> Result<Picture> {
    if orientation == 1 {
        return Ok(picture.clone());
    }
    picture.each(|image| {
        let (w, h) = (image.width(), image.height());
        let lies = orientation >= 5;
        let grid = if lies { Grid::pixels(h, w)? } else { image.grid() };
        // where the upright pixel (x, y) is in the file: TIFF 6.0, "Orientation"
        let source = |x: usize, y: usize| match orientation {
            2 => (w - 1 - x, y),
            3 => (w - 1 - x, h - 1 - y),
            4 => (x, h - 1 - y),
            5 => (y, x),
            6 => (y, h - 1 - x),
            7 => (w - 1 - y, h - 1 - x),
            8 => (w - 1 - y, x),
            _ => (x, y),
        };
        let places = (0..grid.height()).flat_map(|y| (0..grid.width()).map(move |x| (x, y)));
        let values = places.map(|(x, y)| {
            let (i, j) = source(x, y);
            image.at(i, j)
        });
        Image::new(grid, values.collect())
    })
}
