//! Columns of an image, side by side.

use crate::engine::fft::pool::Pool;
use crate::engine::fft::roots::{root, rounded};
use crate::engine::fft::vectors::number::{Block, Number};
use crate::engine::fft::vectors::points::{Few, Points};
use crate::engine::fft::vectors::streams::{InTurnTo, Output};
use crate::engine::real::Real;
use crate::engine::simd::{LANES, Simd, Task, Wide, unrolled, with_vectors};
use crate::parallel;
use num_complex::Complex;

/// How many real columns are transformed side by side, two as one complex.
pub(in crate::engine::fft) const ABREAST: usize = 2 * LANES;

/// Bytes of a row of an image that are read at a time: each row is on another page, whose address must be looked up.
const GATHERED: usize = 1024;

const ROOTS: &str = "a stage has as many roots as points";

/// Transforms of the real columns of an image, where they stand: row `j` of a group of columns is a block, its first half
/// real, the second half imaginary parts, as they are in the image; nothing is turned. The first stage takes the group
/// apart into blocks of rows that fit into a nearer cache, the others stay within those (Gentleman & Sande 1966).
#[derive(Debug)]
pub(in crate::engine::fft) struct Abreast<T> {
    height: usize,
    first: Stage<T>,
    others: Vec<Stage<T>>,
    /// Where each frequency stands then.
    places: Vec<usize>,
}

/// Transforms of `r` points over `j` of the rows `p + mj`, times `e^{−2πipk/rm}`.
#[derive(Debug)]
struct Stage<T> {
    radix: usize,
    len: usize,
    roots: Vec<Complex<T>>,
    turns: Vec<Complex<T>>,
}

impl<T: Real> Stage<T> {
    fn new(radix: usize, len: usize) -> Self {
        let turns = (0..len / radix).flat_map(|p| (1..radix).map(move |k| rounded(root(p * k, len))));
        Self { radix, len, roots: (0..radix).map(|k| rounded(root(k, radix))).collect(), turns: turns.collect() }
    }
}

impl<T: Real> Abreast<T> {
    /// For images that are `width` wide, a multiple of 32, and `height` high, which has no prime factors but 2, 3, 5 and 7.
    pub(in crate::engine::fft) fn new(width: usize, height: usize) -> Option<Self> {
        let mut radices = radices(height).filter(|_| width.is_multiple_of(ABREAST))?.into_iter();
        let first = Stage::new(radices.next()?, height);
        let mut len = height / first.radix;
        let others: Vec<_> = radices
            .map(|radix| {
                let stage = Stage::new(radix, len);
                len /= radix;
                stage
            })
            .collect();
        let place = |k: usize| {
            let part = height / first.radix;
            let (mut place, mut rest) = (k % first.radix * (part + 1), k / first.radix);
            for stage in &others {
                place += rest % stage.radix * (stage.len / stage.radix);
                rest /= stage.radix;
            }
            place
        };
        let places = (0..height).map(place).collect();
        Some(Self { height, first, others, places })
    }

    /// Twice the spectra of all columns, frequencies up to half the height. Tile by tile, each as wide as a group of
    /// columns, row after row.
    pub(in crate::engine::fft) fn transform(&self, image: &[T], tiles: &mut [Complex<T>], pool: &Pool<T>) {
        let width = image.len() / self.height;
        // rows apart by what takes a power of two off the sets of a cache
        let rows = self.height + self.first.radix;
        let (groups, tile) = (GATHERED / (ABREAST * size_of::<T>()), ABREAST * (self.height / 2 + 1));
        parallel::chunks(tiles, groups * tile, |number, tiles| {
            let count = tiles.len() / tile;
            pool.lend(count * LANES * rows, |room| {
                let part = self.height / self.first.radix;
                let room: &mut [Block<T>] = bytemuck::cast_slice_mut(room);
                for (j, row) in image.chunks_exact(width).enumerate() {
                    let pixels = row[number * groups * ABREAST..].chunks_exact(ABREAST);
                    for (rows, pixels) in room.chunks_exact_mut(rows).zip(pixels) {
                        rows[j + j / part].as_flattened_mut().copy_from_slice(pixels);
                    }
                }
                for (rows, tile) in room.chunks_exact_mut(rows).zip(tiles.chunks_exact_mut(tile)) {
                    with_vectors(Columns { abreast: self, rows, tile: bytemuck::cast_slice_mut(tile) });
                }
            });
        });
    }

