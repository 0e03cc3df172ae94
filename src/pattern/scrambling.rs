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
#[inline]
pub(crate) fn binary(digits: u32, scrambling: Scrambling, key: u64) -> f64 {
    match scrambling {
        Scrambling::None => f64::from(digits) / (1u64 << 32) as f64,
        Scrambling::Digits => unit((u64::from(digits) << 32) ^ word(key, 0)),
        Scrambling::Owen => unit(nested_binary(digits, key)),
    }
}

/// Owen's scrambling in base 2 of 32 digits, as 64 digits in a word.
///
/// The digits before a place lead to a node of a binary tree, and every node has a random bit that flips the digit there
/// or leaves it. Behind the root, and behind every one, a chain of zeros goes down the tree; each chain has a word of its
/// own, whose bit at a place is that of the chain's node there. So no two nodes share a bit, nothing is approximated
/// (Burley 2020 approximates the tree by a hash that mixes upwards), and a number needs one word more than it has ones.
pub(crate) fn nested_binary(digits: u32, key: u64) -> u64 {
    let (mut path, mut scrambled, mut rest) = (0, word(key, 0), digits);
    while rest > 0 {
        let one = (1 << 31) >> rest.leading_zeros();
        path |= one;
        scrambled = behind_one(scrambled, one, word(key, path.into()));
        rest ^= one;
    }
    scrambled
}

/// The scrambled digits of a number whose last one is `one`, from those of its parent, the same number without that one:
/// the parent's as far as there, the one flipped, and behind it those of the chain that begins there.
#[inline(always)]
pub(crate) fn behind_one(parent: u64, one: u32, chain: u64) -> u64 {
    let one = u64::from(one) << 32;
    let behind = one - 1;
    ((parent ^ one) & !behind) | (chain & behind)
}

/// Permutations for each place of numbers in a base: [`Scrambling::Digits`].
#[derive(Debug)]
pub(crate) struct Places {
    base: u32,
    places: Vec<Vec<u32>>,
    /// For each place, the power of the base and the number that zeros make from there on.
    zeros: Vec<(u64, u64)>,
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
        let mut zeros = vec![(1, 0)];
        for permutation in places.iter().rev() {
            let (power, number) = zeros[zeros.len() - 1];
            zeros.push((power * u64::from(base), u64::from(permutation[0]) * power + number));
        }
        zeros.reverse();
        Self { base, places, zeros }
    }

    /// The radical inverse of `index` with permuted digits, the zeros behind its digits too.
    pub(crate) fn inverse(&self, index: u32) -> f64 {
        let (mut numerator, mut place, mut rest) = (0, 0, index);
        while rest > 0 {
            let digit = self.places[place][(rest % self.base) as usize];
            numerator = numerator * u64::from(self.base) + u64::from(digit);
            rest /= self.base;
            place += 1;
        }
        let (power, zeros) = self.zeros[place];
        (numerator * power + zeros) as f64 / self.zeros[0].0 as f64
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
