//! Files are written whole or not at all.

use crate::cli::Failure;
use std::fs;
use std::io::{self, BufWriter, Write};
use std::path::Path;

/// A file that may be written: one that does not exist, or, with `force`, one that may be replaced.
pub(super) fn vacant(path: &Path, force: bool) -> Result<(), Failure> {
    let trouble = |why: &str| Err(Failure::Trouble(format!("{} {why}", path.display())));
    match fs::metadata(path) {
        Err(_) => Ok(()),
        Ok(there) if !there.is_file() => trouble("is not a file that could be replaced"),
        Ok(_) if !force => trouble("exists already; --force replaces it"),
        Ok(_) => Ok(()),
    }
}

/// Two paths that are not the same file, whatever they are called; `-` is none.
pub(super) fn distinct(input: &Path, output: &Path) -> Result<(), Failure> {
    match (fs::canonicalize(input), fs::canonicalize(output)) {
        (Ok(a), Ok(b)) if a == b && input != Path::new("-") => {
            Err(Failure::Trouble(format!("{} is the input, which is never overwritten", output.display())))
        }
        _ => Ok(()),
    }
}

/// Writes to a temporary file beside the target and renames it, so that an existing file is replaced whole or stays
/// as it was.
pub(super) fn write(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    write_with(path, |file| file.write_all(bytes))
}

/// [`write`] for what is made while it is written.
pub(super) fn write_with(path: &Path, fill: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<(), Failure> {
    write_seek(path, |file| fill(file).map_err(|error| cannot_write(path, error)))
}

/// [`write`] for what is made while it is written, goes back in the file, or can fail for reasons of its own.
pub(super) fn write_seek<T>(
    path: &Path,
    fill: impl FnOnce(&mut BufWriter<fs::File>) -> Result<T, Failure>,
) -> Result<T, Failure> {
    let failed = |error| cannot_write(path, error);
    let folder = path.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
    fs::create_dir_all(folder).map_err(failed)?;
    let name = path.file_name().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default();
    let temporary = folder.join(format!(".{name}.{}.tmp", std::process::id()));
    let written = fs::File::create(&temporary).map_err(failed).and_then(|file| {
        let mut file = BufWriter::new(file);
        let made = fill(&mut file)?;
        file.flush().map_err(failed)?;
        fs::rename(&temporary, path).map_err(failed)?;
        Ok(made)
    });
    if written.is_err() {
        // best effort: the error that matters is the first
        let _ = fs::remove_file(&temporary);
    }
    written
}

fn cannot_write(path: &Path, error: io::Error) -> Failure {
    Failure::trouble(format!("cannot write {}", path.display()), error)
}
