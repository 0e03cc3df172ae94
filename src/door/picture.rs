//! What a file of an image holds: grey or colour, with or without transparency.

use crate::error::{Error, Result};
use crate::grid::Grid;
use crate::image::{Image, Rgb};

/// Grey, or three primaries.
#[derive(Debug, Clone, PartialEq)]
pub enum Color {
    /// One plane.
    Grey(Image),
    /// Three planes.
    Rgb(Rgb),
}

/// An image as a file holds it: its colours in linear light, not multiplied by its opacity, and that, if it has one.
///
/// ```
/// use nyquist::prelude::*;
/// let grey = Image::of(&Flat::new(0.25)?, Grid::pixels(2, 2)?);
/// let picture = Picture::from(grey.clone());
/// assert_eq!((picture.luminance(), picture.alpha()), (grey, None));
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Picture {
    color: Color,
    alpha: Option<Image>,
}

impl From<Image> for Picture {
    fn from(grey: Image) -> Self {
        Self { color: Color::Grey(grey), alpha: None }
    }
}

impl From<Rgb> for Picture {
    fn from(rgb: Rgb) -> Self {
        Self { color: Color::Rgb(rgb), alpha: None }
    }
}

impl Picture {
    /// The same colours with an opacity between 0 and 1.
    ///
    /// # Errors
    /// Another grid.
    pub fn with_alpha(self, alpha: Image) -> Result<Self> {
        if alpha.grid() != self.grid() {
            let (expected, got) = (self.grid().len(), alpha.grid().len());
            return Err(Error::Length { what: "the pixels of the opacity", expected, got });
        }
        Ok(Self { alpha: Some(alpha), ..self })
    }

    /// Its colours.
    pub fn color(&self) -> &Color {
        &self.color
    }

    /// Its opacity; without one it is opaque.
    pub fn alpha(&self) -> Option<&Image> {
        self.alpha.as_ref()
    }

    /// Where the pixels are.
    pub fn grid(&self) -> Grid {
        match &self.color {
            Color::Grey(grey) => grey.grid(),
            Color::Rgb(rgb) => rgb.grid(),
        }
    }

    /// How bright the colours are, whatever the opacity.
    pub fn luminance(&self) -> Image {
        match &self.color {
            Color::Grey(grey) => grey.clone(),
            Color::Rgb(rgb) => rgb.luminance(),
        }
    }

    /// What a linear operation makes of the picture: resizing, filtering, convolving.
    ///
    /// Colours are weighed by their opacity first, `f(c·α)/f(α)`, so that the invisible colour of a transparent pixel does
    /// not leak into its neighbours. Where nothing is left of the opacity the colour is black.
    ///
    /// ```
    /// use nyquist::prelude::*;
    /// use nyquist::image::resize::resize;
    /// // a white pixel beside a transparent one whose colour is black: white, half transparent, and not grey
    /// let plane = |values| Image::new(Grid::pixels(2, 1)?, values);
    /// let picture = Picture::from(plane(vec![1.0, 0.0])?).with_alpha(plane(vec![1.0, 0.0])?)?;
    /// let small = picture.each(|image| resize(image, 1, 1, &BoxKernel, Edge::Clamp))?;
    /// assert_eq!((small.luminance().at(0, 0), small.alpha().map(|alpha| alpha.at(0, 0))), (1.0, Some(0.5)));
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    /// What `f` refuses, and planes that it makes of different sizes.
    pub fn each(&self, mut f: impl FnMut(&Image) -> Result<Image>) -> Result<Self> {
        let Some(alpha) = &self.alpha else {
            return self.colors(f);
        };
        let opacity = f(alpha)?;
        let weighed = |plane: &Image| {
            let sum = f(&plane.with(alpha, |c, a| c * a)?)?;
            sum.with(&opacity, |c, a| if a == 0.0 { 0.0 } else { c / a })
        };
        self.colors(weighed)?.with_alpha(opacity)
    }

    /// `f` of every plane of colour.
    fn colors(&self, mut f: impl FnMut(&Image) -> Result<Image>) -> Result<Self> {
        match &self.color {
            Color::Grey(grey) => f(grey).map(Self::from),
            Color::Rgb(rgb) => rgb.each(f).map(Self::from),
        }
    }

    /// The picture in front of a background: `c·α + background·(1 − α)`, opaque.
    #[must_use]
    pub fn over(&self, background: f64) -> Self {
        let Some(alpha) = &self.alpha else { return self.clone() };
        self.colors(|plane| plane.with(alpha, |c, a| c * a + background * (1.0 - a)))
            .expect("its planes and its opacity have one size")
    }
}
