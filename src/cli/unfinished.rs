//! Temporary files that are being written: whoever stops the command finds none of them.

use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};
use std::{fs, process};

/// Those that exist and are not in their place yet.
static UNFINISHED: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

/// The exit code of what was interrupted, as shells have it.
const INTERRUPTED: i32 = 130;

/// From now on an interruption (Ctrl-C, or being told to end) removes what is unfinished before it ends the command.
pub(super) fn removed_on_interruption() {
    // without a handler an interruption ends the command all the same, and leaves its temporary file
    let _ = ctrlc::set_handler(|| {
        // locked until the end: nothing is placed any more, nothing begun
        let unfinished = UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner);
        for path in unfinished.iter() {
            let _ = fs::remove_file(path);
        }
        process::exit(INTERRUPTED);
    });
}

pub(super) fn begun(path: &Path) {
    UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner).push(path.to_owned());
}

pub(super) fn ended(path: &Path) {
    UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner).retain(|other| other != path);
}
