//! Tables out of bytes.

use crate::door::table::date::Calendar;
use crate::door::table::decimal::Decimal;
use crate::door::table::dialect::{Dialect, Separator};
use crate::door::table::heading::Heading;
use crate::door::table::{Clock, Column, Skipped, Table};
use crate::error::{Error, Result, unknown};
use std::borrow::Cow;

/// How a table is to be read.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Reading {
    /// What stands between cells; none: told by the first rows.
    pub separator: Option<Separator>,
    /// Whether numbers have a decimal comma.
    pub decimal_comma: bool,
    /// Which column holds the times.
    pub times: TimeColumn,
    /// Which columns hold the values.
    pub values: ValueColumns,
    /// Whether rows with a missing value are left out instead of refused.
    pub skip_missing: bool,
}

/// Which column holds the times.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub enum TimeColumn {
    /// The first.
    #[default]
    First,
    /// That of this name, or of this number counted from one.
    Named(String),
    /// None: all columns are values.
    Nowhere,
}

/// Which columns hold the values.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub enum ValueColumns {
    /// All but that of the times.
    #[default]
    Others,
    /// These, by name or by number counted from one.
    These(Vec<String>),
    /// None: only times are read.
    Nothing,
}

/// The table in the bytes of a text file; `name` is what errors call it.
///
/// ```
/// use nyquist::door::table::{Reading, read_table};
/// let table = read_table("log", b"time [s],U [V],I [A]\n0.00,1.5,2\n0.25,-1.5,3e-3\n", &Reading::default())?;
/// assert_eq!(table.clock.as_ref().map(|c| c.since_first()), Some(vec![0.0, 0.25]));
/// assert_eq!((table.columns[0].heading.unit.as_str(), table.columns[1].values[1]), ("V", 3e-3));
/// // German: a comma in numbers, semicolons between them
/// let german = Reading { decimal_comma: true, ..Reading::default() };
/// assert_eq!(read_table("log", b"0,5;1,5\r\n", &german)?.columns[0].values, [1.5]);
/// let error = read_table("log", b"t,v\n0,1\n1,oops\n", &Reading::default()).unwrap_err();
/// assert_eq!(error.to_string(), "log: line 3, column 2 (v): \"oops\" is no number");
/// # Ok::<(), nyquist::error::Error>(())
/// ```
///
/// # Errors
/// [`Error::Format`] with line and column for text where a number should be, missing values (empty cells, NaN, infinity)
/// unless they are to be skipped, numbers beyond the range of `f64`, rows of another length, quotes that are not closed;
/// for UTF-16, and for tables without rows or without values. [`Error::Unknown`] for a column that is not there.
pub fn read_table(name: &str, bytes: &[u8], reading: &Reading) -> Result<Table> {
    let refused = |reason: String| Error::Format { file: name.to_owned(), reason };
    let (text, latin) = decoded(bytes).map_err(|reason| refused(reason.into()))?;
    let mut lines = content(&text).peekable();
    let first: Vec<&str> = content(&text).take(16).map(|(_, line)| line).collect();
    let mut dialect = Dialect::of(&first, reading.decimal_comma);
    dialect.separator = reading.separator.unwrap_or(dialect.separator);
    if dialect.decimal_comma && dialect.separator == Separator::Comma {
        return Err(Error::Unsupported("a comma cannot be both the decimal point and the separator"));
    }

    let Some(&(number, line)) = lines.peek() else {
        return Err(refused("nothing but blank lines and comments".into()));
    };
    let mut cells = Vec::new();
    dialect.split(line, &mut cells).map_err(|what| refused(format!("line {number}: {what}")))?;
    let headed = is_header(dialect, reading, &cells);
    let mut headings: Vec<Heading> = cells.iter().map(|cell| Heading::read(cell)).collect();
    if headed {
        lines.next();
        while headings.len() > 1 && headings.last().is_some_and(|h| h.to_string().is_empty()) {
            headings.pop(); // spreadsheets end lines with separators
        }
        if let Some(units) = lines.peek().and_then(|(_, line)| units(dialect, line, headings.len())) {
            headings.iter_mut().zip(units).for_each(|(heading, unit)| heading.unit = unit);
            lines.next();
        }
    } else {
        headings = (1..=cells.len()).map(|i| Heading { name: format!("column {i}"), unit: String::new() }).collect();
    }

    let plan = Plan::new(reading, &headings)?;
    let mut rows = Rows::new(name, dialect, headings, plan);
    for (number, line) in lines {
        rows.take(number, line, reading.skip_missing)?;
    }
    rows.finish(headed, latin)
}

