//! The one error of the library: what was wrong, where, and with which numbers.

/// A number as one would write it: with a power of ten where it is very large or very small.
fn short(value: f64) -> String {
    let usual = value == 0.0 || !value.is_finite() || (1e-6..1e16).contains(&value.abs());
    if usual { format!("{value}") } else { format!("{value:e}") }
}

/// Why a thing could not be made.
///
/// Everything is validated once, at construction; what has been constructed is total and cannot fail. The variants
/// carry the numbers, so that a caller can match on them and a reader can act on the sentence.
///
/// ```
/// use nyquist::prelude::*;
/// let error = Axis::new(0.0, -0.5, 8).unwrap_err();
/// assert_eq!(error, Error::NotPositive { what: "the step of an axis", value: -0.5 });
/// assert_eq!(error.to_string(), "the step of an axis must be greater than zero, got -0.5");
/// assert!(Axis::new(0.0, -1e-300, 8).unwrap_err().to_string().ends_with("got -1e-300"));
/// ```
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// A number that is NaN or infinite where only finite ones make sense.
    #[error("{what} must be finite, got {value}")]
    NotFinite {
        /// What the number stands for.
        what: &'static str,
        /// The number.
        value: f64,
    },
    /// One of many values is NaN or infinite.
    #[error("{what} must be finite, but number {index} (counted from 0) is {value}")]
    NotFiniteAt {
        /// What the values are.
        what: &'static str,
        /// Which of them, counted from zero.
        index: usize,
        /// The value found there.
        value: f64,
    },
    /// A number that must be greater than zero and is not.
    #[error("{what} must be greater than zero, got {}", short(*value))]
    NotPositive {
        /// What the number stands for.
        what: &'static str,
        /// The number.
        value: f64,
    },
    /// A number outside its range.
    #[error("{what} must lie between {} and {}, got {}", short(*low), short(*high), short(*value))]
    OutOfRange {
        /// What the number stands for.
        what: &'static str,
        /// The number.
        value: f64,
        /// The least that is allowed.
        low: f64,
        /// The greatest that is allowed.
        high: f64,
    },
    /// Too few of something.
    #[error("{what}: at least {least} needed, got {got}")]
    TooFew {
        /// What there is too little of.
        what: &'static str,
        /// How many are needed.
        least: usize,
        /// How many there are.
        got: usize,
    },
    /// Two lengths that must agree and do not.
    #[error("{what}: expected {expected}, got {got}")]
    Length {
        /// Whose length it is.
        what: &'static str,
        /// The length that fits.
        expected: usize,
        /// The length that was given.
        got: usize,
    },
    /// A number of things that a construction cannot have; the nearest that it can have stand beside it.
    #[error("{what}: {given} is impossible; the nearest numbers are {below} and {above}")]
    Count {
        /// What the construction is.
        what: &'static str,
        /// The number asked for.
        given: usize,
        /// The largest possible number below it (zero if there is none).
        below: usize,
        /// The smallest possible number above it.
        above: usize,
    },
    /// A pattern of points that there is only in another number of dimensions.
    #[error("dimensions of the pattern {pattern}: only {own} are possible, not {given}")]
    Dimensions {
        /// The pattern's name.
        pattern: String,
        /// The number of dimensions that it has.
        own: usize,
        /// The number asked for.
        given: usize,
    },
    /// A size that does not fit into memory or into its type.
    #[error("{what} overflows: {} is more than {}", short(*value), short(*most))]
    Overflow {
        /// What became too large.
        what: &'static str,
        /// The size asked for.
        value: f64,
        /// The largest that is allowed.
        most: f64,
    },
    /// A name that nothing is called; the known ones stand with the nearest first.
    #[error("no {kind} is called \"{name}\"; known: {}", known.join(", "))]
    Unknown {
        /// What kind of thing was asked for: figure, law, kernel, …
        kind: &'static str,
        /// The name that was given.
        name: String,
        /// The names that exist, nearest first.
        known: Vec<String>,
    },
    /// A value that cannot be read as what it should be.
    #[error("{what}: cannot read \"{given}\" as {wanted}")]
    Unreadable {
        /// Whose value it is.
        what: String,
        /// The text given.
        given: String,
        /// What it should have been.
        wanted: &'static str,
    },
    /// A value of a named parameter outside its range.
    #[error("parameter {name} must lie between {} and {}{unit}, got {}", short(*low), short(*high), short(*value))]
    Parameter {
        /// The parameter's name.
        name: &'static str,
        /// The value given.
        value: f64,
        /// The least that is allowed.
        low: f64,
        /// The greatest that is allowed.
        high: f64,
        /// The unit with a space before it, or nothing.
        unit: String,
    },
    /// A problem whose answer would be amplified noise.
    #[error("{what}: the condition number {condition:.3e} is above the allowed {most:.3e}")]
    IllConditioned {
        /// Which problem.
        what: &'static str,
        /// Its condition number.
        condition: f64,
        /// The largest that was allowed.
        most: f64,
    },
    /// A file that is not what it should be: truncated, lying about its size, or of a kind that is not read.
    #[error("{file}: {reason}")]
    Format {
        /// The file, as it was named.
        file: String,
        /// What is wrong with it.
        reason: String,
    },
    /// A file that cannot be read or written.
    #[error("{file}: {reason}")]
    Io {
        /// The file, as it was named.
        file: String,
        /// What the system says.
        reason: String,
    },
    /// A law that does not hold.
    #[error("{law}: measured {measured:.3e}, allowed {bound:.3e}")]
    Broken {
        /// Which law.
        law: String,
        /// What was measured.
        measured: f64,
        /// What theory allows.
        bound: f64,
    },
    /// A combination that has no meaning.
    #[error("{0}")]
    Unsupported(&'static str),
}

