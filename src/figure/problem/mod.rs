//! The problem: displays, sampling too slowly, folding.

pub mod cause;
pub mod display;
pub mod folding;

use crate::figure::Entry;

/// The families of this chapter, in its order.
pub static FAMILIES: &[&[Entry]] = &[display::ENTRIES, cause::ENTRIES, folding::ENTRIES];
