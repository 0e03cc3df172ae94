//! The chunks of a PNG file, by name.

use crate::door::skipped::Skipped;

/// What is used or carried over, and what pixels are made of.
const TAKEN: [&[u8; 4]; 12] =
    [b"IHDR", b"PLTE", b"IDAT", b"IEND", b"tRNS", b"iCCP", b"sRGB", b"gAMA", b"cHRM", b"cICP", b"pHYs", b"acTL"];

/// Chunks that are not taken, and whether a chunk of some name is there: a walk over lengths and names, which the decoder
/// has found sound.
pub(super) struct Chunks {
    names: Vec<[u8; 4]>,
    pub(super) skipped: Vec<Skipped>,
}

impl Chunks {
    /// Of a file, its signature included.
    pub(super) fn of(file: &[u8]) -> Self {
        let (mut names, mut skipped) = (Vec::new(), Vec::new());
        let mut rest = file.get(8..).unwrap_or_default();
        while let Some((head, after)) = rest.split_first_chunk::<8>() {
            let [l0, l1, l2, l3, name @ ..] = *head;
            let length = u32::from_be_bytes([l0, l1, l2, l3]);
            // frames of an animation are told of in words
            let frame = matches!(&name, b"fcTL" | b"fdAT");
            if !TAKEN.contains(&&name) && !frame {
                Skipped::count(&mut skipped, String::from_utf8_lossy(&name).into_owned(), u64::from(length));
            }
            if !names.contains(&name) && names.len() < 64 {
                names.push(name);
            }
            let whole = usize::try_from(length).unwrap_or(usize::MAX).saturating_add(4);
            rest = after.get(whole..).unwrap_or_default();
        }
        Self { names, skipped }
    }

    pub(super) fn has(&self, name: &[u8; 4]) -> bool {
        self.names.contains(name)
    }
}
