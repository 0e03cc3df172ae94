//! All figures, in the order of the lecture.

use crate::error::{Result, unknown};
use crate::figure::{
    Entry, alias, film, formal, further, images, patterns, problem, reconstruction, remedy, synthesis,
};

/// The chapters, each with its families.
static CHAPTERS: &[&[&[Entry]]] = &[
    problem::FAMILIES,
    formal::FAMILIES,
    reconstruction::FAMILIES,
    alias::FAMILIES,
    remedy::FAMILIES,
    images::FAMILIES,
    synthesis::FAMILIES,
    patterns::FAMILIES,
    film::FAMILIES,
    further::FAMILIES,
];

/// All figures, sorted by their ids: `f02-…` first, what goes beyond the lecture (`x…`) last.
pub fn all() -> Vec<&'static Entry> {
    let mut entries: Vec<&Entry> = CHAPTERS.iter().copied().flatten().copied().flatten().collect();
    entries.sort_by_key(|entry| entry.id);
    entries
}

/// The figure of that id, or all that cover that entry of the lecture's inventory (`F28`).
///
/// # Errors
/// An unknown name; the known ones stand in the error, nearest first.
pub fn matching(name: &str) -> Result<Vec<&'static Entry>> {
    let found: Vec<_> = all().into_iter().filter(|entry| entry.id == name || entry.inventory.contains(&name)).collect();
    if found.is_empty() { Err(unknown("figure", name, all().iter().map(|entry| entry.id))) } else { Ok(found) }
}

/// The figure of that id, or the first that covers that entry of the lecture's inventory (`F28`).
///
/// # Errors
/// An unknown name; the known ones stand in the error, nearest first.
pub fn by_name(name: &str) -> Result<&'static Entry> {
    Ok(matching(name)?[0])
}
