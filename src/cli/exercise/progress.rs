//! What a student has done, kept in `.nyquist/progress.json`.

use crate::cli::{Failure, files};
use nyquist::text::Lang;
use serde_json::{Map, Value, json};
use std::collections::BTreeMap;
use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

/// What was done with one exercise.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Mark {
    /// How often it was checked.
    pub(super) tries: u64,
    /// How many hints were shown.
    pub(super) hints: u64,
    /// Whether it was solved.
    pub(super) solved: bool,
}

/// What was done in a folder.
#[derive(Debug)]
pub(super) struct Progress {
    path: PathBuf,
    /// The language that was chosen.
    pub(super) lang: Lang,
    marks: BTreeMap<String, Mark>,
    /// The exercise that was worked on last.
    pub(super) latest: Option<String>,
}

impl Progress {
    /// Reads what was done in that folder: nothing, if it is new. A language that is given replaces the chosen one.
    pub(super) fn read(folder: &Path, lang: Option<Lang>) -> Result<Self, Failure> {
        let path = folder.join(".nyquist/progress.json");
        let known = match fs::read_to_string(&path) {
            Ok(text) => parsed(&text).ok_or_else(|| {
                Failure::Trouble(format!("{} is damaged; delete it to begin anew (your files stay)", path.display()))
            })?,
            Err(error) if error.kind() == ErrorKind::NotFound => (Lang::En, BTreeMap::new(), None),
            Err(error) => return Err(Failure::trouble(format!("cannot read {}", path.display()), error)),
        };
        Ok(Self { path, lang: lang.unwrap_or(known.0), marks: known.1, latest: known.2 })
    }

    /// What was done with that exercise.
    pub(super) fn of(&self, id: &str) -> Mark {
        self.marks.get(id).copied().unwrap_or_default()
    }

    /// Notes something, and writes it down.
    pub(super) fn note(&mut self, id: &str, change: impl FnOnce(&mut Mark)) -> Result<(), Failure> {
        change(self.marks.entry(id.to_owned()).or_default());
        self.latest = Some(id.to_owned());
        let mark =
            |(id, m): (&String, &Mark)| (id.clone(), json!({ "tries": m.tries, "hints": m.hints, "solved": m.solved }));
        let marks = Value::Object(self.marks.iter().map(mark).collect::<Map<_, _>>());
        let text = format!("{:#}\n", json!({ "lang": self.lang.code(), "latest": self.latest, "exercises": marks }));
        files::write(&self.path, text.as_bytes())
    }
}

fn parsed(text: &str) -> Option<(Lang, BTreeMap<String, Mark>, Option<String>)> {
    let value: Value = serde_json::from_str(text).ok()?;
    let marks = value["exercises"].as_object()?.iter().map(|(id, m)| {
        let mark = Mark { tries: m["tries"].as_u64()?, hints: m["hints"].as_u64()?, solved: m["solved"].as_bool()? };
        Some((id.clone(), mark))
    });
    let latest = value["latest"].as_str().map(str::to_owned);
    Some((value["lang"].as_str()?.parse().ok()?, marks.collect::<Option<_>>()?, latest))
}
