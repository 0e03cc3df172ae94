//! Pieces of a file that are not carried over: in words, and as JSON.

use crate::cli::working::note;
use nyquist::door::skipped::Skipped;
use serde_json::{Value, json};

/// A note for each name, as `called` says it.
pub(super) fn tell(all: &[Skipped], called: impl Fn(&str) -> String) {
    for Skipped { name, count, bytes } in all {
        let times = if *count == 1 { String::new() } else { format!("{count} times, ") };
        note(&format!("{} ({times}{bytes} bytes) is not carried over", called(name)));
    }
}

/// A list of them.
pub(super) fn json(all: &[Skipped]) -> Value {
    all.iter().map(|s| json!({ "name": s.name, "count": s.count, "bytes": s.bytes })).collect()
}
