//! The dual of the convolution theorem.

use crate::error::Result;
use crate::signal::{FourierPair, Signal};
use crate::spectrum::Spectrum;

/// `f·g` ↔ `F ⊗ G`: sampling is this theorem with the comb for `g`.
///
/// The spectrum is exact where one factor consists of lines, else a quadrature at every frequency (see
/// [`Spectrum::convolved`]).
///
/// ```
/// use nyquist::prelude::*;
/// let beat = Product::new(Cosine::new(3.0)?, Cosine::new(2.0)?)?;
/// assert_eq!(beat.spectrum().lines().iter().map(|l| l.at).collect::<Vec<_>>(), [-5.0, -1.0, 1.0, 5.0]);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Product<F, G> {
    f: F,
    g: G,
    spectrum: Spectrum,
}

impl<F: FourierPair, G: FourierPair> Product<F, G> {
    /// `f·g`.
    ///
    /// # Errors
    /// Two densities that both decay algebraically: their convolution is not computed.
    pub fn new(f: F, g: G) -> Result<Self> {
        let spectrum = f.spectrum().convolved(&g.spectrum())?;
        Ok(Self { f, g, spectrum })
    }
}

impl<F: Signal, G: Signal> Signal for Product<F, G> {
    fn at(&self, x: f64) -> f64 {
        self.f.at(x) * self.g.at(x)
    }
}

impl<F: FourierPair, G: FourierPair> FourierPair for Product<F, G> {
    fn spectrum(&self) -> Spectrum {
        self.spectrum.clone()
    }
}
