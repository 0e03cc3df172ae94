//! How the codes of a file stand for light, and back.

use crate::door::srgb::srgb_to_linear;

/// How codes stand for light: the curve that decodes them, both from 0 to 1.
#[derive(Debug, Clone, PartialEq)]
pub enum Transfer {
    /// The curve of sRGB.
    Srgb,
    /// A plain power: light = code^exponent. With the exponent 1 light is the code itself.
    Power(f64),
    /// The tone curves of a colour profile, for red, green and blue; the first one for grey.
    Curves(Box<[Curve; 3]>),
}

/// A tone curve of an ICC profile.
#[derive(Debug, Clone, PartialEq)]
pub enum Curve {
    /// A plain power.
    Power(f64),
    /// Values at equal steps from 0 to 1, straight lines between them.
    Table(Vec<u16>),
    /// `(ax + b)^g + e` from `d` on, `cx + f` below: `[g, a, b, c, d, e, f]`.
    Parametric([f64; 7]),
}

impl Curve {
    /// The light of a code.
    pub fn light(&self, v: f64) -> f64 {
        match self {
            Self::Power(exponent) => v.powf(*exponent),
            Self::Table(table) => {
                let at = v.clamp(0.0, 1.0) * (table.len() - 1) as f64;
                let (i, part) = (at as usize, at.fract());
                let value = |i: usize| f64::from(table[i.min(table.len() - 1)]) / 65_535.0;
                value(i) + part * (value(i + 1) - value(i))
            }
            Self::Parametric([g, a, b, c, d, e, f]) => {
                if v >= *d {
                    (a * v + b).max(0.0).powf(*g) + e
                } else {
                    c * v + f
                }
            }
        }
    }

    /// Whether it never falls and ends above where it begins, so that it can be read backwards.
    pub(super) fn rises(&self) -> bool {
        let values: Vec<f64> = (0..=256u32).map(|i| self.light(f64::from(i) / 256.0)).collect();
        let steady = values.windows(2).all(|pair| pair[1] >= pair[0]);
        steady && values[0].is_finite() && values[256].is_finite() && values[256] > values[0]
    }
}

impl Transfer {
    /// The light of a code, both from 0 to 1, in channel 0 (red or grey), 1 or 2.
    ///
    /// ```
    /// use nyquist::door::transfer::Transfer;
    /// assert_eq!(Transfer::Power(2.0).light(0, 0.5), 0.25);
    /// assert_eq!(Transfer::Srgb.light(1, 1.0), 1.0);
    /// ```
    pub fn light(&self, channel: usize, v: f64) -> f64 {
        match self {
            Self::Srgb => srgb_to_linear(v),
            Self::Power(exponent) => v.powf(*exponent),
            Self::Curves(curves) => curves[channel.min(2)].light(v),
        }
    }

    /// The light of every code from 0 to `most`.
    pub(super) fn table(&self, channel: usize, most: u16) -> Vec<f64> {
        (0..=most).map(|code| self.light(channel, f64::from(code) / f64::from(most))).collect()
    }

    /// The code of every value: the nearest one as codes go, the ends for what lies beyond them.
    ///
    /// The light half-way between two codes parts their values, so that no curve has to be inverted, and every code comes
    /// back as itself; where a curve is level, as the highest one of that light.
    pub(super) fn codes(&self, channel: usize, most: u16, values: &[f64]) -> Vec<u16> {
        let half = |code: u16| self.light(channel, (f64::from(code) + 0.5) / f64::from(most));
        let limits: Vec<f64> = (0..most).map(half).collect();
        values.iter().map(|v| limits.partition_point(|limit| limit <= v) as u16).collect()
    }
}
