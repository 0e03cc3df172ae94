//! The band of data.

use crate::error::{Error, Result, finite};
use crate::sampled::Bins;

/// The least `B` such that the bins with `|ν| ≤ B` hold at least `fraction` of the energy: the occupied band of
/// measured data, which is never band-limited in the strict sense.
///
/// Resolved to one bin, `1/span`. Data with noise need a fraction below one minus the noise's share; a record that does
/// not come back to where it began leaks, so window it first.
///
/// ```
/// use nyquist::prelude::*;
/// // a strong tone at 2 and one of a hundredth of its energy at 7
/// let f = from_fn(|x| nyquist::num::cos_pi(4.0 * x) + 0.1 * nyquist::num::cos_pi(14.0 * x));
/// let bins = forward(&Samples::of(&f, Axis::nodes(0.0..1.0, 64)?));
/// assert_eq!((occupied_band(&bins, 0.98)?, occupied_band(&bins, 0.999)?), (2.0, 7.0));
/// # Ok::<(), Error>(())
/// ```
///
/// # Errors
/// A fraction that is not strictly between zero and one.
pub fn occupied_band(bins: &Bins, fraction: f64) -> Result<f64> {
    band_of(bins.magnitudes().map(|[nu, size]| [nu.abs(), size * size]).collect(), fraction)
}

/// The least `B` such that the energies, `[|ν|, energy]` in any order, up to `|ν| = B` are at least `fraction` of all.
pub(crate) fn band_of(mut energies: Vec<[f64; 2]>, fraction: f64) -> Result<f64> {
    finite("the fraction of energy", fraction)?;
    if !(fraction > 0.0 && fraction < 1.0) {
        return Err(Error::OutOfRange { what: "the fraction of energy", value: fraction, low: 0.0, high: 1.0 });
    }
    energies.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let wanted = fraction * energies.iter().map(|e| e[1]).sum::<f64>();
    let mut sum = 0.0;
    let enough = |&&[_, energy]: &&[f64; 2]| {
        sum += energy;
        sum >= wanted
    };
    Ok(energies.iter().find(enough).map_or(0.0, |e| e[0]))
}
