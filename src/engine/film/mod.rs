//! Scattered samples into pixels, in bulk: `Σ f·L / Σ f` as the [film](crate::film) defines it, in `f32` or `f64`.
//!
//! | file | does |
//! | --- | --- |
//! | `weights` | the kernel as polynomials between pixels, verified against it |
//! | `block` | samples of a block sorted by tiles |
//! | `tile` | samples added to the pixels of a tile and the margin around it |
//!
//! Samples are read once. A block of them is sorted by tiles while it is in the cache, a few blocks at a time; a tile then
//! takes its samples from these blocks in their order. It has a margin as wide as the kernel, so that a sample belongs to
//! one tile; margins are added to the neighbours at the end, in a fixed order. So memory holds a few blocks beside the
//! pixels, and the bits do not depend on the number of threads. Sums are plain: the bits are the same with any vectors.

mod block;
mod tile;
mod weights;

use crate::engine::film::block::Block;
use crate::engine::film::tile::{SIDE, Tile};
use crate::engine::film::weights::Weights;
use crate::engine::real::Real;
use crate::engine::simd::{Loop, vectorised};
use crate::error::{Error, Result};
use crate::parallel;

pub use crate::engine::film::weights::MOST_DEGREE;

/// Light at a place: `2 + C` numbers, one after the other.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(C)]
pub struct Sample<T, const C: usize> {
    /// Where `(x, y)`, in pixels: pixel `(i, j)` is `i ≤ x < i + 1`, `j ≤ y < j + 1`.
    pub at: [T; 2],
    /// How much, colour by colour.
    pub light: [T; C],
}

/// What a pixel has gathered.
#[derive(Debug, Clone, Copy)]
struct Pixel<T, const C: usize> {
    weight: T,
    light: [T; C],
}

impl<T: Real, const C: usize> Pixel<T, C> {
    fn dark() -> Self {
        Self { weight: T::zero(), light: [T::zero(); C] }
    }

    #[inline(always)]
    fn add(&mut self, other: &Self) {
        self.weight += other.weight;
        (0..C).for_each(|c| self.light[c] += other.light[c]);
    }
}

/// The most pixels of a film, if its sides are rounded up to multiples of 64.
pub const MOST_PIXELS: usize = 1 << 28;

/// Samples that are sorted together: as many as stay in a cache.
const BLOCK: usize = 1 << 15;

/// Blocks that are sorted before tiles take their samples.
const BLOCKS: usize = 32;

/// A film of `width × height` pixels for many samples, with a kernel as `f(x, y) = k(x)·k(y)` of a radius that is a multiple
/// of one half.
///
/// The kernel's values are those of polynomials, one between each two pixels, of the least odd degree that agrees with it to
/// `16ε` of its largest value (`ε` of `T`), or of the best up to [`MOST_DEGREE`]; [`error`](Film::error) is the largest
/// difference that was seen when the plan was made. A pixel's sums lose at most that in either direction, `n·ε/2` to their
/// own rounding for `n` samples within reach, and what a place loses by being a number of `T`, which counts in `f32`: at
/// pixel 1000 it is known to `3·10⁻⁵` of a pixel. A sample exactly where a kernel jumps (the box) counts wholly on one side.
///
/// ```
/// use nyquist::engine::film::{Film, Sample};
/// use nyquist::prelude::*;
/// let mitchell = Cubic::mitchell();
/// let engine = Film::<f32>::new([3, 1], 2.0, |t| mitchell.at(t))?;
/// // three samples of the same light at odd places: every pixel has that light
/// let samples = [[0.2, 0.9], [1.7, 0.4], [2.1, 0.3]].map(|at| Sample { at, light: [0.25] });
/// let exposure = engine.develop(&samples)?;
/// assert!(exposure.planes[0].iter().all(|v| (v - 0.25).abs() <= 4.0 * f32::EPSILON));
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Film<T> {
    width: usize,
    height: usize,
    weights: Weights<T>,
}

/// A developed film, row by row.
#[derive(Debug, Clone, PartialEq)]
pub struct Exposure<T, const C: usize> {
    /// `Σ f·L / Σ f`, colour by colour; zero where no sample reached.
    pub planes: [Vec<T>; C],
    /// `Σ f`.
    pub weights: Vec<T>,
}

impl<T: Real> Film<T> {
    /// A film of `[width, height]` pixels with the kernel `k(t) = kernel(t)` for `|t| < radius`, even.
    ///
    /// # Errors
    /// No pixels or more than [`MOST_PIXELS`]; a radius other than ½, 1, 1½, 2, 2½ or 3; a kernel that has a corner between
    /// these places, so that no polynomial of degree [`MOST_DEGREE`] is it to `10⁻³` of its largest value.
    pub fn new([width, height]: [usize; 2], radius: f64, kernel: impl Fn(f64) -> f64) -> Result<Self> {
        if width == 0 || height == 0 {
            return Err(Error::TooFew { what: "pixels of a film", least: 1, got: 0 });
        }
        // tiles are whole, even of a film that is one pixel wide
        let whole = |n: usize| (n as f64 / SIDE as f64 + 1.0) * SIDE as f64;
        let value = whole(width) * whole(height);
        if value > MOST_PIXELS as f64 {
            let what = "the number of pixels of a film, counted in whole tiles,";
            return Err(Error::Overflow { what, value, most: MOST_PIXELS as f64 });
        }
        Ok(Self { width, height, weights: Weights::new(radius, kernel)? })
    }

    /// How far, at most, the weights along one axis were seen from the kernel, in parts of its largest value.
    pub fn error(&self) -> f64 {
        self.weights.error()
    }

