//! Images as panels.

use crate::axis::Axis;
use crate::error::Result;
use crate::figure::common::unmarked;
use crate::figure::{Layer, Meaning, Panel, Tones};
use crate::grid::Grid;
use crate::image::{Image, Rgb};
use crate::text::Text;
use std::ops::Range;

/// An image in linear light from black, 0, to white, 1, without scales and upright: the first row on top.
///
/// ```
/// use nyquist::figure::picture::{picture, upward};
/// use nyquist::prelude::*;
/// use nyquist::text::Text;
/// let panel = picture("ramp", Text::EMPTY, &Image::of(&field_fn(|x, _| 0.25 * x), Grid::pixels(4, 2)?));
/// assert_eq!((panel.x.range, panel.y.range), ((0.0, 4.0), (2.0, 0.0)));
/// assert_eq!(upward(panel).y.range, (0.0, 2.0));
/// # Ok::<(), Error>(())
/// ```
pub fn picture(name: &'static str, title: Text, image: &Image) -> Panel {
    grey(name, title, image, (0.0, 1.0))
}

/// The same from black at the start of `range` to white at its end.
pub fn grey(name: &'static str, title: Text, image: &Image, range: (f64, f64)) -> Panel {
    tones(name, title, image, range, Tones::Grey)
}

/// The values of an image in tones, the first at the start of `range` and the last at its end; otherwise as [`picture`].
pub fn tones(name: &'static str, title: Text, image: &Image, range: (f64, f64), tones: Tones) -> Panel {
    let (x, y) = (extent(image.grid().x()), extent(image.grid().y()));
    let panel = Panel::new(name, title, unmarked(x.0, x.1), unmarked(y.1, y.0)).square();
    panel.with(Layer::raster("pixels", x, y, image.pixels().clone(), range, tones))
}

/// A picture in colours, otherwise as [`picture`].
pub fn colors(name: &'static str, title: Text, picture: &Rgb) -> Panel {
    let (x, y) = (extent(picture.grid().x()), extent(picture.grid().y()));
    let panel = Panel::new(name, title, unmarked(x.0, x.1), unmarked(y.1, y.0)).square();
    panel.with(Layer::colors("pixels", x, y, picture))
}

/// The same panel turned upside down: `y` points up, as in formulas.
#[must_use]
pub fn upward(mut panel: Panel) -> Panel {
    panel.y.range = (panel.y.range.1, panel.y.range.0);
    panel
}

/// From where to where the pixels of an axis reach: half a step beyond the outermost middles.
pub fn extent(axis: Axis) -> (f64, f64) {
    let start = axis.start() - 0.5 * axis.step();
    (start, start + axis.span())
}

/// Some columns and rows of an image, where they were.
///
/// # Errors
/// None of them.
///
/// # Panics
/// If the image has fewer.
pub fn part(image: &Image, columns: Range<usize>, rows: Range<usize>) -> Result<Image> {
    let along = |axis: Axis, range: &Range<usize>| Axis::new(axis.at(range.start as i64), axis.step(), range.len());
    let grid = Grid::new(along(image.grid().x(), &columns)?, along(image.grid().y(), &rows)?)?;
    let places = rows.flat_map(|j| columns.clone().map(move |i| (i, j)));
    Image::new(grid, places.map(|(i, j)| image.at(i, j)).collect())
}

/// The outline of a rectangle.
pub fn frame(name: &'static str, meaning: Meaning, [x0, x1]: [f64; 2], [y0, y1]: [f64; 2]) -> Layer {
    Layer::line(name, meaning, [[x0, y0], [x1, y0], [x1, y1], [x0, y1], [x0, y0]])
}

/// Circles as one line.
pub fn circles(name: &'static str, meaning: Meaning, radius: f64, centers: &[[f64; 2]]) -> Layer {
    let around = |[x, y]: [f64; 2]| {
        let turn = (0..=SIDES).map(move |i| std::f64::consts::TAU * f64::from(i) / f64::from(SIDES));
        turn.map(move |t| [x + radius * t.cos(), y + radius * t.sin()]).chain([[f64::NAN; 2]])
    };
    Layer::line(name, meaning, centers.iter().copied().flat_map(around))
}

/// How many straight pieces a drawn circle has: at a radius of 50 pixels it is off by a tenth of one.
const SIDES: i32 = 48;