/// `Result` with this crate's [`Error`].
pub type Result<T> = std::result::Result<T, Error>;

/// `value` if it is finite.
///
/// # Errors
/// [`Error::NotFinite`] that names `what`.
pub fn finite(what: &'static str, value: f64) -> Result<f64> {
    if value.is_finite() { Ok(value) } else { Err(Error::NotFinite { what, value }) }
}

/// `value` if it is finite, greater than zero and has a finite reciprocal (no subnormal number).
///
/// # Errors
/// [`Error::NotFinite`], [`Error::NotPositive`] or [`Error::OutOfRange`], naming `what`.
pub fn positive(what: &'static str, value: f64) -> Result<f64> {
    finite(what, value)?;
    match value {
        _ if value <= 0.0 => Err(Error::NotPositive { what, value }),
        // below it the reciprocal overflows: a step without a rate, a rate without a step
        _ if value < f64::MIN_POSITIVE => {
            Err(Error::OutOfRange { what, value, low: f64::MIN_POSITIVE, high: f64::MAX })
        }
        _ => Ok(value),
    }
}

/// `value` if it is finite and within `low..=high`.
///
/// # Errors
/// [`Error::NotFinite`] or [`Error::OutOfRange`], naming `what`.
pub fn within(what: &'static str, value: f64, low: f64, high: f64) -> Result<f64> {
    finite(what, value)?;
    if (low..=high).contains(&value) { Ok(value) } else { Err(Error::OutOfRange { what, value, low, high }) }
}

/// `values` if there is at least one and all are finite.
///
/// # Errors
/// [`Error::TooFew`] or [`Error::NotFiniteAt`], naming `what`.
pub fn all_finite<'a>(what: &'static str, values: &'a [f64]) -> Result<&'a [f64]> {
    if values.is_empty() {
        return Err(Error::TooFew { what, least: 1, got: 0 });
    }
    match values.iter().position(|v| !v.is_finite()) {
        None => Ok(values),
        Some(index) => Err(Error::NotFiniteAt { what, index, value: values[index] }),
    }
}

/// The error for an unknown `name`, with the `known` ones sorted by how near they are to it.
///
/// Nearness is the edit distance (insertions, deletions, substitutions; Levenshtein 1965), less where one name
/// contains the other.
///
/// ```
/// use nyquist::error::{Error, unknown};
/// let Error::Unknown { known, .. } = unknown("kernel", "michell", ["box", "tent", "mitchell"]) else { panic!() };
/// assert_eq!(known[0], "mitchell");
/// ```
pub fn unknown<'a>(kind: &'static str, name: &str, known: impl IntoIterator<Item = &'a str>) -> Error {
    let mut known: Vec<String> = known.into_iter().map(str::to_owned).collect();
    let near = |k: &String| {
        let contains = k.contains(name) || name.contains(k.as_str());
        let shared = if contains { k.chars().count().min(name.chars().count()) } else { 0 };
        edits(k, name) as i64 - shared as i64
    };
    known.sort_by_key(near);
    Error::Unknown { kind, name: name.to_owned(), known }
}

fn edits(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, ca) in a.chars().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, cb) in b.iter().enumerate() {
            let substituted = diagonal + usize::from(ca != *cb);
            diagonal = row[j + 1];
            row[j + 1] = substituted.min(row[j] + 1).min(diagonal + 1);
        }
    }
    row[b.len()]
}
