//! Sobol's sequence.

use crate::error::{Result, within};
use crate::pattern::directions::{COLUMNS, DIMENSIONS};
use crate::pattern::scrambling::{Scrambling, binary, key};
use crate::pattern::{Pattern, countable};

/// The digital sequence in base 2 of Sobol' (1967), with the direction numbers of Joe and Kuo (2008) in 32 dimensions.
///
/// Every coordinate is a sequence of radical inverses of base 2 with its own generator matrix. The first two coordinates
/// are a (0, 2)-sequence: every run of `2^m` points that starts at a multiple of `2^m` has one in each of the boxes
/// `2^{−a} × 2^{−(m−a)}`. Use powers of two, and start at zero: dropping the first point spoils the net. Scrambling
/// keeps all of this and makes means unbiased; Owen's also makes them better, to a variance of `N⁻³` for smooth
/// functions.
///
/// Order: of the index (not Gray's); `n` points are the first `n` of any more. More than 32 dimensions do not compile.
///
/// ```
/// use nyquist::prelude::*;
/// let points: Vec<[f64; 3]> = Sobol::new(4)?.points(0);
/// assert_eq!(points, [[0.0, 0.0, 0.0], [0.5, 0.5, 0.5], [0.25, 0.75, 0.75], [0.75, 0.25, 0.25]]);
/// // scrambled, the points are others, but still one in each of 8 × 2, 4 × 4, … boxes
/// let owen = Sobol::new(16)?.scrambled(Scrambling::Owen);
/// let points: Vec<[f64; 2]> = owen.points(9);
/// assert_eq!(net_quality(&points, 2)?, 0);
/// assert_eq!(points[5][1], owen.sample(5, 1, 9)?);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sobol {
    count: usize,
    scrambling: Scrambling,
}

impl Sobol {
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
    /// A dimension beyond the [`DIMENSIONS`] of the table.
    pub fn sample(&self, index: u32, dimension: usize, seed: u64) -> Result<f64> {
        within("the dimension of a Sobol' point", dimension as f64, 0.0, (DIMENSIONS - 1) as f64)?;
        Ok(binary(digits(index, dimension), self.scrambling, key(seed, dimension)))
    }
}

/// The 32 digits of a coordinate: the matrix times the digits of the index, over the field of two elements.
fn digits(index: u32, dimension: usize) -> u32 {
    COLUMNS[dimension]
        .iter()
        .enumerate()
        .fold(0, |sum, (k, column)| if index >> k & 1 == 1 { sum ^ column } else { sum })
}

impl<const D: usize> Pattern<D> for Sobol {
    fn name(&self) -> String {
        match self.scrambling {
            Scrambling::None => "sobol",
            Scrambling::Digits => "sobol-shifted",
            Scrambling::Owen => "sobol-owen",
        }
        .into()
    }

    fn count(&self) -> Option<usize> {
        Some(self.count)
    }

    fn points(&self, seed: u64) -> Vec<[f64; D]> {
        const { assert!(D <= DIMENSIONS, "direction numbers for each dimension") };
        let keys: [u64; D] = std::array::from_fn(|d| key(seed, d));
        // from i to i + 1 the last ones of i and the zero before them turn over
        let turn: [[u32; 32]; D] = std::array::from_fn(|d| {
            let mut sum = 0;
            COLUMNS[d].map(|column| {
                sum ^= column;
                sum
            })
        });
        let mut state = [0u32; D];
        let next = |i: u32| {
            let point = std::array::from_fn(|d| binary(state[d], self.scrambling, keys[d]));
            let ones = i.trailing_ones() as usize;
            state.iter_mut().zip(&turn).for_each(|(s, turn)| *s ^= turn[ones]);
            point
        };
        (0..self.count as u32).map(next).collect()
    }
}
