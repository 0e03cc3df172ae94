//! Bytes that stand for light by a curve.

use crate::engine::resize::code::Direct;
use crate::engine::resize::strips::Meaning;
use crate::error::{Error, Result, finite};

/// Steps of light in which the code of a value is looked up.
const CELLS: usize = 4096;

/// The light that bytes stand for: tables of a curve that rises from 0 to 1.
///
/// Sums are made of light in `f32`; a sum becomes the byte whose light is nearest on the scale of codes: the threshold
/// between two bytes is the light of the code half-way between them.
///
/// ```
/// use nyquist::door::srgb::srgb_to_linear;
/// use nyquist::engine::resize::Light;
/// let light = Light::new(srgb_to_linear)?;
/// assert_eq!((light.decode(255), light.encode(1.0), light.encode(0.5)), (1.0, 255, 188));
/// # Ok::<(), nyquist::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Light {
    light: [f32; 256],
    /// The light at code + ½; what lies there or above has a greater code.
    thresholds: [f32; 256],
    /// The code of the lower end of every cell, and how many thresholds a cell has at most.
    codes: Vec<u8>,
    most: usize,
}

impl Light {
    /// By a curve from codes to light, from 0 to 1 or within.
    ///
    /// # Errors
    /// A curve that in `f32` falls or stands still, leaves 0 to 1, or gives what is not finite.
    pub fn new(curve: impl Fn(f64) -> f64) -> Result<Self> {
        let at = |half: usize| finite("a value of a curve of light", curve(half as f64 / 510.0)).map(|v| v as f32);
        let halves = (0..=510).map(at).collect::<Result<Vec<f32>>>()?;
        if halves[0] < 0.0 || halves[510] > 1.0 || halves.windows(2).any(|pair| pair[0] >= pair[1]) {
            return Err(Error::Unsupported("a curve of light that does not rise within 0 to 1"));
        }
        let light = std::array::from_fn(|code| halves[2 * code]);
        let thresholds = std::array::from_fn(|code| halves.get(2 * code + 1).copied().unwrap_or(f32::INFINITY));
        let code = |v: f32| thresholds.partition_point(|t| *t <= v) as u8;
        let codes: Vec<u8> = (0..=CELLS).map(|i| code(i as f32 / CELLS as f32)).collect();
        let most = codes.windows(2).map(|pair| usize::from(pair[1] - pair[0])).max().unwrap_or(0);
        Ok(Self { light, thresholds, codes, most })
    }

    /// The light of a byte.
    #[inline(always)]
    pub fn decode(&self, code: u8) -> f32 {
        self.light[usize::from(code)]
    }

    /// The byte of a light; of what lies outside 0 to 1 the first or the last, of what is not a number the first.
    #[inline(always)]
    pub fn encode(&self, light: f32) -> u8 {
        let v = if light > 0.0 { light } else { 0.0 };
        let v = if v < 1.0 { v } else { 1.0 };
        let mut code = self.codes[(v * CELLS as f32) as usize];
        for _ in 0..self.most {
            code += u8::from(v >= self.thresholds[usize::from(code)]);
        }
        code
    }
}

impl Meaning<u8> for Light {
    type Sum = f32;
    type Line = f32;

    #[inline(always)]
    fn widen(&self, from: &[u8], to: &mut [f32]) {
        for (to, from) in to.iter_mut().zip(from) {
            *to = self.decode(*from);
        }
    }

    #[inline(always)]
    fn narrow(&self, from: &[f32], to: &mut [u8]) {
        for (to, from) in to.iter_mut().zip(from) {
            *to = self.encode(*from);
        }
    }

    fn direct<'a>(&self, _: &'a [u8]) -> Direct<'a, f32> {
        Direct::Not
    }
}
