//! Reports: what was found in a user's data, in words, in tables and in a picture.
//!
//! A report is data, as a figure is: the command line prints its sections, the page shows them around the picture, and
//! tests ask it for its numbers.

use crate::figure::Portrait;
use crate::text::Text;

/// What was found.
#[derive(Debug, Clone, PartialEq)]
pub struct Report {
    /// The picture that explains itself, and its title.
    pub portrait: Portrait,
    /// The findings in words and numbers, the most important first.
    pub sections: Vec<Section>,
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
