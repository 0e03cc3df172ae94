//! What can be said of points in a few numbers.

use crate::error::Result;
use crate::pattern::cloud::Cloud;
use crate::pattern::measure::discrepancy::{star_discrepancy, star_discrepancy_line};
use crate::pattern::measure::distance::{min_distance, min_distance_torus};
use crate::pattern::measure::periodogram::Periodogram;
use crate::pattern::measure::radial::{Ring, rings};

/// How evenly points fill, how near they come to each other, and what their spectrum is like; nothing where a number of
/// dimensions has no such measure here.
///
/// ```
/// use nyquist::pattern::cloud::Cloud;
/// use nyquist::pattern::measure::summary::Summary;
/// let grid = Summary::of(&Cloud::new("regular", 2, 256, 0)?)?;
/// assert_eq!((grid.star_discrepancy, grid.least_distance), (Some(0.0615234375), Some(0.0625)));
/// assert_eq!(Summary::of(&Cloud::new("random", 3, 256, 0)?)?.star_discrepancy, None);
/// # Ok::<(), nyquist::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Summary {
    /// The number of points.
    pub points: usize,
    /// The star discrepancy, of points on a line or in the plane.
    pub star_discrepancy: Option<f64>,
    /// The distance of the two nearest points, on a line or in the plane; infinite for one point.
    pub least_distance: Option<f64>,
    /// The same on the torus, in the plane.
    pub least_distance_torus: Option<f64>,
    /// The spectrum, in the plane.
    pub spectrum: Option<Spectrum>,
}

/// The power spectrum of points in the plane.
#[derive(Debug, Clone, PartialEq)]
pub struct Spectrum {
    /// At integer frequencies.
    pub periodogram: Periodogram,
    /// Its rings around zero.
    pub rings: Vec<Ring>,
}

impl Spectrum {
    /// Of points in the plane, at frequencies up to `2√N`, or 140 at most; in rings of width 1, and wider ones where there
    /// are many.
    ///
    /// # Errors
    /// No points, or points outside the unit square.
    pub fn of(points: &[[f64; 2]]) -> Result<Self> {
        let reach = (2.0 * (points.len() as f64).sqrt()).clamp(8.0, 140.0) as usize;
        let periodogram = Periodogram::of(points, reach)?;
        let rings = rings(&periodogram, (reach as f64 / 48.0).ceil())?;
        Ok(Self { periodogram, rings })
    }

    /// The mean power of all rings' frequencies: one for independent points.
    pub fn mean(&self) -> f64 {
        let total: f64 = self.rings.iter().map(|ring| ring.power * ring.bins as f64).sum();
        total / self.rings.iter().map(|ring| ring.bins as f64).sum::<f64>()
    }
}

impl Summary {
    /// Of points.
    ///
    /// # Errors
    /// Points outside the unit cube, which patterns do not have.
    pub fn of(cloud: &Cloud) -> Result<Self> {
        let nothing = Self {
            points: cloud.len(),
            star_discrepancy: None,
            least_distance: None,
            least_distance_torus: None,
            spectrum: None,
        };
        if let Some(line) = cloud.line() {
            let mut sorted = line.to_vec();
            sorted.sort_unstable_by(f64::total_cmp);
            let least = sorted.windows(2).map(|pair| pair[1] - pair[0]).fold(f64::INFINITY, f64::min);
            let star_discrepancy = Some(star_discrepancy_line(line)?);
            return Ok(Self { star_discrepancy, least_distance: Some(least), ..nothing });
        }
        let Some(points) = cloud.plane() else { return Ok(nothing) };
        Ok(Self {
            star_discrepancy: Some(star_discrepancy(points)?),
            least_distance: Some(min_distance(points)?),
            least_distance_torus: Some(min_distance_torus(points)?),
            spectrum: Some(Spectrum::of(points)?),
            ..nothing
        })
    }
}
