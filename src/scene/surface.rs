//! What things are made of.

use crate::error::{Result, all_finite, positive, within};
use crate::field::Field;
use crate::field::checks::Checks;
use crate::scene::vector::mix;

/// A diffuse colour, plain or in checks, with a highlight and a share of mirror.
///
/// Colours are shares of the light that is thrown back, in linear light: red, green, blue.
///
/// ```
/// use nyquist::prelude::*;
/// assert!(Surface::plain([0.6, 0.2, 0.7])?.with_highlight(0.8, 300.0).is_ok());
/// assert!(Surface::plain([0.6, f64::NAN, 0.7]).is_err());
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Surface {
    colors: [[f64; 3]; 2],
    checks: Option<Checks>,
    pub(in crate::scene) highlight: f64,
    pub(in crate::scene) exponent: f64,
    pub(in crate::scene) mirror: f64,
}

impl Surface {
    /// One colour everywhere.
    ///
    /// # Errors
    /// A colour with a share outside `0 … 1`.
    pub fn plain(color: [f64; 3]) -> Result<Self> {
        Self::of([color; 2], None)
    }

    /// Squares of two colours, of that size, in the surface's own coordinates: on the floor, in space.
    ///
    /// # Errors
    /// Colours with a share outside `0 … 1`, a size that is not positive and finite.
    pub fn checkered(colors: [[f64; 3]; 2], size: f64) -> Result<Self> {
        Self::of(colors, Some(Checks::new(size)?))
    }

    fn of(colors: [[f64; 3]; 2], checks: Option<Checks>) -> Result<Self> {
        for share in colors.concat() {
            within("a share of the colour of a surface", share, 0.0, 1.0)?;
        }
        Ok(Self { colors, checks, highlight: 0.0, exponent: 1.0, mirror: 0.0 })
    }

    /// With a highlight: `strength·(n·h)^exponent`, `h` half way between light and eye (Blinn 1977). The greater the
    /// exponent, the narrower the highlight.
    ///
    /// # Errors
    /// A strength outside `0 … 1000`, an exponent that is not positive and finite.
    pub fn with_highlight(self, strength: f64, exponent: f64) -> Result<Self> {
        within("the strength of a highlight", strength, 0.0, 1e3)?;
        Ok(Self { highlight: strength, exponent: positive("the exponent of a highlight", exponent)?, ..self })
    }

    /// With a share of a perfect mirror.
    ///
    /// # Errors
    /// A share outside `0 … 1`.
    pub fn with_mirror(self, share: f64) -> Result<Self> {
        Ok(Self { mirror: within("the mirror's share of a surface", share, 0.0, 1.0)?, ..self })
    }

    /// The colour at a place.
    pub(in crate::scene) fn color(&self, x: f64, y: f64) -> [f64; 3] {
        match self.checks {
            None => self.colors[0],
            Some(checks) => mix(self.colors[0], self.colors[1], checks.at(x, y)),
        }
    }
}

/// Three numbers that are finite and not negative: light.
pub(in crate::scene) fn light(what: &'static str, light: [f64; 3]) -> Result<[f64; 3]> {
    all_finite(what, &light)?;
    for part in light {
        within(what, part, 0.0, f64::MAX)?;
    }
    Ok(light)
}
