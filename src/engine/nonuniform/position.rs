//! Positions, and the cells of a grid that they fall into.

use crate::engine::nonuniform::taps::{FRACTION, FRACTION_BITS};

/// A position on the line, in units of which a period has a whole number: a number, or a whole number and a fraction.
///
/// Near 10⁶ an `f64` resolves 10⁻¹⁰; as (whole, fraction) a position keeps all digits of the fraction. Either is taken
/// exactly as it is.
pub trait Position: Copy + Send + Sync + sealed::Sealed {
    /// Whether it lies within `0..period`.
    #[doc(hidden)]
    fn is_inside(self, period: f64) -> bool;

    /// The same place within `0..period`, or the number in it that is not finite.
    #[doc(hidden)]
    fn brought_inside(self, period: f64) -> Result<Self, f64>;

    /// A position inside as the sum of two numbers of which the first has few enough bits that its product with a whole
    /// number below 2²⁷ is exact.
    #[doc(hidden)]
    fn parts(self) -> [f64; 2];
}

mod sealed {
    pub trait Sealed {}
    impl Sealed for f64 {}
    impl Sealed for (i64, f64) {}
}

impl Position for f64 {
    #[inline(always)]
    fn is_inside(self, period: f64) -> bool {
        self >= 0.0 && self < period
    }

    fn brought_inside(self, period: f64) -> Result<Self, f64> {
        if self.is_finite() { Ok(self.rem_euclid(period)) } else { Err(self) }
    }

    #[inline(always)]
    fn parts(self) -> [f64; 2] {
        let short = f64::from(self as f32);
        [short, self - short]
    }
}

impl Position for (i64, f64) {
    #[inline(always)]
    fn is_inside(self, period: f64) -> bool {
        self.0 >= 0 && self.0 < period as i64 && self.1 >= 0.0 && self.1 < 1.0
    }

    fn brought_inside(self, period: f64) -> Result<Self, f64> {
        let ((whole, fraction), units) = (self, period as i64);
        if !fraction.is_finite() {
            return Err(fraction);
        }
        let floor = fraction.floor();
        let whole = whole.rem_euclid(units) + (floor % period) as i64;
        Ok((whole.rem_euclid(units), fraction - floor))
    }

    #[inline(always)]
    fn parts(self) -> [f64; 2] {
        [self.0 as f64, self.1]
    }
}

/// From positions to cells of a grid around one axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Ruler {
    period: f64,
    cells: f64,
    /// How many cells lie between the first one of a window and the point.
    lead: f64,
    /// How many bits count the cells of a bin.
    bits: u32,
}

impl Ruler {
    pub(super) fn new(period: usize, cells: usize, width: usize, bits: u32) -> Self {
        Self { period: period as f64, cells: cells as f64, lead: (width / 2 - 1) as f64, bits }
    }

    pub(super) fn period(&self) -> f64 {
        self.period
    }

    /// How many bins there are.
    pub(super) fn bins(&self) -> usize {
        (self.cells as usize).div_ceil(1 << self.bits)
    }

    /// The bin of the first cell of the window at a position, and the code of the rest: the cell within the bin in the
    /// upper 12 bits, the fraction below.
    #[inline(always)]
    pub(super) fn bin(&self, [short, rest]: [f64; 2]) -> (u32, u64) {
        // a number added and taken away rounds to a whole number, which then stands in the lowest bits
        const ROUND: f64 = 1.5 * (1u64 << 52) as f64;
        let rounded = (short + rest) * (self.cells / self.period) - 0.5 + ROUND;
        let cell = rounded - ROUND;
        // products of whole numbers, exact; so the fraction has no more error than the position
        let fraction = ((short * self.cells - cell * self.period) + rest * self.cells) * (1.0 / self.period);
        let fraction = fraction.clamp(0.0, 1.0 - f64::EPSILON);
        let first = cell - self.lead;
        let first = first + if first < 0.0 { self.cells } else { 0.0 };
        let first = (first + ROUND).to_bits() as u32;
        let inside = u64::from(first & ((1 << self.bits) - 1));
        (first >> self.bits, inside << FRACTION_BITS | (fraction + 1.0).to_bits() & FRACTION)
    }
}
