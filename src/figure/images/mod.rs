//! Pictures and their spectra: the plane as the line before it.

pub mod gaussians;
pub mod gratings;
mod view;

use crate::figure::Entry;

/// The families of this chapter, in its order.
pub static FAMILIES: &[&[Entry]] = &[gratings::ENTRIES, gaussians::ENTRIES];
