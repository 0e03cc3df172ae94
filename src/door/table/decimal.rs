//! Decimal numbers as they are printed.

use std::fmt;
use std::str::FromStr;

/// `digits · 10^exponent`, exactly, with as many decimals as were printed.
///
/// Times are kept so: seconds since 1970 with microseconds have 16 digits, as many as an `f64` has, and with nanoseconds
/// more. Their differences fit; so they are taken before anything is rounded.
///
/// ```
/// use nyquist::door::table::Decimal;
/// let [now, then]: [Decimal; 2] = ["1769860800.0000001", "1769860800"].map(|t| t.parse().unwrap());
/// assert_eq!(now.minus(then), 1e-7);
/// assert_eq!(now.value() - then.value(), 0.0); // what is left of it in f64
/// assert_eq!(then.plus("0.50".parse().unwrap()).unwrap().to_string(), "1769860800.50");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Decimal {
    digits: i128,
    exponent: i32,
}

/// Text that is no decimal number, or one of more than 36 digits or beyond 10^±300.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct NoDecimal;

const MOST_DIGITS: u32 = 36;
const MOST_EXPONENT: i32 = 300;

impl Decimal {
    /// Zero, without decimals.
    pub const ZERO: Self = Self { digits: 0, exponent: 0 };

    /// `digits · 10^exponent`.
    pub(crate) fn new(digits: i128, exponent: i32) -> Self {
        Self { digits, exponent }
    }

    /// The shortest decimal that reads back as `value`; none if it is not finite or beyond `10^±300`.
    pub fn of(value: f64) -> Option<Self> {
        format!("{value:e}").parse().ok()
    }

    /// The nearest `f64`.
    pub fn value(self) -> f64 {
        format!("{}e{}", self.digits, self.exponent).parse().expect("digits and an exponent are a number")
    }

    /// The difference, rounded once.
    pub fn minus(self, other: Self) -> f64 {
        let opposite = Self { digits: -other.digits, ..other };
        // what overflows in digits is so far apart that rounding the terms first is rounding once
        self.plus(opposite).map_or_else(|| self.value() - other.value(), Self::value)
    }

    /// The sum, with the decimals of the term that has more; none if it overflows.
    pub fn plus(self, other: Self) -> Option<Self> {
        let exponent = self.exponent.min(other.exponent);
        let shifted = |d: Self| {
            let shift = 10i128.checked_pow(u32::try_from(d.exponent - exponent).ok()?)?;
            d.digits.checked_mul(shift)
        };
        Some(Self { digits: shifted(self)?.checked_add(shifted(other)?)?, exponent })
    }

    /// The product with a whole number; none if it overflows.
    pub fn times(self, factor: u64) -> Option<Self> {
        Some(Self { digits: self.digits.checked_mul(factor.into())?, ..self })
    }

    /// How many digits stand behind the point.
    pub fn decimals(self) -> u32 {
        (-self.exponent).max(0).unsigned_abs()
    }

    /// How many digits there are from the first that is not zero on; none of zero.
    pub fn significant(self) -> u32 {
        self.digits.unsigned_abs().checked_ilog10().map_or(0, |log| log + 1)
    }

    /// The digits without a point, and the power of ten that they count.
    pub(crate) fn parts(self) -> (i128, i32) {
        (self.digits, self.exponent)
    }
}

impl FromStr for Decimal {
    type Err = NoDecimal;

    fn from_str(text: &str) -> Result<Self, NoDecimal> {
        let (mantissa, power) = match text.split_once(['e', 'E']) {
            Some((mantissa, power)) => (mantissa, power.parse::<i32>().map_err(|_| NoDecimal)?),
            None => (text, 0),
        };
        let (sign, unsigned) = match mantissa.as_bytes() {
            [b'-', ..] => (-1, &mantissa[1..]),
            [b'+', ..] => (1, &mantissa[1..]),
            _ => (1, mantissa),
        };
        let (whole, fraction) = unsigned.split_once('.').unwrap_or((unsigned, ""));
        let letters = || whole.bytes().chain(fraction.bytes());
        if letters().next().is_none() || !letters().all(|b| b.is_ascii_digit()) {
            return Err(NoDecimal);
        }
        let significant = letters().skip_while(|b| *b == b'0').count();
        let exponent = i32::try_from(fraction.len()).ok().and_then(|f| power.checked_sub(f)).ok_or(NoDecimal)?;
        if significant > MOST_DIGITS as usize || !(-MOST_EXPONENT..=MOST_EXPONENT).contains(&exponent) {
            return Err(NoDecimal);
        }
        let digits = letters().fold(0i128, |sum, b| 10 * sum + i128::from(b - b'0'));
        Ok(Self { digits: sign * digits, exponent })
    }
}

impl fmt::Display for Decimal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (sign, digits) = (if self.digits < 0 { "-" } else { "" }, self.digits.unsigned_abs().to_string());
        let decimals = self.decimals() as usize;
        match decimals {
            0 if digits == "0" => write!(f, "0"),
            0 => write!(f, "{sign}{digits}{}", "0".repeat(self.exponent as usize)),
            _ => {
                let padded = format!("{digits:0>width$}", width = decimals + 1);
                let (whole, fraction) = padded.split_at(padded.len() - decimals);
                write!(f, "{sign}{whole}.{fraction}")
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Decimal {
        text.parse().unwrap()
    }

    #[test]
    fn numbers_are_printed_as_they_were_read() {
        for text in ["0", "0.000", "-0.050", "17", "1700000000.123456789", "-3.0"] {
            assert_eq!(read(text).to_string(), text);
        }
        let others = [("+1.5", "1.5"), (".5", "0.5"), ("5.", "5"), ("1e3", "1000"), ("-2.50E-3", "-0.00250")];
        for (text, shown) in others {
            assert_eq!(read(text).to_string(), shown);
        }
        for text in ["", "-", ".", "1.2.3", "1e", "1e1.5", "0x10", "nan", "inf", "1_0", " 1", "1e999", "--1"] {
            assert_eq!(text.parse::<Decimal>(), Err(NoDecimal), "{text}");
        }
        assert_eq!(format!("1e{}", i32::MIN).parse::<Decimal>(), Err(NoDecimal));
        assert_eq!("9".repeat(37).parse::<Decimal>(), Err(NoDecimal));
    }

    #[test]
    fn values_and_differences_are_rounded_once() {
        assert_eq!(read("0.1").value(), 0.1);
        assert_eq!(read("0.3").minus(read("0.1")), 0.2); // 0.3 − 0.1 = 0.19999999999999998 in f64
        assert_eq!(read("1e200").minus(read("1e-200")), 1e200);
        assert_eq!((read("0.10").decimals(), read("0.10").significant(), read("1e3").decimals()), (2, 2, 0));
        assert_eq!(Decimal::of(0.1), Some(read("0.1")));
        assert_eq!(Decimal::of(f64::NAN), None);
        assert_eq!(read("0.001").times(3).unwrap().to_string(), "0.003");
    }
}
