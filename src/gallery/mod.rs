//! Figures as files: pictures, data and the index with captions and measured claims.

pub mod data;
pub mod html;
pub mod index;
pub mod markdown;
pub mod report;

use crate::error::Result;
use crate::figure::params::Params;
use crate::figure::{Entry, Figure};
use crate::plot::{Format, Scene, Style, Theme, animated, draw};
use crate::text::Lang;
use std::path::PathBuf;

/// What to make of every figure.
#[derive(Debug, Clone, PartialEq)]
pub struct Options {
    /// The file formats.
    pub formats: Vec<Format>,
    /// The languages of the labels.
    pub langs: Vec<Lang>,
    /// Light or dark.
    pub theme: Theme,
    /// Whether the title stands above the picture.
    pub title: bool,
    /// Whether every layer is also written as CSV and JSON.
    pub data: bool,
    /// Whether figures in motion are also written as animations.
    pub motion: bool,
}

impl Default for Options {
    /// All formats and motion, both languages, light, with titles, without data: what the main job writes.
    fn default() -> Self {
        Self {
            formats: Format::ALL.to_vec(),
            langs: Lang::ALL.to_vec(),
            theme: Theme::Light,
            title: true,
            data: false,
            motion: true,
        }
    }
}

/// How large an animation is: half a slide.
const MOVING: (u32, u32) = (800, 450);

/// A file that is to be written, its path relative to the gallery's folder.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct File {
    /// Where, relative to the gallery.
    pub path: PathBuf,
    /// What.
    pub bytes: Vec<u8>,
}

/// A computed figure with its files.
#[derive(Debug, Clone)]
pub struct Rendered {
    /// Which figure.
    pub entry: &'static Entry,
    /// Its data and claims.
    pub figure: Figure,
    /// Its files.
    pub files: Vec<File>,
}

/// The name of a figure's files: its id, and after an `@` what was set, so that a variant never replaces the figure of
/// the lecture: `f28-leak@T=0.9`.
pub fn stem(id: &str, set: &[(String, String)]) -> String {
    let set: Vec<String> = set.iter().map(|(name, value)| format!("{name}={value}")).collect();
    if set.is_empty() { id.to_owned() } else { format!("{id}@{}", set.join(",")) }
}

/// Computes a figure with the given values and draws it in every language and format asked for.
///
/// # Errors
/// Unknown parameters, values out of range, and whatever the computation reports.
pub fn render(entry: &'static Entry, set: &[(String, String)], options: &Options) -> Result<Rendered> {
    let params = Params::with(entry.params, set.iter().map(|(name, value)| (name.as_str(), value.as_str())))?;
    let figure = (entry.build)(&params)?;
    let stem = stem(entry.id, set);
    let mut files = Vec::new();
    for &lang in &options.langs {
        let style = Style { lang, theme: options.theme, title: options.title, ..Style::default() };
        let scene = draw(entry.title, entry.caption, &figure, &style);
        for &format in &options.formats {
            let path = folder(lang, options.theme).join(format!("{stem}.{}", format.extension()));
            files.push(File { path, bytes: scene.write(format) });
        }
        if let Some(motion) = figure.motion.as_ref().filter(|_| options.motion) {
            let style = Style { size: MOVING, ..style };
            let scenes: Vec<Scene> =
                motion.frames.iter().map(|frame| draw(entry.title, entry.caption, frame, &style)).collect();
            let path = folder(lang, options.theme).join(format!("{stem}.apng"));
            files.push(File { path, bytes: animated(&scenes, motion.rate) });
        }
    }
    if options.data {
        files.extend(data::files(&stem, entry, &figure));
    }
    Ok(Rendered { entry, figure, files })
}

/// The folder of a language and theme: `en`, `ru`, `en-dark`, `ru-dark`.
pub fn folder(lang: Lang, theme: Theme) -> PathBuf {
    match theme {
        Theme::Light => lang.code().into(),
        Theme::Dark => format!("{}-dark", lang.code()).into(),
    }
}
