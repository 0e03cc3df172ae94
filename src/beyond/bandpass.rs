//! Reconstruction of a band that does not begin at zero.

use crate::error::{Error, Result, finite, positive};
use crate::num::sinc;
use crate::nyquist::bandpass_rates;
use crate::sampled::Samples;
use crate::signal::Signal;

/// The band-pass signal through samples below twice its highest frequency (V23):
///
/// `f(x) = Σ_k f(x_k) k(x − x_k)`, `k(x) = T[2f_H sinc(2f_H x) − 2f_L sinc(2f_L x)]`.
///
/// `k` is `T` times the inverse transform of the pass band: it cuts one copy out of the replicated spectrum, which is
/// right where the copies do not overlap, see [`bandpass_rates`]. A rate between the allowed intervals is accepted, as
/// is a rate below `2B` by an ordinary reconstruction; [`BandPass::recoverable`] tells. Vaughan, Scott, White, *The theory
/// of bandpass sampling*, 1991.
///
/// ```
/// use nyquist::prelude::*;
/// // a carrier at 22.5 with a slow envelope, sampled at 8.2 where a low-pass reconstruction would ask for 48
/// let f = from_fn(|x| nyquist::num::sinc(0.5 * x).powi(2) * nyquist::num::cos_pi(45.0 * x));
/// let axis = Axis::centered(1.0 / 8.2, 8000)?;
/// let band = BandPass::new(Samples::of(&f, axis), 21.0..24.0)?;
/// assert!(band.recoverable() && (band.at(0.3) - f.at(0.3)).abs() < 1e-5);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct BandPass {
    samples: Samples,
    low: f64,
    high: f64,
    recoverable: bool,
}

impl BandPass {
    /// The reconstruction on the band `low < |ν| < high` through samples at any rate.
    ///
    /// # Errors
    /// A band that is not finite and rising, or begins below zero.
    pub fn new(samples: Samples, band: std::ops::Range<f64>) -> Result<Self> {
        let (low, high) = (finite("the lower edge of the band", band.start)?, band.end);
        if low < 0.0 {
            return Err(Error::OutOfRange { what: "the lower edge of the band", value: low, low: 0.0, high });
        }
        finite("the upper edge of the band", high)?;
        positive("the width of the band", high - low)?;
        let rate = samples.axis().rate();
        let recoverable = bandpass_rates(low, high)?.iter().any(|interval| interval.contains(rate));
        Ok(Self { samples, low, high, recoverable })
    }

    /// Whether the rate lies in one of the allowed intervals, so that the copies of the band do not overlap.
    pub fn recoverable(&self) -> bool {
        self.recoverable
    }

    /// The samples.
    pub fn samples(&self) -> &Samples {
        &self.samples
    }

    /// The kernel `k(x)` above, dimensionless.
    pub fn kernel(&self, x: f64) -> f64 {
        let part = |f: f64| 2.0 * f * sinc(2.0 * f * x);
        self.samples.axis().step() * (part(self.high) - part(self.low))
    }

    /// Its transform: `T` on the pass band, half of that at its edges, zero elsewhere.
    pub fn response(&self, nu: f64) -> f64 {
        let low_pass = |edge: f64| if edge == 0.0 { 0.0 } else { crate::spectrum::low_pass(nu, edge) };
        self.samples.axis().step() * (low_pass(self.high) - low_pass(self.low))
    }
}

impl Signal for BandPass {
    fn at(&self, x: f64) -> f64 {
        self.samples.points().map(|[at, value]| value * self.kernel(x - at)).sum()
    }
}
