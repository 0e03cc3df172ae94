//! The (0, 2)-sequence of two short functions.

use crate::error::Result;
use crate::pattern::scrambling::{Scrambling, binary, key};
use crate::pattern::sobol::Sobol;
use crate::pattern::{Pattern, countable};

/// Van der Corput's sequence beside the second dimension of Sobol's, with random digits: a (0, 2)-sequence.
///
/// Every run of `2^m` points that starts at a multiple of `2^m` has exactly one in each elementary interval
/// `[i 2^{−a}, (i+1) 2^{−a}) × [j 2^{−b}, (j+1) 2^{−b})`, `a + b = m`: it is jittered and N rooks at once, and all that is
/// in between. The digits are permuted by default (an exclusive or with a random word: Kollig, Keller, *Efficient
/// multidimensional sampling*, 2002), which keeps all of it. What [`Sobol`] does with
/// tables is written here in two short functions, of the same values.
///
/// Order: of the index; `n` points are the first `n` of any more.
///
/// ```
/// use nyquist::prelude::*;
/// let pattern = ZeroTwo::new(64)?;
/// assert_eq!(net_quality(&pattern.points(3), 2)?, 0);
/// let plain = pattern.scrambled(Scrambling::None).points(3);
/// assert_eq!(plain, Pattern::<2>::points(&Sobol::new(64)?, 0));
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ZeroTwo {
    count: usize,
    scrambling: Scrambling,
}

impl ZeroTwo {
    /// The first `count` points, with randomly permuted digits.
    ///
    /// # Errors
    /// No points, or more than [`MOST_POINTS`](crate::pattern::MOST_POINTS).
    pub fn new(count: usize) -> Result<Self> {
        Ok(Self { count: countable(count)?, scrambling: Scrambling::Digits })
    }

    /// The same points with other scrambling, or none.
    #[must_use]
    pub fn scrambled(self, scrambling: Scrambling) -> Self {
        Self { scrambling, ..self }
    }

    /// One point alone, also beyond the last.
    pub fn sample(&self, index: u32, seed: u64) -> [f64; 2] {
        let coordinate = |digits, d| binary(digits, self.scrambling, key(seed, d));
        [coordinate(van_der_corput(index), 0), coordinate(pascal(index), 1)]
    }
}

/// The binary digits mirrored.
fn van_der_corput(index: u32) -> u32 {
    index.reverse_bits()
}

/// The digits multiplied by Pascal's triangle modulo 2, mirrored.
///
/// `C(k, j)` is odd where the ones of `j` are ones of `k` (Lucas 1878). So digit `j` is the sum of all bits `k` above it in
/// that order, and the sums over all of them are made one digit of `k` after the other.
fn pascal(index: u32) -> u32 {
    let halves = [(1, 0x5555_5555), (2, 0x3333_3333), (4, 0x0f0f_0f0f), (8, 0x00ff_00ff), (16, 0x0000_ffff)];
    halves.into_iter().fold(index, |sum, (shift, mask)| sum ^ ((sum >> shift) & mask)).reverse_bits()
}

impl Pattern<2> for ZeroTwo {
    fn name(&self) -> String {
        match self.scrambling {
            Scrambling::None => "zero-two-plain",
            Scrambling::Digits => "zero-two",
            Scrambling::Owen => "zero-two-owen",
        }
        .into()
    }

    fn count(&self) -> Option<usize> {
        Some(self.count)
    }

    fn points(&self, seed: u64) -> Vec<[f64; 2]> {
        Sobol::new(self.count).expect("as many points as were allowed here").scrambled(self.scrambling).points(seed)
    }
}
