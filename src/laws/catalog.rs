//! All laws, in the order of the lecture.

use crate::error::{Result, unknown};
use crate::laws::{
    Law, alias, coverage, cubics, discrepancy, film, frames, generalised, gibbs, hold, integration, jitter, kernels,
    lattices, metrics, nonuniform, plane, point_spectra, poisson, scene, spacing, theorems, truncation, variance,
};

/// The themes, each with its laws.
static THEMES: &[&[Law]] = &[
    theorems::LAWS,
    poisson::LAWS,
    alias::LAWS,
    gibbs::LAWS,
    truncation::LAWS,
    kernels::LAWS,
    cubics::LAWS,
    metrics::LAWS,
    hold::LAWS,
    jitter::LAWS,
    integration::LAWS,
    point_spectra::LAWS,
    discrepancy::LAWS,
    spacing::LAWS,
    variance::LAWS,
    generalised::LAWS,
    frames::LAWS,
    nonuniform::LAWS,
    plane::LAWS,
    lattices::LAWS,
    coverage::LAWS,
    film::LAWS,
    scene::LAWS,
];

/// All laws.
pub fn all() -> impl Iterator<Item = &'static Law> {
    THEMES.iter().copied().flatten()
}

/// The law of that name, or all that state that result of the inventory (`V31`).
///
/// # Errors
/// An unknown name; the known ones stand in the error, nearest first.
pub fn matching(name: &str) -> Result<Vec<&'static Law>> {
    let found: Vec<_> = all().filter(|law| law.name == name || law.inventory.contains(&name)).collect();
    if found.is_empty() { Err(unknown("law", name, all().map(|law| law.name))) } else { Ok(found) }
}
