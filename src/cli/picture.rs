//! What the commands that read pictures share.

use crate::cli::Failure;
use crate::cli::number::number;
use crate::cli::source::Source;
use crate::cli::working::note;
use nyquist::door::carried::{Light, Opened};
use nyquist::door::{Limits, read_file};
use nyquist::error::{Error, unknown};
use nyquist::image::Image;
use nyquist::kernel::{Kernel, catalog};
use std::io::Read;
use std::path::Path;

/// How large a picture may be.
#[derive(Debug, Clone, Copy, clap::Args)]
pub(super) struct Most {
    /// The most pixels of a picture, read or written, in millions; they take 24 MB each in colour
    #[arg(long, value_name = "MILLIONS", default_value_t = 67.2, value_parser = millions)]
    max_pixels: f64,
}

impl Most {
    pub(super) fn limits(self) -> Limits {
        Limits { pixels: (self.max_pixels * 1e6) as u64 }
    }
}

fn millions(text: &str) -> Result<f64, String> {
    let millions = number(text)?;
    if millions > 0.0 { Ok(millions) } else { Err(format!("there must be room for a pixel, got {millions}")) }
}

/// The names of filters for another size: none, and the kernels that do not reach for ever.
pub(super) fn filters() -> impl Iterator<Item = &'static str> {
    let finite = |name: &&str| catalog::by_name(name).is_ok_and(|kernel| kernel.radius().is_finite());
    std::iter::once("none").chain(catalog::names().filter(finite))
}

/// The kernel of a filter; nothing for none.
pub(super) fn filter(name: &str) -> Result<Option<Box<dyn Kernel>>, Failure> {
    if name == "none" {
        return Ok(None);
    }
    let kernel = catalog::by_name(name).map_err(|error| match error {
        Error::Unknown { .. } => unknown("filter", name, filters().chain(catalog::FAMILIES.iter().copied())),
        other => other,
    })?;
    if kernel.radius().is_infinite() {
        let words = "the filter ideal needs every pixel for each: lanczos-4 or kaiser:8,8 come near it";
        return Err(Failure::Trouble(words.into()));
    }
    Ok(Some(kernel))
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
