//! Pictures and their spectra: the plane as the line before it.

pub mod copies;
#[cfg(feature = "files")]
pub mod filtered;
pub mod gaussians;
pub mod ghosts;
pub mod gratings;
pub mod hexagonal;
pub mod references;
pub mod slices;
mod view;
pub mod zone_plate;

use crate::figure::Entry;

/// The families of this chapter, in its order.
pub static FAMILIES: &[&[Entry]] = &[
    gratings::ENTRIES,
    gaussians::ENTRIES,
    #[cfg(feature = "files")]
    filtered::ENTRIES,
    copies::ENTRIES,
    slices::ENTRIES,
    hexagonal::ENTRIES,
    zone_plate::ENTRIES,
    ghosts::ENTRIES,
    references::ENTRIES,
];
