//! How pictures and their spectra are shown in this chapter.

use crate::error::Result;
use crate::figure::picture::{grey, upward};
use crate::figure::{Bar, Layer, Panel, Scale, Tones};
use crate::image::{Image, ImageBins};
use crate::residual::Residual;
use crate::text;
use crate::text::Text;
use ndarray::Array2;

/// A picture in grey, from black at the start of `range` to white at its end; `y` points up, as in formulas.
pub(super) fn picture(name: &'static str, title: Text, image: &Image, range: (f64, f64)) -> Panel {
    upward(grey(name, title, image, range))
}

/// A part of an array around the bin of zero frequency: `reach` bins to every side.
fn around_zero(values: &Array2<f64>, reach: usize) -> Array2<f64> {
    let (rows, columns) = values.dim();
    let (top, left) = (rows / 2 - reach, columns / 2 - reach);
    Array2::from_shape_fn((2 * reach + 1, 2 * reach + 1), |(l, k)| values[[top + l, left + k]])
}

/// The middle of a spectrum, `reach` bins from zero to every side, in decibels from `floor` to 0, which is its largest bin;
/// the scales count bins: periods across the picture.
pub(super) fn spectrum(name: &'static str, title: Text, bins: &ImageBins, floor: f64, reach: usize) -> Result<Panel> {
    let largest = bins.values().iter().map(|f| f.norm()).fold(0.0, f64::max);
    spectrum_over(name, title, bins, largest, floor, reach)
}

/// The same with 0 dB where a bin is as large as `whole`: for several spectra on one scale.
pub(super) fn spectrum_over(
    name: &'static str,
    title: Text,
    bins: &ImageBins,
    whole: f64,
    floor: f64,
    reach: usize,
) -> Result<Panel> {
    let end = reach as f64 + 0.5;
    let scale = || Scale::linear(Text::EMPTY, -end, end);
    // relative to its own largest bin the floor is that much nearer
    let largest = bins.values().iter().map(|f| f.norm()).fold(0.0, f64::max);
    let own = floor - 20.0 * (largest / whole).log10();
    // to whole decibels, which is as much as colours tell apart
    let shown = around_zero(bins.log_magnitude(own)?.pixels(), reach).mapv(|v| (floor - own * v).round());
    Ok(Panel::new(name, title, scale(), scale()).square().with(Layer::raster(
        "spectrum",
        (-end, end),
        (-end, end),
        shown,
        (floor, 0.0),
        Tones::Data,
    )))
}

/// A bar of decibels.
pub(super) fn decibels() -> Bar {
    Bar::values(text!("dB", "дБ"))
}

/// What stands above a spectrum without a bar.
pub(super) fn in_decibels(floor: f64) -> Text {
    text!("spectrum, {floor} to 0 dB", "спектр, от {floor} до 0 дБ")
}

/// The one that comes nearer to its bound.
pub(super) fn worse(a: Residual, b: Residual) -> Residual {
    if a.measured / a.bound >= b.measured / b.bound { a } else { b }
}
