//! Figures drawn: the only place that knows plotters.
//!
//! A figure's data become one picture, a [`Scene`], drawn once through plotters on a backend of our own; SVG, PNG and
//! PDF are written from that one scene, so that they are the same picture. Nothing outside the program takes part: the
//! letters are the embedded DejaVu fonts, drawn as outlines. Equal figures give equal bytes.
//!
//! What the drawing decides, so that figures need not:
//!
//! - Letters have 26 units with one or two panels, 18 with ten and more, on a slide of 1600 × 900. Ticks are thinned
//!   until their numbers have room; titles and labels that are too long shrink to 18 units, then break at spaces.
//! - Plots of a column share their margins, and so do those of a row; pictures take what room there is.
//! - Rows of panels over others of the same horizontal scales leave the numbers to the lowest.
//! - A legend stands in the corner that its panel names; if it would hide data there, in a free corner; if there is
//!   none, above the plot. Layers of one label share an entry.
//! - Lines are cut at the frame. Dots beyond it are left out; on it they are whole. Notes are moved into their panel.
//! - A panel that says what its tones stand for has a bar with numbers to its right.
//! - Pictures of a row stand level. Cells of a raster are whole units: a plot shrinks to the next multiple of its raster.
//!   A raster fits well where a multiple of its cells is about the room of a square plot: 640 units in one row of one or
//!   two columns, 400 in three, 300 in four, 290 in two rows. Cells below a unit are averaged in linear light.
//!
//! ```
//! use nyquist::figure::{Figure, Layer, Meaning, Panel, Scale};
//! use nyquist::plot::{Style, draw};
//! use nyquist::text::Text;
//! let (x, y) = (Scale::linear(Text::same("x"), -4.0, 4.0), Scale::linear(Text::same("sinc x"), -0.4, 1.1));
//! let sinc = Layer::curve("sinc", Meaning::Signal, -4.0, 4.0, 400, nyquist::num::sinc);
//! let figure = Figure::new(1).with(Panel::new("sinc", Text::EMPTY, x, y).with(sinc));
//! let scene = draw(&Text::same("sinc"), &Text::EMPTY, &figure, &Style::default());
//! assert!(scene.svg().starts_with("<svg"));
//! assert_eq!(&scene.png()[1..4], b"PNG");
//! assert_eq!(&scene.pdf()[..5], b"%PDF-");
//! ```

mod apng;
mod bar;
mod canvas;
mod chart;
mod elements;
mod layout;
mod legend;
mod look;
mod marks;
mod palette;
mod pdf;
mod png;
mod raster;
mod ruler;
mod scene;
mod stroke;
mod svg;
mod typeset;

pub use apng::animated;
pub use palette::{Rgb, Theme};
pub use scene::{Label, Scene};

use crate::error::{Error, Result, unknown};
use crate::figure::Figure;
use crate::text::{Lang, Text, plain};
use canvas::Canvas;
use chart::{Frame, Sheet};
use layout::{Fitted, placed};
use look::Sizes;
use plotters::drawing::{DrawingAreaErrorKind, IntoDrawingArea};
use std::convert::Infallible;
use std::str::FromStr;
use typeset::{Face, LEADING};

/// Why plotters stopped; on a canvas in memory it never does.
type Failure = DrawingAreaErrorKind<Infallible>;

/// What a scene can be written as.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Format {
    /// Scalable Vector Graphics, for the web and for slides.
    Svg,
    /// Portable Network Graphics: pixels.
    Png,
    /// Portable Document Format, for LaTeX and for paper.
    Pdf,
}

impl Format {
    /// All three.
    pub const ALL: [Self; 3] = [Self::Svg, Self::Png, Self::Pdf];

    /// Its name, which is also the extension of its files: `svg`, `png`, `pdf`.
    pub fn extension(self) -> &'static str {
        match self {
            Self::Svg => "svg",
            Self::Png => "png",
            Self::Pdf => "pdf",
        }
    }
}

