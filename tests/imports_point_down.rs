//! The house has floors: every room may use those below it, never those above, and nothing goes through the roof.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

/// From the ground up. A module may use those that stand before it.
const FLOORS: [&str; 34] = [
    "error",
    "text",
    "num",
    "parallel",
    "residual",
    "axis",
    "grid",
    "engine",
    "spectrum",
    "pattern",
    "signal",
    "field",
    "nyquist",
    "kernel",
    "sampled",
    "comb",
    "reconstruct",
    "rate",
    "image",
    "film",
    "antialias",
    "door",
    "scene",
    "beyond",
    "record",
    "resolve",
    "inspect",
    "laws",
    "figure",
    "exercise",
    "plot",
    "gallery",
    "course",
    "cli",
];

fn sources(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("the source folder can be read") {
        let path = entry.expect("its entries can be read").path();
        if path.is_dir() {
            sources(&path, found);
        } else if path.extension().is_some_and(|e| e == "rs") {
            found.push(path);
        }
    }
}

/// The code of a file without comments and documentation.
fn code(path: &Path) -> String {
    let text = fs::read_to_string(path).expect("a source file can be read");
    text.lines().filter(|line| !line.trim_start().starts_with("//")).collect::<Vec<_>>().join("\n")
}

#[test]
fn no_room_uses_one_above_it() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let floor: BTreeMap<&str, usize> = FLOORS.iter().zip(0..).map(|(f, i)| (*f, i)).collect();
    let mut files = Vec::new();
    sources(&source, &mut files);
    assert!(files.len() > 50, "the walk found the sources");
    let mut arrows = 0;
    for path in files {
        let inside = path.strip_prefix(&source).expect("found under it");
        let room = inside.iter().next().expect("a file has a name").to_string_lossy().replace(".rs", "");
        if room == "lib" || room == "main" {
            continue;
        }
        let here = *floor.get(room.as_str()).unwrap_or_else(|| panic!("{room} has no floor: add it to the list"));
        // the command line is another crate: it sees the library as a user does
        let prefix = if room == "cli" { "nyquist::" } else { "crate::" };
        let code = code(&path);
        for (at, _) in code.match_indices(prefix) {
            let name: String =
                code[at + prefix.len()..].chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect();
            assert!(!name.is_empty() && name != "prelude", "{}: an import through the roof", inside.display());
            if let Some(there) = floor.get(name.as_str()) {
                assert!(*there <= here, "{} uses {name}, which stands above {room}", inside.display());
                arrows += 1;
            }
        }
    }
    assert!(arrows > 100, "the imports were seen");
}
