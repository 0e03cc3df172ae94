//! Adaptive sampling: more samples where neighbours differ.

use crate::axis::Axis;
use crate::error::{Error, Result, positive};
use crate::signal::Signal;

/// Samples on an axis, and between neighbours that differ further ones by bisection.
///
/// An interval whose ends differ by more than the contrast is halved, and so are its halves, `n` times at most. A jump
/// is so localised to `δ = T/2ⁿ` with `n` further samples, where uniform samples must stand `2ⁿ` times as dense. What
/// falls between two equal samples is never found, however high it is: the slide "Адаптивное сэмплирование" rightly
/// calls it a hard problem (Whitted 1980; Mitchell 1987).
///
/// ```
/// use nyquist::prelude::*;
/// let edge = from_fn(|x| f64::from(x > 0.3));
/// let refined = Refined::of(&edge, Axis::new(0.0, 1.0, 3)?, 0.5, 3)?;
/// let tried: Vec<f64> = refined.samples().iter().map(|s| s.at).collect();
/// assert_eq!((tried, refined.extra()), (vec![0.0, 0.25, 0.375, 0.5, 1.0, 2.0], 3));
/// assert_eq!(refined.steep().collect::<Vec<_>>(), [[0.25, 0.375]]);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Refined {
    samples: Vec<Refinement>,
    contrast: f64,
}

/// One of the samples.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Refinement {
    /// Where it was taken.
    pub at: f64,
    /// The value found there.
    pub value: f64,
    /// How many times its interval had been halved when it was taken; zero for those on the axis.
    pub level: u32,
}

impl Refined {
    /// Samples a signal on `axis`, and halves intervals whose ends differ by more than `contrast`, down to the
    /// `2^halvings`-th part of a step.
    ///
    /// # Errors
    /// A contrast that is not positive; more than 20 halvings, which are a million samples for every step of noise.
    pub fn of(signal: &impl Signal, axis: Axis, contrast: f64, halvings: u32) -> Result<Self> {
        positive("the contrast that asks for more samples", contrast)?;
        if halvings > 20 {
            let what = "how often an interval is halved";
            return Err(Error::Overflow { what, value: halvings.into(), most: 20.0 });
        }
        let search = Search { signal, contrast, halvings };
        let uniform: Vec<Refinement> =
            axis.iter().map(|at| Refinement { at, value: signal.at(at), level: 0 }).collect();
        let mut samples = vec![uniform[0]];
        for pair in uniform.windows(2) {
            search.halve([pair[0], pair[1]], 1, &mut samples);
            samples.push(pair[1]);
        }
        Ok(Self { samples, contrast })
    }

    /// All samples, from left to right.
    pub fn samples(&self) -> &[Refinement] {
        &self.samples
    }

    /// How many were taken beyond those on the axis.
    pub fn extra(&self) -> usize {
        self.samples.iter().filter(|s| s.level > 0).count()
    }

    /// The intervals between neighbours that still differ by more than the contrast: where the jumps are.
    pub fn steep(&self) -> impl Iterator<Item = [f64; 2]> + '_ {
        let differ = |pair: &&[Refinement]| (pair[1].value - pair[0].value).abs() > self.contrast;
        self.samples.windows(2).filter(differ).map(|pair| [pair[0].at, pair[1].at])
    }
}

struct Search<'a, S> {
    signal: &'a S,
    contrast: f64,
    halvings: u32,
}

impl<S: Signal> Search<'_, S> {
    /// The samples strictly between the ends, from left to right.
    fn halve(&self, [left, right]: [Refinement; 2], level: u32, samples: &mut Vec<Refinement>) {
        if level > self.halvings || (right.value - left.value).abs() <= self.contrast {
            return;
        }
        let at = 0.5 * (left.at + right.at);
        let middle = Refinement { at, value: self.signal.at(at), level };
        self.halve([left, middle], level + 1, samples);
        samples.push(middle);
        self.halve([middle, right], level + 1, samples);
    }
}
