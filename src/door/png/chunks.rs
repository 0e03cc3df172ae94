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
    /// How many bytes stand behind the last chunk.
    pub(super) beyond: usize,
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
            if &name == b"IEND" {
                break;
            }
        }
        Self { names, skipped, beyond: rest.len() }
    }

    pub(super) fn has(&self, name: &[u8; 4]) -> bool {
        self.names.contains(name)
    }
}

/// What is wrong with the first chunk that is not whole, in words.
pub(super) fn fault(file: &[u8]) -> Option<String> {
    let mut rest = file.get(8..).unwrap_or_default();
    loop {
        let Some((length, after)) = rest.split_first_chunk::<4>() else {
            return Some("the PNG ends in the middle".into());
        };
        let length = usize::try_from(u32::from_be_bytes(*length)).unwrap_or(usize::MAX);
        let end = length.saturating_add(4);
        let (Some(body), Some(sum)) = (after.get(..end), after.get(end..end.saturating_add(4))) else {
            return Some("the PNG ends in the middle".into());
        };
        let name = body[..4].escape_ascii();
        if checksum(body).to_be_bytes() != sum {
            return Some(format!("the chunk {name} is damaged (its checksum differs)"));
        }
        if body.starts_with(b"IEND") {
            return None;
        }
        rest = &after[end + 4..];
    }
}

/// CRC-32 as PNG has it (annex D), bit by bit: files that are damaged are few.
fn checksum(body: &[u8]) -> u32 {
    let step = |c: u32| if c & 1 == 1 { 0xedb8_8320 ^ (c >> 1) } else { c >> 1 };
    !body.iter().fold(!0, |crc, byte| (0..8).fold(crc ^ u32::from(*byte), |c, _| step(c)))
}
