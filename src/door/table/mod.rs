//! Tables of numbers: times and values in rows of text, as loggers, oscilloscopes and spreadsheets write them.
//!
//! Read are cells between commas, semicolons or tabulators (told apart by the first rows), with or without a header, names
//! with units (`time [s]`), quotes, a decimal comma on request, ends of lines of every system, blank lines, and comments
//! that begin with `#`. Text is UTF-8, with or without its mark; what is not, is taken for Latin-1, in which old
//! spreadsheets write their `°`. UTF-16 is refused by name.
//!
//! Times are kept as they were printed, as exact decimals ([`Decimal`]), since the differences of two times around
//! 1.7·10⁹ seconds have seven digits less in `f64` than the times; dates of ISO 8601 become seconds since 1970. All that is
//! wrong with a cell is said with its line and its column.
//!
//! # Why no crate
//!
//! The well-kept one, `csv`, splits records and leaves the rest: which separator, which decimal point, where the numbers
//! begin, what a cell means. Splitting a line is thirty of the lines here. A quoted line break inside a cell is refused,
//! which `csv` would read: a table of numbers has none, and a quote left open by a damaged file would swallow the rest.

mod date;
mod decimal;
mod dialect;
mod heading;
mod reader;
mod writer;

pub use date::Calendar;
pub use decimal::{Decimal, NoDecimal};
pub use dialect::{Dialect, Separator};
pub use heading::Heading;
pub use reader::{Reading, TimeColumn, ValueColumns, read_table};
pub use writer::TableWriter;

/// Times and values, column by column.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    /// What errors call it.
    pub file: String,
    /// How it was written.
    pub dialect: Dialect,
    /// Whether a header stood above the rows.
    pub headed: bool,
    /// The column of times; none where all columns are values.
    pub clock: Option<Clock>,
    /// The columns of values, all of one length.
    pub columns: Vec<Column>,
    /// On which line each row stood, counted from one.
    pub lines: Vec<u64>,
    /// What was left out.
    pub skipped: Skipped,
    /// Whether the text was not UTF-8, and taken for Latin-1.
    pub latin: bool,
}

/// A column of values.
#[derive(Debug, Clone, PartialEq)]
pub struct Column {
    /// What stands above it; without a header, its number.
    pub heading: Heading,
    /// The values, all finite.
    pub values: Vec<f64>,
}

/// A column of times.
#[derive(Debug, Clone, PartialEq)]
pub struct Clock {
    /// What stands above it.
    pub heading: Heading,
    /// How dates are written; none where times are numbers.
    pub calendar: Option<Calendar>,
    /// The times as they were printed; dates as seconds since 1970.
    pub times: Vec<Decimal>,
}

/// Rows that were left out since a value was missing in them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Skipped {
    /// How many.
    pub rows: usize,
    /// On which line the first of them stood.
    pub first_line: u64,
}

impl Table {
    /// How many rows there are.
    pub fn rows(&self) -> usize {
        self.lines.len()
    }
}

impl Clock {
    /// The times since the first, each difference rounded once.
    pub fn since_first(&self) -> Vec<f64> {
        let first = self.times.first().copied().unwrap_or(Decimal::ZERO);
        self.times.iter().map(|time| time.minus(first)).collect()
    }

    /// To what the times were printed: a row's time `t` was rounded to a multiple of the larger of `10^−decimals` and
    /// `10^(magnitude of t + 1 − significant)`. So `decimals` is the most that any time has, and `significant` the most
    /// digits: the one limits numbers such as `12.345`, the other such as `1.2346e4` or the sixteen digits of an `f64`.
    pub fn printed(&self) -> (u32, u32) {
        let most = |of: fn(Decimal) -> u32| self.times.iter().map(|&t| of(t)).max().unwrap_or(0);
        (most(Decimal::decimals), most(Decimal::significant).max(1))
    }

    /// By how much each time may be off from having been printed: half of what it was rounded to.
    pub fn rounding(&self) -> Vec<f64> {
        let (decimals, significant) = self.printed();
        let half = |t: &Decimal| {
            let (digits, exponent) = t.parts();
            let magnitude =
                digits.unsigned_abs().checked_ilog10().map_or(-(decimals as i32), |log| log as i32 + exponent);
            0.5 * 10f64.powi((-(decimals as i32)).max(magnitude + 1 - significant as i32))
        };
        self.times.iter().map(half).collect()
    }

    /// A time as this column writes it.
    pub fn show(&self, time: Decimal) -> String {
        self.calendar.map_or_else(|| time.to_string(), |calendar| calendar.show(time))
    }

    /// The unit of the differences: that of the header, seconds for dates.
    pub fn unit(&self) -> &str {
        if self.calendar.is_some() { "s" } else { &self.heading.unit }
    }
}
