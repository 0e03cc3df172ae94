//! Spectra and spectrograms of sounds, to be looked at.

use super::picture::{COLUMNS, curve, frequencies};
use super::{decibels, hertz};
use crate::error::{Error, Result};
use crate::figure::report::Quantity;
use crate::figure::{Figure, Layer, Legend, Meaning, Panel, Portrait, Scale, Tones};
use crate::inspect::sound::dbfs;
use crate::sampled::spectrogram::Spectrogram;
use crate::sampled::welch::PowerSpectrum;
use crate::text;
use crate::text::Text;

/// The units of a sound's spectrum, of its values and of their levels; FS is full scale.
///
/// An amplitude is that of the sine that would read the same: one of full scale is 1 FS, or 0 dBFS. A density is one-sided,
/// its integral is the mean square; in decibels 0 dBFS/Hz is the mean square of a sine of full scale, ½, in one Hz.
pub const fn units(quantity: Quantity) -> [&'static str; 2] {
    match quantity {
        Quantity::Amplitude => ["FS", "dBFS"],
        Quantity::Density => ["FS^2/Hz", "dBFS/Hz"],
    }
}

/// The value in bin `k` of a sound's spectrum, and its level in decibels.
pub fn value_and_level(spectrum: &PowerSpectrum, quantity: Quantity, k: usize) -> [f64; 2] {
    match quantity {
        Quantity::Amplitude => {
            let amplitude = spectrum.amplitude(k);
            [amplitude, 20.0 * amplitude.log10()]
        }
        Quantity::Density => [spectrum.density()[k], dbfs(spectrum.density()[k])],
    }
}

/// Channels that are drawn.
const MOST_CURVES: usize = 8;
const MOST_PANELS: usize = 4;
/// What is shown below the loudest, in dB.
const DEPTH: f64 = 150.0;
const SPECTROGRAM_DEPTH: f64 = 100.0;

/// The spectra of all channels (of the first eight) in one panel, over a logarithmic scale of frequencies if wanted.
///
/// ```
/// use nyquist::figure::report::sound::spectrum::spectra;
/// use nyquist::figure::report::Quantity;
/// use nyquist::num::sin_pi;
/// use nyquist::sampled::segments::Segments;
/// use nyquist::sampled::welch::welch;
/// use nyquist::sampled::window::Window;
/// let sine: Vec<f64> = (0..48_000).map(|i| sin_pi(2.0 * f64::from(i % 48) / 48.0)).collect();
/// let spectrum = welch(&sine, 48_000.0, Segments::new(4800, 2400, Window::Hann)?)?;
/// let drawn = spectra("sine.wav", &[spectrum], Quantity::Amplitude, false);
/// let curve = drawn.figure.layer("channel").map(|layer| layer.points().to_vec()).unwrap_or_default();
/// let top = curve.iter().map(|p| p[1]).fold(f64::NEG_INFINITY, f64::max);
/// assert!(top.abs() < 1e-9); // 0 dBFS
/// # Ok::<(), nyquist::error::Error>(())
/// ```
pub fn spectra(name: &str, spectra: &[PowerSpectrum], quantity: Quantity, log: bool) -> Portrait {
    let level = |spectrum: &PowerSpectrum, k: usize| value_and_level(spectrum, quantity, k)[1];
    let levels = spectra.iter().flat_map(|s| (1..s.density().len()).map(|k| level(s, k))).filter(|v| v.is_finite());
    let (least, most) = levels.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| (a.min(v), b.max(v)));
    let top = if most.is_finite() { (most / 10.0).ceil() * 10.0 + 5.0 } else { 0.0 };
    let low = if least.is_finite() { ((least - 5.0) / 10.0).floor() * 10.0 } else { top - DEPTH };
    let low = low.max(top - DEPTH);
    let (end, step) = spectra.first().map_or((1.0, 0.5), |s| (0.5 * s.rate(), s.step()));
    let x = if log {
        Scale::log(text!("frequency, Hz", "частота, Гц"), step.max(end * 1e-4), end)
    } else {
        frequencies(end)
    };
    let [_, unit] = units(quantity);
    let y = match quantity {
        Quantity::Amplitude => text!("amplitude, dBFS", "амплитуда, dBFS"),
        Quantity::Density => text!("power density, dBFS/Hz", "плотность мощности, dBFS/Гц"),
    };
    let mut panel =
        Panel::new("spectrum", Text::EMPTY, x.clone(), Scale::linear(y, low, top)).legend(Legend::UpperRight);
    for (i, spectrum) in spectra.iter().enumerate().take(MOST_CURVES) {
        // back from levels to what the curve takes: a power whose level it is
        let points = (1..spectrum.density().len()).map(|k| {
            let frequency = spectrum.frequency(k);
            let place = if log { (frequency / x.range.0).log10().max(0.0) } else { frequency };
            (place, 0.5 * 10f64.powf(level(spectrum, k) / 10.0))
        });
        let width = if log { (end / x.range.0).log10() } else { end };
        let points = curve(&points.collect::<Vec<_>>(), width);
        let points = points.into_iter().map(|[at, y]| [if log { x.range.0 * 10f64.powf(at) } else { at }, y]);
        let meaning = if spectra.len() == 1 { Meaning::Signal } else { Meaning::Series(i as u8) };
        let layer = Layer::line("channel", meaning, points).thin();
        let label = if spectra.len() == 1 { Text::EMPTY } else { text!("channel {}", "канал {}", i + 1) };
        panel = panel.with(layer.label(label));
    }
    let segments = spectra.first().map_or(0, PowerSpectrum::segments);
    let (kind, unit_ru) = match quantity {
        Quantity::Amplitude => ("амплитуда", "dBFS"),
        Quantity::Density => ("плотность мощности", "dBFS/Гц"),
    };
    let caption = match spectra.first() {
        Some(first) => text!(
            "{quantity} of {name} in {unit}: {segments} segments of {} samples under the window {}, a bin every {} Hz, noise \
             bandwidth {} Hz.",
            "{name}, {kind}, {unit_ru}: сегментов {segments}, по {} отсчётов, окно {}, шаг {} Гц, шумовая полоса {} Гц.",
            first.cut().length(),
            first.cut().window(),
            hertz(first.step()),
            hertz(first.noise_bandwidth())
        ),
        None => Text::EMPTY,
    };
    let title = match quantity {
        Quantity::Amplitude => text!("Amplitude spectrum of {name}", "Амплитудный спектр {name}"),
        Quantity::Density => text!("Power density of {name}", "Плотность мощности {name}"),
    };
    Portrait { title, caption, figure: Figure::new(1).with(panel) }
}

