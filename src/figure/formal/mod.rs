//! The formal part: sampling, the Fourier transform, the comb, copies of the spectrum.

pub mod convolution;
pub mod fourier;
pub mod functions;
pub mod pairs;
pub mod replicas;
pub mod sampling;
pub mod series;

use crate::figure::Entry;

/// The families of this chapter, in its order.
pub static FAMILIES: &[&[Entry]] = &[
    sampling::ENTRIES,
    functions::ENTRIES,
    series::ENTRIES,
    fourier::ENTRIES,
    pairs::ENTRIES,
    convolution::ENTRIES,
    replicas::ENTRIES,
];
