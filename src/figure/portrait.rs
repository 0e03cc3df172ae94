//! Figures of what a user brings.

use crate::figure::Figure;
use crate::text::Text;

/// A figure that belongs to no catalogue, since it shows a user's own data, with its title and its caption.
#[derive(Debug, Clone, PartialEq)]
pub struct Portrait {
    /// What stands above it.
    pub title: Text,
    /// What can be seen in it, in sentences.
    pub caption: Text,
    /// The panels.
    pub figure: Figure,
}
