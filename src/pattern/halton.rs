//! Halton's sequence.

use crate::error::Result;
use crate::pattern::radical::{PRIMES, base, inverse};
use crate::pattern::scrambling::{Places, Scrambling, binary, key, nested};
use crate::pattern::sobol::Sobol;
use crate::pattern::{Pattern, countable};

/// Point `i` is `(Φ₂(i), Φ₃(i), Φ₅(i), …)`, radical inverses in the first primes (Halton 1960).
///
/// Every run of `2^a 3^b` points has one in each box of `2^a × 3^b`. The star discrepancy is `O((ln N)^D/N)`. In high
/// dimensions the plain sequence begins with lines (bases 29 and 31: the first 29 points lie on one), which permuted
/// digits and, better, Owen's scrambling break up. Unscrambled, the first point is the origin.
///
/// Order: of the index; `n` points are the first `n` of any more. At most 64 dimensions, the 64 primes of the table:
/// more do not compile.
///
/// ```
/// use nyquist::prelude::*;
/// let points: Vec<[f64; 2]> = Halton::new(4)?.points(0);
/// assert_eq!(points, [[0.0, 0.0], [0.5, 1.0 / 3.0], [0.25, 2.0 / 3.0], [0.75, 1.0 / 9.0]]);
/// // any coordinate of any point alone
/// let owen = Halton::new(1000)?.scrambled(Scrambling::Owen);
/// let all: Vec<[f64; 5]> = owen.points(7);
/// assert_eq!(all[777][4], owen.sample(777, 4, 7)?);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Halton {
    count: usize,
    scrambling: Scrambling,
}

impl Halton {
    /// The first `count` points, not scrambled.
    ///
    /// # Errors
    /// No points, or more than [`MOST_POINTS`](crate::pattern::MOST_POINTS).
    pub fn new(count: usize) -> Result<Self> {
        Ok(Self { count: countable(count)?, scrambling: Scrambling::None })
    }

    /// The same points with scrambled digits.
    #[must_use]
    pub fn scrambled(self, scrambling: Scrambling) -> Self {
        Self { scrambling, ..self }
    }

    /// One coordinate of one point alone, also beyond the last.
    ///
    /// # Errors
    /// A dimension beyond the 64 primes of the table.
    pub fn sample(&self, index: u32, dimension: usize, seed: u64) -> Result<f64> {
        Ok(self.coordinate(base(dimension)?, key(seed, dimension))(index))
    }

    /// The sequence of one coordinate.
    fn coordinate(&self, base: u32, key: u64) -> Box<dyn Fn(u32) -> f64> {
        match (self.scrambling, base) {
            (scrambling, 2) => Box::new(move |index| binary(index.reverse_bits(), scrambling, key)),
            (Scrambling::None, _) => Box::new(move |index| inverse(base, index).value()),
            (Scrambling::Digits, _) => {
                let places = Places::new(base, key);
                Box::new(move |index| places.inverse(index))
            }
            (Scrambling::Owen, _) => Box::new(move |index| nested(base, index, key)),
        }
    }
}

impl<const D: usize> Pattern<D> for Halton {
    fn name(&self) -> String {
        match self.scrambling {
            Scrambling::None => "halton",
            Scrambling::Digits => "halton-permuted",
            Scrambling::Owen => "halton-owen",
        }
        .into()
    }

    fn count(&self) -> Option<usize> {
        Some(self.count)
    }

    fn points(&self, seed: u64) -> Vec<[f64; D]> {
        const { assert!(D <= PRIMES.len(), "a prime for each dimension") };
        // base 2 is Sobol's first dimension, made all at once
        let sobol = Sobol::new(self.count).expect("as many points as were allowed here").scrambled(self.scrambling);
        let first: Vec<[f64; 1]> = sobol.points(seed);
        let coordinates: [_; D] = std::array::from_fn(|d| self.coordinate(PRIMES[d], key(seed, d)));
        let point = |(i, [x]): (u32, [f64; 1])| std::array::from_fn(|d| if d == 0 { x } else { coordinates[d](i) });
        (0..).zip(first).map(point).collect()
    }
}
