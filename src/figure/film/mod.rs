//! Reconstruction of the image: from samples to pixels, and the choice of a filter.

pub mod choice;
pub mod stages;

use crate::figure::Entry;

/// The families of this chapter, in its order.
pub static FAMILIES: &[&[Entry]] = &[stages::ENTRIES, choice::ENTRIES];