    /// The pixels that these samples make; those out of reach count for nothing.
    ///
    /// # Errors
    /// A place or a light that is not finite: which sample.
    pub fn develop<const C: usize>(&self, samples: &[Sample<T, C>]) -> Result<Exposure<T, C>> {
        match self.weights.taps() {
            1 => self.expose::<C, 1>(samples),
            2 => self.expose::<C, 2>(samples),
            3 => self.expose::<C, 3>(samples),
            4 => self.expose::<C, 4>(samples),
            5 => self.expose::<C, 5>(samples),
            _ => self.expose::<C, 6>(samples),
        }
    }

    fn expose<const C: usize, const W: usize>(&self, samples: &[Sample<T, C>]) -> Result<Exposure<T, C>> {
        // a sample's first pixel can be W − 1 before the first of the film
        let across = (self.width + W - 1).div_ceil(SIDE);
        let tiles = across * (self.height + W - 1).div_ceil(SIDE);
        let layout = Layout {
            beyond: T::of((W - 1) as f64),
            most: [self.width, self.height].map(|n| T::of((n + W - 1) as f64)),
            across: across as u32,
            tiles: tiles as u32,
        };
        let row = SIDE + W - 1;
        let mut sums = vec![Pixel::dark(); tiles * row * row];
        let mut blocks: Vec<Block<T, C>> = Vec::new();
        for (group, samples) in samples.chunks(BLOCK * BLOCKS).enumerate() {
            blocks.resize_with(samples.len().div_ceil(BLOCK), Block::default);
            parallel::chunks(&mut blocks, 1, |i, block| {
                let samples = &samples[i * BLOCK..];
                block[0].sort(&samples[..samples.len().min(BLOCK)], tiles, |samples, into| {
                    vectorised(Finding { layout, weights: &self.weights, samples, into });
                });
            });
            if let Some((block, at)) = blocks.iter().zip(0..).find_map(|(b, i)| b.unclear().map(|at| (i, at))) {
                return Err(unclear(samples, group * BLOCK * BLOCKS, block * BLOCK + at));
            }
            parallel::chunks(&mut sums, row * row, |i, pixels| {
                let corner = [i % across, i / across].map(|c| (c * SIDE) as f64 - (W - 1) as f64);
                let mut tile = Tile::<T, C, W>::new(pixels, corner, &self.weights);
                blocks.iter().for_each(|block| tile.gather(block.of_tile(i)));
            });
        }
        Ok(self.merged::<C, W>(&sums, across))
    }

    /// The tiles put together, margins added.
    fn merged<const C: usize, const W: usize>(&self, sums: &[Pixel<T, C>], across: usize) -> Exposure<T, C> {
        let row = SIDE + W - 1;
        let mut pixels = vec![Pixel::dark(); self.width * self.height];
        parallel::chunks(&mut pixels, self.width, |y, pixels| {
            // the tile whose margin reaches this row, and the one it is in
            for (down, v) in parts::<W>(y) {
                for (x, pixel) in pixels.iter_mut().enumerate() {
                    for (right, u) in parts::<W>(x) {
                        if let Some(sum) = sums.get((down * across + right) * row * row + v * row + u) {
                            pixel.add(sum);
                        }
                    }
                }
            }
        });
        let light = |pixel: &Pixel<T, C>, c: usize| {
            if pixel.weight == T::zero() { T::zero() } else { pixel.light[c] / pixel.weight }
        };
        Exposure {
            planes: std::array::from_fn(|c| pixels.iter().map(|pixel| light(pixel, c)).collect()),
            weights: pixels.iter().map(|pixel| pixel.weight).collect(),
        }
    }
}

/// Where the tiles of a film are.
#[derive(Debug, Clone, Copy)]
struct Layout<T> {
    /// The pixels beside the film that a sample's first pixel can be: before it, and in all.
    beyond: T,
    most: [T; 2],
    /// Tiles in a row, and in all.
    across: u32,
    tiles: u32,
}

/// The tile of every sample; as many as there are tiles for those that reach no pixel.
struct Finding<'a, T, const C: usize> {
    layout: Layout<T>,
    weights: &'a Weights<T>,
    samples: &'a [Sample<T, C>],
    into: &'a mut [u32],
}

impl<T: Real, const C: usize> Loop for Finding<'_, T, C> {
    #[inline(always)]
    fn run(self) {
        let Layout { beyond, most, across, tiles } = self.layout;
        for (sample, tile) in self.samples.iter().zip(self.into) {
            let [x, y] = sample.at.map(|at| self.weights.first(at) + beyond);
            let inside = (x >= T::zero()) & (x < most[0]) & (y >= T::zero()) & (y < most[1]);
            let [column, row] = [x, y].map(|c| c.whole() as u32 / SIDE as u32);
            *tile = if inside { row.wrapping_mul(across).wrapping_add(column) } else { tiles };
        }
    }
}

/// The tiles along one axis that have a pixel, and where in them it is: that in whose margin it lies, if so, and its own.
fn parts<const W: usize>(pixel: usize) -> impl Iterator<Item = (usize, usize)> {
    let (tile, within) = ((pixel + W - 1) / SIDE, (pixel + W - 1) % SIDE);
    let before = (tile > 0 && within < W - 1).then(|| (tile - 1, SIDE + within));
    before.into_iter().chain([(tile, within)])
}

/// What is wrong with a sample.
fn unclear<T: Real, const C: usize>(samples: &[Sample<T, C>], before: usize, at: usize) -> Error {
    let Sample { at: place, light } = samples[at];
    let index = before + at;
    let wrong = |values: &[T]| values.iter().find(|v| !v.is_finite()).and_then(|v| v.to_f64());
    match wrong(&place) {
        Some(value) => Error::NotFiniteAt { what: "places of samples", index, value },
        None => Error::NotFiniteAt { what: "lights of samples", index, value: wrong(&light).unwrap_or(f64::NAN) },
    }
}
