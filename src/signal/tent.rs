//! The tent.

use crate::error::{Result, positive};
use crate::num::sinc;
use crate::signal::{FourierPair, Signal};
use crate::spectrum::Spectrum;

/// The tent of height 1: `f(x) = max(0, 1 − |x|/w)` ↔ `F(ν) = w·sinc²(wν)`.
///
/// The convolution of the box of width `w` with itself, divided by `w`: hence the square.
///
/// ```
/// use nyquist::prelude::*;
/// let tent = Tent::new(2.0)?;
/// assert_eq!((tent.at(0.0), tent.at(1.0), tent.at(2.0)), (1.0, 0.5, 0.0));
/// assert_eq!(tent.spectrum().density(0.0).re, 2.0); // the area
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tent {
    half_width: f64,
}

impl Tent {
    /// A tent that reaches from `−half_width` to `half_width`.
    ///
    /// # Errors
    /// A width that is not positive and finite.
    pub fn new(half_width: f64) -> Result<Self> {
        Ok(Self { half_width: positive("the half-width of a tent", half_width)? })
    }
}

impl Signal for Tent {
    fn at(&self, x: f64) -> f64 {
        (1.0 - x.abs() / self.half_width).max(0.0)
    }
}

impl FourierPair for Tent {
    fn spectrum(&self) -> Spectrum {
        let w = self.half_width;
        Spectrum::decaying(f64::INFINITY, move |nu| (w * sinc(w * nu).powi(2)).into())
    }
}