    /// Row `k` of all tiles.
    pub(in crate::engine::fft) fn row(&self, tiles: &[Complex<T>], k: usize, row: &mut [Complex<T>]) {
        let tile = ABREAST * (self.height / 2 + 1);
        for (tile, out) in tiles.chunks_exact(tile).zip(row.chunks_exact_mut(ABREAST)) {
            let blocks: &[Block<T>] = bytemuck::cast_slice(&tile[k * ABREAST..][..ABREAST]);
            with_vectors(Row { blocks, out });
        }
    }
}

/// Sixteens first, so that blocks are small, what is left of the twos, odd ones.
fn radices(n: usize) -> Option<Vec<usize>> {
    let mut twos = n.checked_ilog2().map(|_| n.trailing_zeros())?;
    let (mut rest, mut radices) = (n >> twos, Vec::new());
    while twos > 0 {
        let next = if twos == 5 { 3 } else { twos.min(4) };
        radices.push(1 << next);
        twos -= next;
    }
    for odd in [7, 5, 3] {
        while rest.is_multiple_of(odd) {
            rest /= odd;
            radices.push(odd);
        }
    }
    (rest == 1).then_some(radices)
}

struct Columns<'a, T> {
    abreast: &'a Abreast<T>,
    rows: &'a mut [Block<T>],
    tile: &'a mut [Block<T>],
}

impl<T: Real> Task for Columns<'_, T> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let Self { abreast, rows, tile } = self;
        let part = abreast.height / abreast.first.radix;
        abreast.first.run(simd, rows, part + 1);
        for rows in rows.chunks_exact_mut(part + 1) {
            for stage in &abreast.others {
                for rows in rows[..part].chunks_exact_mut(stage.len) {
                    stage.run(simd, rows, stage.len / stage.radix);
                }
            }
        }
        for (k, pair) in tile.chunks_exact_mut(2).enumerate() {
            let here = &rows[abreast.places[k]];
            let there = &rows[abreast.places[if k == 0 { 0 } else { abreast.height - k }]];
            for at in (0..LANES).step_by(Wide::<T, S>::COUNT) {
                let (here, there) = (Number::part(simd, here, at), Number::part(simd, there, at));
                Number { re: here.re + there.re, im: here.im - there.im }.to_part(&mut pair[0], at);
                Number { re: here.im + there.im, im: there.re - here.re }.to_part(&mut pair[1], at);
            }
        }
    }
}

impl<T: Real> Stage<T> {
    #[inline(always)]
    fn run<S: Simd>(&self, simd: S, rows: &mut [Block<T>], stride: usize) {
        match self.radix {
            2 => self.by::<S, 2>(simd, rows, stride),
            3 => self.by::<S, 3>(simd, rows, stride),
            4 => self.by::<S, 4>(simd, rows, stride),
            5 => self.by::<S, 5>(simd, rows, stride),
            7 => self.by::<S, 7>(simd, rows, stride),
            8 => self.by::<S, 8>(simd, rows, stride),
            _ => self.by::<S, 16>(simd, rows, stride),
        }
    }

    #[inline(always)]
    fn by<S: Simd, const R: usize>(&self, simd: S, rows: &mut [Block<T>], stride: usize)
    where
        Few: Points<R>,
    {
        let roots: &[Complex<T>; R] = self.roots.as_slice().try_into().expect(ROOTS);
        for (p, turns) in self.turns.chunks_exact(R - 1).enumerate() {
            let rows = &mut rows[p..][..stride * (R - 1) + 1];
            for at in (0..LANES).step_by(Wide::<T, S>::COUNT) {
                let mut z = [Number::splat(simd, roots[0]); R];
                unrolled!(j < R, z[j] = Number::part(simd, &rows[stride * j], at));
                z = Few::transform(simd, roots, z);
                z[0].to_part(&mut rows[0], at);
                unrolled!(k < R - 1, {
                    z[k + 1].times(Number::splat(simd, turns[k])).to_part(&mut rows[stride * (k + 1)], at);
                });
            }
        }
    }
}

struct Row<'a, T> {
    blocks: &'a [Block<T>],
    out: &'a mut [Complex<T>],
}

impl<T: Real> Task for Row<'_, T> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        for (block, out) in self.blocks.iter().zip(self.out.chunks_exact_mut(LANES)) {
            for at in (0..LANES).step_by(Wide::<T, S>::COUNT) {
                InTurnTo(&mut *out).write(simd, at, Number::part(simd, block, at));
            }
        }
    }
}
