//! What the commands that read sound share.

use crate::cli::Failure;
use crate::cli::source::Source;
use crate::cli::working::{note, progress};
use nyquist::door::wav::WavReader;
use nyquist::error::Error;
use nyquist::rate::Ratio;
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

/// Whether a file of the rate `own` can be brought to `rate`: how far away a rate may be is said in Hz, and of which option.
pub(super) fn reachable(own: f64, rate: f64) -> Result<(), Failure> {
    match Ratio::new(own, rate) {
        Err(Error::OutOfRange { low, high, .. }) => {
            let got = if (1e-3..1e12).contains(&rate) { format!("{rate}") } else { format!("{rate:e}") };
            Err(Failure::Trouble(format!(
                "--rate must lie between {} and {} Hz, between {low} and {high} times the rate of the file, got {got}",
                own * low,
                own * high
            )))
        }
        Err(error) => Err(error.into()),
        Ok(_) => Ok(()),
    }
}

/// Says what is odd about a file that has been read to its end, and harmless.
pub(super) fn note_oddities<R: Read>(reader: &WavReader<R>) {
    if reader.frames().is_none() && reader.position() > 0 {
        note("the header gives no length: read to the end of the file");
    }
    if reader.trailing() > 0 {
        note(&format!("{} bytes after the sound are no chunk: ignored", reader.trailing()));
    }
    if !reader.byte_rate_fits() {
        note("the header's bytes a second are not frames times rate: ignored");
    }
}
