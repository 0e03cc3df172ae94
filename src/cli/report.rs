//! Reports on the terminal and in files.

use crate::cli::{Failure, files};
use nyquist::figure::report::{Report, Table};
use nyquist::gallery::report::{page, picture};
use nyquist::plot::{Format, Style, Theme};
use nyquist::text::{Lang, Text, plain};
use serde_json::Value;
use std::io::Write;
use std::path::{Path, PathBuf};

/// Where a report goes.
#[derive(Debug, clap::Args)]
#[group(skip)]
pub(super) struct Options {
    /// Also write the report as a picture (.svg, .png, .pdf) or as a page with all numbers (.html)
    #[arg(short = 'o', long = "out", value_name = "REPORT")]
    out: Option<PathBuf>,
    /// Print the findings as JSON
    #[arg(long)]
    json: bool,
    /// The language of the report: en or ru
    #[arg(long, default_value = "en")]
    lang: Lang,
    /// The colours of the report: light or dark
    #[arg(long, default_value = "light")]
    theme: Theme,
    /// Replace the report if it exists
    #[arg(long)]
    force: bool,
}

/// What a report is written as.
enum Kind {
    Picture(Format),
    Page,
}

impl Options {
    /// Refuses, before any work is done, what could not be written afterwards.
    pub(super) fn checked(&self, input: &Path) -> Result<(), Failure> {
        let Some(out) = &self.out else { return Ok(()) };
        kind(out)?;
        files::distinct(input, out)?;
        files::vacant(out, self.force)
    }

    /// Writes the report where it was asked for, and prints the findings.
    pub(super) fn deliver(&self, report: &Report, json: &Value, out: &mut impl Write) -> Result<(), Failure> {
        if let Some(path) = &self.out {
            let style = Style { lang: self.lang, theme: self.theme, ..Style::default() };
            let bytes = match kind(path)? {
                Kind::Picture(format) => picture(report, &style).write(format),
                Kind::Page => page(report, &style).into_bytes(),
            };
            files::write(path, &bytes)?;
        }
        if self.json { Ok(writeln!(out, "{json:#}")?) } else { print(report, self.lang, out) }
    }
}

fn kind(path: &Path) -> Result<Kind, Failure> {
    let ending = files::ending(path);
    match (ending.as_str(), ending.parse()) {
        ("html", _) => Ok(Kind::Page),
        (_, Ok(format)) => Ok(Kind::Picture(format)),
        _ => Err(Failure::trouble(path.display(), "a report ends with .svg, .png, .pdf or .html")),
    }
}

fn print(report: &Report, lang: Lang, out: &mut impl Write) -> Result<(), Failure> {
    let words = |text: &Text| plain(text.get(lang));
    writeln!(out, "{}", words(&report.portrait.title))?;
    for section in &report.sections {
        writeln!(out, "\n{}", words(&section.heading))?;
        for sentence in &section.sentences {
            writeln!(out, "  {}", words(sentence))?;
        }
        if let Some(table) = &section.table {
            print_table(table, lang, out)?;
        }
    }
    Ok(())
}

/// Columns as wide as their widest cell, the first flush left, the others flush right.
fn print_table(table: &Table, lang: Lang, out: &mut impl Write) -> Result<(), Failure> {
    let lines: Vec<Vec<String>> = std::iter::once(&table.head)
        .chain(&table.rows)
        .map(|row| row.iter().map(|cell| plain(cell.get(lang))).collect())
        .collect();
    let wide = |column: usize| {
        let cells = lines.iter().filter_map(|line| line.get(column));
        cells.map(|cell| cell.chars().count()).max().unwrap_or(0)
    };
    let widths: Vec<usize> = (0..table.head.len()).map(wide).collect();
    for line in &lines {
        let mut shown = String::from(" ");
        for (column, (cell, width)) in line.iter().zip(&widths).enumerate() {
            shown += &if column == 0 { format!(" {cell:<width$}") } else { format!("  {cell:>width$}") };
        }
        writeln!(out, "{}", shown.trim_end())?;
    }
    Ok(())
}
