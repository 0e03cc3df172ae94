//! Images of one size to another one, again and again: [`resize`](crate::image::resize::resize) by the engine.

use crate::axis::Edge;
use crate::engine::Arithmetic;
use crate::engine::resize::{Resizer, View, ViewMut};
use crate::error::{Error, Result};
use crate::grid::Grid;
use crate::image::Image;
use crate::image::resize::over;
use crate::image::weights::Weights;
use crate::kernel::Kernel;

/// A resizing by a kernel, planned once for all images on one grid (planes of colour, frames of a film).
///
/// What [`resize`](crate::image::resize::resize) does with the same weights, by the [engine](crate::engine::resize): many
/// times faster, with the same bits on every processor and any number of threads. The two differ by rounding: sums here are
/// plain, so that a constant stays itself to `(n + m + 4)ε·Σ|w|`, `n` and `m` the numbers of weights along the axes, and not
/// to the last bit.
///
/// ```
/// use nyquist::prelude::*;
/// use nyquist::image::resize::resize;
/// use nyquist::image::resizing::Resizing;
/// let image = Image::of(&ZonePlate::new(0.01)?, Grid::pixels(60, 40)?);
/// let half = Resizing::new(image.grid(), [30, 20], &Cubic::mitchell(), Edge::Mirror)?;
/// let slowly = resize(&image, 30, 20, &Cubic::mitchell(), Edge::Mirror)?;
/// assert!(half.apply(&image)?.rmse(&slowly)? < 20.0 * f64::EPSILON); // eight weights an axis
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug)]
pub struct Resizing {
    from: Grid,
    to: Grid,
    resizer: Resizer<f64>,
}

impl Resizing {
    /// To another width and height over the same rectangle.
    ///
    /// # Errors
    /// A width or height of zero, more than [`Grid::MOST`] pixels, a kernel of infinite radius, more than 2²⁸ weights along
    /// one axis.
    pub fn new(from: Grid, [width, height]: [usize; 2], kernel: &dyn Kernel, edge: Edge) -> Result<Self> {
        let to = over(from, width, height)?;
        let across = Weights::of(from.x(), to.x(), kernel)?.taps(edge)?;
        let down = Weights::of(from.y(), to.y(), kernel)?.taps(edge)?;
        Ok(Self { from, to, resizer: Resizer::new(across, down, Arithmetic::Plain) })
    }

    /// The image at the new size.
    ///
    /// # Errors
    /// An image on another grid.
    pub fn apply(&self, image: &Image) -> Result<Image> {
        if image.grid() != self.from {
            return Err(Error::Unsupported("resizing an image on another grid than planned"));
        }
        let [old, new] = [self.from, self.to].map(|grid| [grid.width(), grid.height()]);
        let mut values = vec![0.0; self.to.len()];
        let pixels = image.values();
        self.resizer.run(View::new(pixels, old, 1, old[0])?, ViewMut::new(&mut values, new, 1, new[0])?)?;
        Image::new(self.to, values)
    }
}
