//! A field, made larger or smaller along its axes.

use crate::error::{Result, positive};
use crate::field::spectrum::PlaneSpectrum;
use crate::field::{ExactMean, Field, FourierField};
use std::sync::Arc;

/// `f(x/a, y/b)` ↔ `ab·F(au, bv)`: what is wide in space is narrow in frequency, each axis on its own. Exact means stay
/// exact, lines move and keep their weight.
///
/// ```
/// use nyquist::prelude::*;
/// let zoomed = Zoomed::new([4.0, 1.0], GaussianSpot::round(1.0)?)?;
/// let same = GaussianSpot::new([4.0, 1.0])?;
/// assert_eq!(zoomed.at(3.0, 0.5), same.at(3.0, 0.5));
/// assert_eq!(zoomed.mean([0.0, 1.0], [0.0, 1.0]), same.mean([0.0, 1.0], [0.0, 1.0]));
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Zoomed<F> {
    by: [f64; 2],
    field: F,
}

impl<F> Zoomed<F> {
    /// The field made `by[0]` times as wide and `by[1]` times as high.
    ///
    /// # Errors
    /// A factor that is not positive and finite.
    pub fn new(by: [f64; 2], field: F) -> Result<Self> {
        for factor in by {
            positive("a zoom", factor)?;
        }
        Ok(Self { by, field })
    }
}

impl<F: Field> Field for Zoomed<F> {
    fn at(&self, x: f64, y: f64) -> f64 {
        self.field.at(x / self.by[0], y / self.by[1])
    }
}

impl<F: ExactMean> ExactMean for Zoomed<F> {
    fn mean(&self, x: [f64; 2], y: [f64; 2]) -> f64 {
        self.field.mean(x.map(|x| x / self.by[0]), y.map(|y| y / self.by[1]))
    }
}

impl<F: FourierField> FourierField for Zoomed<F> {
    fn spectrum(&self) -> PlaneSpectrum {
        let [a, b] = self.by;
        let wide = Arc::new(move |[u, v]: [f64; 2]| [a * u, b * v]);
        let narrow = Arc::new(move |[u, v]: [f64; 2]| [u / a, v / b]);
        self.field.spectrum().mapped(wide, narrow, a * b)
    }
}
