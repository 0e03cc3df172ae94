//! What can be set in a figure: names, ranges, defaults, units.

use crate::error::{Error, Result, unknown};
use crate::text::Text;

/// One thing that can be set.
#[derive(Debug, Clone, Copy)]
pub struct Param {
    /// The name in `--set NAME=VALUE`.
    pub name: &'static str,
    /// What it is.
    pub about: &'static Text,
    /// Its kind, range and default.
    pub kind: Kind,
}

/// The kinds of parameters.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Kind {
    /// A real number.
    Real {
        /// What it is without being set.
        default: f64,
        /// The least that is allowed.
        low: f64,
        /// The greatest that is allowed.
        high: f64,
        /// What it is counted in, or nothing.
        unit: &'static str,
    },
    /// A whole number.
    Count {
        /// What it is without being set.
        default: usize,
        /// The least that is allowed.
        low: usize,
        /// The greatest that is allowed.
        high: usize,
    },
    /// One of several names; the first is the default.
    Choice(&'static [&'static str]),
}

impl Param {
    /// A real number.
    pub const fn real(
        name: &'static str,
        about: &'static Text,
        default: f64,
        low: f64,
        high: f64,
        unit: &'static str,
    ) -> Self {
        Self { name, about, kind: Kind::Real { default, low, high, unit } }
    }

    /// A whole number.
    pub const fn count(name: &'static str, about: &'static Text, default: usize, low: usize, high: usize) -> Self {
        Self { name, about, kind: Kind::Count { default, low, high } }
    }

    /// One of several names; the first is the default.
    pub const fn choice(name: &'static str, about: &'static Text, of: &'static [&'static str]) -> Self {
        Self { name, about, kind: Kind::Choice(of) }
    }

    fn default(&self) -> Value {
        match self.kind {
            Kind::Real { default, .. } => Value::Real(default),
            Kind::Count { default, .. } => Value::Count(default),
            Kind::Choice(of) => Value::Choice(of[0]),
        }
    }

    fn read(&self, given: &str) -> Result<Value> {
        let unreadable =
            |wanted| Error::Unreadable { what: format!("parameter {}", self.name), given: given.to_owned(), wanted };
        let outside = |value, low, high, unit: &str| {
            let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
            Error::Parameter { name: self.name, value, low, high, unit }
        };
        match self.kind {
            Kind::Real { low, high, unit, .. } => {
                let value: f64 = given.parse().map_err(|_| unreadable("a number"))?;
                let inside = (low..=high).contains(&value); // false for NaN
                if inside { Ok(Value::Real(value)) } else { Err(outside(value, low, high, unit)) }
            }
            Kind::Count { low, high, .. } => {
                let value: i128 = given.parse().map_err(|_| unreadable("a whole number"))?;
                let inside = (low as i128..=high as i128).contains(&value);
                if inside {
                    Ok(Value::Count(value as usize))
                } else {
                    Err(outside(value as f64, low as f64, high as f64, ""))
                }
            }
            Kind::Choice(of) => of
                .iter()
                .find(|name| **name == given)
                .map(|name| Value::Choice(name))
                .ok_or_else(|| unknown("choice", given, of.iter().copied())),
        }
    }
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Value {
    Real(f64),
    Count(usize),
    Choice(&'static str),
}

/// The values of a figure's parameters, each within its range.
#[derive(Debug, Clone, PartialEq)]
pub struct Params(Vec<(&'static str, Value)>);

impl Params {
    /// All at their defaults.
    pub fn defaults(of: &[Param]) -> Self {
        Self(of.iter().map(|p| (p.name, p.default())).collect())
    }

    /// The defaults with some replaced: `[("T", "0.9")]`.
    ///
    /// # Errors
    /// An unknown name, an unreadable value, a value outside its range.
    ///
    /// ```
    /// use nyquist::figure::params::{Param, Params};
    /// use nyquist::text::Text;
    /// static STEP: Text = Text::fixed("sampling step", "шаг");
    /// let of = [Param::real("T", &STEP, 0.8, 0.1, 2.0, "")];
    /// assert_eq!(Params::with(&of, [("T", "0.9")])?.real("T"), 0.9);
    /// let error = Params::with(&of, [("T", "-1")]).unwrap_err();
    /// assert_eq!(error.to_string(), "parameter T must lie between 0.1 and 2, got -1");
    /// # Ok::<(), nyquist::error::Error>(())
    /// ```
    pub fn with<'a>(of: &[Param], set: impl IntoIterator<Item = (&'a str, &'a str)>) -> Result<Self> {
        let mut values = Self::defaults(of);
        for (name, given) in set {
            let param = of.iter().find(|p| p.name == name);
            let param = param.ok_or_else(|| unknown("parameter", name, of.iter().map(|p| p.name)))?;
            let value = param.read(given)?;
            for slot in values.0.iter_mut().filter(|slot| slot.0 == name) {
                slot.1 = value;
            }
        }
        Ok(values)
    }

    fn get(&self, name: &str) -> Value {
        let found = self.0.iter().find(|slot| slot.0 == name);
        found.expect("a figure asks only for parameters that its entry declares").1
    }

    /// The real number of that name.
    ///
    /// # Panics
    /// If the figure's entry declares no real parameter of that name.
    pub fn real(&self, name: &str) -> f64 {
        let Value::Real(value) = self.get(name) else { panic!("parameter {name} is not declared as real") };
        value
    }

    /// The whole number of that name.
    ///
    /// # Panics
    /// If the figure's entry declares no count of that name.
    pub fn count(&self, name: &str) -> usize {
        let Value::Count(value) = self.get(name) else { panic!("parameter {name} is not declared as a count") };
        value
    }

    /// The choice of that name.
    ///
    /// # Panics
    /// If the figure's entry declares no choice of that name.
    pub fn choice(&self, name: &str) -> &'static str {
        let Value::Choice(value) = self.get(name) else { panic!("parameter {name} is not declared as a choice") };
        value
    }
}
