//! Notebooks for the evcxr kernel, with the outputs of the compiled program.

use crate::run::Library;
use crate::source::{LANGUAGES, Piece, Source};
use serde_json::{Value, json};
use std::fs;
use std::path::{Path, PathBuf};
use std::thread;

/// The first line of every notebook's code: where its kernel finds the library, without the command and what it needs.
const LIBRARY: &str =
    ":dep nyquist = { path = \"../..\", default-features = false, features = [\"plot\", \"files\", \"threads\"] }";
/// Around a picture in what a cell prints.
const PICTURE: [&str; 2] = ["EVCXR_BEGIN_CONTENT image/svg+xml\n", "\nEVCXR_END_CONTENT\n"];

/// Derives all notebooks and writes them.
pub fn write(root: &Path) -> Result<String, String> {
    let derived = derive(root)?;
    for (path, text) in &derived {
        let folder = path.parent().expect("a notebook lies in a folder");
        let written = fs::create_dir_all(folder).and_then(|()| fs::write(path, text));
        written.map_err(|error| format!("{}: {error}", path.display()))?;
    }
    Ok(format!("{} notebooks written", derived.len()))
}

/// Derives all notebooks and compares them with what lies there.
pub fn check(root: &Path) -> Result<String, String> {
    let derived = derive(root)?;
    let stale = |(path, text): &&(PathBuf, String)| fs::read_to_string(path).ok().as_ref() != Some(text);
    let mut wrong: Vec<String> =
        derived.iter().filter(stale).map(|(path, _)| format!("{} is stale", path.display())).collect();
    for lang in LANGUAGES {
        let Ok(there) = fs::read_dir(root.join("notebooks-rs").join(lang)) else { continue };
        let strange = there.flatten().map(|e| e.path()).filter(|p| derived.iter().all(|(path, _)| path != p));
        wrong.extend(strange.map(|path| format!("{} belongs to no source", path.display())));
    }
    if wrong.is_empty() { Ok(format!("{} notebooks are fresh", derived.len())) } else { Err(wrong.join("\n")) }
}

fn derive(root: &Path) -> Result<Vec<(PathBuf, String)>, String> {
    let folder = root.join("notebooks-rs");
    let sources = Source::all(&folder)?;
    let library = Library::built(root)?;
    let one = |lang: &'static str| -> Result<Vec<(PathBuf, String)>, String> {
        let derived = sources.iter().map(|source| {
            let printed = library.run(&format!("{}-{lang}", source.name), &source.program(lang))?;
            for (i, words) in &printed {
                ends_with_its_picture(words).map_err(|why| format!("{}: cell {i} {why}", source.name))?;
            }
            let cells = source.pieces(lang);
            let cells = cells.iter().enumerate().map(|(i, piece)| cell(i, piece, printed.get(&i)));
            let path = folder.join(lang).join(format!("{}.ipynb", source.name));
            Ok((path, notebook(cells.collect())))
        });
        derived.collect()
    };
    let done = thread::scope(|scope| {
        let threads = LANGUAGES.map(|lang| scope.spawn(move || one(lang)));
        threads.map(|thread| thread.join().expect("a thread that panics has said why"))
    });
    let done: Result<Vec<_>, String> = done.into_iter().collect();
    Ok(done?.concat())
}

fn notebook(mut cells: Vec<Value>) -> String {
    let (mut first, mut count) = (true, 0);
    for cell in &mut cells {
        if cell["cell_type"] == "code" {
            count += 1;
            cell["execution_count"] = count.into();
            if std::mem::take(&mut first)
                && let Some(lines) = cell["source"].as_array_mut()
            {
                lines.insert(0, format!("{LIBRARY}\n").into());
            }
        }
    }
    let language =
        json!({ "name": "Rust", "file_extension": ".rs", "mimetype": "text/rust", "codemirror_mode": "rust" });
    let value = json!({
        "cells": cells,
        "metadata": {
            "kernelspec": { "display_name": "Rust", "language": "rust", "name": "rust" },
            "language_info": language,
        },
        "nbformat": 4,
        "nbformat_minor": 5,
    });
    format!("{value:#}\n")
}

fn cell(index: usize, piece: &Piece, printed: Option<&String>) -> Value {
    let id = format!("cell-{index}");
    match piece {
        Piece::Text(words) => {
            json!({ "cell_type": "markdown", "id": id, "metadata": {}, "source": lines(&words.join("\n")) })
        }
        Piece::Code(code) => json!({
            "cell_type": "code",
            "id": id,
            "metadata": {},
            "source": lines(&code.join("\n")),
            "execution_count": null,
            "outputs": outputs(printed.map_or("", String::as_str)),
        }),
    }
}

/// The kernel keeps one picture of a cell, the last, and shows it after all words.
fn ends_with_its_picture(printed: &str) -> Result<(), String> {
    match next(printed) {
        (_, Some(_), after) if !after.is_empty() => {
            Err("shows something after a picture; begin another cell there".into())
        }
        _ => Ok(()),
    }
}

/// Words and pictures, in the order in which they came.
fn outputs(printed: &str) -> Vec<Value> {
    let mut outputs = Vec::new();
    let mut rest = printed;
    while !rest.is_empty() {
        let (words, picture, after) = next(rest);
        if !words.is_empty() {
            outputs.push(json!({ "output_type": "stream", "name": "stdout", "text": lines(words) }));
        }
        if let Some(picture) = picture {
            let data = json!({ "image/svg+xml": lines(picture) });
            outputs.push(json!({ "output_type": "display_data", "data": data, "metadata": {} }));
        }
        rest = after;
    }
    outputs
}

/// The words up to the next picture, that picture, and what follows.
fn next(printed: &str) -> (&str, Option<&str>, &str) {
    let found = printed.split_once(PICTURE[0]).and_then(|(words, rest)| Some((words, rest.split_once(PICTURE[1])?)));
    found.map_or((printed, None, ""), |(words, (picture, after))| (words, Some(picture), after))
}

/// A text as Jupyter keeps it: line by line, all but the last with their ends.
fn lines(text: &str) -> Vec<String> {
    text.split_inclusive('\n').map(str::to_owned).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_is_the_last_thing_in_its_cell() {
        let picture = format!("{}<svg/>{}", PICTURE[0], PICTURE[1]);
        assert!(ends_with_its_picture("words\n").is_ok());
        assert!(ends_with_its_picture(&format!("words\n{picture}")).is_ok());
        assert!(ends_with_its_picture(&format!("{picture}words\n")).is_err());
        assert!(ends_with_its_picture(&format!("{picture}{picture}")).is_err());
    }
}
