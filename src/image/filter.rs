//! Filters in frequency: low-, high- and band-pass.

use crate::error::{Error, Result, positive};
use crate::image::Image;
use crate::image::dft::{forward, inverse};
use crate::spectrum::low_pass;

/// How a filter goes from one to zero. Every shape has the gain ½ at its cut-off.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Shape {
    /// One below the cut-off, zero above, ½ at it. Rings: its kernel is a Bessel function that falls like `r^{−3/2}`.
    Ideal,
    /// `2^{−(ρ/c)²}`. Never rings; lets through 6 % at twice the cut-off.
    Gaussian,
    /// `1/(1 + (ρ/c)^{2n})` of the given order `n`: between the two, the sharper the higher the order (Butterworth 1930, as
    /// image processing writes it: Gonzalez and Woods, *Digital image processing*).
    Butterworth(u32),
}

/// A filter with a round response: a function of `ρ = √(u² + v²)` alone.
///
/// ```
/// use nyquist::prelude::*;
/// let (low, high) = (Filter::low_pass(0.1, Shape::Gaussian)?, Filter::high_pass(0.1, Shape::Gaussian)?);
/// assert_eq!((low.response(0.06, 0.08), high.response(0.0, 0.0)), (0.5, 0.0));
/// // what one lets through the other keeps back
/// let image = Image::of(&ZonePlate::new(64.0)?, Grid::pixels(32, 32)?);
/// let sum = low.apply(&image).with(&high.apply(&image), |a, b| a + b)?;
/// assert!(image.rmse(&sum)? < 1e-15);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Filter {
    /// Passed below this, infinite for a high-pass.
    below: f64,
    /// Passed above this, zero for a low-pass.
    above: f64,
    shape: Shape,
}

impl Filter {
    /// Passes what is below `cutoff`, in cycles per unit.
    ///
    /// # Errors
    /// A cut-off that is not positive and finite, a Butterworth order of zero.
    pub fn low_pass(cutoff: f64, shape: Shape) -> Result<Self> {
        Self::new(0.0, positive("the cut-off frequency", cutoff)?, shape)
    }

    /// Passes what is above `cutoff`: one minus the low-pass.
    ///
    /// # Errors
    /// A cut-off that is not positive and finite, a Butterworth order of zero.
    pub fn high_pass(cutoff: f64, shape: Shape) -> Result<Self> {
        Self::new(positive("the cut-off frequency", cutoff)?, f64::INFINITY, shape)
    }

    /// Passes what is between `low` and `high`: the difference of the two low-passes, so that low-pass at `low`, this, and
    /// high-pass at `high` add up to everything.
    ///
    /// # Errors
    /// Cut-offs that are not positive and finite, or do not rise; a Butterworth order of zero.
    pub fn band_pass(low: f64, high: f64, shape: Shape) -> Result<Self> {
        positive("the lower cut-off frequency", low)?;
        positive("the higher cut-off frequency", high)?;
        positive("the width of a pass band", high - low)?;
        Self::new(low, high, shape)
    }

    fn new(above: f64, below: f64, shape: Shape) -> Result<Self> {
        if shape == Shape::Butterworth(0) {
            return Err(Error::TooFew { what: "the order of a Butterworth filter", least: 1, got: 0 });
        }
        Ok(Self { below, above, shape })
    }

    /// The gain at the frequency `(u, v)`.
    pub fn response(&self, u: f64, v: f64) -> f64 {
        let rho = u.hypot(v);
        let low = |cutoff: f64| {
            let ratio = rho / cutoff;
            match self.shape {
                Shape::Ideal => low_pass(rho, cutoff),
                Shape::Gaussian => (-ratio * ratio).exp2(),
                Shape::Butterworth(n) => 1.0 / (1.0 + ratio.powf(2.0 * f64::from(n))),
            }
        };
        let passed = if self.below.is_infinite() { 1.0 } else { low(self.below) };
        let stopped = if self.above == 0.0 { 0.0 } else { low(self.above) };
        passed - stopped
    }

    /// The image behind the filter: transformed, weighed, transformed back. The image counts as periodic: what leaves on
    /// one side comes in on the other.
    #[must_use]
    pub fn apply(&self, image: &Image) -> Image {
        inverse(&forward(image).times(|u, v| self.response(u, v).into()))
    }
}