/// Reads a format's name, in letters of any case.
impl FromStr for Format {
    type Err = Error;

    fn from_str(name: &str) -> Result<Self> {
        let found = Self::ALL.into_iter().find(|f| f.extension().eq_ignore_ascii_case(name));
        found.ok_or_else(|| unknown("format", name, Self::ALL.map(Self::extension)))
    }
}

/// Reads a theme's name, in letters of any case.
impl FromStr for Theme {
    type Err = Error;

    fn from_str(name: &str) -> Result<Self> {
        let found = Self::ALL.into_iter().find(|t| t.name().eq_ignore_ascii_case(name));
        found.ok_or_else(|| unknown("theme", name, Self::ALL.map(Self::name)))
    }
}

/// How figures are drawn.
#[derive(Debug, Clone, PartialEq)]
pub struct Style {
    /// The language of everything that is read.
    pub lang: Lang,
    /// Dark on light or light on dark.
    pub theme: Theme,
    /// Width and height in units, at least 320 × 180: a slide of 16:9 is 1600 × 900. Letters and lines grow with it.
    pub size: (u32, u32),
    /// Whether the title stands above the panels.
    pub title: bool,
    /// Pixels of a PNG to the unit, from 0.1 to 8.
    pub scale: f64,
}

impl Default for Style {
    /// An English slide, light, 1600 × 900, with its title.
    fn default() -> Self {
        Self { lang: Lang::En, theme: Theme::Light, size: (1600, 900), title: true, scale: 1.0 }
    }
}

/// Draws a figure. `title` stands above it where the style wants that; `caption` becomes the description that screen
/// readers read.
///
/// Every figure can be drawn: what lies outside the scales is cut off at the frame, values that are not finite are left
/// out.
pub fn draw(title: &Text, caption: &Text, figure: &Figure, style: &Style) -> Scene {
    let size = (style.size.0.clamp(320, 16_000), style.size.1.clamp(180, 16_000));
    let scale = if style.scale.is_finite() { style.scale.clamp(0.1, 8.0) } else { 1.0 };
    let canvas = Canvas::new(Scene {
        size,
        scale,
        lang: style.lang,
        title: plain(title.get(style.lang)),
        about: plain(caption.get(style.lang)),
        paper: style.theme.paper(),
        clips: Vec::new(),
        ops: Vec::new(),
    });
    paint(&canvas, title.get(style.lang), figure, style, size).expect("drawing into memory cannot fail");
    canvas.finish()
}

fn paint(
    canvas: &Canvas,
    title: &str,
    figure: &Figure,
    style: &Style,
    size: (u32, u32),
) -> std::result::Result<(), Failure> {
    let sizes = Sizes::new(size, figure.panels.len());
    let root = canvas.clone().into_drawing_area();

    let sheet = Sheet { root: &root, canvas, theme: style.theme, lang: style.lang, sizes: &sizes };
    let (width, height) = (f64::from(size.0), f64::from(size.1));
    let edge = 30.0 * sizes.one;
    let mut page = Frame { left: edge, top: 0.8 * edge, right: width - edge, bottom: height - 0.7 * edge };
    if style.title && !title.is_empty() {
        let (text, size) = typeset::fit(title, Face::Bold, sizes.title, 0.75 * sizes.title, page.width());
        let title = Fitted { text, size };
        sheet.headline(&title, (0.5 * width, page.top))?;
        page.top += title.height() + 0.2 * LEADING * sizes.body;
    }
    for panel in placed(figure, page, &sizes, style.lang) {
        sheet.panel(&panel)?;
    }
    Ok(())
}

impl Scene {
    /// The scene in one of the formats.
    pub fn write(&self, format: Format) -> Vec<u8> {
        match format {
            Format::Svg => self.svg().into_bytes(),
            Format::Png => self.png(),
            Format::Pdf => self.pdf(),
        }
    }
}
