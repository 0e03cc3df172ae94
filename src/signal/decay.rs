//! The one-sided exponential.

use crate::error::{Result, positive};
use crate::signal::{FourierPair, Signal};
use crate::spectrum::Spectrum;
use num_complex::Complex;
use std::f64::consts::PI;

/// `f(x) = e^{−x/τ}` for `x > 0`, ½ at zero, 0 before ↔ `F(ν) = τ/(1 + 2πiντ)`: the impulse response of an RC circuit.
///
/// The pair whose transform is not real: it decays like `1/ν` and turns by a quarter on the way.
///
/// ```
/// use nyquist::prelude::*;
/// let f = Decay::new(1.0)?;
/// let corner = f.spectrum().density(1.0 / (2.0 * std::f64::consts::PI));
/// assert!((corner.norm_sqr() - 0.5).abs() < 1e-15 && (corner.arg() + std::f64::consts::FRAC_PI_4).abs() < 1e-15);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Decay {
    time: f64,
}

impl Decay {
    /// The exponential that falls to `1/e` within `time`.
    ///
    /// # Errors
    /// A time that is not positive and finite.
    pub fn new(time: f64) -> Result<Self> {
        Ok(Self { time: positive("the decay time", time)? })
    }
}

impl Signal for Decay {
    fn at(&self, x: f64) -> f64 {
        if x > 0.0 {
            (-x / self.time).exp()
        } else if x == 0.0 {
            0.5
        } else {
            0.0
        }
    }
}

impl FourierPair for Decay {
    fn spectrum(&self) -> Spectrum {
        let time = self.time;
        Spectrum::decaying(f64::INFINITY, move |nu| time / Complex::new(1.0, 2.0 * PI * nu * time))
    }
}
