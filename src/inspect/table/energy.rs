//! Where the energy of a record is.

use crate::axis::Edge;
use crate::error::Result;
use crate::inspect::table::lines::Line;
use crate::num::mean::mean;
use crate::record::{Recoverable, Sampling};
use crate::sampled::dft::dft;
use crate::sampled::window::Window;
use std::ops::Range;

/// The mean square of a record, without its mean, over frequency: that of its lines where they stand, and that of the rest
/// where a band-limited signal through it has it.
///
/// The rest is taken stretch by stretch under Hann's window: by the discrete Fourier transform where samples are equally
/// spaced, otherwise by least squares on the highest band that is well conditioned ([`Recoverable`]). What that does not
/// pass is not resolved: it has frequencies above the band, or none.
#[derive(Debug, Clone, PartialEq)]
pub struct Energy {
    /// Frequencies and energies, rising.
    parts: Vec<[f64; 2]>,
    unresolved: f64,
    /// The lowest band up to which all stretches were resolved.
    band: f64,
}

/// Samples below which a stretch is not resolved.
const FEW: usize = 8;

impl Energy {
    pub(super) fn of(sampling: &Sampling, lines: &[Line], rest: &[f64]) -> Self {
        let mut energy = Self { parts: Vec::new(), unresolved: 0.0, band: f64::INFINITY };
        energy.parts.extend(lines.iter().map(|line| [line.frequency, line.energy()]));
        let n = rest.len() as f64;
        for stretch in sampling.stretches() {
            let square = rest[stretch.clone()].iter().map(|v| v * v).sum::<f64>() / n;
            let resolved = if stretch.len() < FEW { None } else { resolve(sampling, stretch, rest).ok() };
            match resolved {
                Some((bins, band)) => {
                    // the window's loss is made up for, so that the parts add up to the mean square
                    let sum: f64 = bins.iter().map(|bin| bin[1]).sum();
                    let scale = if sum > 0.0 { square / sum } else { 0.0 };
                    energy.unresolved += scale * bins.iter().filter(|b| b[0].is_infinite()).map(|b| b[1]).sum::<f64>();
                    energy.parts.extend(bins.iter().filter(|b| b[0].is_finite()).map(|b| [b[0], scale * b[1]]));
                    energy.band = energy.band.min(band);
                }
                None => energy.unresolved += square,
            }
        }
        energy.parts.sort_by(|a, b| a[0].total_cmp(&b[0]));
        energy
    }

    /// All of it: the mean square of the record without its mean, as far as lines and rest are independent.
    pub fn total(&self) -> f64 {
        self.unresolved + self.parts.iter().map(|part| part[1]).sum::<f64>()
    }

    /// What no frequency can be said of.
    pub fn unresolved(&self) -> f64 {
        self.unresolved
    }

    /// Up to which frequency the rest was resolved; infinite if nothing was.
    pub fn band(&self) -> f64 {
        self.band
    }

    /// The least frequency below or at which there is that part of the energy; none if too much is unresolved. Zero for a
    /// constant.
    pub fn occupied(&self, part: f64) -> Option<f64> {
        let wanted = part * self.total();
        let mut sum = 0.0;
        let enough = |[_, energy]: &&[f64; 2]| {
            sum += energy;
            sum >= wanted
        };
        if self.total() == 0.0 { Some(0.0) } else { self.parts.iter().find(enough).map(|part| part[0]) }
    }

    /// The energy at and above a frequency, the unresolved part of it included.
    pub fn above(&self, frequency: f64) -> f64 {
        let from = self.parts.partition_point(|part| part[0] < frequency);
        self.unresolved + self.parts[from..].iter().map(|part| part[1]).sum::<f64>()
    }
}

/// Energies at the frequencies of a stretch, the unresolved one at infinity; and the band that was resolved.
fn resolve(sampling: &Sampling, stretch: Range<usize>, rest: &[f64]) -> Result<(Vec<[f64; 2]>, f64)> {
    let positions = &sampling.positions()[stretch.clone()];
    let n = stretch.len();
    let mean = mean(&rest[stretch.clone()]);
    let length = (positions[n - 1] - positions[0]) * n as f64 / (n - 1) as f64;
    let windowed = |i: usize| {
        let part = (positions[i] - positions[0]) / length;
        (rest[stretch.start + i] - mean) * Window::Hann.at(part)
    };
    let values: Vec<f64> = (0..n).map(windowed).collect();
    if let Some(axis) = sampling.axis_of(stretch.clone()) {
        let half = dft(&values)?;
        let once = |k: usize| if k == 0 || 2 * k == n { 1.0 } else { 2.0 };
        let bin = |k: usize| [k as f64 / axis.span(), once(k) * half[k].norm_sqr()];
        return Ok(((0..=n / 2).map(bin).collect(), axis.nyquist()));
    }
    let recoverable = Recoverable::of_period(positions, sampling.nodes_of(stretch), Edge::Wrap, None, f64::INFINITY)?;
    let (dense, misfit) = recoverable.fit_period(&values)?;
    let polynomial = dense.polynomial();
    let once = |k: usize| if k == 0 { 1.0 } else { 2.0 };
    let bins = polynomial.coefficients().iter().enumerate();
    let mut bins: Vec<[f64; 2]> = bins.map(|(k, c)| [k as f64 / polynomial.period(), once(k) * c.norm_sqr()]).collect();
    bins.push([f64::INFINITY, misfit * misfit]);
    Ok((bins, recoverable.band()))
}
