//! Ways against aliasing: prefiltering, uniform and stochastic supersampling, adaptive sampling.

pub mod adaptive;
pub mod chart;
pub mod jitter;
pub mod prefilter;
pub mod stochastic;
pub mod supersample;

use crate::figure::Entry;

/// The families of this chapter, in its order.
pub static FAMILIES: &[&[Entry]] = &[
    chart::ENTRIES,
    prefilter::ENTRIES,
    supersample::ENTRIES,
    stochastic::ENTRIES,
    jitter::ENTRIES,
    adaptive::ENTRIES,
];