/// Text in UTF-8, with or without its mark, or in Latin-1.
fn decoded(bytes: &[u8]) -> std::result::Result<(Cow<'_, str>, bool), &'static str> {
    if bytes.starts_with(b"\xff\xfe") || bytes.starts_with(b"\xfe\xff") || bytes.iter().take(64).any(|b| *b == 0) {
        return Err("the text is UTF-16 (\"Unicode\"); save it as UTF-8");
    }
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    match std::str::from_utf8(bytes) {
        Ok(text) => Ok((text.into(), false)),
        Err(_) => Ok((bytes.iter().map(|&b| char::from(b)).collect::<String>().into(), true)),
    }
}

/// The lines that are neither blank nor comments, with their numbers from one on.
fn content(text: &str) -> impl Iterator<Item = (u64, &str)> {
    // old systems end lines with a carriage return alone
    let end = if text.contains('\n') { '\n' } else { '\r' };
    let bare = |line: &&str| line.trim_matches([' ', '\t', '\r', ',', ';']).is_empty();
    let lines = (1..).zip(text.split(end)).map(|(number, line)| (number, line.strip_suffix('\r').unwrap_or(line)));
    lines.filter(move |(_, line)| !bare(line) && !line.trim_start().starts_with('#'))
}

/// The first line is a header where the cell of the times, or of the first values, is neither a number nor missing.
fn is_header(dialect: Dialect, reading: &Reading, cells: &[Cow<'_, str>]) -> bool {
    let number = |name: &str| name.parse::<usize>().ok().and_then(|i| i.checked_sub(1));
    let decisive = match (&reading.times, &reading.values) {
        (TimeColumn::Named(name), _) => number(name),
        (TimeColumn::Nowhere, ValueColumns::These(names)) => names.first().and_then(|name| number(name)),
        _ => Some(0),
    };
    // a name can only be found in a header
    decisive.and_then(|i| cells.get(i)).is_none_or(|cell| {
        let cell = dialect.pointed(cell);
        matches!(number_of(&cell), Err(Trouble::Text)) && Calendar::read(&cell).is_none()
    })
}

/// A line of units under the header, each in brackets.
fn units(dialect: Dialect, line: &str, columns: usize) -> Option<Vec<String>> {
    let mut cells = Vec::new();
    dialect.split(line, &mut cells).ok()?;
    let unit = |cell: &Cow<'_, str>| {
        let inner = |open, close| cell.strip_prefix(open)?.strip_suffix(close).map(|u: &str| u.trim().to_owned());
        if cell.is_empty() { Some(String::new()) } else { inner('(', ')').or_else(|| inner('[', ']')) }
    };
    let units: Option<Vec<String>> = cells.iter().map(unit).collect();
    units.filter(|units| units.len() >= columns && units.iter().any(|u| !u.is_empty()))
}

/// Which columns are read.
struct Plan {
    time: Option<usize>,
    values: Vec<usize>,
}

impl Plan {
    fn new(reading: &Reading, headings: &[Heading]) -> Result<Self> {
        let find = |wanted: &str| {
            let is = |h: &Heading| h.name == wanted || h.to_string() == wanted;
            let by_number = || wanted.parse::<usize>().ok().filter(|i| (1..=headings.len()).contains(i)).map(|i| i - 1);
            let found = headings.iter().position(is).or_else(by_number);
            found.ok_or_else(|| unknown("column", wanted, headings.iter().map(|h| h.name.as_str())))
        };
        let time = match &reading.times {
            TimeColumn::First => Some(0),
            TimeColumn::Named(name) => Some(find(name)?),
            TimeColumn::Nowhere => None,
        };
        let values = match &reading.values {
            ValueColumns::Others => (0..headings.len()).filter(|i| Some(*i) != time).collect(),
            ValueColumns::These(names) => names.iter().map(|name| find(name)).collect::<Result<Vec<_>>>()?,
            ValueColumns::Nothing => Vec::new(),
        };
        Ok(Self { time, values })
    }
}

/// What is wrong with a cell.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Trouble {
    Missing(&'static str),
    TooLarge,
    /// A time that is not told from others as exactly as it is written.
    NoTime,
    Text,
}

/// The number in a cell with a decimal point.
fn number_of(cell: &str) -> std::result::Result<f64, Trouble> {
    if cell.is_empty() {
        return Err(Trouble::Missing("is empty"));
    }
    if ["na", "n/a", "null", "none", "-"].iter().any(|word| cell.eq_ignore_ascii_case(word)) {
        return Err(Trouble::Missing("has no value"));
    }
    match cell.parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(value),
        Ok(value) if value.is_nan() => Err(Trouble::Missing("is not a number (NaN)")),
        Ok(_) if cell.bytes().any(|b| b.is_ascii_digit()) => Err(Trouble::TooLarge),
        Ok(_) => Err(Trouble::Missing("is infinite")),
        Err(_) => Err(Trouble::Text),
    }
}

