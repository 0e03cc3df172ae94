//! What was measured, beside what theory allows.

use std::borrow::Cow;

/// The outcome of checking one law once: it holds if `measured ≤ bound`.
///
/// Both numbers are in the units of the thing measured. A bound is computed and named where the law is stated: a
/// rounding bound `c·ε·n·scale`, a truncation tail, a quadrature error, a statistical deviation; never a bare number.
///
/// ```
/// use nyquist::residual::Residual;
/// let residual = Residual::near("sinc(1/2) = 2/π", nyquist::num::sinc(0.5), 2.0 / std::f64::consts::PI, f64::EPSILON);
/// assert!(residual.holds());
/// assert!(!Residual::at_most("a NaN holds nothing", f64::NAN, 1.0).holds());
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Residual {
    /// The law that was checked, in words or by its name.
    pub law: Cow<'static, str>,
    /// What was measured: a deviation, an error, a defect; zero is perfect.
    pub measured: f64,
    /// What theory allows.
    pub bound: f64,
}

impl Residual {
    /// `measured` must not exceed `bound`.
    pub fn at_most(law: impl Into<Cow<'static, str>>, measured: f64, bound: f64) -> Self {
        Self { law: law.into(), measured, bound }
    }

    /// `value` must be within `bound` of `expected`; what is measured is `|value − expected|`.
    pub fn near(law: impl Into<Cow<'static, str>>, value: f64, expected: f64, bound: f64) -> Self {
        Self::at_most(law, (value - expected).abs(), bound)
    }

    /// `value` must be at least `least`; what is measured is the shortfall `max(0, least − value)`, and none is allowed.
    pub fn at_least(law: impl Into<Cow<'static, str>>, value: f64, least: f64) -> Self {
        let shortfall = if value >= least { 0.0 } else { least - value };
        Self::at_most(law, shortfall, 0.0)
    }

    /// Whether `measured ≤ bound`. A NaN on either side does not hold.
    pub fn holds(&self) -> bool {
        self.measured <= self.bound
    }
}
