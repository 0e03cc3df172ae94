//! What stands above a column.

use std::fmt;

/// The name of a column, and its unit where the header says one: `time [s]`, `U (mV)`.
///
/// ```
/// use nyquist::door::table::Heading;
/// let heading = Heading::read("Luft Temp. [°C]");
/// assert_eq!((heading.name.as_str(), heading.unit.as_str()), ("Luft Temp.", "°C"));
/// assert_eq!(heading.to_string(), "Luft Temp. [°C]");
/// assert_eq!(Heading::read("x").unit, "");
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Heading {
    /// The name without the unit.
    pub name: String,
    /// The unit; empty if there is none.
    pub unit: String,
}

impl Heading {
    /// The name and unit in a cell of the header.
    pub fn read(cell: &str) -> Self {
        let cell = cell.trim();
        let inside = |open: char, close: char| {
            let (name, unit) = cell.strip_suffix(close)?.rsplit_once(open)?;
            Some(Self { name: name.trim().to_owned(), unit: unit.trim().to_owned() })
        };
        let bracketed = inside('[', ']').or_else(|| inside('(', ')'));
        bracketed.unwrap_or_else(|| Self { name: cell.to_owned(), unit: String::new() })
    }
}

impl fmt::Display for Heading {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (self.name.as_str(), self.unit.as_str()) {
            (name, "") => write!(f, "{name}"),
            ("", unit) => write!(f, "[{unit}]"),
            (name, unit) => write!(f, "{name} [{unit}]"),
        }
    }
}
