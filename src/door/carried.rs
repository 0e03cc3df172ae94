//! What a file of a picture says beside its pixels, and another file can say as well.

use crate::door::picture::Picture;
use crate::door::skipped::Skipped;
use crate::door::transfer::Transfer;

/// Bits a channel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Depth {
    /// 256 codes.
    Eight,
    /// 65536 codes.
    Sixteen,
}

impl Depth {
    /// The highest code.
    pub(super) fn most(self) -> u16 {
        match self {
            Self::Eight => 255,
            Self::Sixteen => 65_535,
        }
    }

    /// 8 or 16.
    pub fn bits(self) -> u8 {
        match self {
            Self::Eight => 8,
            Self::Sixteen => 16,
        }
    }
}

/// What a picture's values are.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Light {
    /// Linear light: codes are decoded by their curve.
    #[default]
    Linear,
    /// The codes themselves, from 0 to 1: what averages bytes computes with.
    Encoded,
}

/// What the codes of a file are the colours of.
#[derive(Debug, Clone, PartialEq, Default)]
pub enum Space {
    /// Nothing is said, which means sRGB.
    #[default]
    Unmarked,
    /// sRGB, with a rendering intent from 0 to 3.
    Srgb(u8),
    /// A gamma and the chromaticities of white, red, green, blue, in units of 10⁻⁵, as PNG has them.
    Measured {
        /// `gAMA`.
        gamma: Option<u32>,
        /// `cHRM`: x and y of each.
        chromaticities: Option<[u32; 8]>,
    },
    /// An ICC profile.
    Profile(Vec<u8>),
    /// Primaries, transfer, matrix and range by the numbers of ITU-T H.273 (`cICP`).
    CodePoints([u8; 4]),
}

/// What a density is counted in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Per {
    /// No length: only the shape of a pixel is known.
    Shape,
    /// Pixels a metre.
    Metre,
    /// Pixels a centimetre.
    Centimetre,
    /// Pixels an inch.
    Inch,
}

/// How many pixels there are in a length, when the picture is printed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Density {
    /// Across.
    pub x: f64,
    /// Down.
    pub y: f64,
    /// In what.
    pub per: Per,
}

impl Density {
    /// The same in pixels a metre; a shape stays one.
    pub(super) fn per_metre(self) -> Self {
        let factor = match self.per {
            Per::Shape => return self,
            Per::Metre => 1.0,
            Per::Centimetre => 100.0,
            Per::Inch => 1.0 / 0.0254,
        };
        Self { x: self.x * factor, y: self.y * factor, per: Per::Metre }
    }

    /// The same in pixels an inch; a shape stays one.
    ///
    /// ```
    /// use nyquist::door::carried::{Density, Per};
    /// let print = Density { x: 300.0, y: 300.0, per: Per::Inch };
    /// assert_eq!(print.per_inch(), print);
    /// ```
    #[must_use]
    pub fn per_inch(self) -> Self {
        match self.per {
            Per::Shape | Per::Inch => self,
            _ => {
                let Self { x, y, .. } = self.per_metre();
                Self { x: x * 0.0254, y: y * 0.0254, per: Per::Inch }
            }
        }
    }
}

/// What is carried over from one file to another, as far as the other's format has a place for it.
#[derive(Debug, Clone, PartialEq)]
pub struct Carried {
    /// Bits a channel.
    pub depth: Depth,
    /// What the codes are the colours of.
    pub space: Space,
    /// How codes stand for light.
    pub transfer: Transfer,
    /// Whether the picture's values are light, or the codes.
    pub light: Light,
    /// Pixels in a length.
    pub density: Option<Density>,
}

impl Carried {
    /// The curve between codes and the picture's values.
    pub(super) fn curve(&self) -> &Transfer {
        match self.light {
            Light::Linear => &self.transfer,
            Light::Encoded => &Transfer::Power(1.0),
        }
    }
}

impl Default for Carried {
    /// Eight bits of sRGB, which say so.
    fn default() -> Self {
        Self {
            depth: Depth::Eight,
            space: Space::Srgb(0),
            transfer: Transfer::Srgb,
            light: Light::Linear,
            density: None,
        }
    }
}

/// A file that was read.
#[derive(Debug, Clone, PartialEq)]
pub struct Opened {
    /// Its pixels.
    pub picture: Picture,
    /// What another file can say as well.
    pub carried: Carried,
    /// What was left out, by name.
    pub skipped: Vec<Skipped>,
    /// What else should be known, in sentences.
    pub remarks: Vec<String>,
}
