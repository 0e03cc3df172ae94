//! What is in a record of times and values: its lines, its band, and where they would go at another rate.
//!
//! Everything works for positions of any kind ([`Sampling`]); where they lie on a grid, with or without gaps, by fast
//! transforms.

mod check;
mod drift;
mod energy;
mod frame;
mod likeness;
mod lines;
mod prediction;
mod spectrum;
mod tone;
pub mod units;

pub use check::{ColumnCheck, TOLERANCE, TableCheck};
pub use energy::Energy;
pub use likeness::Likeness;
pub use lines::Line;
pub use prediction::{Landing, Prediction};
pub use spectrum::LeastSquaresSpectrum;

use crate::error::{Error, Result, within};
use crate::inspect::table::frame::Frame;
use crate::num::mean::mean;
use crate::record::Sampling;
use crate::sampled::segments::LARGEST;
use crate::sampled::window::Window;
use std::ops::Range;

/// Samples below which a spectrum says nothing.
const FEWEST: usize = 8;

/// How a record is to be looked at.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Look {
    /// The window under which the spectrum is taken.
    pub window: Window,
    /// The highest frequency looked at. None: half the rate of the grid or of the mean step; where there is no step, the
    /// density, but no more than 2²³ − 1 frequencies.
    pub up_to: Option<f64>,
    /// How many lines are looked for.
    pub most_lines: usize,
}

impl Default for Look {
    /// Hann's window, eight lines.
    fn default() -> Self {
        Self { window: Window::Hann, up_to: None, most_lines: 8 }
    }
}

/// What was found in a record.
#[derive(Debug, Clone, PartialEq)]
pub struct Findings {
    /// Which of the positions were looked at: all, or the longest stretch of a record that is nearly all gaps.
    pub looked_at: Range<usize>,
    /// The spectrum.
    pub spectrum: LeastSquaresSpectrum,
    /// The mean of the values.
    pub mean: f64,
    /// The root mean square of their distance from it.
    pub rms: f64,
    /// The lines found, the strongest first.
    pub lines: Vec<Line>,
    /// What is left when they are taken away: its root mean square.
    pub rest: f64,
    /// Where the energy is.
    pub energy: Energy,
    /// Shifts by which lines can hardly be told apart at these positions; none for equally spaced ones, where a shift by the
    /// rate changes nothing at all.
    pub likenesses: Vec<Likeness>,
}

/// Looks into a record: `values` at the positions of `sampling`.
///
/// ```
/// use nyquist::inspect::table::{Look, inspect};
/// use nyquist::num::cos_pi;
/// use nyquist::num::random::uniform;
/// use nyquist::record::Sampling;
/// // two tones at times that jitter by a third of the step
/// let times: Vec<f64> = (0..400u32).map(|k| 0.01 * (f64::from(k) + 0.3 * uniform(1, k.into(), 0))).collect();
/// let at = |t: f64| 2.0 * cos_pi(2.0 * 12.3 * t) + 0.5 * cos_pi(2.0 * 31.7 * t) + 7.0;
/// let sampling = Sampling::of(&times, &[0.0; 400])?;
/// let found = inspect(&sampling, &times.iter().map(|&t| at(t)).collect::<Vec<_>>(), Look::default())?;
/// assert!((found.lines[0].frequency - 12.3).abs() < 1e-9 && (found.lines[0].amplitude - 2.0).abs() < 1e-9);
/// assert!((found.lines[1].frequency - 31.7).abs() < 1e-9 && (found.mean - 7.0).abs() < 0.01);
/// assert_eq!(found.energy.occupied(0.999), Some(found.lines[1].frequency));
/// # Ok::<(), nyquist::error::Error>(())
/// ```
///
/// # Errors
/// Fewer than eight positions, also of the longest stretch where that is looked at; values of another number, not finite, or
/// beyond 10¹⁴⁰; a highest frequency that is not positive, leaves no frequency, or would take more than 2²³ − 1 of them
/// (on a grid, more than its nodes as well).
pub fn inspect(sampling: &Sampling, values: &[f64], look: Look) -> Result<Findings> {
    let n = sampling.positions().len();
    if n < FEWEST {
        return Err(Error::TooFew { what: "samples for a spectrum", least: FEWEST, got: n });
    }
    let looked_at = sampling.main_stretch();
    if looked_at.len() < n {
        let values = values.get(looked_at.clone()).unwrap_or_default();
        return Ok(Findings { looked_at: looked_at.clone(), ..inspect(&sampling.part(looked_at), values, look)? });
    }
    let peak = values.iter().map(|v| v.abs()).fold(0.0, f64::max);
    within("the size of the largest value, whose square is needed", peak, 0.0, LARGEST)?;
    let frame = Frame::new(sampling, look.window, look.up_to)?;
    let spectrum = LeastSquaresSpectrum::in_frame(&frame, values)?;
    let average = mean(values);
    let centred: Vec<f64> = values.iter().map(|v| v - average).collect();
    let (lines, rest) = lines::lines(&frame, &centred, look.most_lines)?;
    let energy = Energy::of(sampling, &lines, &rest);
    let rms = |values: &[f64]| (values.iter().map(|v| v * v).sum::<f64>() / n as f64).sqrt();
    Ok(Findings {
        looked_at,
        spectrum,
        mean: average,
        rms: rms(&centred),
        lines,
        rest: rms(&rest),
        energy,
        likenesses: likeness::likenesses(&frame, sampling),
    })
}