/// Rows as they come.
struct Rows<'a> {
    file: &'a str,
    dialect: Dialect,
    headings: Vec<Heading>,
    plan: Plan,
    calendar: Option<Calendar>,
    times: Vec<Decimal>,
    columns: Vec<Vec<f64>>,
    lines: Vec<u64>,
    skipped: Skipped,
}

impl<'a> Rows<'a> {
    fn new(file: &'a str, dialect: Dialect, headings: Vec<Heading>, plan: Plan) -> Self {
        let columns = vec![Vec::new(); plan.values.len()];
        let (times, lines, skipped) = (Vec::new(), Vec::new(), Skipped::default());
        Self { file, dialect, headings, plan, calendar: None, times, columns, lines, skipped }
    }

    fn take(&mut self, number: u64, line: &str, skip_missing: bool) -> Result<()> {
        let refused =
            |what: String| Error::Format { file: self.file.to_owned(), reason: format!("line {number}{what}") };
        let mut cells = Vec::with_capacity(self.headings.len() + 1);
        self.dialect.split(line, &mut cells).map_err(|what| refused(format!(": {what}")))?;
        let expected = self.headings.len();
        if cells.len() == expected + 1 && cells.last().is_some_and(|c| c.is_empty()) {
            cells.pop();
        }
        if cells.len() != expected {
            let plural = if cells.len() == 1 { "cell" } else { "cells" };
            return Err(refused(format!(": {} {plural}, but {expected} in the first line", cells.len())));
        }
        let pointed = |i: usize| self.dialect.pointed(&cells[i]);
        let mut missing = false;
        let mut trouble = |i: usize, trouble: Trouble, wanted: &str| -> Result<()> {
            let said = match trouble {
                Trouble::Missing(_) if skip_missing => {
                    missing = true;
                    return Ok(());
                }
                Trouble::Missing(what) => format!("the cell {what} (--skip-missing leaves such rows out)"),
                Trouble::TooLarge => format!("{} is too large", shown(&cells[i])),
                Trouble::NoTime => format!("{} is too large or too small for a time", shown(&cells[i])),
                Trouble::Text => format!("{} is no {wanted}{}", shown(&cells[i]), self.hint(&cells[i])),
            };
            Err(refused(format!(", column {} ({}): {said}", i + 1, self.headings[i].name)))
        };
        let mut values = Vec::with_capacity(self.plan.values.len());
        for &i in &self.plan.values {
            match number_of(&pointed(i)) {
                Ok(value) => values.push(value),
                Err(what) => trouble(i, what, "number")?,
            }
        }
        let mut time = None;
        if let Some(i) = self.plan.time {
            match self.time_of(&pointed(i)) {
                Ok(read) => time = Some(read),
                Err(what) => trouble(i, what, "number, and no date such as 2026-01-31T12:00:00.25Z")?,
            }
        }
        if missing {
            let first_line = if self.skipped.rows == 0 { number } else { self.skipped.first_line };
            self.skipped = Skipped { rows: self.skipped.rows + 1, first_line };
            return Ok(());
        }
        if let Some((time, calendar)) = time {
            let kept = if self.times.is_empty() { calendar } else { self.calendar };
            let comparable = match (kept, calendar) {
                (None, None) => true,
                (Some(kept), Some(calendar)) => kept.comparable(calendar),
                _ => false,
            };
            if !comparable {
                return Err(refused(": the time is written in another way than those before".into()));
            }
            self.calendar = kept;
            self.times.push(time);
        }
        self.columns.iter_mut().zip(values).for_each(|(column, value)| column.push(value));
        self.lines.push(number);
        Ok(())
    }

