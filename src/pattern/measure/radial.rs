//! The periodogram as a function of the distance from zero.

use crate::error::{Result, positive};
use crate::pattern::measure::periodogram::Periodogram;

/// The frequencies of one ring.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ring {
    /// The mean of `|(u, v)|`.
    pub frequency: f64,
    /// The mean power.
    pub power: f64,
    /// The variance of the power over the ring divided by the square of its mean (Ulichney 1988): `1/R` for a mean over
    /// `R` patterns that are the same in all directions; more where directions differ. Zero where there is no power.
    pub anisotropy: f64,
    /// How many frequencies there are, those of one half of the plane: the others repeat them.
    pub bins: usize,
}

impl Ring {
    /// One standard deviation of the mean power, if it is the same in all directions: `P/√(R·bins)`.
    pub fn deviation(&self, patterns: u32) -> f64 {
        self.power / (f64::from(patterns) * self.bins as f64).sqrt()
    }
}

/// The rings `[i·width, (i+1)·width)` around zero, which is left out itself, as far as they lie within the reach whole;
/// those without frequencies are left out.
///
/// ```
/// use nyquist::prelude::*;
/// use nyquist::pattern::measure::radial::rings;
/// // independent points: one at every frequency, and in all directions
/// let noise = rings(&Periodogram::mean(&Random::new(256)?, 1, 100, 24)?, 4.0)?;
/// assert!(noise.iter().all(|ring| (ring.power - 1.0).abs() < 4.0 * ring.deviation(100)));
/// assert!(noise.iter().skip(1).all(|ring| (ring.anisotropy * 100.0 - 1.0).abs() < 0.7));
/// # Ok::<(), Error>(())
/// ```
///
/// # Errors
/// A width that is not positive and finite.
pub fn rings(periodogram: &Periodogram, width: f64) -> Result<Vec<Ring>> {
    positive("the width of a ring", width)?;
    let count = ((periodogram.reach() as f64 + 1e-9) / width) as usize; // 1e-9: a width that divides the reach but for rounding
    let mut sums = vec![[0.0f64; 4]; count];
    for ([u, v], power) in periodogram.half() {
        let frequency = (u as f64).hypot(v as f64);
        if let Some(sum) = sums.get_mut((frequency / width) as usize) {
            let terms = [1.0, frequency, power, power * power];
            sum.iter_mut().zip(terms).for_each(|(s, term)| *s += term);
        }
    }
    let ring = |[bins, frequency, power, squares]: [f64; 4]| {
        let (mean, variance) = (power / bins, (squares - power * power / bins).max(0.0) / (bins - 1.0).max(1.0));
        let anisotropy = if mean > 0.0 { variance / (mean * mean) } else { 0.0 };
        Ring { frequency: frequency / bins, power: mean, anisotropy, bins: bins as usize }
    };
    Ok(sums.into_iter().filter(|sum| sum[0] > 0.0).map(ring).collect())
}
