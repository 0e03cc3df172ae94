//! Least squares on a stretch of irregular samples.

use crate::axis::Edge;
use crate::beyond::Weighted;
use crate::error::{Error, Result, positive};
use crate::num::scale::scale;
use crate::record::dense::Dense;
use crate::record::ends::{Ends, Recovered};
use crate::sampled::harmonics::Places;

/// Where no band is asked for, the highest of these parts of the highest band is taken that is well conditioned.
const PARTS: [f64; 9] = [0.9, 0.8, 0.7, 0.6, 0.5, 0.4, 0.3, 0.2, 0.1];
/// What is well: noise of the values grows by two digits at most.
const WELL: f64 = 100.0;
/// Samples beyond the unknowns that the ends need.
const SPARE: usize = 8;

/// Positions of a stretch, prepared for the recovery of any values at them: a period, a band, and the condition number.
///
/// The record is continued beyond its ends as a period ([`Edge::Wrap`]) or by its reflection ([`Edge::Mirror`]); a
/// trigonometric polynomial of least squares ([`Weighted`]) goes with it. What the record itself does not continue, jumps
/// and bends at its ends, would ring throughout; so a polynomial of degree four is fitted beside it, which costs four more
/// unknowns and takes them up (as in the method of Eckhoff, *Accurate reconstructions of functions of finite regularity*,
/// 1995).
#[derive(Debug, Clone)]
pub struct Recoverable {
    equations: Weighted,
    mirrored: bool,
    degree: usize,
    condition: f64,
    positions: Vec<f64>,
    ends: Ends,
}

impl Recoverable {
    /// Strictly rising positions, which stand at these `nodes` of a grid if there is one; the `band` to recover, or the
    /// highest part (0.9, 0.8, …) of half their density whose condition number is at most 100.
    ///
    /// # Errors
    /// Fewer than two positions; an edge that is neither wrap nor mirror; [`Error::OutOfRange`] for a band above half the
    /// density (Landau); [`Error::IllConditioned`] for one whose condition number exceeds `most_condition`; sums that are
    /// too long ([`Places::harmonics`]).
    pub fn new(
        positions: &[f64],
        nodes: Option<&[usize]>,
        edge: Edge,
        band: Option<f64>,
        most_condition: f64,
    ) -> Result<Self> {
        let mut recoverable = Self::of_period(positions, nodes, edge, band, most_condition)?;
        let (n, degree) = (positions.len(), recoverable.degree);
        let unknowns = if recoverable.mirrored { degree + 1 } else { 2 * degree + 1 };
        if n >= unknowns + SPARE {
            let fit = |values: &[f64]| recoverable.polynomial(values);
            let weights: Vec<f64> = recoverable.equations.weights()[..n].to_vec();
            recoverable.ends = Ends::new(&recoverable.positions, &weights, fit)?;
        }
        Ok(recoverable)
    }

