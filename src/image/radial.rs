//! Means over rings: what a spectrum is at a distance from zero, whatever the direction.

use crate::error::{Error, Result};
use crate::image::{Image, ImageBins};

/// One ring of a spectrum.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ring {
    /// The mean distance `ρ` of its bins from zero frequency.
    pub frequency: f64,
    /// The mean of the power `|F|²/area` over its bins.
    pub power: f64,
    /// How many bins lie in it.
    pub bins: usize,
}

/// The power spectrum averaged over `rings` rings of equal width between zero and the lower of the two Nyquist
/// frequencies; rings without a bin are left out, and so is zero frequency itself, the image's mean.
///
/// The mean over a ring of `n` bins of white noise deviates by `1/√(n/2)` of itself: a bin and its opposite are one.
///
/// ```
/// use nyquist::prelude::*;
/// use nyquist::image::radial::radial_power;
/// let noise = |i: usize| nyquist::num::random::normal(1, i as u64, 0);
/// let image = Image::new(Grid::pixels(64, 64)?, (0..4096).map(noise).collect())?;
/// for ring in radial_power(&image_forward(&image), 8)? {
///     assert!((ring.power - 1.0).abs() < 4.0 / (0.5 * ring.bins as f64).sqrt()); // white: four deviations
/// }
/// # Ok::<(), Error>(())
/// ```
///
/// # Errors
/// No rings.
pub fn radial_power(bins: &ImageBins, rings: usize) -> Result<Vec<Ring>> {
    radial_mean(&bins.power(), rings)
}

/// [`radial_power`] of a power spectrum, an image over frequencies: the mean over rings of anything in the plane.
///
/// # Errors
/// No rings.
pub fn radial_mean(power: &Image, rings: usize) -> Result<Vec<Ring>> {
    if rings == 0 {
        return Err(Error::TooFew { what: "rings of a radial mean", least: 1, got: 0 });
    }
    let grid = power.grid();
    let nyquist = 0.5 * grid.x().span().min(grid.y().span());
    let mut sums = vec![(0.0, 0.0, 0usize); rings];
    for ([u, v], value) in grid.iter().zip(power.values()) {
        let rho = u.hypot(v);
        let ring = (rho / nyquist * rings as f64) as usize;
        if let Some((frequency, power, count)) = sums.get_mut(ring).filter(|_| rho > 0.0) {
            *frequency += rho;
            *power += value;
            *count += 1;
        }
    }
    let ring = |(frequency, power, bins): (f64, f64, usize)| {
        (bins > 0).then(|| Ring { frequency: frequency / bins as f64, power: power / bins as f64, bins })
    };
    Ok(sums.into_iter().filter_map(ring).collect())
}
