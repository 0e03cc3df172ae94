//! What is in a file and is not taken.

/// How many names are kept.
const MOST_NAMES: usize = 32;

/// Pieces of a file of one name, chunks or segments, that were skipped.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Skipped {
    /// The name, as the format has it; "…" for all the others in a file with too many names.
    pub name: String,
    /// How many there were.
    pub count: u64,
    /// How many bytes they had.
    pub bytes: u64,
}

impl Skipped {
    /// Counts one more piece.
    pub(super) fn count(all: &mut Vec<Self>, name: String, bytes: u64) {
        let full = all.len() >= MOST_NAMES;
        let name = if full && !all.iter().any(|s| s.name == name) { "…".to_owned() } else { name };
        match all.iter_mut().find(|s| s.name == name) {
            Some(same) => {
                same.count += 1;
                same.bytes = same.bytes.saturating_add(bytes);
            }
            None => all.push(Self { name, count: 1, bytes }),
        }
    }
}
