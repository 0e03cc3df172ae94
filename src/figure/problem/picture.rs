//! Images as panels.

use crate::figure::common::unmarked;
use crate::figure::{Layer, Meaning, Panel, Tones};
use crate::image::Image;
use crate::text::Text;

/// An image in linear light from black, 0, to white, 1, upright: the first row on top.
pub(super) fn picture(name: &'static str, title: Text, image: &Image) -> Panel {
    let [[x0, y0], [x1, y1]] = corners(image);
    Panel::new(name, title, unmarked(x0, x1), unmarked(y1, y0)).square().with(pixels(image))
}

/// An image as a layer over the rectangle that its pixels cover.
pub(super) fn pixels(image: &Image) -> Layer {
    let [[x0, y0], [x1, y1]] = corners(image);
    Layer::raster("pixels", (x0, x1), (y0, y1), image.pixels().clone(), (0.0, 1.0), Tones::Grey)
}

/// Its first and its last corner.
fn corners(image: &Image) -> [[f64; 2]; 2] {
    let grid = image.grid();
    let [[x0, _], [y0, _]] = grid.cell(0, 0);
    let [[_, x1], [_, y1]] = grid.cell(grid.width() as i64 - 1, grid.height() as i64 - 1);
    [[x0, y0], [x1, y1]]
}

/// Circles as one line.
pub(super) fn circles(name: &'static str, meaning: Meaning, radius: f64, centers: &[[f64; 2]]) -> Layer {
    let around = |[x, y]: [f64; 2]| {
        let turn = (0..=SIDES).map(move |i| std::f64::consts::TAU * f64::from(i) / f64::from(SIDES));
        turn.map(move |t| [x + radius * t.cos(), y + radius * t.sin()]).chain([[f64::NAN; 2]])
    };
    Layer::line(name, meaning, centers.iter().copied().flat_map(around))
}

/// How many straight pieces a drawn circle has: at a radius of 50 pixels it is off by a tenth of one.
const SIDES: i32 = 48;

/// The outline of a rectangle.
pub(super) fn frame(name: &'static str, meaning: Meaning, [x0, x1]: [f64; 2], [y0, y1]: [f64; 2]) -> Layer {
    Layer::line(name, meaning, [[x0, y0], [x1, y0], [x1, y1], [x0, y1], [x0, y0]])
}
