//! The power spectrum of a picture of any size.

use crate::axis::{Axis, Unit};
use crate::error::{Error, Result, unknown};
use crate::grid::Grid;
use crate::image::Image;
use crate::image::dft::forward;
use crate::image::periodic::periodic_forward;
use crate::num::mean::mean;
use crate::sampled::window::Window;
use ndarray::Array2;
use std::str::FromStr;

/// What is done about the border of a picture, whose opposite sides do not meet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Border {
    /// The picture is made periodic by taking away a smooth one (see [`periodic`](crate::image::periodic)): no cross, full
    /// resolution, and every pixel counts. Fine detail at the border counts as a jump as well: of a grating about `1/16n` of
    /// the energy goes astray, along the axes, with `n` pixels along a side.
    Periodic,
    /// The picture fades out under a window in both directions: lines far apart in strength are told apart, but the middle
    /// counts more than the border.
    Window(Window),
}

impl Border {
    /// The names, as they are read.
    pub const NAMES: [&str; 6] = ["periodic", "hann", "hamming", "blackman", "blackman-harris", "none"];
}

/// Reads a border's name: `periodic`, a window's, or `none` (the cross stays).
///
/// ```
/// use nyquist::inspect::picture::power::Border;
/// assert_eq!("periodic".parse(), Ok(Border::Periodic));
/// assert!("han".parse::<Border>().unwrap_err().to_string().contains("known: hann"));
/// ```
impl FromStr for Border {
    type Err = Error;

    fn from_str(name: &str) -> Result<Self> {
        Ok(match name {
            "periodic" => Self::Periodic,
            "hann" => Self::Window(Window::Hann),
            "hamming" => Self::Window(Window::Hamming),
            "blackman" => Self::Window(Window::Blackman),
            "blackman-harris" => Self::Window(Window::BlackmanHarris),
            "none" => Self::Window(Window::Rectangular),
            _ => return Err(unknown("border", name, Self::NAMES)),
        })
    }
}

/// The power of a picture without its mean, over the frequencies of the plane: `|F|²/area`, in the squared unit of the picture
/// times pixel². Its sum times the area of a bin is the variance of the picture (Parseval; under a window, on average).
/// Two kinds are made: [`of`](Self::of) the whole, and the mean over [small blocks](Self::welch).
///
/// ```
/// use nyquist::prelude::*;
/// use nyquist::inspect::picture::power::{Border, PowerSpectrum};
/// let image = Image::of(&Grating::new([0.25, 0.125])?, Grid::pixels(64, 48)?);
/// let spectrum = PowerSpectrum::of(&image, "none".parse()?);
/// assert!((spectrum.energy() - 0.5).abs() < 1e-12); // of a cosine
/// let there = spectrum.energies().filter(|([u, v], _)| [u.abs(), v.abs()] == [0.25, 0.125]);
/// assert!((there.map(|(_, energy)| energy).sum::<f64>() - 0.5).abs() < 1e-12);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct PowerSpectrum {
    power: Image,
    mean: f64,
    deviation: f64,
    blocks: usize,
}

impl PowerSpectrum {
    /// The longest side of what is transformed as a whole.
    pub const SIDE: usize = 1024;
    /// The side of a small block.
    pub const BLOCK: usize = 256;

    /// Of a picture, whose pixels count as of size one.
    ///
    /// Pictures longer than [`SIDE`](Self::SIDE) along an axis are cut into blocks of that length, evenly spread and
    /// overlapping by half or less, whose powers are averaged: memory and resolution are bounded.
    pub fn of(image: &Image, border: Border) -> Self {
        Self::averaged(image, border, Self::SIDE)
    }

    /// The mean over blocks of [`BLOCK`](Self::BLOCK) pixels under a Hann window that overlap by half (Welch 1967): what
    /// energies and bands are measured from.
    ///
    /// Nothing far from a line comes from it: it leaks 31 dB to the third bin and 18 dB an octave less beyond, where the seam
    /// of a whole picture always leaves a ten-thousandth of a fine grating. And what is anywhere in a large picture counts as
    /// much as in the middle, but for the outermost 64 pixels.
    pub fn welch(image: &Image) -> Self {
        Self::averaged(image, Border::Window(Window::Hann), Self::BLOCK)
    }

    fn averaged(image: &Image, border: Border, side: usize) -> Self {
        let values = image.values();
        // exact for constants, so that an even picture deviates by nothing
        let mean = mean(values);
        let deviation = (values.iter().map(|v| (v - mean) * (v - mean)).sum::<f64>() / values.len() as f64).sqrt();
        let (w, h) = (image.width().min(side), image.height().min(side));
        let axis =
            |n: usize| Axis::new(0.5, 1.0, n).expect("as many pixels as there are are an axis").in_unit(Unit::PIXEL);
        let grid = Grid::new(axis(w), axis(h)).expect("a part of a grid that there is");
        let mut sum = Array2::<f64>::zeros((h, w));
        let (across, down) = (starts(image.width(), w, border), starts(image.height(), h, border));
        for &top in &down {
            for &left in &across {
                let part = image.part([left, top], [w, h]).and_then(|part| part.map(|v| v - mean).on(grid));
                sum += power(&part.expect("blocks lie inside"), border).pixels();
            }
        }
        let blocks = across.len() * down.len();
        Self { power: Image::trusted(grid.dual(), sum / blocks as f64), mean, deviation, blocks }
    }

    /// The power at the frequencies of its grid, in cycles a pixel, zero in the middle.
    pub fn power(&self) -> &Image {
        &self.power
    }

    /// The picture's mean.
    pub fn mean(&self) -> f64 {
        self.mean
    }

    /// The picture's standard deviation.
    pub fn deviation(&self) -> f64 {
        self.deviation
    }

    /// How many blocks were averaged.
    pub fn blocks(&self) -> usize {
        self.blocks
    }

    /// The frequencies, and the energy of their bins: parts of the variance.
    pub fn energies(&self) -> impl Iterator<Item = ([f64; 2], f64)> + '_ {
        let area = self.power.grid().pixel_area();
        self.power.grid().iter().zip(self.power.values()).map(move |(at, p)| (at, p * area))
    }

    /// The sum of all energies: the variance, which a window only estimates.
    pub fn energy(&self) -> f64 {
        self.energies().map(|(_, e)| e).sum()
    }
}

/// Where the blocks of `n` out of `whole` pixels start: windowed ones overlap by half, as little of them is seen.
fn starts(whole: usize, n: usize, border: Border) -> Vec<usize> {
    let faded = border != Border::Periodic && border != Border::Window(Window::Rectangular);
    let count = if whole == n { 1 } else { (whole * if faded { 2 } else { 1 }).div_ceil(n) };
    let last = whole - n;
    (0..count).map(|i| if count == 1 { 0 } else { i * last / (count - 1) }).collect()
}

fn power(part: &Image, border: Border) -> Image {
    let Border::Window(window) = border else { return periodic_forward(part).power() };
    let weights = |n: usize| -> Vec<f64> {
        let raw: Vec<f64> = (0..n).map(|j| window.at((j as f64 + 0.5) / n as f64)).collect();
        let rms = (raw.iter().map(|w| w * w).sum::<f64>() / n as f64).sqrt();
        raw.into_iter().map(|w| w / rms).collect()
    };
    let (across, down) = (weights(part.width()), weights(part.height()));
    let mut pixels = part.pixels().clone();
    for (mut row, b) in pixels.rows_mut().into_iter().zip(&down) {
        row.iter_mut().zip(&across).for_each(|(v, a)| *v *= a * b);
    }
    forward(&Image::trusted(part.grid(), pixels)).power()
}
