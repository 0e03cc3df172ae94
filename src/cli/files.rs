//! Files are written whole or not at all.

use crate::cli::Failure;
use std::fs;
use std::io::Write;
use std::path::Path;

/// Writes to a temporary file beside the target and renames it, so that an existing file is replaced whole or stays
/// as it was.
pub(super) fn write(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    let failed = |error: std::io::Error| Failure::trouble(format!("cannot write {}", path.display()), error);
    let folder = path.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
    fs::create_dir_all(folder).map_err(failed)?;
    let name = path.file_name().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default();
    let temporary = folder.join(format!(".{name}.{}.tmp", std::process::id()));
    let written = fs::File::create(&temporary)
        .and_then(|mut file| file.write_all(bytes))
        .and_then(|()| fs::rename(&temporary, path));
    written.map_err(|error| {
        // best effort: the error that matters is the first
        let _ = fs::remove_file(&temporary);
        failed(error)
    })
}
