//! The segments of a JPEG file before its data.

use crate::door::carried::{Density, Per};
use crate::door::skipped::Skipped;

const START_OF_SCAN: u8 = 0xda;
const END_OF_IMAGE: u8 = 0xd9;

/// The segments up to the first scan, and where its data begin: a walk over markers and lengths.
pub(super) struct Segments<'a> {
    file: &'a [u8],
    /// The second byte of each marker, and what stands in the segment.
    all: Vec<(u8, &'a [u8])>,
    data: Option<usize>,
}

impl<'a> Segments<'a> {
    pub(super) fn of(file: &'a [u8]) -> Self {
        let (mut all, mut at) = (Vec::new(), 2);
        let data = loop {
            let (Some(0xff), Some(&kind)) = (file.get(at), file.get(at + 1)) else { break None };
            if kind == 0xff {
                at += 1; // a marker may be preceded by any number of these
                continue;
            }
            // a length of two bytes, which counts itself
            let Some(&[high, low]) = file.get(at + 2..at + 4) else { break None };
            let length = usize::from(high) << 8 | usize::from(low);
            let Some(content) = file.get(at + 4..at + 2 + length) else { break None };
            all.push((kind, content));
            at += 2 + length;
            if kind == START_OF_SCAN {
                break Some(at);
            }
        };
        Self { file, all, data }
    }

    /// How many bits a sample has, as the frame's header says: SOF0 to SOF15, without DHT, JPG and DAC among them.
    pub(super) fn precision(&self) -> Option<u8> {
        let frame = |kind: u8| matches!(kind, 0xc0..=0xcf) && !matches!(kind, 0xc4 | 0xc8 | 0xcc);
        let header = self.all.iter().find(|(kind, _)| frame(*kind));
        header.and_then(|(_, content)| content.first().copied())
    }

    /// What an application's segment of that name says: marker `0xe0 + application`, then the name.
    fn named(&self, application: u8, name: &[u8]) -> Option<&'a [u8]> {
        let found = self.all.iter().find(|(kind, content)| *kind == 0xe0 + application && content.starts_with(name));
        found.and_then(|(_, content)| content.get(name.len()..))
    }

    /// The EXIF data, from the TIFF header on.
    pub(super) fn exif(&self) -> Option<&'a [u8]> {
        self.named(1, b"Exif\0\0")
    }

    /// The density of the JFIF header; nothing where that says 1 × 1 without a unit, as most cameras do.
    pub(super) fn density(&self) -> Option<Density> {
        let header = self.named(0, b"JFIF\0")?;
        let &[_, _, unit, x1, x0, y1, y0, ..] = header else { return None };
        let [x, y] = [[x1, x0], [y1, y0]].map(u16::from_be_bytes);
        let per = match unit {
            1 => Per::Inch,
            2 => Per::Centimetre,
            _ => Per::Shape,
        };
        let known = x > 0 && y > 0 && (per != Per::Shape || x != y);
        known.then(|| Density { x: f64::from(x), y: f64::from(y), per })
    }

    /// What is neither needed for the pixels nor carried over.
    pub(super) fn skipped(&self) -> Vec<Skipped> {
        let mut all = Vec::new();
        for (kind, content) in &self.all {
            let starts = |name: &[u8]| content.starts_with(name);
            let name = match kind {
                0xe0 if starts(b"JFIF\0") => continue,
                0xe1 if starts(b"Exif\0\0") => "EXIF".to_owned(),
                0xe1 if starts(b"http://ns.adobe.com/x") => "XMP".to_owned(),
                0xe2 if starts(b"ICC_PROFILE\0") => continue,
                0xed if starts(b"Photoshop") => "Photoshop".to_owned(),
                0xee if starts(b"Adobe") => continue,
                0xe0..=0xef => format!("APP{}", kind - 0xe0),
                0xfe => "COM".to_owned(),
                _ => continue,
            };
            Skipped::count(&mut all, name, content.len() as u64);
        }
        all
    }

    /// Whether there are pieces of a colour profile.
    pub(super) fn profiled(&self) -> bool {
        self.named(2, b"ICC_PROFILE\0").is_some()
    }

    /// Where the marker stands that ends the picture, if its data are one piece without restarts.
    pub(super) fn end_of_single_scan(&self) -> Option<usize> {
        let at = self.data?;
        let data = self.file.get(at..)?;
        // within the data 0xff is always followed by zero
        let next = data.windows(2).position(|pair| pair[0] == 0xff && pair[1] != 0)?;
        (data[next + 1] == END_OF_IMAGE).then_some(at + next)
    }
}
