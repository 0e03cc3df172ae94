//! Beyond the lecture's slides: the ids start with `x`, so that they come last.

pub mod bandpass;
pub mod chirp;
pub mod cubics;
pub mod filters;
pub mod generalised;
pub mod irregular;
pub mod truncation;

use crate::figure::Entry;

/// The families of this chapter, in its order.
pub static FAMILIES: &[&[Entry]] = &[
    chirp::ENTRIES,
    filters::ENTRIES,
    truncation::ENTRIES,
    cubics::ENTRIES,
    generalised::ENTRIES,
    bandpass::ENTRIES,
    irregular::ENTRIES,
];