    /// The same for [`fit_period`](Self::fit_period) alone, without polynomials beside the period: [`fit`](Self::fit) then
    /// is that, too.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn of_period(
        positions: &[f64],
        nodes: Option<&[usize]>,
        edge: Edge,
        band: Option<f64>,
        most_condition: f64,
    ) -> Result<Self> {
        let n = positions.len();
        if n < 2 {
            return Err(Error::TooFew { what: "irregular samples to recover a signal from", least: 2, got: n });
        }
        let mirrored = match edge {
            Edge::Wrap => false,
            Edge::Mirror => true,
            _ => return Err(Error::Unsupported("least squares continue a record by wrap or mirror alone")),
        };
        let span = positions[n - 1] - positions[0];
        let cells = nodes.map_or(n, |nodes| nodes[n - 1] - nodes[0] + 1);
        let step = positive("the mean step of irregular samples", span / (cells - 1) as f64)?;
        let whole = cells as f64 * step;
        let (start, period) = if mirrored { (positions[0] - 0.5 * step, 2.0 * whole) } else { (positions[0], whole) };
        let places = match (nodes, mirrored) {
            (Some(nodes), false) => Places::Grid { nodes: cells, taken: nodes.iter().map(|k| k - nodes[0]).collect() },
            (Some(nodes), true) => {
                // half a step between the mirror and the first node
                let forth = nodes.iter().map(|k| 2 * (k - nodes[0]) + 1);
                let back = nodes.iter().rev().map(|k| 4 * cells - 2 * (k - nodes[0]) - 1);
                Places::Grid { nodes: 4 * cells, taken: forth.chain(back).collect() }
            }
            (None, false) => Places::Anywhere(positions.iter().map(|x| (x - start) / period).collect()),
            (None, true) => {
                let forth = positions.iter().map(|x| (x - start) / period);
                let back = positions.iter().rev().map(|x| 1.0 - (x - start) / period);
                Places::Anywhere(forth.chain(back).collect())
            }
        };
        let determined = (places.len() - 1) / 2;
        let of_band = |band: f64| -> Result<usize> {
            positive("the band", band)?;
            let degree = (band * period * (1.0 + 4.0 * f64::EPSILON)).floor();
            if degree > determined as f64 {
                let (what, high) = ("the band that so many samples can determine", determined as f64 / period);
                return Err(Error::OutOfRange { what, value: band, low: 0.0, high });
            }
            Ok(degree as usize)
        };
        let asked = band.map(of_band).transpose()?;
        let part = |part: f64| (part * determined as f64).floor() as usize;
        let equations = Weighted::new(start..start + period, places, asked.unwrap_or(part(PARTS[0])))?;
        let equations = if mirrored { equations.even() } else { equations };
        let (degree, condition) = match asked {
            Some(degree) => (degree, equations.condition(degree, most_condition)?),
            None => {
                let well = |&p: &f64| Some((part(p), equations.condition(part(p), WELL).ok()?));
                let least = part(PARTS[PARTS.len() - 1]);
                let found = PARTS.iter().find_map(well);
                found.map_or_else(|| Ok((least, equations.condition(least, most_condition)?)), Ok::<_, Error>)?
            }
        };
        let (positions, ends) = (positions.to_vec(), Ends::none(positions));
        Ok(Self { equations, mirrored, degree, condition, positions, ends })
    }

    /// The band that is recovered.
    pub fn band(&self) -> f64 {
        self.degree as f64 / self.equations.period()
    }

    /// By how much relative errors of the values may grow.
    pub fn condition(&self) -> f64 {
        self.condition
    }

    /// The signal that passes nearest to these values, and its distance from them in the root mean square.
    ///
    /// # Errors
    /// As [`Weighted::fit`].
    pub fn fit(&self, values: &[f64]) -> Result<(Recovered, f64)> {
        let dense = self.polynomial(values)?;
        let recovered = self.ends.taken_up(dense, &self.positions, values, self.mirrored)?;
        let misfit = rms(&recovered.at_all(&self.positions), values);
        Ok((recovered, misfit))
    }

    /// The trigonometric polynomial alone that passes nearest to these values, for what fades in and out at the ends; and
    /// its distance from them.
    ///
    /// # Errors
    /// As [`Weighted::fit`].
    pub fn fit_period(&self, values: &[f64]) -> Result<(Dense, f64)> {
        let dense = self.polynomial(values)?;
        let misfit = rms(&dense.at_all(&self.positions), values);
        Ok((dense, misfit))
    }

    fn polynomial(&self, values: &[f64]) -> Result<Dense> {
        if !self.mirrored {
            return Ok(Dense::of(self.equations.fit(values, self.degree)?));
        }
        let both: Vec<f64> = values.iter().chain(values.iter().rev()).copied().collect();
        Ok(Dense::of(self.equations.fit(&both, self.degree)?))
    }
}

/// The root mean square of differences.
fn rms(near: &[f64], values: &[f64]) -> f64 {
    let differences = || near.iter().zip(values).map(|(a, b)| a - b);
    let unit = scale(differences());
    let squares: f64 = differences().map(|d| (d / unit).powi(2)).sum();
    unit * (squares / values.len() as f64).sqrt()
}
