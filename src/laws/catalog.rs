//! All laws, in the order of the lecture.

use crate::error::{Result, unknown};
use crate::laws::{
    Law, alias, coverage, cubics, discrepancy, frames, generalised, gibbs, hold, integration, jitter, kernels,
    lattices, metrics, plane, point_spectra, poisson, spacing, theorems, truncation, variance,
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
    plane::LAWS,
    lattices::LAWS,
    coverage::LAWS,
];

/// All laws.
pub fn all() -> impl Iterator<Item = &'static Law> {
    THEMES.iter().copied().flatten()
}

/// The law of that name, or the one that states that result of the inventory.
///
/// # Errors
/// An unknown name; the known ones stand in the error, nearest first.
pub fn by_name(name: &str) -> Result<&'static Law> {
    all()
        .find(|law| law.name == name || law.inventory.contains(&name))
        .ok_or_else(|| unknown("law", name, all().map(|law| law.name)))
}
