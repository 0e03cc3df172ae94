//! Where things are: [`Axis`], its [`Unit`], and what lies beyond its ends ([`Edge`]).

use crate::error::{Error, Result, finite, positive, unknown};
use std::ops::Range;
use std::str::FromStr;

/// What one step along an axis is counted in: a symbol, or its reciprocal.
///
/// ```
/// use nyquist::axis::Unit;
/// assert_eq!(Unit::SECOND.reciprocal().to_string(), "1/s");
/// assert_eq!(Unit::SECOND.reciprocal().reciprocal(), Unit::SECOND);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Unit {
    symbol: &'static str,
    reciprocal: bool,
}

impl Unit {
    /// A pure number: positions without a unit, frequencies in cycles per one.
    pub const ONE: Self = Self { symbol: "", reciprocal: false };
    /// Seconds; the reciprocal is hertz.
    pub const SECOND: Self = Self { symbol: "s", reciprocal: false };
    /// Pixels; the reciprocal is cycles per pixel.
    pub const PIXEL: Self = Self { symbol: "px", reciprocal: false };

    /// The unit of frequencies for this unit of positions, and back.
    pub fn reciprocal(self) -> Self {
        Self { reciprocal: !self.reciprocal, ..self }
    }
}

impl std::fmt::Display for Unit {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match (self.reciprocal, self.symbol) {
            (_, "") => Ok(()),
            (false, symbol) => write!(f, "{symbol}"),
            (true, symbol) => write!(f, "1/{symbol}"),
        }
    }
}

/// What a record of samples is continued by beyond its ends.
///
/// For three samples `a b c`: zero `0 0|abc|0 0`, clamp `a a|abc|c c`, wrap `b c|abc|a b`, mirror `b a|abc|c b`
/// (the end samples are repeated: the mirror stands half a step outside, as for pixels).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Edge {
    /// Nothing there.
    #[default]
    Zero,
    /// The end sample repeated.
    Clamp,
    /// The record repeated.
    Wrap,
    /// The record reflected.
    Mirror,
}

impl Edge {
    /// All four.
    pub const ALL: [Self; 4] = [Self::Zero, Self::Clamp, Self::Wrap, Self::Mirror];

    /// Its name: `zero`, `clamp`, `wrap`, `mirror`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Zero => "zero",
            Self::Clamp => "clamp",
            Self::Wrap => "wrap",
            Self::Mirror => "mirror",
        }
    }

    /// Which of `len` samples stands at position `index`, or `None` for nothing.
    ///
    /// ```
    /// use nyquist::axis::Edge;
    /// let at = |edge: Edge| (-2..5).map(|i| edge.index(i, 3)).collect::<Vec<_>>();
    /// assert_eq!(at(Edge::Wrap), [1, 2, 0, 1, 2, 0, 1].map(Some));
    /// assert_eq!(at(Edge::Mirror), [1, 0, 0, 1, 2, 2, 1].map(Some));
    /// ```
    pub fn index(self, index: i64, len: usize) -> Option<usize> {
        let n = len as i64;
        let inside = match self {
            Self::Zero => index,
            Self::Clamp => index.clamp(0, n - 1),
            Self::Wrap => index.rem_euclid(n),
            Self::Mirror => {
                let m = index.rem_euclid(2 * n);
                m.min(2 * n - 1 - m)
            }
        };
        (0..n).contains(&inside).then_some(inside as usize)
    }
}

/// Reads an edge's name, in letters of any case.
impl FromStr for Edge {
    type Err = Error;

    fn from_str(name: &str) -> Result<Self> {
        let found = Self::ALL.into_iter().find(|e| e.name().eq_ignore_ascii_case(name));
        found.ok_or_else(|| unknown("edge", name, Self::ALL.map(Self::name)))
    }
}

/// Equally spaced positions `x_i = start + i·step`, `0 ≤ i < len`: the one way to say where.
///
/// The record covers the half-open interval `[start, start + len·step)`, so that its length in units is the period
/// of its transform's grid. Positions are computed from the index, never accumulated.
///
/// ```
/// use nyquist::axis::Axis;
/// let pixels = Axis::cells(0.0..4.0, 4)?;
/// assert_eq!(pixels.iter().collect::<Vec<_>>(), [0.5, 1.5, 2.5, 3.5]);
/// assert_eq!((pixels.rate(), pixels.nyquist()), (1.0, 0.5));
/// # Ok::<(), nyquist::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Axis {
    start: f64,
    step: f64,
    len: usize,
    unit: Unit,
}

impl Axis {
    /// The most positions an axis may have, 2³²: 32 GiB of values. Far below 2⁵³, so that every index is exact in `f64`.
    pub const MOST: usize = 1 << 32;

