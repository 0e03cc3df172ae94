//! What the commands that read sound share.

use crate::cli::Failure;
use crate::cli::source::Source;
use crate::cli::working::{note, progress};
use nyquist::door::wav::WavReader;
use nyquist::error::Error;
use std::io::Read;

/// Reads the head of a WAV file.
pub(super) fn open(source: Source) -> Result<WavReader<Box<dyn Read>>, Failure> {
    Ok(WavReader::new(&source.name, source.bytes)?)
}

/// Block after block, to the end, with progress on a terminal.
pub(super) fn pump<R: Read>(
    reader: &mut WavReader<R>,
    mut take: impl FnMut(&[f64]) -> Result<(), Error>,
) -> Result<(), Error> {
    let progress = progress(reader.frames(), "frames");
    let mut block = Vec::new();
    while reader.read(reader.block(), &mut block)? > 0 {
        take(&block)?;
        block.clear();
        progress.set_position(reader.position());
    }
    progress.finish_and_clear();
    Ok(())
}

/// Says what is odd about a file that has been read to its end, and harmless.
pub(super) fn note_oddities<R: Read>(reader: &WavReader<R>) {
    if reader.trailing() > 0 {
        note(&format!("{} bytes after the sound are no chunk: ignored", reader.trailing()));
    }
    if !reader.byte_rate_fits() {
        note("the header's bytes a second are not frames times rate: ignored");
    }
}
