//! Scrambling of digits: sequences made random without losing how evenly they fill space.

use crate::num::random::{below, bits, unit, word};
use crate::pattern::cells::within_cell;
use crate::pattern::permutation::{permutation, shuffle};
use crate::pattern::radical::PRIMES;

/// What is done to the digits of every coordinate of a digital sequence.
///
/// Both kinds permute digits so that a half, quarter, … (in base 2) of the unit interval is mapped to a half, quarter, …:
/// nets stay nets. Each scrambled point is uniform over the cube, so that means have the right expectation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Scrambling {
    /// Nothing: the sequence of the textbook, the same for every seed.
    #[default]
    None,
    /// One random permutation for each place; in base 2, an exclusive or with one random word (Kollig, Keller 2002).
    Digits,
    /// Owen's nested uniform scrambling (1995): a random permutation for each place *and* each string of digits before
    /// it. The variance of a mean of smooth functions then falls as `N⁻³` (times logarithms), and it is never much more
    /// than that of independent points.
    Owen,
}

/// The largest base of the table of primes.
const MOST_BASE: usize = PRIMES[PRIMES.len() - 1] as usize;

/// The key of a dimension, of which everything random in it is derived.
pub(crate) fn key(seed: u64, dimension: usize) -> u64 {
    bits(seed, 0x6f77_656e, dimension as u32)
}

/// 32 binary digits after the point, the first in the highest bit, as a number from `[0, 1)`.
pub(crate) fn binary(digits: u32, scrambling: Scrambling, key: u64) -> f64 {
    match scrambling {
        Scrambling::None => f64::from(digits) / (1u64 << 32) as f64,
        Scrambling::Digits => unit((u64::from(digits) << 32) ^ word(key, 0)),
        Scrambling::Owen => unit(nested_binary(digits, key)),
    }
}

/// Owen's scrambling in base 2 of 32 digits, as 64 digits in a word.
///
/// The digits that stand before a place choose a node of a binary tree, and each of its nodes a random bit that flips the
/// digit or leaves it. The words of a stream give the bits of six levels, 63 nodes, at a time. Below level 32 no two
/// points share a node, so that one more word gives all digits that are left. Nothing is approximated: the flips of any
/// two nodes are different bits of the stream (Burley 2020 approximates the tree by a hash that mixes upwards).
fn nested_binary(digits: u32, key: u64) -> u64 {
    let digits = u64::from(digits);
    let mut flips = 0;
    for level in [0, 6, 12, 18, 24, 30] {
        let depth = if level < 30 { 6 } else { 2 };
        // the path to here, with a leading one, names the subtree; the path within it, likewise, the node
        let flip_bits = word(key, (1 << level) | (digits >> (32 - level)));
        let within = (1 << depth) | ((digits >> (32 - level - depth)) & ((1 << depth) - 1));
        for k in 0..depth {
            flips |= ((flip_bits >> (within >> (depth - k))) & 1) << (31 - level - k);
        }
    }
    let tail = word(key, (1 << 32) | digits);
    ((digits ^ flips) << 32) | (tail >> 32)
}

/// Permutations for each place of numbers in a base: [`Scrambling::Digits`].
#[derive(Debug)]
pub(crate) struct Places {
    base: u32,
    places: Vec<Vec<u32>>,
}

impl Places {
    /// As many places as keep all fractions exact in `f64`: `base^places ≤ 2⁵³`.
    pub(crate) fn new(base: u32, key: u64) -> Self {
        let mut power = u64::from(base);
        let mut places = Vec::new();
        while power <= 1 << 53 {
            places.push(permutation(word(key, places.len() as u64), base as usize));
            power *= u64::from(base);
        }
        Self { base, places }
    }

    /// The radical inverse of `index` with permuted digits, the zeros behind its digits too.
    pub(crate) fn inverse(&self, index: u32) -> f64 {
        let (mut numerator, mut denominator, mut rest) = (0u64, 1u64, index);
        for permutation in &self.places {
            numerator = numerator * u64::from(self.base) + u64::from(permutation[(rest % self.base) as usize]);
            denominator *= u64::from(self.base);
            rest /= self.base;
        }
        numerator as f64 / denominator as f64
    }
}

/// The radical inverse of `index` in an odd prime base with Owen's scrambling.
///
/// Places until no two 32-bit indices share a node, and one random number for all that are left.
pub(crate) fn nested(base: u32, index: u32, key: u64) -> f64 {
    let base64 = u64::from(base);
    let mut digits = [0u32; MOST_BASE];
    let (mut path, mut scrambled, mut power, mut rest) = (0, 0, 1u64, index);
    while power < 1 << 32 {
        let digit = (rest % base) as usize;
        rest /= base;
        // base^level + path is another number for every node
        let node = word(key, power + path);
        let permuted = if base == 3 {
            THREE[below(node, 6) as usize][digit]
        } else {
            let digits = &mut digits[..base as usize];
            digits.iter_mut().zip(0..).for_each(|(d, i)| *d = i);
            shuffle(node, digits);
            digits[digit]
        };
        scrambled = scrambled * base64 + u64::from(permuted);
        path = path * base64 + digit as u64;
        power *= base64;
    }
    within_cell(scrambled, power, unit(word(key, power + path)))
}

/// The six permutations of three digits.
const THREE: [[u32; 3]; 6] = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];