    fn time_of(&self, cell: &str) -> std::result::Result<(Decimal, Option<Calendar>), Trouble> {
        match (number_of(cell), cell.parse::<Decimal>()) {
            (Ok(_), Ok(decimal)) => Ok((decimal, None)),
            (Ok(value), Err(_)) => Decimal::of(value).map(|decimal| (decimal, None)).ok_or(Trouble::NoTime),
            (Err(Trouble::Text), _) => {
                Calendar::read(cell).map(|(time, calendar)| (time, Some(calendar))).ok_or(Trouble::Text)
            }
            (Err(trouble), _) => Err(trouble),
        }
    }

    /// What may have been meant.
    fn hint(&self, cell: &str) -> String {
        let pointed = cell.replacen(',', ".", 1);
        let comma = !self.dialect.decimal_comma && cell.contains(',') && number_of(&pointed).is_ok();
        if comma { format!(" (with --decimal-comma it is {pointed})") } else { String::new() }
    }

    fn finish(self, headed: bool, latin: bool) -> Result<Table> {
        let refused = |reason: &str| Err(Error::Format { file: self.file.to_owned(), reason: reason.into() });
        match (self.lines.len(), self.skipped.rows) {
            (0, 0) if latin => {
                return refused("there is no row of numbers, and its bytes are no UTF-8: it may be no text");
            }
            (0, 0) => return refused("there is a header and no row of numbers"),
            (0, _) => return refused("a value is missing in every row"),
            _ => {}
        }
        let heading = |i: usize| self.headings[i].clone();
        let clock = self.plan.time.map(|i| Clock { heading: heading(i), calendar: self.calendar, times: self.times });
        let columns = self.plan.values.iter().zip(self.columns);
        Ok(Table {
            file: self.file.to_owned(),
            dialect: self.dialect,
            headed,
            clock,
            columns: columns.map(|(&i, values)| Column { heading: heading(i), values }).collect(),
            lines: self.lines,
            skipped: self.skipped,
            latin,
        })
    }
}

/// A cell in an error: not all of a long one, and nothing that moves the cursor.
fn shown(cell: &str) -> String {
    const MOST: usize = 40;
    let start: String = cell.chars().take(MOST).collect();
    let more = if cell.chars().nth(MOST).is_some() { "…" } else { "" };
    format!("\"{}{more}\"", start.escape_debug().to_string().replace("\\\"", "\""))
}
