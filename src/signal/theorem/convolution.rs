//! The convolution theorem.

use crate::error::{Error, Result, all_finite};
use crate::num::quadrature::integrate_pieces;
use crate::signal::{FourierPair, Signal};
use crate::spectrum::Spectrum;

/// `(f ⊗ g)(x) = ∫ f(x′) g(x − x′) dx′` ↔ `F·G`.
///
/// The value is a quadrature over the support of `f`, to about 1e-14; the spectrum is exact.
///
/// ```
/// use nyquist::prelude::*;
/// let unit = Boxcar::new(1.0)?;
/// let edges = [-0.5, 0.5];
/// let tent = Convolution::new(unit, &edges, unit, &edges)?; // box ⊗ box = tent
/// assert!((tent.at(0.25) - 0.75).abs() < 1e-15);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Convolution<F, G> {
    f: F,
    f_breaks: Vec<f64>,
    g: G,
    g_breaks: Vec<f64>,
}

impl<F, G> Convolution<F, G> {
    /// `f ⊗ g`, where `f` is zero (or negligible) outside the first and last of its rising `f_breaks` and smooth
    /// between any two of them, and `g` is smooth between its `g_breaks`, which may be none.
    ///
    /// # Errors
    /// Fewer than two breaks of `f`, breaks that are not finite.
    pub fn new(f: F, f_breaks: &[f64], g: G, g_breaks: &[f64]) -> Result<Self> {
        if f_breaks.len() < 2 {
            return Err(Error::TooFew { what: "breaks of the first factor", least: 2, got: f_breaks.len() });
        }
        all_finite("breaks of the first factor", f_breaks)?;
        if !g_breaks.is_empty() {
            all_finite("breaks of the second factor", g_breaks)?;
        }
        let (mut f_breaks, g_breaks) = (f_breaks.to_vec(), g_breaks.to_vec());
        f_breaks.sort_by(f64::total_cmp);
        Ok(Self { f, f_breaks, g, g_breaks })
    }
}

impl<F: Signal, G: Signal> Signal for Convolution<F, G> {
    fn at(&self, x: f64) -> f64 {
        let inside = |b: &f64| (self.f_breaks[0]..self.f_breaks[self.f_breaks.len() - 1]).contains(b);
        let mut breaks = self.f_breaks.clone();
        breaks.extend(self.g_breaks.iter().map(|b| x - b).filter(inside));
        breaks.sort_by(f64::total_cmp);
        integrate_pieces(|y| self.f.at(y) * self.g.at(x - y), &breaks, 1e-14).value
    }
}

impl<F: FourierPair, G: FourierPair> FourierPair for Convolution<F, G> {
    fn spectrum(&self) -> Spectrum {
        self.f.spectrum().multiplied(&self.g.spectrum())
    }
}
