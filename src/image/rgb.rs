//! A colour image: three planes of linear light.

use crate::error::{Error, Result};
use crate::grid::Grid;
use crate::image::Image;

/// Red, green and blue in linear light, each an [`Image`] on the same grid.
///
/// What is linear (filtering, resizing, transforming) is done plane by plane with [`Rgb::each`].
///
/// ```
/// use nyquist::prelude::*;
/// let grid = Grid::pixels(1, 1)?;
/// let plane = |v: f64| Image::new(grid, vec![v]);
/// let white = Rgb::new([plane(1.0)?, plane(1.0)?, plane(1.0)?])?;
/// assert!((white.luminance().at(0, 0) - 1.0).abs() < 1e-15);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Rgb {
    planes: Box<[Image; 3]>,
}

impl Rgb {
    /// The luminance of the primaries of sRGB, the second row of its matrix to CIE XYZ (IEC 61966-2-1, ITU-R BT.709).
    pub const LUMINANCE: [f64; 3] = [0.2126, 0.7152, 0.0722];

    /// Three planes.
    ///
    /// # Errors
    /// Planes on different grids.
    pub fn new(planes: [Image; 3]) -> Result<Self> {
        let grid = planes[0].grid();
        match planes.iter().find(|p| p.grid() != grid) {
            None => Ok(Self { planes: Box::new(planes) }),
            Some(other) if other.grid().len() == grid.len() => {
                Err(Error::Unsupported("planes of colour on different grids"))
            }
            Some(other) => {
                let what = "the pixels of a plane of colour";
                Err(Error::Length { what, expected: grid.len(), got: other.grid().len() })
            }
        }
    }

    /// Red, green, blue.
    pub fn planes(&self) -> &[Image; 3] {
        &self.planes
    }

    /// Where the pixels are.
    pub fn grid(&self) -> Grid {
        self.planes[0].grid()
    }

    /// What `f` makes of each plane.
    ///
    /// # Errors
    /// What `f` refuses, and planes that it puts on different grids.
    pub fn each(&self, mut f: impl FnMut(&Image) -> Result<Image>) -> Result<Self> {
        let [red, green, blue] = &*self.planes;
        Self::new([f(red)?, f(green)?, f(blue)?])
    }

    /// How bright it is: `0.2126·R + 0.7152·G + 0.0722·B`.
    pub fn luminance(&self) -> Image {
        let [red, green, blue] = self.planes.each_ref().map(Image::pixels);
        let [r, g, b] = Self::LUMINANCE;
        let mut sum = red * r;
        sum.scaled_add(g, green);
        sum.scaled_add(b, blue);
        Image::trusted(self.grid(), sum)
    }
}