/// How many rows a spectrogram should have to be drawn with so many channels, and how many columns at most.
pub fn room(channels: usize) -> (usize, usize) {
    let rows = match channels {
        1 => 342,
        2 => 147,
        _ => 129,
    };
    (rows, COLUMNS)
}

/// The spectrograms of all channels (of the first four), one under another.
///
/// # Errors
/// [`Error::TooFew`] where there is none.
pub fn spectrograms(name: &str, spectrograms: &[Spectrogram], end: f64) -> Result<Portrait> {
    if spectrograms.is_empty() {
        return Err(Error::TooFew { what: "spectrograms to draw", least: 1, got: 0 });
    }
    let most = spectrograms.iter().flat_map(|s| s.density().iter().copied()).fold(0.0, f64::max);
    let top = if most > 0.0 { dbfs(most) } else { 0.0 };
    let low = top - SPECTROGRAM_DEPTH;
    let mut figure = Figure::new(1);
    for (i, spectrogram) in spectrograms.iter().enumerate().take(MOST_PANELS) {
        let (rows, columns) = spectrogram.density().dim();
        let levels = spectrogram.density().mapv(|d| dbfs(d).max(low));
        let time = (spectrogram.time(0)[0], spectrogram.time(columns - 1)[1]);
        let reach = (spectrogram.frequencies(0)[0], spectrogram.frequencies(rows - 1)[1]);
        let scale = frequencies(end);
        let title = if spectrograms.len() == 1 { Text::EMPTY } else { text!("channel {}", "канал {}", i + 1) };
        let panel = Panel::new(
            "spectrogram",
            title,
            Scale::linear(text!("time, s", "время, с"), time.0, time.1),
            Scale { range: reach, ..scale },
        );
        figure = figure.with(panel.with(Layer::raster("power", time, reach, levels, (low, top), Tones::Data)));
    }
    let [low, top] = [low, top].map(decibels);
    Ok(Portrait {
        title: text!(
            "Spectrogram of {name}, {low} to {top} dBFS/Hz",
            "Спектрограмма {name}, от {low} до {top} dBFS/Гц"
        ),
        caption: text!(
            "Power density of {name} over time and frequency; dark is {low} dBFS/Hz or less, bright {top}.",
            "Плотность мощности {name} во времени и по частоте; тёмное — {low} dBFS/Гц и ниже, яркое — {top}."
        ),
        figure,
    })
}
