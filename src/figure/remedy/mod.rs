//! Ways against aliasing: prefiltering, uniform and stochastic supersampling, adaptive sampling.

pub mod adaptive;
pub mod chart;
pub mod jitter;
pub mod prefilter;
pub mod random;
pub mod regular;
mod stochastic;
pub mod supersample;

use crate::figure::Entry;

/// The families of this chapter, in its order.
pub static FAMILIES: &[&[Entry]] = &[
    chart::ENTRIES,
    prefilter::ENTRIES,
    supersample::ENTRIES,
    regular::ENTRIES,
    random::ENTRIES,
    jitter::ENTRIES,
    adaptive::ENTRIES,
];
