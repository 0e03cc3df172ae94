//! Tables into text.

use crate::door::table::dialect::Dialect;
use crate::door::table::heading::Heading;

/// Writes rows of a table; every number is the shortest that reads back as the same.
///
/// ```
/// use nyquist::door::table::{Dialect, Heading, Separator, TableWriter};
/// let mut writer = TableWriter::new(Dialect { separator: Separator::Semicolon, decimal_comma: true });
/// writer.header(&[Heading::read("t [s]"), Heading::read("a;b")]);
/// writer.row(Some("0.50"), &[0.1, 1e-300, f64::NAN]);
/// assert_eq!(writer.take(), "t [s];\"a;b\"\n0,50;0,1;1e-300;\n"); // what is not a number leaves its cell empty
/// ```
#[derive(Debug, Clone)]
pub struct TableWriter {
    dialect: Dialect,
    text: String,
}

impl TableWriter {
    /// Nothing yet.
    pub fn new(dialect: Dialect) -> Self {
        Self { dialect, text: String::new() }
    }

    /// A line of names and units.
    pub fn header(&mut self, headings: &[Heading]) {
        let cells: Vec<String> = headings.iter().map(|h| self.dialect.quoted(&h.to_string())).collect();
        self.text += &cells.join(&self.dialect.separator.letter().to_string());
        self.text.push('\n');
    }

    /// A line of numbers, behind a time if there is one, which is written with a decimal point.
    pub fn row(&mut self, time: Option<&str>, values: &[f64]) {
        let times = time.into_iter().map(str::to_owned);
        let cells = times.chain(values.iter().map(|&v| shortest(v))).map(|cell| self.dialect.localised(cell));
        for (i, cell) in cells.enumerate() {
            if i > 0 {
                self.text.push(self.dialect.separator.letter());
            }
            self.text += &cell;
        }
        self.text.push('\n');
    }

    /// What was written since the last time.
    pub fn take(&mut self) -> String {
        std::mem::take(&mut self.text)
    }
}

/// The shortest decimal that reads back as the same: with an exponent where that is shorter than zeros.
fn shortest(value: f64) -> String {
    match value.abs() {
        _ if value.is_nan() => String::new(),
        size if size != 0.0 && !(1e-5..1e16).contains(&size) => format!("{value:e}"),
        _ => value.to_string(),
    }
}
