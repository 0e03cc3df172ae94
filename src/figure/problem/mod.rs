//! The problem: sensors and displays, what goes wrong in pictures, sampling too slowly, folding.

pub mod cause;
pub mod display;
pub mod flicker;
pub mod folding;
pub mod highlights;
pub mod images;
pub mod jaggies;
pub mod moire;
pub mod retort;
pub mod scene;
pub mod sensor;
pub mod strobing;
pub mod tilted;

use crate::figure::Entry;

/// The families of this chapter, in its order.
pub static FAMILIES: &[&[Entry]] = &[
    sensor::ENTRIES,
    display::ENTRIES,
    jaggies::ENTRIES,
    moire::ENTRIES,
    flicker::ENTRIES,
    highlights::ENTRIES,
    strobing::ENTRIES,
    images::ENTRIES,
    scene::ENTRIES,
    cause::ENTRIES,
    folding::ENTRIES,
    retort::ENTRIES,
    tilted::ENTRIES,
];
