//! Reconstruction of the image: from samples to pixels, and the choice of a filter.

pub mod choice;
pub mod examples;
pub mod plane;
pub mod stages;
mod trial;
pub mod weights;
pub mod window;

use crate::figure::Entry;

/// The families of this chapter, in its order.
pub static FAMILIES: &[&[Entry]] =
    &[stages::ENTRIES, plane::ENTRIES, weights::ENTRIES, choice::ENTRIES, examples::ENTRIES, window::ENTRIES];
