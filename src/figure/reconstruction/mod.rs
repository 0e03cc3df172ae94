//! Reconstruction: the ideal low-pass in frequency and in space, its problems, and the whole chain.

pub mod cardinal;
pub mod convolving;
pub mod low_pass;
pub mod overview;

use crate::figure::Entry;

/// The families of this chapter, in its order.
pub static FAMILIES: &[&[Entry]] = &[low_pass::ENTRIES, convolving::ENTRIES, cardinal::ENTRIES, overview::ENTRIES];
