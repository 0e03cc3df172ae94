//! Samples added to the pixels of a tile.

use crate::engine::film::weights::Weights;
use crate::engine::film::{Pixel, Sample};
use crate::engine::real::Real;
use crate::engine::simd::{Loop, vectorised};

/// Pixels along a side of a tile, without the margin.
pub(super) const SIDE: usize = 64;

/// Samples whose weights are computed together.
const BATCH: usize = 32;

/// A tile: the samples whose first pixel is in it, and the pixels that they reach, `W − 1` beyond it.
#[derive(Debug)]
pub(super) struct Tile<'a, T, const C: usize, const W: usize> {
    pixels: &'a mut [Pixel<T, C>],
    /// The first pixel of the tile, counted on the film.
    corner: [T; 2],
    weights: &'a Weights<T>,
}

impl<'a, T: Real, const C: usize, const W: usize> Tile<'a, T, C, W> {
    pub(super) fn new(pixels: &'a mut [Pixel<T, C>], corner: [f64; 2], weights: &'a Weights<T>) -> Self {
        Self { pixels, corner: corner.map(T::of), weights }
    }

    /// Adds samples of this tile, in their order.
    pub(super) fn gather(&mut self, samples: &[Sample<T, C>]) {
        vectorised(Gathering { tile: self, samples });
    }

    #[inline(always)]
    fn batch(&mut self, samples: &[Sample<T, C>]) {
        let (mut starts, mut within) = ([0u32; BATCH], [[T::zero(); BATCH]; 2]);
        for (i, sample) in samples.iter().enumerate().take(BATCH) {
            let first = sample.at.map(|at| self.weights.first(at));
            within[0][i] = self.weights.beyond(first[0], sample.at[0]);
            within[1][i] = self.weights.beyond(first[1], sample.at[1]);
            let [x, y] = [0, 1].map(|d| (first[d] - self.corner[d]).whole() as u32);
            starts[i] = y * (SIDE + W - 1) as u32 + x;
        }
        let [across, down]: [[[T; BATCH]; W]; 2] = [self.weights.of(&within[0]), self.weights.of(&within[1])];
        for (i, sample) in samples.iter().enumerate().take(BATCH) {
            let row: [Pixel<T, C>; W] = std::array::from_fn(|k| {
                let weight = across[k][i];
                Pixel { weight, light: sample.light.map(|l| weight * l) }
            });
            for (j, down) in down.iter().enumerate() {
                let start = starts[i] as usize + j * (SIDE + W - 1);
                let Some(pixels) = self.pixels[start..].first_chunk_mut::<W>() else { continue };
                for (pixel, part) in pixels.iter_mut().zip(&row) {
                    pixel.weight += down[i] * part.weight;
                    (0..C).for_each(|c| pixel.light[c] += down[i] * part.light[c]);
                }
            }
        }
    }
}

struct Gathering<'a, 'b, T, const C: usize, const W: usize> {
    tile: &'a mut Tile<'b, T, C, W>,
    samples: &'a [Sample<T, C>],
}

impl<T: Real, const C: usize, const W: usize> Loop for Gathering<'_, '_, T, C, W> {
    #[inline(always)]
    fn run(self) {
        for batch in self.samples.chunks(BATCH) {
            self.tile.batch(batch);
        }
    }
}