    /// `len` positions from `start`, `step` apart, without a unit.
    ///
    /// # Errors
    /// A start or step that is not finite, a step that is not positive or is lost in the rounding of the positions, no
    /// positions, more than [`Axis::MOST`], or an end that overflows.
    pub fn new(start: f64, step: f64, len: usize) -> Result<Self> {
        finite("the start of an axis", start)?;
        positive("the step of an axis", step)?;
        if len == 0 {
            return Err(Error::TooFew { what: "positions on an axis", least: 1, got: 0 });
        }
        if len > Self::MOST {
            let what = "the length of an axis";
            return Err(Error::Overflow { what, value: len as f64, most: Self::MOST as f64 });
        }
        let end = finite("the end of an axis", start + step * len as f64)?;
        // where positions are so large that a step is lost in their rounding, neighbours would coincide
        let least = f64::EPSILON * start.abs().max(end.abs());
        if step < least {
            return Err(Error::OutOfRange { what: "the step of an axis", value: step, low: least, high: f64::MAX });
        }
        Ok(Self { start, step, len, unit: Unit::ONE })
    }

    /// `n` positions over the half-open `range`, the first at its start.
    ///
    /// # Errors
    /// As [`Axis::new`]; the range must rise.
    pub fn nodes(range: Range<f64>, n: usize) -> Result<Self> {
        finite("the start of an axis", range.start)?;
        finite("the end of an axis", range.end)?;
        let length = positive("the length of an axis", range.end - range.start)?;
        if n == 0 {
            return Err(Error::TooFew { what: "positions on an axis", least: 1, got: 0 });
        }
        Self::new(range.start, length / n as f64, n)
    }

    /// `n` positions at the middles of the `n` equal cells of `range`: pixel centres.
    ///
    /// # Errors
    /// As [`Axis::nodes`].
    pub fn cells(range: Range<f64>, n: usize) -> Result<Self> {
        let nodes = Self::nodes(range, n)?;
        Ok(Self { start: nodes.start + 0.5 * nodes.step, ..nodes })
    }

    /// `len` positions `step` apart with zero at index `len/2` (integer division), the order of the bins.
    ///
    /// # Errors
    /// As [`Axis::new`].
    pub fn centered(step: f64, len: usize) -> Result<Self> {
        positive("the step of an axis", step)?;
        Self::new(-((len / 2) as f64) * step, step, len)
    }

    /// The same positions, counted in `unit`.
    #[must_use]
    pub fn in_unit(self, unit: Unit) -> Self {
        Self { unit, ..self }
    }

    /// The position of index 0.
    pub fn start(&self) -> f64 {
        self.start
    }

    /// The distance between neighbours, `T`.
    pub fn step(&self) -> f64 {
        self.step
    }

    /// How many positions there are; never zero.
    #[expect(clippy::len_without_is_empty, reason = "an axis is never empty: the constructor refuses it")]
    pub fn len(&self) -> usize {
        self.len
    }

    /// What positions are counted in.
    pub fn unit(&self) -> Unit {
        self.unit
    }

    /// The position of index `i`; indices beyond the ends, also negative ones, continue the axis.
    pub fn at(&self, i: i64) -> f64 {
        self.start + i as f64 * self.step
    }

    /// The index that position `x` would have, a real number: `(x − start)/step`.
    pub fn index_of(&self, x: f64) -> f64 {
        (x - self.start) / self.step
    }

    /// Positions per unit, `f_s = 1/T`.
    pub fn rate(&self) -> f64 {
        1.0 / self.step
    }

    /// The Nyquist frequency `f_s/2`: the highest frequency that this axis can tell from a lower one.
    pub fn nyquist(&self) -> f64 {
        0.5 / self.step
    }

    /// The length `len·step` of the interval covered.
    pub fn span(&self) -> f64 {
        self.len as f64 * self.step
    }

    /// The axis of this axis' transform: `len` frequencies `1/span` apart, rising, zero at index `len/2`, in the
    /// reciprocal unit.
    ///
    /// ```
    /// use nyquist::axis::Axis;
    /// let frequencies = Axis::nodes(10.0..12.0, 4)?.dual();
    /// assert_eq!(frequencies.iter().collect::<Vec<_>>(), [-1.0, -0.5, 0.0, 0.5]);
    /// # Ok::<(), nyquist::error::Error>(())
    /// ```
    #[must_use]
    pub fn dual(&self) -> Self {
        let step = 1.0 / self.span();
        Self { start: -((self.len / 2) as f64) * step, step, len: self.len, unit: self.unit.reciprocal() }
    }

    /// All positions in order.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = f64> + use<> {
        let axis = *self;
        (0..self.len).map(move |i| axis.at(i as i64))
    }
}
