//! The report on a picture: its band, and what another scale would make of it.

mod panels;
mod sections;
pub mod spectrum;

use crate::error::Result;
use crate::figure::report::Report;
use crate::image::Image;
use crate::inspect::picture::found::{Found, found};
use crate::inspect::picture::power::PowerSpectrum;
use crate::inspect::picture::shrinking::{Shrinking, Tolerance};
use crate::inspect::picture::wave::Wave;
use crate::kernel::Kernel;

/// What was looked at, and what was found.
#[derive(Debug, Clone, PartialEq)]
pub struct Checked {
    /// The power spectrum.
    pub spectrum: PowerSpectrum,
    /// What shrinking makes of it, if that was asked.
    pub shrinking: Option<Shrinking>,
    /// What was found where moirés were predicted, in plain decimation and with the [filter](Self::filter).
    pub found: Vec<[Option<Found>; 2]>,
    /// The filter that the report shows beside plain decimation.
    pub filter: String,
    /// In words, numbers and pictures.
    pub report: Report,
}

/// What to look for.
#[derive(Clone, Copy, Default)]
pub struct Question<'a> {
    /// The size to which the picture would be shrunk.
    pub size: Option<[usize; 2]>,
    /// How far aliases must stay below.
    pub tolerance: Tolerance,
    /// The filter that is meant; the best one if none.
    pub filter: Option<&'a dyn Kernel>,
    /// What commands call the file; the name if empty.
    pub file: &'a str,
}

impl std::fmt::Debug for Question<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let filter = self.filter.map(Kernel::name);
        f.debug_struct("Question")
            .field("size", &self.size)
            .field("filter", &filter)
            .field("file", &self.file)
            .finish_non_exhaustive()
    }
}

/// Looks at a picture in linear light; `name` is what the report calls it.
///
/// ```
/// use nyquist::figure::report::picture::{Question, check};
/// use nyquist::prelude::*;
/// let image = Image::of(&Grating::new([0.4, 0.1])?, Grid::pixels(128, 128)?).map(|v| 0.5 + 0.2 * v);
/// let checked = check("stripes.png", &image, Question { size: Some([64, 64]), ..Question::default() })?;
/// let shrinking = checked.shrinking.unwrap();
/// assert_eq!(shrinking.waves.strongest.len(), 1);
/// assert_eq!(checked.report.portrait.figure.panel("spectrum").map(|p| p.layer("pointers").is_some()), Some(true));
/// # Ok::<(), Error>(())
/// ```
///
/// # Errors
/// A size of zero, or of more pixels than a grid can have; a filter of infinite radius, or of a name that
/// [`by_name`](crate::kernel::catalog::by_name) does not know.
pub fn check(name: &str, image: &Image, question: Question<'_>) -> Result<Checked> {
    let spectrum = PowerSpectrum::welch(image);
    let Question { size, tolerance, filter, file } = question;
    let file = if file.is_empty() { name } else { file };
    let shrinking = size.map(|size| Shrinking::with(image, &spectrum, size, tolerance, filter)).transpose()?;
    let shown = match (&shrinking, filter) {
        (_, Some(filter)) => filter.name(),
        (None, None) => String::new(),
        (Some(shrinking), None) => shown(shrinking).to_owned(),
    };
    let small = match &shrinking {
        Some(shrinking) => Some(panels::Small::of(image, shrinking, &shown)?),
        None => None,
    };
    let found = shrinking.as_ref().map_or(Ok(Vec::new()), |shrinking| done(image, shrinking, &shown))?;
    let mut checked = Checked { spectrum, shrinking, found, filter: shown, report: Report::empty() };
    checked.report = Report {
        portrait: panels::portrait(name, image, &checked, small.as_ref())?,
        sections: sections::sections(image, &checked, tolerance, &quoted(file))?,
    };
    Ok(checked)
}

/// A name as a shell reads it: in quotes where it has more than letters, digits and what paths are made of. A backslash parts
/// folders on Windows only; elsewhere a shell would swallow it.
fn quoted(name: &str) -> String {
    let plain = |c: char| c.is_alphanumeric() || "-_./:+,@%".contains(c) || cfg!(windows) && c == '\\';
    if name.chars().all(plain) { name.to_owned() } else { format!("'{}'", name.replace('\'', r"'\''")) }
}

/// The filter to show beside plain decimation: the best one that is a filter, or the cleanest.
fn shown(shrinking: &Shrinking) -> &str {
    let best = shrinking.best().filter(|way| way.name != "none");
    match best {
        Some(way) => &way.name,
        None if shrinking.ways[0].fine => "mitchell",
        None => &shrinking.cleanest().name,
    }
}

/// What was found at the places of all predicted moirés.
fn done(image: &Image, shrinking: &Shrinking, filter: &str) -> Result<Vec<[Option<Found>; 2]>> {
    let waves = shrinking.waves.strongest.iter().enumerate();
    let at = |i: usize, wave: &Wave, name: &str| match shrinking.way(name) {
        Some(way) => found(image, wave, &way.moires[i], shrinking.size, name),
        None => Ok(None),
    };
    waves.map(|(i, wave)| Ok([at(i, wave, "none")?, at(i, wave, filter)?])).collect()
}
