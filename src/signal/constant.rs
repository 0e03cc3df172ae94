//! The constant.

use crate::error::{Result, finite};
use crate::signal::{Differentiable, FourierPair, Signal};
use crate::spectrum::{Impulse, Spectrum};

/// `f(x) = c` ↔ `F = c·δ(ν)`: one line at zero that carries the whole weight. Third row of the lecture's table.
///
/// ```
/// use nyquist::prelude::*;
/// let spectrum = Constant::new(2.0)?.spectrum();
/// assert_eq!(spectrum.lines(), [Impulse::new(0.0, 2.0)]);
/// assert!(!spectrum.has_density());
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Constant {
    value: f64,
}

impl Constant {
    /// That value everywhere.
    ///
    /// # Errors
    /// A value that is not finite.
    pub fn new(value: f64) -> Result<Self> {
        Ok(Self { value: finite("the value of a constant", value)? })
    }
}

impl Signal for Constant {
    fn at(&self, _: f64) -> f64 {
        self.value
    }
}

impl Differentiable for Constant {
    fn slope(&self, _: f64) -> f64 {
        0.0
    }
}

impl FourierPair for Constant {
    fn spectrum(&self) -> Spectrum {
        Spectrum::zero().plus_line(Impulse::new(0.0, self.value))
    }
}
