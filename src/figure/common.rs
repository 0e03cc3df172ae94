//! What many figures share: scales with their names, and layers made from the library's nouns.

use crate::figure::{Layer, Meaning, Scale};
use crate::signal::Signal;
use crate::spectrum::Spectrum;
use crate::text::Text;

/// How many pieces a drawn curve is made of, where nothing asks for more: finer than a pixel of a slide's panel.
pub const PIECES: usize = 800;

/// A scale of positions.
pub fn space(low: f64, high: f64) -> Scale {
    Scale::linear(Text::same("x"), low, high)
}

/// A scale of frequencies, in cycles per unit of x.
pub fn frequency(low: f64, high: f64) -> Scale {
    Scale::linear(Text::same("ν"), low, high)
}

/// A scale of values of that name.
pub fn values(name: &'static str, low: f64, high: f64) -> Scale {
    Scale::linear(Text::same(name), low, high)
}

/// A scale without a name, ticks or numbers: for panels stacked over one that has them, and for values that need none.
pub fn unmarked(low: f64, high: f64) -> Scale {
    Scale::linear(Text::EMPTY, low, high).bare()
}

/// The curve of a signal over `low..=high`.
pub fn signal_curve(name: &'static str, meaning: Meaning, signal: &impl Signal, low: f64, high: f64) -> Layer {
    Layer::curve(name, meaning, low, high, PIECES, |x| signal.at(x))
}

/// The curve of the real part of a spectrum's density over `low..=high`.
pub fn density_curve(name: &'static str, meaning: Meaning, spectrum: &Spectrum, low: f64, high: f64) -> Layer {
    Layer::curve(name, meaning, low, high, PIECES, |nu| spectrum.density(nu).re)
}

/// The lines of a spectrum as arrows, by the real part of their weights.
pub fn line_arrows(name: &'static str, meaning: Meaning, spectrum: &Spectrum) -> Layer {
    Layer::arrows(name, meaning, spectrum.lines().iter().map(|l| [l.at, l.weight.re]))
}

/// The largest `|y|` of a layer's points.
pub fn peak(layer: &Layer) -> f64 {
    layer.points().iter().map(|p| p[1].abs()).fold(0.0, f64::max)
}

/// The largest `|y_a − y_b|` of two layers on the same positions.
pub fn difference(a: &Layer, b: &Layer) -> f64 {
    a.points().iter().zip(b.points()).map(|(a, b)| (a[1] - b[1]).abs()).fold(0.0, f64::max)
}
