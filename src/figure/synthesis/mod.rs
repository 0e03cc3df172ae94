//! Applied to image synthesis: where aliasing comes from.

pub mod camera;
pub mod defocus;
pub mod gibbs;
pub mod motion;
mod rendered;
pub mod scene_function;
pub mod shear;
pub mod sources;

use crate::figure::Entry;

/// The families of this chapter, in its order.
pub static FAMILIES: &[&[Entry]] = &[
    gibbs::ENTRIES,
    sources::ENTRIES,
    scene_function::ENTRIES,
    shear::ENTRIES,
    defocus::ENTRIES,
    motion::ENTRIES,
    camera::ENTRIES,
];
