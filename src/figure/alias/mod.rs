//! Aliasing: copies that overlap, what leaks, and which step suffices.

pub mod leak;
pub mod theorem;

use crate::figure::Entry;

/// The families of this chapter, in its order.
pub static FAMILIES: &[&[Entry]] = &[leak::ENTRIES, theorem::ENTRIES];
