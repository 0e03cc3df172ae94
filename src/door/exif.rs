//! What EXIF says of the whole picture: which way up, and how many pixels an inch.

use crate::door::carried::{Density, Per};

/// EXIF data: a TIFF header, `II*\0` or `MM\0*`, then the place of a directory of twelve-byte entries (EXIF 2.3, §4.6).
///
/// What is missing or damaged is as if it were not there.
pub(super) struct Exif<'a> {
    bytes: &'a [u8],
    little: bool,
}

impl<'a> Exif<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        Self { bytes, little: bytes.starts_with(b"II") }
    }

    fn short(&self, at: usize) -> Option<u16> {
        let pair = self.bytes.get(at..at.checked_add(2)?)?.try_into().ok()?;
        Some(if self.little { u16::from_le_bytes(pair) } else { u16::from_be_bytes(pair) })
    }

    fn long(&self, at: usize) -> Option<u32> {
        let four = self.bytes.get(at..at.checked_add(4)?)?.try_into().ok()?;
        Some(if self.little { u32::from_le_bytes(four) } else { u32::from_be_bytes(four) })
    }

    /// Where the value of a tag stands in the first directory.
    fn value(&self, tag: u16) -> Option<usize> {
        let directory = usize::try_from(self.long(4)?).ok()?;
        let entries = usize::from(self.short(directory)?);
        let mut places = (0..entries).map(|i| directory + 2 + 12 * i);
        places.find(|&at| self.short(at) == Some(tag)).map(|at| at + 8)
    }

    /// The quotient that a tag refers to.
    fn ratio(&self, tag: u16) -> Option<f64> {
        let at = usize::try_from(self.long(self.value(tag)?)?).ok()?;
        let (above, below) = (self.long(at)?, self.long(at.checked_add(4)?)?);
        (above > 0 && below > 0).then(|| f64::from(above) / f64::from(below))
    }

    /// The orientation tag (0x0112), from 1 to 8; 1, upright, if it is not there.
    pub(super) fn orientation(&self) -> u16 {
        let tag = self.value(0x0112).and_then(|at| self.short(at));
        tag.filter(|value| (1..=8).contains(value)).unwrap_or(1)
    }

    /// The resolution (0x011a, 0x011b) and its unit (0x0128: 2 inches, 3 centimetres).
    pub(super) fn density(&self) -> Option<Density> {
        let per = match self.value(0x0128).and_then(|at| self.short(at)) {
            Some(3) => Per::Centimetre,
            Some(1) => Per::Shape,
            _ => Per::Inch,
        };
        Some(Density { x: self.ratio(0x011a)?, y: self.ratio(0x011b)?, per })
    }
}
