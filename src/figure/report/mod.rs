//! Reports: what was found in a user's data, in words, in tables and in a picture.
//!
//! A report is data, as a figure is: the command line prints its sections, the page shows them around the picture, and
//! tests ask it for its numbers.

pub mod picture;
pub mod sound;
pub mod table;

use crate::error::{Error, unknown};
use crate::figure::{Figure, Portrait};
use crate::text::Text;
use std::fmt;
use std::str::FromStr;

/// What a spectrum says of each frequency.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Quantity {
    /// The amplitude of a sinusoid.
    #[default]
    Amplitude,
    /// The mean square per unit of frequency.
    Density,
}

impl Quantity {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Amplitude, Self::Density];

    /// Its name: `amplitude`, `density`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Amplitude => "amplitude",
            Self::Density => "density",
        }
    }
}

/// The name.
impl fmt::Display for Quantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// Reads a quantity's name.
impl FromStr for Quantity {
    type Err = Error;

    fn from_str(name: &str) -> Result<Self, Error> {
        let found = Self::ALL.into_iter().find(|quantity| quantity.name() == name);
        found.ok_or_else(|| unknown("quantity", name, Self::ALL.map(Self::name)))
    }
}

/// What was found.
#[derive(Debug, Clone, PartialEq)]
pub struct Report {
    /// The picture that explains itself, and its title.
    pub portrait: Portrait,
    /// The findings in words and numbers, the most important first.
    pub sections: Vec<Section>,
}

impl Report {
    /// Without anything yet.
    pub(super) fn empty() -> Self {
        let portrait = Portrait { title: Text::EMPTY, caption: Text::EMPTY, figure: Figure::new(1) };
        Self { portrait, sections: Vec::new() }
    }
}

/// Findings of one kind.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Section {
    /// What they are about.
    pub heading: Text,
    /// In sentences.
    pub sentences: Vec<Text>,
    /// And in numbers.
    pub table: Option<Table>,
}

/// Rows of numbers under a head.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Table {
    /// What stands in the columns.
    pub head: Vec<Text>,
    /// The rows, each as long as the head. A cell may be empty.
    pub rows: Vec<Vec<Text>>,
}

impl Section {
    /// Without findings yet.
    pub fn new(heading: Text) -> Self {
        Self { heading, ..Self::default() }
    }

    /// With one more sentence.
    #[must_use]
    pub fn say(mut self, sentence: Text) -> Self {
        self.sentences.push(sentence);
        self
    }

    /// With a table of these columns and rows.
    #[must_use]
    pub fn table(mut self, head: impl Into<Vec<Text>>, rows: impl IntoIterator<Item = Vec<Text>>) -> Self {
        self.table = Some(Table { head: head.into(), rows: rows.into_iter().collect() });
        self
    }
}
