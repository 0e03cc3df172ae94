//! Sobol's sequence.

use crate::engine::simd::{Loop, vectorised};
use crate::error::{Result, within};
use crate::num::random;
use crate::pattern::directions::{COLUMNS, DIMENSIONS};
use crate::pattern::scrambling::{Scrambling, behind_one, binary, key, nested_binary};
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
        // told apart here, so that the inner loops need not
        match self.scrambling {
            Scrambling::None => each(self.count, |digits, d| binary(digits, Scrambling::None, keys[d])),
            Scrambling::Digits => each(self.count, |digits, d| binary(digits, Scrambling::Digits, keys[d])),
            Scrambling::Owen => nested(self.count, keys),
        }
    }
}

/// How many points are made together: the digits of an index are those of its low bits and of its high bits, added.
const CHUNK: usize = 64;

/// The digits of the first points.
fn first<const D: usize>() -> [[u32; D]; CHUNK] {
    std::array::from_fn(|i| std::array::from_fn(|d| digits(i as u32, d)))
}

/// The first `count` points, whose coordinates are functions of their digits and dimension.
fn each<const D: usize>(count: usize, coordinate: impl Fn(u32, usize) -> f64) -> Vec<[f64; D]> {
    let low: [[u32; D]; CHUNK] = first();
    let mut points = Vec::with_capacity(count);
    for start in (0..count).step_by(CHUNK) {
        let high: [u32; D] = std::array::from_fn(|d| digits(start as u32, d));
        let point = |low: &[u32; D]| std::array::from_fn(|d| coordinate(high[d] ^ low[d], d));
        points.extend(low[..CHUNK.min(count - start)].iter().map(point));
    }
    points
}

/// The first `count` points with Owen's scrambling, one word each for a coordinate.
///
/// The matrices are triangular: the indices `2^k ≤ i < 2^{k+1}` are those whose last one is the digit `k`. The parent of
/// each of them in the tree of scrambled numbers is a point of lower index, which is there already.
fn nested<const D: usize>(count: usize, keys: [u64; D]) -> Vec<[f64; D]> {
    let mut points = vec![[0.0; D]; count.next_multiple_of(CHUNK)];
    // until they become points, the words of each coordinate of a chunk stand side by side
    let words: &mut [u64] = bytemuck::cast_slice_mut(points.as_flattened_mut());
    let chunks = words.as_chunks_mut::<CHUNK>().0.as_chunks_mut::<D>().0;
    let first: [[u32; D]; CHUNK] = first();
    let low: [[u32; CHUNK]; D] = std::array::from_fn(|d| first.map(|low| low[d]));
    chunks[0] = std::array::from_fn(|d| low[d].map(|low| nested_binary(low, keys[d])));
    let mut size = 1;
    while size < chunks.len() {
        let (done, new) = chunks.split_at_mut(size);
        let count = new.len().min(size);
        vectorised(Children { low: &low, keys, done, new: &mut new[..count] });
        size *= 2;
    }
    vectorised(Woven(chunks));
    points.truncate(count);
    points
}

/// Words of points, coordinate by coordinate.
type Chunk<const D: usize> = [[u64; CHUNK]; D];

/// The scrambled digits of as many new points as are done, or fewer.
struct Children<'a, const D: usize> {
    low: &'a [[u32; CHUNK]; D],
    keys: [u64; D],
    done: &'a [Chunk<D>],
    new: &'a mut [Chunk<D>],
}

impl<const D: usize> Loop for Children<'_, D> {
    #[inline(always)]
    fn run(self) {
        let size = self.done.len() * CHUNK;
        let k = size.ilog2();
        let turns: [usize; D] = std::array::from_fn(|d| single(k, d) as usize ^ size);
        for (i, chunk) in self.new.iter_mut().enumerate() {
            for (d, words) in chunk.iter_mut().enumerate() {
                let high = digits((size + i * CHUNK) as u32, d);
                let (key, turn) = (self.keys[d], turns[d]);
                let parents = &self.done[i ^ (turn / CHUNK)][d];
                // in the order of the children, which has vectors
                let parents: [u64; CHUNK] = std::array::from_fn(|j| parents[(j ^ turn) % CHUNK]);
                for ((word, parent), low) in words.iter_mut().zip(parents).zip(&self.low[d]) {
                    *word = behind_one(parent, (1 << 31) >> k, random::word(key, (high ^ low).into()));
                }
            }
        }
    }
}

/// Words become the bits of numbers from `[0, 1)`, and points.
struct Woven<'a, const D: usize>(&'a mut [Chunk<D>]);

impl<const D: usize> Loop for Woven<'_, D> {
    #[inline(always)]
    fn run(self) {
        for chunk in self.0 {
            let words = *chunk;
            let points = chunk.as_flattened_mut().as_chunks_mut::<D>().0;
            for (j, point) in points.iter_mut().enumerate() {
                for d in 0..D {
                    point[d] = random::unit(words[d][j]).to_bits();
                }
            }
        }
    }
}

/// The index whose only digit that is a one is number `place`: a column of the inverse of the matrix, from below.
fn single(place: u32, dimension: usize) -> u32 {
    let (mut index, mut rest) = (0, (1u32 << 31) >> place);
    while rest > 0 {
        let last = 31 - rest.trailing_zeros();
        index |= 1 << last;
        rest ^= COLUMNS[dimension][last as usize];
    }
    index
}
