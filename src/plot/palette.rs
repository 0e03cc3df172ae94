//! Colours: one for each meaning, told apart by people with any colour vision, in a light and a dark theme.
//!
//! The hues are Okabe and Ito's (2008), moved until every pair of the meanings that meet in one panel keeps a distance
//! of at least 19 ΔE*ab also under simulated protanopia and deuteranopia (Machado et al. 2009), and every one keeps a
//! contrast of at least 3:1 against the paper (WCAG 2.2, graphical objects). Tests compute both.

use crate::figure::{Meaning, Tones};

/// What figures are drawn on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Theme {
    /// Dark on white: paper, bright rooms.
    #[default]
    Light,
    /// Light on almost black: dark lecture halls.
    Dark,
}

impl Theme {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Light, Self::Dark];

    /// Its name: `light` or `dark`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Light => "light",
            Self::Dark => "dark",
        }
    }

    /// The background.
    pub fn paper(self) -> Rgb {
        self.pick(0xFFFFFF, 0x15181E)
    }

    /// Titles, labels, numbers.
    pub fn text(self) -> Rgb {
        self.pick(0x1A1A1A, 0xF2F4F8)
    }

    /// The frame of a panel and its ticks.
    pub fn frame(self) -> Rgb {
        self.pick(0x5B6472, 0x9AA4B4)
    }

    /// The lines of the grid.
    pub fn grid(self) -> Rgb {
        self.pick(0xE2E6EB, 0x2B313B)
    }

    /// The colour of a meaning: the same in every figure of a theme.
    pub fn colour(self, meaning: Meaning) -> Rgb {
        match meaning {
            Meaning::Signal => self.pick(0x084F7A, 0x78B2FF),
            Meaning::Samples => self.pick(0xE8650A, 0xF08A1E),
            Meaning::Replica => self.pick(0x3C8CC9, 0x4E86C8),
            Meaning::Leaked => self.pick(0xE10A48, 0xD9485F),
            Meaning::Reconstructed => self.pick(0x00A378, 0x22E38F),
            Meaning::Error => self.pick(0xCC4FC7, 0xC64BC0),
            Meaning::Kernel => self.pick(0x503901, 0xF8E04A),
            Meaning::Theory => self.pick(0x1A1A1A, 0xF2F4F8),
            Meaning::Guide => self.pick(0x6B7280, 0x8B95A5),
            Meaning::Series(n) => {
                let of = match self {
                    Self::Light => [0x084F7A, 0xE8650A, 0x00A378, 0xCC4FC7, 0x503901, 0x3C8CC9, 0xE10A48, 0x6B7280],
                    Self::Dark => [0x78B2FF, 0xF08A1E, 0x22E38F, 0xC64BC0, 0xF8E04A, 0x4E86C8, 0xD9485F, 0x8B95A5],
                };
                Rgb::hex(of[usize::from(n) % of.len()])
            }
        }
    }

    /// How much of a colour an area has that takes so much of it on white: the eye sees less of it on black.
    pub(super) fn wash(self, opacity: f64) -> f64 {
        match self {
            Self::Light => opacity,
            Self::Dark => (1.6 * opacity).min(1.0),
        }
    }

    fn pick(self, light: u32, dark: u32) -> Rgb {
        Rgb::hex(match self {
            Self::Light => light,
            Self::Dark => dark,
        })
    }
}

/// A colour in sRGB.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Rgb(pub [u8; 3]);

impl Rgb {
    const fn hex(code: u32) -> Self {
        let [_, r, g, b] = code.to_be_bytes();
        Self([r, g, b])
    }

    /// Its three channels in linear light, from 0 to 1.
    pub fn linear(self) -> [f64; 3] {
        self.0.map(|c| {
            let c = f64::from(c) / 255.0;
            if c <= 0.04045 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) }
        })
    }

    /// The contrast against another colour, from 1 (none) to 21 (black on white), after WCAG 2.2.
    pub fn contrast(self, other: Self) -> f64 {
        let luminance = |c: Self| {
            let [r, g, b] = c.linear();
            0.2126 * r + 0.7152 * g + 0.0722 * b
        };
        let (a, b) = (luminance(self), luminance(other));
        (a.max(b) + 0.05) / (a.min(b) + 0.05)
    }
}

/// The byte that shows a linear light of `value` (0 to 1, clamped) in sRGB.
pub(super) fn srgb(value: f64) -> u8 {
    let v = value.clamp(0.0, 1.0);
    let encoded = if v <= 0.0031308 { 12.92 * v } else { 1.055 * v.powf(1.0 / 2.4) - 0.055 };
    (encoded * 255.0 + 0.5) as u8
}

/// The 256 colours of `tones`, the lowest value first.
pub(super) fn table(tones: Tones) -> [[u8; 3]; 256] {
    std::array::from_fn(|i| match tones {
        Tones::Grey => [i as u8; 3],
        Tones::Data => {
            let at = i as f64 / 255.0 * (DATA.len() - 1) as f64;
            let k = (at as usize).min(DATA.len() - 2);
            let part = at - k as f64;
            std::array::from_fn(|c| {
                let (a, b) = (f64::from(DATA[k][c]), f64::from(DATA[k + 1][c]));
                (a + (b - a) * part + 0.5) as u8
            })
        }
    })
}

/// Every sixteenth colour of viridis (Smith and van der Walt 2015): lightness rises evenly from 15 to 91.
const DATA: [[u8; 3]; 17] = [
    [68, 1, 84],
    [72, 24, 106],
    [71, 45, 123],
    [66, 64, 134],
    [59, 82, 139],
    [51, 99, 141],
    [44, 114, 142],
    [38, 130, 142],
    [33, 145, 140],
    [31, 160, 136],
    [40, 174, 128],
    [63, 188, 115],
    [94, 201, 98],
    [132, 212, 75],
    [173, 220, 48],
    [216, 226, 25],
    [253, 231, 37],
];
