//! Samples of a block, sorted by tiles.

use crate::engine::film::Sample;
use crate::engine::real::Real;

/// Some samples, those of each tile together, in their order.
#[derive(Debug)]
pub(super) struct Block<T, const C: usize> {
    sorted: Vec<Sample<T, C>>,
    /// Where the samples of each tile end, behind where those of the first begin.
    ends: Vec<u32>,
    /// The tile of each sample as it was given.
    tiles: Vec<u32>,
    /// The first sample that is not finite.
    unclear: Option<usize>,
}

impl<T, const C: usize> Default for Block<T, C> {
    fn default() -> Self {
        Self { sorted: Vec::new(), ends: Vec::new(), tiles: Vec::new(), unclear: None }
    }
}

impl<T: Real, const C: usize> Block<T, C> {
    /// Takes samples: a counting sort by the numbers below `tiles` that `find` gives them. Samples of the number `tiles`
    /// are left out.
    pub(super) fn sort(&mut self, samples: &[Sample<T, C>], tiles: usize, find: impl Fn(&[Sample<T, C>], &mut [u32])) {
        self.tiles.resize(samples.len(), 0);
        find(samples, &mut self.tiles);
        let finite = |s: &Sample<T, C>| s.at.iter().chain(&s.light).all(|v| v.is_finite());
        self.unclear = samples.iter().position(|s| !finite(s));
        self.ends.clear();
        self.ends.resize(tiles + 2, 0);
        self.tiles.iter().for_each(|&t| self.ends[t as usize + 1] += 1);
        (1..tiles + 2).for_each(|t| self.ends[t] += self.ends[t - 1]);
        // where the next sample of each tile goes; afterwards, where its samples end
        self.ends.rotate_right(1);
        self.ends[0] = 0;
        self.sorted.resize(samples.len(), Sample { at: [T::zero(); 2], light: [T::zero(); C] });
        for (sample, &t) in samples.iter().zip(&self.tiles) {
            let next = &mut self.ends[t as usize + 1];
            self.sorted[*next as usize] = *sample;
            *next += 1;
        }
    }

    /// The first sample that is not finite.
    pub(super) fn unclear(&self) -> Option<usize> {
        self.unclear
    }

    /// The samples of a tile.
    pub(super) fn of_tile(&self, tile: usize) -> &[Sample<T, C>] {
        &self.sorted[self.ends[tile] as usize..self.ends[tile + 1] as usize]
    }
}
