//! What is read: a file, or standard input.

use crate::cli::Failure;
use nyquist::door::kind::Kind;
use std::fs::File;
use std::io::{self, BufReader, Read};
use std::path::Path;

/// An input, opened.
pub(super) struct Source {
    /// What errors call it.
    pub(super) name: String,
    /// Its bytes, from the first on.
    pub(super) bytes: Box<dyn Read>,
}

impl Source {
    /// The file of that name; `-` is standard input.
    pub(super) fn open(path: &Path) -> Result<Self, Failure> {
        if path == Path::new("-") {
            return Ok(Self { name: "standard input".into(), bytes: Box::new(io::stdin().lock()) });
        }
        let name = path.display().to_string();
        let failed = |error: io::Error| Failure::trouble(&name, error);
        let file = File::open(path).map_err(failed)?;
        if file.metadata().map_err(failed)?.is_dir() {
            return Err(Failure::trouble(name, "is a folder"));
        }
        Ok(Self { name, bytes: Box::new(BufReader::new(file)) })
    }

    /// The same, and what kind of file it is by its first bytes.
    pub(super) fn open_any(path: &Path) -> Result<(Self, Kind), Failure> {
        let Self { name, mut bytes } = Self::open(path)?;
        let mut head = Vec::new();
        let read = bytes.by_ref().take(Kind::HEAD as u64).read_to_end(&mut head);
        read.map_err(|error| Failure::trouble(&name, error))?;
        let kind = Kind::of(&name, &head)?;
        Ok((Self { name, bytes: Box::new(io::Cursor::new(head).chain(bytes)) }, kind))
    }
}
