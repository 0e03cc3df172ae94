//! The box.

use crate::error::{Result, positive};
use crate::num::sinc;
use crate::signal::{FourierPair, Signal};
use crate::spectrum::Spectrum;

/// The box of height 1: `f(x) = 1` for `|x| < w/2`, ½ at the edges, 0 beyond ↔ `F(ν) = w·sinc(wν)`.
///
/// First row of the lecture's table of pairs. Not band-limited: the spectrum decays like `1/ν`, with a first side lobe
/// 13.26 dB under the peak.
///
/// ```
/// use nyquist::prelude::*;
/// let unit = Boxcar::new(1.0)?;
/// assert_eq!((unit.at(0.0), unit.at(0.5), unit.at(0.6)), (1.0, 0.5, 0.0));
/// assert_eq!(unit.spectrum().density(3.0).re, 0.0); // zeros at all nonzero integers
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Boxcar {
    width: f64,
}

impl Boxcar {
    /// A box of that full width, centred at zero.
    ///
    /// # Errors
    /// A width that is not positive and finite.
    pub fn new(width: f64) -> Result<Self> {
        Ok(Self { width: positive("the width of a box", width)? })
    }
}

impl Signal for Boxcar {
    fn at(&self, x: f64) -> f64 {
        crate::spectrum::low_pass(x, 0.5 * self.width)
    }
}

impl FourierPair for Boxcar {
    fn spectrum(&self) -> Spectrum {
        let w = self.width;
        Spectrum::decaying(f64::INFINITY, move |nu| (w * sinc(w * nu)).into())
    }
}
