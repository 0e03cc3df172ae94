//! What the commands that read tables share.

use crate::cli::Failure;
use crate::cli::number::quotient;
use crate::cli::source::Source;
use crate::cli::working::note;
use nyquist::door::kind::Kind;
use nyquist::door::table::{Reading, Separator, Table, TimeColumn, ValueColumns, read_table};
use nyquist::record::{Order, Sampling};
use serde_json::{Value, json};
use std::io::Read;

/// How a table is read.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Tables")]
#[group(skip)]
pub(super) struct Options {
    /// What stands between cells: comma, semicolon or tab [default: told by the first rows]
    #[arg(long, value_name = "NAME")]
    separator: Option<Separator>,
    /// Numbers have a decimal comma: 0,5
    #[arg(long)]
    decimal_comma: bool,
    /// The column of the times, by name or by number from 1 [default: the first]
    #[arg(long, value_name = "COLUMN")]
    time: Option<String>,
    /// A column of values, by name or by number from 1; can be given several times [default: all others]
    #[arg(long = "column", value_name = "COLUMN")]
    columns: Vec<String>,
    /// There are no times: rows are so many seconds apart, 0.001 or 1/48000
    #[arg(long, value_name = "DT", value_parser = quotient, conflicts_with = "time", allow_negative_numbers = true)]
    dt: Option<f64>,
    /// Leave out rows in which a value is missing (an empty cell, NaN, infinity), instead of refusing them
    #[arg(long)]
    skip_missing: bool,
}

/// How a table is read, and up to where its frequencies are looked at.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Tables")]
#[group(skip)]
pub(super) struct Frequencies {
    #[command(flatten)]
    pub(super) table: Options,
    /// The highest frequency to look at [default: half the rate; of times without a step, their
    /// density]
    #[arg(long, value_name = "FREQUENCY", allow_negative_numbers = true)]
    pub(super) up_to: Option<f64>,
}

impl Options {
    /// The table of a source.
    pub(super) fn read(&self, source: Source) -> Result<Table, Failure> {
        let times = match (&self.time, self.dt) {
            (Some(name), _) => TimeColumn::Named(name.clone()),
            (None, Some(_)) => TimeColumn::Nowhere,
            (None, None) => TimeColumn::First,
        };
        let named = || ValueColumns::These(self.columns.clone());
        let values = if self.columns.is_empty() { ValueColumns::Others } else { named() };
        let table = self.read_with(source, times, values)?;
        if table.columns.is_empty() {
            let why = "there is one column: if it holds values, --dt says how many seconds apart they are";
            return Err(Failure::trouble(table.file, why));
        }
        Ok(table)
    }

    /// The times in the first column of a source.
    pub(super) fn read_times(&self, source: Source) -> Result<Table, Failure> {
        self.read_with(source, TimeColumn::First, ValueColumns::Nothing)
    }

    fn read_with(&self, source: Source, times: TimeColumn, values: ValueColumns) -> Result<Table, Failure> {
        let Source { name, mut bytes } = source;
        let mut text = Vec::new();
        bytes.read_to_end(&mut text).map_err(|error| Failure::trouble(&name, error))?;
        let kind = if text.is_empty() { Ok(Kind::Table) } else { Kind::of(&name, &text[..text.len().min(Kind::HEAD)]) };
        match kind? {
            Kind::Table => {}
            Kind::Sound => return Err(Failure::trouble(name, "this is a sound (WAV), and no table of numbers")),
            Kind::Picture => {
                return Err(Failure::trouble(name, "this is a picture (PNG or JPEG), and no table of numbers"));
            }
        }
        let (separator, decimal_comma, skip_missing) = (self.separator, self.decimal_comma, self.skip_missing);
        Ok(read_table(&name, &text, &Reading { separator, decimal_comma, times, values, skip_missing })?)
    }

    /// The step between rows, where there are no times.
    pub(super) fn step(&self) -> Option<f64> {
        self.dt
    }
}

/// So many of something, in English.
pub(super) fn counted(n: usize, what: &str) -> String {
    if n == 1 { format!("1 {what}") } else { format!("{n} {what}s") }
}

/// Notes of what was put right or left out in the rows of a table.
pub(super) fn tell(table: &Table, sampling: &Sampling) {
    if table.latin {
        note("the text is not UTF-8; it was read as Latin-1");
    }
    if table.skipped.rows > 0 {
        let (rows, line) = (counted(table.skipped.rows, "row"), table.skipped.first_line);
        note(&format!("{rows} with missing values left out, the first on line {line}"));
    }
    match sampling.order() {
        Order::Rising => {}
        Order::Falling => note("the rows run backwards in time; they were turned round"),
        Order::Mixed { falls, first } => {
            let (line, is) = (table.lines[first], if falls == 1 { "is" } else { "are" });
            let rows = counted(falls, "row");
            note(&format!("{rows} {is} earlier than the row before, the first on line {line}; all were sorted"));
        }
    }
    let duplicates = sampling.duplicates();
    if duplicates.rows > 0 {
        let (has, line) = (if duplicates.rows == 1 { "has" } else { "have" }, table.lines[duplicates.first]);
        let rows = counted(duplicates.rows, "row");
        note(&format!("{rows} {has} a time that stood there before, the first on line {line}; means are used"));
    }
}

/// The sampling of a table as JSON.
pub(super) fn sampling(table: &Table, sampling: &Sampling) -> Value {
    use nyquist::record::Kind;
    let shown = |position: usize| {
        let row = sampling.row(position);
        table.clock.as_ref().map_or_else(|| sampling.positions()[position].to_string(), |c| c.show(c.times[row]))
    };
    let line = |position: usize| table.lines[sampling.row(position)];
    let kind = match sampling.kind() {
        Kind::Uniform => "uniform",
        Kind::Gaps => "gaps",
        Kind::Jittered => "jittered",
        Kind::Irregular => "irregular",
    };
    let order = match sampling.order() {
        Order::Rising => json!({ "kind": "rising" }),
        Order::Falling => json!({ "kind": "falling" }),
        Order::Mixed { falls, first } => json!({ "kind": "mixed", "falls": falls, "first_line": table.lines[first] }),
    };
    let (gap, position) = sampling.largest_gap();
    let duplicates = sampling.duplicates();
    let first_line = (duplicates.rows > 0).then(|| table.lines[duplicates.first]);
    let gaps = sampling.gaps();
    let start = sampling.positions()[0];
    json!({
        "kind": kind,
        "samples": sampling.positions().len(),
        "first": shown(0),
        "last": shown(sampling.positions().len() - 1),
        "length": sampling.length(),
        "step": sampling.step(),
        "step_slack": sampling.step_slack(),
        "rounding": sampling.rounding(),
        "jitter": { "rms": sampling.jitter().rms, "most": sampling.jitter().most },
        "missing": gaps.iter().map(|gap| gap.missing).sum::<usize>(),
        "gaps": gaps.iter().map(|gap| json!({
            "after": gap.between[0] - start, "until": gap.between[1] - start, "missing": gap.missing,
        })).collect::<Vec<_>>(),
        "order": order,
        "duplicates": { "rows": duplicates.rows, "first_line": first_line },
        "skipped": { "rows": table.skipped.rows, "first_line": (table.skipped.rows > 0).then_some(table.skipped.first_line) },
        "density": sampling.density(),
        "largest_gap": { "length": gap, "after": shown(position), "line": line(position) },
        "highest_band": sampling.highest_band(),
        "safe_band": sampling.safe_band(),
    })
}
