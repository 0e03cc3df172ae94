//! Which way up a camera was held.

use crate::door::picture::Picture;
use crate::error::Result;
use crate::grid::Grid;
use crate::image::Image;

/// The picture turned and mirrored so that it stands upright.
pub(super) fn turned(picture: Picture, orientation: u16) -> Result<Picture> {
    if orientation == 1 {
        return Ok(picture);
    }
    picture.each(|image| {
        let (w, h) = (image.width(), image.height());
        let lies = orientation >= 5;
        let grid = if lies { Grid::pixels(h, w)? } else { image.grid() };
        // where the upright pixel (x, y) is in the file: TIFF 6.0, "Orientation"
        let source = |x: usize, y: usize| match orientation {
            2 => (w - 1 - x, y),
            3 => (w - 1 - x, h - 1 - y),
            4 => (x, h - 1 - y),
            5 => (y, x),
            6 => (y, h - 1 - x),
            7 => (w - 1 - y, h - 1 - x),
            8 => (w - 1 - y, x),
            _ => (x, y),
        };
        let places = (0..grid.height()).flat_map(|y| (0..grid.width()).map(move |x| (x, y)));
        let values = places.map(|(x, y)| {
            let (i, j) = source(x, y);
            image.at(i, j)
        });
        Image::new(grid, values.collect())
    })
}
