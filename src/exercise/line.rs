//! What is asked of an answer: cases with their truths, and the error that is allowed.

use crate::residual::Residual;
use crate::text::{Lang, Text};

/// One case: how the answer was called, what it said, and what is true.
#[derive(Debug, Clone, PartialEq)]
pub struct Case {
    /// The call, as it would stand in a program: `alias(0.9, 1.0)`.
    pub call: String,
    /// Where it stands in a plot.
    pub at: f64,
    /// What the answer said.
    pub said: f64,
    /// What is true.
    pub truth: f64,
}

impl Case {
    /// How far the answer is from the truth; NaN for a NaN.
    pub fn error(&self) -> f64 {
        (self.said - self.truth).abs()
    }
}

/// A demand: several cases of one kind, none of which may be off by more than is allowed.
///
/// ```
/// use nyquist::exercise::Line;
/// use nyquist::text;
/// let half = |x: f64| 0.5 * x;
/// let line = Line::new(text!("half of a whole number", "половина целого числа"), 0.0)
///     .over((0..4).map(f64::from), |x| (format!("half({x})"), half(x), x / 2.0));
/// assert!(line.residual().holds());
/// assert_eq!(line.worst().map(|case| case.call.as_str()), Some("half(0)"));
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Line {
    /// What is asked.
    pub law: Text,
    /// The error that is allowed in each case.
    pub allowed: f64,
    /// What the cases of a plot are over; none is drawn if empty.
    pub along: Text,
    /// The cases.
    pub cases: Vec<Case>,
}

impl Line {
    /// A demand without cases yet.
    pub fn new(law: Text, allowed: f64) -> Self {
        Self { law, allowed, along: Text::EMPTY, cases: Vec::new() }
    }

    /// Drawn over that quantity: what the answer says beside the truth.
    #[must_use]
    pub fn along(mut self, axis: Text) -> Self {
        self.along = axis;
        self
    }

    /// With one more case.
    #[must_use]
    pub fn case(mut self, call: impl Into<String>, said: f64, truth: f64) -> Self {
        let at = self.cases.len() as f64;
        self.cases.push(Case { call: call.into(), at, said, truth });
        self
    }

    /// With a case at each of these places: the call, what the answer says, what is true.
    #[must_use]
    pub fn over(mut self, places: impl IntoIterator<Item = f64>, case: impl Fn(f64) -> (String, f64, f64)) -> Self {
        self.cases.extend(places.into_iter().map(|at| {
            let (call, said, truth) = case(at);
            Case { call, at, said, truth }
        }));
        self
    }

    /// With a case for the number of values of a list, and for each value.
    #[must_use]
    pub fn list(mut self, call: &str, said: &[f64], truth: &[f64]) -> Self {
        self = self.case(format!("{call}.len()"), said.len() as f64, truth.len() as f64);
        for (i, (said, truth)) in said.iter().zip(truth).enumerate() {
            self = self.case(format!("{call}[{i}]"), *said, *truth);
        }
        self
    }

    /// The case with the largest error, a NaN before all.
    pub fn worst(&self) -> Option<&Case> {
        let weight = |case: &Case| if case.error().is_nan() { f64::INFINITY } else { case.error() };
        self.cases.iter().reduce(|worst, case| if weight(case) > weight(worst) { case } else { worst })
    }

    /// The largest error beside the allowed one. A demand without cases is not met.
    pub fn residual(&self) -> Residual {
        let measured = self.worst().map_or(f64::NAN, Case::error);
        Residual::at_most(self.law.get(Lang::En).to_owned(), measured, self.allowed)
    }

    /// Whether another answer said the same, up to the allowed error.
    pub(super) fn says_the_same(&self, other: &Self) -> bool {
        let same = |a: f64, b: f64| a == b || (a.is_nan() && b.is_nan()) || (a - b).abs() <= self.allowed;
        let mut cases = self.cases.iter().zip(&other.cases);
        self.cases.len() == other.cases.len() && cases.all(|(a, b)| a.call == b.call && same(a.said, b.said))
    }
}
