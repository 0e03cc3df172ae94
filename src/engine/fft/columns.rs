//! Transforms of the columns of a matrix, in blocks that fit into a cache.

use crate::engine::fft::butterflies::Short;
use crate::engine::fft::pool::Pool;
use crate::engine::real::Real;
use crate::engine::simd::{Loop, vectorised};
use crate::parallel;
use num_complex::Complex;

/// How many complex columns are gathered at a time: as many as eight lines of a cache hold.
pub(super) const fn block<T>() -> usize {
    512 / size_of::<Complex<T>>()
}

/// The most of them.
const MOST: usize = 64;

/// Numbers between columns that lie one after another, so that a row of them does not fall into one set of the cache when
/// they are a power of two long.
const GAP: usize = 8;

/// A part of a row.
pub(super) type Piece<T> = [Complex<T>; MOST];

/// The rows of a matrix. Implementations are `#[inline(always)]`: they are compiled into the loop that reads.
pub(super) trait Rows<T>: Sync {
    /// The numbers of a row from column `first` on; what is behind its end may be anything.
    fn read(&self, row: usize, first: usize, piece: &mut Piece<T>);
}

/// What columns become in their tile.
pub(super) trait Tile<T>: Sync {
    /// How many numbers a column becomes, of `height`.
    fn kept(height: usize) -> usize;

    /// How many columns one becomes.
    const SPREAD: usize;

    /// Row `k` to the rows of the tile, from columns that lie one after another, `stride` apart, with their first number
    /// once more behind the last.
    fn store(columns: &[Complex<T>], height: usize, stride: usize, width: usize, tile: &mut [Complex<T>]);
}

/// Transforms all columns of a matrix that is `plan.len()` high and has `width` columns in the end.
///
/// `tiles` is filled tile by tile, from front to back, and a tile row by row: of each row every tile has a piece in one
/// place, where it is found by [`gather_row`].
pub(super) fn transform_columns<T: Real, S: Tile<T>>(
    plan: &Short<T>,
    width: usize,
    rows: &impl Rows<T>,
    tiles: &mut [Complex<T>],
    pool: &Pool<T>,
) {
    let height = plan.len();
    let (stride, wide) = (height + GAP, block::<T>() * S::SPREAD);
    parallel::chunks(tiles, S::kept(height) * wide, |number, tile| {
        let width = wide.min(width - number * wide);
        let count = width.div_ceil(S::SPREAD);
        pool.lend(count * stride + plan.room(), |work| {
            let (columns, room) = work.split_at_mut(count * stride);
            vectorised(Gather { rows, height, first: number * block::<T>(), stride, columns: &mut *columns });
            for column in columns.chunks_exact_mut(stride) {
                plan.run(&mut column[..height], room);
                column[height] = column[0];
            }
            vectorised(Store::<T, S> { columns, height, stride, width, tile, kind: std::marker::PhantomData });
        });
    });
}

/// Row `k` of the matrix in `tiles` of `kept` rows, each `wide`.
pub(super) fn gather_row<T: Copy>(tiles: &[Complex<T>], kept: usize, wide: usize, k: usize, row: &mut [Complex<T>]) {
    for (tile, piece) in tiles.chunks(kept * wide).zip(row.chunks_mut(wide)) {
        piece.copy_from_slice(&tile[k * piece.len()..][..piece.len()]);
    }
}

/// Rows to columns.
struct Gather<'a, T, R> {
    rows: &'a R,
    height: usize,
    first: usize,
    stride: usize,
    columns: &'a mut [Complex<T>],
}

impl<T: Real, R: Rows<T>> Loop for Gather<'_, T, R> {
    #[inline(always)]
    fn run(self) {
        let mut pieces = [[Complex::default(); MOST]; 4];
        for top in (0..self.height).step_by(4) {
            for (i, piece) in pieces.iter_mut().enumerate().take(self.height - top) {
                self.rows.read(top + i, self.first, piece);
            }
            // four at a time, a line of the cache; what is written below the last row falls into the gap
            for (i, column) in self.columns.chunks_exact_mut(self.stride).enumerate() {
                if let Some(four) = column[top..].first_chunk_mut::<4>() {
                    *four = [pieces[0][i], pieces[1][i], pieces[2][i], pieces[3][i]];
                }
            }
        }
    }
}

struct Store<'a, T, S> {
    columns: &'a [Complex<T>],
    height: usize,
    stride: usize,
    width: usize,
    tile: &'a mut [Complex<T>],
    kind: std::marker::PhantomData<S>,
}

impl<T: Real, S: Tile<T>> Loop for Store<'_, T, S> {
    #[inline(always)]
    fn run(self) {
        S::store(self.columns, self.height, self.stride, self.width, self.tile);
    }
}

/// Complex columns, as they are.
pub(super) struct Same;

impl<T: Real> Tile<T> for Same {
    const SPREAD: usize = 1;

    fn kept(height: usize) -> usize {
        height
    }

    #[inline(always)]
    fn store(columns: &[Complex<T>], _: usize, stride: usize, width: usize, tile: &mut [Complex<T>]) {
        for (i, rows) in tile.chunks_mut(4 * width).enumerate() {
            for (c, column) in columns.chunks_exact(stride).enumerate() {
                if let Some(four) = column[4 * i..].first_chunk::<4>() {
                    for (row, value) in rows.chunks_exact_mut(width).zip(four) {
                        row[c] = *value;
                    }
                }
            }
        }
    }
}

/// Pairs of real columns `a + ib`: twice the spectra of both, up to half the height, `Z_k + Z̄_{h−k}` and
/// `−i(Z_k − Z̄_{h−k})`.
pub(super) struct Pairs;

impl<T: Real> Tile<T> for Pairs {
    const SPREAD: usize = 2;

    fn kept(height: usize) -> usize {
        height / 2 + 1
    }

    #[inline(always)]
    fn store(columns: &[Complex<T>], height: usize, stride: usize, width: usize, tile: &mut [Complex<T>]) {
        for (k, row) in tile.chunks_exact_mut(width).enumerate() {
            for (pair, column) in row.chunks_mut(2).zip(columns.chunks_exact(stride)) {
                let (here, there) = (column[k], column[height - k]);
                pair[0] = Complex::new(here.re + there.re, here.im - there.im);
                if let Some(second) = pair.get_mut(1) {
                    *second = Complex::new(here.im + there.im, there.re - here.re);
                }
            }
        }
    }
}
