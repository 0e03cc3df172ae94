//! What the commands that read pictures share.

use crate::cli::Failure;
use crate::cli::source::Source;
use crate::cli::working::note;
use nyquist::door::carried::{Light, Opened};
use nyquist::door::{Limits, read_file};
use nyquist::image::Image;
use std::io::Read;
use std::path::Path;

/// How large a picture may be.
#[derive(Debug, Clone, Copy, clap::Args)]
pub(super) struct Most {
    /// The most pixels of a picture, read or written, in millions; they take 24 MB each in colour
    #[arg(long, value_name = "MILLIONS", default_value_t = 67.2)]
    max_pixels: f64,
}

impl Most {
    pub(super) fn limits(self) -> Limits {
        // not a number and negative ones become nothing
        Limits { pixels: (self.max_pixels * 1e6) as u64 }
    }
}

/// The picture in a source, and what its file says beside it.
pub(super) fn open(source: Source, most: Most, light: Light) -> Result<Opened, Failure> {
    let Source { name, mut bytes } = source;
    let mut whole = Vec::new();
    bytes.read_to_end(&mut whole).map_err(|error| Failure::trouble(&name, error))?;
    Ok(read_file(&name, &whole, most.limits(), light)?)
}

/// One picture's light for all that looks at it: its luminance, before white where it is transparent.
pub(super) fn seen(opened: &Opened) -> Image {
    for remark in &opened.remarks {
        note(remark);
    }
    if opened.picture.alpha().is_some() {
        note("transparent pixels are seen before white");
    }
    opened.picture.over(1.0).luminance()
}

/// The name of a file without its folders.
pub(super) fn short(name: &str) -> &str {
    Path::new(name).file_name().and_then(|last| last.to_str()).unwrap_or(name)
}
