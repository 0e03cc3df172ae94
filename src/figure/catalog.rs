//! All figures, in the order of the lecture.

use crate::error::{Result, unknown};
use crate::figure::further::{bandpass, chirp, cubics, filters, generalised, irregular, truncation};
use crate::figure::{
    Entry, adaptive, aliasing, cardinal, choice, convolution, display, film, folding, formal, fourier, gibbs, jitter,
    low_pass, overview, pairs, prefilter, problem, remedies, replicas, sampling, series, sources, stochastic,
    supersample, theorem,
};

/// The families, each with its entries.
static FAMILIES: &[&[Entry]] = &[
    display::ENTRIES,
    problem::ENTRIES,
    sampling::ENTRIES,
    folding::ENTRIES,
    formal::ENTRIES,
    series::ENTRIES,
    fourier::ENTRIES,
    pairs::ENTRIES,
    convolution::ENTRIES,
    replicas::ENTRIES,
    low_pass::ENTRIES,
    aliasing::ENTRIES,
    stochastic::ENTRIES,
    jitter::ENTRIES,
    adaptive::ENTRIES,
    gibbs::ENTRIES,
    sources::ENTRIES,
    cardinal::ENTRIES,
    overview::ENTRIES,
    theorem::ENTRIES,
    remedies::ENTRIES,
    film::ENTRIES,
    choice::ENTRIES,
    prefilter::ENTRIES,
    supersample::ENTRIES,
    chirp::ENTRIES,
    filters::ENTRIES,
    truncation::ENTRIES,
    cubics::ENTRIES,
    generalised::ENTRIES,
    bandpass::ENTRIES,
    irregular::ENTRIES,
];

/// All figures, sorted by their ids: `f02-…` first, what goes beyond the lecture (`x…`) last.
pub fn all() -> Vec<&'static Entry> {
    let mut entries: Vec<&Entry> = FAMILIES.iter().copied().flatten().collect();
    entries.sort_by_key(|entry| entry.id);
    entries
}

/// The figure of that id, or the first that covers that entry of the lecture's inventory (`F28`).
///
/// # Errors
/// An unknown name; the known ones stand in the error, nearest first.
pub fn by_name(name: &str) -> Result<&'static Entry> {
    let found = all().into_iter().find(|entry| entry.id == name || entry.inventory.contains(&name));
    found.ok_or_else(|| unknown("figure", name, all().iter().map(|entry| entry.id)))
}
