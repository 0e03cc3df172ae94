//! The source of a notebook: a Rust program whose `main` is cut into cells by comments.
//!
//! `// %% en` and `// %% ru` begin a cell of text in that language, in comments; `// %%` begins a cell of code. What the
//! program imports, above `main`, stands in the first cell of code.

use std::fs;
use std::path::{Path, PathBuf};

/// The languages that notebooks are derived in.
pub const LANGUAGES: [&str; 2] = ["en", "ru"];
/// How a source says which language its pictures are in.
const ENGLISH: &str = "let lang = Lang::En;";

/// A notebook before it is derived.
#[derive(Debug)]
pub struct Source {
    /// The name of its file without the extension.
    pub name: String,
    cells: Vec<Cell>,
}

/// A piece of a notebook.
#[derive(Debug, PartialEq, Eq)]
enum Cell {
    Text { lang: &'static str, lines: Vec<String> },
    Code(Vec<String>),
}

/// A piece of a notebook in one language.
#[derive(Debug, PartialEq, Eq)]
pub enum Piece {
    /// Markdown.
    Text(Vec<String>),
    /// Rust.
    Code(Vec<String>),
}

impl Source {
    /// All sources of a folder, by name.
    pub fn all(folder: &Path) -> Result<Vec<Self>, String> {
        let failed = |error: std::io::Error| format!("{}: {error}", folder.display());
        let entries = fs::read_dir(folder).map_err(failed)?;
        let mut paths: Vec<PathBuf> = entries.flatten().map(|entry| entry.path()).collect();
        paths.retain(|path| path.extension().is_some_and(|extension| extension == "rs"));
        paths.sort();
        paths.iter().map(|path| Self::read(path)).collect()
    }

    fn read(path: &Path) -> Result<Self, String> {
        let text = fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()))?;
        let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let cells = parse(&text).map_err(|why| format!("{}: {why}", path.display()))?;
        Ok(Self { name, cells })
    }

    /// The cells of one language, and the code of all.
    pub fn pieces(&self, language: &str) -> Vec<Piece> {
        let code = |lines: &[String]| {
            let to = if language == "ru" { "let lang = Lang::Ru;" } else { ENGLISH };
            lines.iter().map(|line| line.replace(ENGLISH, to)).collect()
        };
        let piece = |cell: &Cell| match cell {
            Cell::Text { lang, lines } => (*lang == language).then(|| Piece::Text(lines.clone())),
            Cell::Code(lines) => Some(Piece::Code(code(lines))),
        };
        self.cells.iter().filter_map(piece).collect()
    }

    /// The program in one language, which says on standard output where each cell of code begins.
    pub fn program(&self, language: &str) -> String {
        let mut program = String::from("fn main() -> nyquist::error::Result<()> {\n");
        let pieces = self.pieces(language);
        for (i, piece) in pieces.iter().enumerate() {
            if let Piece::Code(lines) = piece {
                program += &format!("nyquist::course::cell({i});\n{}\n", lines.join("\n"));
            }
        }
        program + "Ok(())\n}\n"
    }
}

fn parse(text: &str) -> Result<Vec<Cell>, String> {
    let main = text.lines().position(|line| line.starts_with("fn main()") && line.ends_with('{'));
    let main = main.ok_or("no line begins fn main() and ends with a brace")?;
    let imports = text.lines().take(main).filter(|line| line.starts_with("use ")).map(str::to_owned);
    let body: Vec<(usize, &str)> =
        text.lines().enumerate().skip(main + 1).take_while(|(_, line)| *line != "}").collect();
    // the end of main belongs to the program, not to its last cell
    let last = body.iter().rposition(|(_, line)| !line.is_empty());
    let last = last.filter(|&last| body[last].1.trim() == "Ok(())").ok_or("the last line of main is not Ok(())")?;
    let mut cells: Vec<Cell> = Vec::new();
    for &(i, line) in &body[..last] {
        let line = match line.strip_prefix("    ") {
            Some(inside) => inside,
            None if line.is_empty() => line,
            None => return Err(format!("line {} is not inside main", i + 1)),
        };
        match (line.strip_prefix("// %%").map(str::trim), cells.last_mut()) {
            (Some(""), _) => cells.push(Cell::Code(Vec::new())),
            (Some(named), _) => {
                let lang = LANGUAGES.into_iter().find(|lang| *lang == named);
                let lang = lang.ok_or_else(|| format!("line {}: no language is called {named}", i + 1))?;
                cells.push(Cell::Text { lang, lines: Vec::new() });
            }
            (None, Some(Cell::Code(code))) => code.push(line.to_owned()),
            (None, Some(Cell::Text { lines, .. })) if line.is_empty() => lines.push(String::new()),
            (None, Some(Cell::Text { lines, .. })) => {
                let words = line.strip_prefix("//").ok_or_else(|| format!("line {} of a text is no comment", i + 1))?;
                lines.push(words.strip_prefix(' ').unwrap_or(words).to_owned());
            }
            (None, None) if line.is_empty() => {}
            (None, None) => return Err(format!("line {} stands before the first cell", i + 1)),
        }
    }
    cells.iter_mut().for_each(|cell| match cell {
        Cell::Text { lines, .. } | Cell::Code(lines) => trim(lines),
    });
    cells.retain(|cell| !matches!(cell, Cell::Code(lines) if lines.is_empty()));
    let code = cells.iter_mut().find_map(|cell| match cell {
        Cell::Code(lines) => Some(lines),
        Cell::Text { .. } => None,
    });
    code.ok_or("there is no code")?.splice(0..0, imports);
    Ok(cells)
}

/// Without empty lines at either end.
fn trim(lines: &mut Vec<String>) {
    while lines.pop_if(|line| line.is_empty()).is_some() {}
    let empty = lines.iter().take_while(|line| line.is_empty()).count();
    lines.drain(..empty);
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "//! About.\n\nuse nyquist::prelude::*;\n\nfn main() -> nyquist::error::Result<()> {\n    // %% en\n    // # One\n    // %% ru\n    \
                        // # Один\n    // %%\n    let lang = Lang::En;\n\n    if true {\n        one();\n    }\n\n    Ok(())\n}\n";

    #[test]
    fn each_language_has_its_texts_and_the_code() {
        let source = Source { name: "one".into(), cells: parse(TEXT).expect("it is well formed") };
        let [Piece::Text(words), Piece::Code(code)] = &source.pieces("ru")[..] else { panic!("a text and a code") };
        assert_eq!(words, &["# Один"]);
        assert_eq!(code, &["use nyquist::prelude::*;", "let lang = Lang::Ru;", "", "if true {", "    one();", "}"]);
        assert!(source.program("en").contains("cell(1);\nuse nyquist::prelude::*;\nlet lang = Lang::En;"));
    }

    #[test]
    fn a_text_may_be_the_last() {
        let cells =
            parse(&TEXT.replace("    Ok(())", "    // %% en\n    // The end.\n    Ok(())")).expect("it is well formed");
        assert_eq!(cells.last(), Some(&Cell::Text { lang: "en", lines: vec!["The end.".into()] }));
    }

    #[test]
    fn what_stands_elsewhere_is_refused() {
        let broken = [("// # Один", "let x;"), ("// %% ru", "// %% de"), ("    Ok(())\n", ""), ("    // %% en\n", "")];
        for (from, to) in broken {
            assert!(parse(&TEXT.replace(from, to)).is_err(), "{to:?} for {from:?}");
        }
    }
}
