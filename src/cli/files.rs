//! Files are written whole or not at all.

use crate::cli::{Failure, unfinished};
use std::fs;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

/// A file that may be written: one that does not exist in a folder that does, or, with `force`, one that may be replaced.
/// What is not a plain file (a folder, a device, a pipe) is never replaced.
pub(super) fn vacant(path: &Path, force: bool) -> Result<(), Failure> {
    let trouble = |why: &str| Err(Failure::Trouble(format!("{} {why}", path.display())));
    if path.file_name().is_none() {
        return trouble("is not a file that could be written");
    }
    match fs::metadata(path) {
        Err(_) if !folder_of(path).is_dir() => trouble("cannot be written: its folder does not exist"),
        Err(_) => Ok(()),
        Ok(there) if !there.is_file() => trouble("is not a file that could be replaced"),
        Ok(_) if !force => trouble("exists already; --force replaces it"),
        Ok(_) => Ok(()),
    }
}

/// The folder that a file stands in.
fn folder_of(path: &Path) -> &Path {
    path.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

/// How a file's name ends, behind its last point, in small letters; empty if it has none.
pub(super) fn ending(path: &Path) -> String {
    path.extension().map(|ending| ending.to_string_lossy().to_lowercase()).unwrap_or_default()
}

/// Whether two names, of files that need not exist yet, are one place.
pub(super) fn same(one: &Path, other: &Path) -> bool {
    let place = |path: &Path| {
        let whole = fs::canonicalize(path).ok();
        whole.or_else(|| Some(fs::canonicalize(folder_of(path)).ok()?.join(path.file_name()?)))
    };
    one == other || place(one).is_some_and(|p| Some(p) == place(other))
}

/// Two paths that are not the same file, whatever they are called; `-` is none.
pub(super) fn distinct(input: &Path, output: &Path) -> Result<(), Failure> {
    if input != Path::new("-") && same(input, output) {
        return Err(Failure::Trouble(format!("{} is the input, which is never overwritten", output.display())));
    }
    Ok(())
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
    let (prepared, made) = Prepared::filled(path, fill)?;
    prepared.place()?;
    Ok(made)
}

/// A file that is written whole, but not in its place yet: several can be prepared before the first is placed.
pub(super) struct Prepared {
    temporary: PathBuf,
    target: PathBuf,
}

impl Prepared {
    /// Writes the temporary file.
    pub(super) fn new(path: &Path, fill: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<Self, Failure> {
        Ok(Self::filled(path, |file| fill(file).map_err(|error| cannot_write(path, error)))?.0)
    }

    fn filled<T>(
        path: &Path,
        fill: impl FnOnce(&mut BufWriter<fs::File>) -> Result<T, Failure>,
    ) -> Result<(Self, T), Failure> {
        let failed = |error| cannot_write(path, error);
        let folder = folder_of(path);
        fs::create_dir_all(folder).map_err(failed)?;
        let name = path.file_name().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default();
        let temporary = folder.join(format!(".{name}.{}.tmp", std::process::id()));
        unfinished::begun(&temporary);
        let prepared = Self { temporary, target: path.to_owned() };
        let mut file = BufWriter::new(fs::File::create(&prepared.temporary).map_err(failed)?);
        let made = fill(&mut file)?;
        file.flush().map_err(failed)?;
        Ok((prepared, made))
    }

    /// Puts it where it belongs.
    pub(super) fn place(self) -> Result<(), Failure> {
        fs::rename(&self.temporary, &self.target).map_err(|error| cannot_write(&self.target, error))
    }
}

impl Drop for Prepared {
    fn drop(&mut self) {
        // gone already where it was placed; otherwise best effort, the error that matters is another
        let _ = fs::remove_file(&self.temporary);
        unfinished::ended(&self.temporary);
    }
}

fn cannot_write(path: &Path, error: io::Error) -> Failure {
    Failure::trouble(format!("cannot write {}", path.display()), error)
}
