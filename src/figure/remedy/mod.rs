//! Ways against aliasing: prefiltering, uniform and stochastic supersampling, adaptive sampling.

pub mod adaptive;
pub mod application;
mod board;
pub mod chart;
pub mod checkerboard;
pub mod checkerboard_noise;
pub mod checkerboard_rays;
pub mod jitter;
pub mod pixel;
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
    pixel::ENTRIES,
    regular::ENTRIES,
    random::ENTRIES,
    jitter::ENTRIES,
    checkerboard::ENTRIES,
    checkerboard_noise::ENTRIES,
    checkerboard_rays::ENTRIES,
    application::ENTRIES,
    adaptive::ENTRIES,
];
