//! What the commands that read sound share.

use crate::cli::Failure;
use crate::cli::source::Source;
use indicatif::{ProgressBar, ProgressStyle};
use nyquist::door::wav::WavReader;
use nyquist::error::Error;
use std::io::{self, IsTerminal, Read, Write};

/// A number, or a quotient of two.
pub(super) fn quotient(text: &str) -> Result<f64, String> {
    let number = |part: &str| part.trim().parse::<f64>().map_err(|_| format!("\"{part}\" is no number"));
    match text.split_once('/') {
        Some((above, below)) => Ok(number(above)? / number(below)?),
        None => number(text),
    }
}

/// Reads the head of a WAV file.
pub(super) fn open(source: Source) -> Result<WavReader<Box<dyn Read>>, Failure> {
    Ok(WavReader::new(&source.name, source.bytes)?)
}

/// Block after block, to the end, with progress on a terminal.
pub(super) fn pump<R: Read>(
    reader: &mut WavReader<R>,
    mut take: impl FnMut(&[f64]) -> Result<(), Error>,
) -> Result<(), Error> {
    let progress = progress(reader.frames());
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

/// A word on standard error; if that is closed there is nobody to tell.
pub(super) fn note(words: &str) {
    let _ = writeln!(io::stderr(), "note: {words}");
}

fn progress(frames: Option<u64>) -> ProgressBar {
    if !io::stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    let (bar, template) = match frames {
        Some(frames) => (ProgressBar::new(frames), "{wide_bar} {percent} % {eta}"),
        None => (ProgressBar::no_length(), "{spinner} {human_pos} frames"),
    };
    match ProgressStyle::with_template(template) {
        Ok(style) => bar.with_style(style),
        Err(_) => bar,
    }
}
