//! What would alias at another rate.

use crate::error::Result;
use crate::inspect::table::Findings;
use crate::inspect::table::lines::Line;
use crate::nyquist::Alias;

/// A line that folds, and where it lands.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Landing {
    /// The line.
    pub line: Line,
    /// Where its samples put it.
    pub alias: Alias,
}

impl Landing {
    /// The phase that the alias has where the first new sample stands `start` after the first position of the record: that of
    /// `A cos(2πν′t + φ′)`, `t` counted from the new sample.
    pub fn phase(&self, start: f64) -> f64 {
        let turns = (self.line.frequency * start).rem_euclid(1.0);
        let phase = 2.0 * std::f64::consts::PI * turns + self.line.phase;
        if self.alias.conjugated() { -phase } else { phase }
    }
}

/// What samples of the same signal at a rate `R` would hold, taken as they are: without a filter.
///
/// ```
/// use nyquist::inspect::table::{Look, Prediction, inspect};
/// use nyquist::num::cos_pi;
/// use nyquist::record::Sampling;
/// let times: Vec<f64> = (0..1000).map(|k| f64::from(k) / 1000.0).collect();
/// let values: Vec<f64> = times.iter().map(|t| cos_pi(2.0 * 13.0 * t) + 0.01 * cos_pi(2.0 * 90.0 * t)).collect();
/// let found = inspect(&Sampling::of(&times, &[0.0; 1000])?, &values, Look::default())?;
/// let at_80 = Prediction::new(&found, 80.0)?;
/// assert!((at_80.landings[0].alias.frequency() - 10.0).abs() < 1e-9);
/// assert!((at_80.signal_to_alias() - 40.0).abs() < 0.1);
/// assert!((at_80.rate_for(60.0).unwrap() - 180.0).abs() < 1e-6); // twice the higher line
/// assert!(Prediction::new(&found, 200.0)?.landings.is_empty());
/// # Ok::<(), nyquist::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Prediction<'a> {
    /// The rate.
    pub rate: f64,
    /// The lines at and above half of it, the strongest first.
    pub landings: Vec<Landing>,
    found: &'a Findings,
}

impl<'a> Prediction<'a> {
    /// Of what was found in a record.
    ///
    /// # Errors
    /// A rate that is not positive and finite.
    pub fn new(found: &'a Findings, rate: f64) -> Result<Self> {
        let landing = |line: &Line| Ok(Landing { line: *line, alias: Alias::of(line.frequency, rate)? });
        let all = found.lines.iter().map(landing).collect::<Result<Vec<_>>>()?;
        // a zero among the lines would have checked the rate as well
        Alias::of(0.0, rate)?;
        let landings = all.into_iter().filter(|landing| landing.line.frequency >= 0.5 * rate).collect();
        Ok(Self { rate, landings, found })
    }

    /// The energy that folds: all at and above half the rate, also what could not be resolved.
    pub fn aliased(&self) -> f64 {
        self.found.energy.above(0.5 * self.rate)
    }

    /// That part of it which is not in lines: noise, or a broad spectrum.
    pub fn aliased_rest(&self) -> f64 {
        let lines: f64 = self.landings.iter().map(|landing| landing.line.energy()).sum();
        (self.aliased() - lines).max(0.0)
    }

    /// What stays where it is over what folds, in dB; infinite if nothing does.
    pub fn signal_to_alias(&self) -> f64 {
        let (total, aliased) = (self.found.energy.total(), self.aliased());
        if aliased == 0.0 { f64::INFINITY } else { 10.0 * ((total - aliased).max(0.0) / aliased).log10() }
    }

    /// The rate above which what folds is `tolerance` dB below the signal; none if more than that is unresolved.
    pub fn rate_for(&self, tolerance: f64) -> Option<f64> {
        let aliased = 1.0 / (1.0 + 10f64.powf(0.1 * tolerance));
        self.found.energy.occupied(1.0 - aliased).map(|band| 2.0 * band)
    }
}
