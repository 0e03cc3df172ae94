//! Sample patterns of the plane, their spectra and their measures (slides from «Стохастический суперсэмплинг» to «Другие
//! методы сэмплирования»).

pub mod blue_noise;
pub mod convergence;
pub mod discrepancy;
pub mod elementary;
pub mod gallery;
pub mod groups;
pub mod jitter_poisson;
pub mod low_discrepancy;
pub mod plane;
pub mod portrait;
mod square;
pub mod stratified;
pub mod worst;

use crate::figure::Entry;

/// The families of this chapter, in its order.
pub static FAMILIES: &[&[Entry]] = &[
    plane::ENTRIES,
    stratified::ENTRIES,
    groups::ENTRIES,
    gallery::ENTRIES,
    low_discrepancy::ENTRIES,
    elementary::ENTRIES,
    worst::ENTRIES,
    blue_noise::ENTRIES,
    jitter_poisson::ENTRIES,
    convergence::ENTRIES,
    discrepancy::ENTRIES,
];
