//! Where values are wanted: times as they are printed.

use crate::door::table::{Clock, Decimal};
use crate::error::{Error, Result};

/// Times at which values are wanted, counted exactly.
///
/// ```
/// use nyquist::door::table::{Reading, read_table};
/// use nyquist::record::Moments;
/// let table = read_table("log", b"1700000000.000,1\n1700000000.010,2\n", &Reading::default())?;
/// let clock = table.clock.as_ref().unwrap();
/// let moments = Moments::every("0.0025".parse().unwrap(), clock)?;
/// assert_eq!((moments.len(), moments.at(3).to_string().as_str()), (5, "1700000000.0075"));
/// assert_eq!(moments.since(3, clock.times[0]), 0.0075);
/// # Ok::<(), nyquist::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Moments(Kind);

#[derive(Debug, Clone, PartialEq)]
enum Kind {
    Every { first: Decimal, step: Decimal, count: usize },
    These(Vec<Decimal>),
}

/// The most moments, 2²⁶.
pub const MOST_MOMENTS: usize = 1 << 26;

impl Moments {
    /// Every `step` from a clock's earliest time to its latest.
    ///
    /// # Errors
    /// A step that is not positive; more than [`MOST_MOMENTS`]; times of more than 38 digits.
    pub fn every(step: Decimal, clock: &Clock) -> Result<Self> {
        let ends = clock.times.iter().copied();
        let first = ends.clone().min_by(|a, b| a.minus(*b).total_cmp(&0.0)).unwrap_or(Decimal::ZERO);
        let last = ends.max_by(|a, b| a.minus(*b).total_cmp(&0.0)).unwrap_or(Decimal::ZERO);
        Self::between(first, last, step)
    }

    /// Every `step` from the first moment, `last` included if it is one of them.
    fn between(first: Decimal, last: Decimal, step: Decimal) -> Result<Self> {
        let what = "the step of the times asked for";
        let size = step.value();
        if size <= 0.0 {
            return Err(Error::NotPositive { what, value: size });
        }
        let steps = last.minus(first) / size;
        let (what, most) = ("the number of times asked for", MOST_MOMENTS as f64);
        if steps >= most {
            return Err(Error::Overflow { what, value: steps + 1.0, most });
        }
        let at = |k: u64| step.times(k).and_then(|way| first.plus(way));
        let nearest = steps.round().max(0.0) as u64;
        // those between the ends have no more digits than the ends
        let (Some(_), Some(end)) = (at(0), at(nearest)) else {
            return Err(Error::Unsupported("times of more than 38 digits"));
        };
        let count = if last.minus(end) >= 0.0 { nearest + 1 } else { nearest };
        Ok(Self(Kind::Every { first, step, count: count as usize }))
    }

    /// The times of a clock, in its order.
    pub fn of(clock: &Clock) -> Self {
        Self(Kind::These(clock.times.clone()))
    }

    /// How many there are.
    pub fn len(&self) -> usize {
        match &self.0 {
            Kind::Every { count, .. } => *count,
            Kind::These(times) => times.len(),
        }
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The moment of index `i`, with its decimals.
    pub fn at(&self, i: usize) -> Decimal {
        match &self.0 {
            Kind::Every { first, step, .. } => {
                let way = step.times(i as u64).and_then(|way| first.plus(way));
                way.expect("the first and the last of the moments had digits enough")
            }
            Kind::These(times) => times[i],
        }
    }

    /// How long after `origin` it is, rounded once.
    pub fn since(&self, i: usize, origin: Decimal) -> f64 {
        self.at(i).minus(origin)
    }
}
