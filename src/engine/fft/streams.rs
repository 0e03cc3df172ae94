//! A large transform as sixteen shorter ones, on all threads.

use crate::engine::fft::butterflies::{Butterflies, Short};
use crate::engine::fft::pool::Pool;
use crate::engine::fft::radix::{ORDER, RADIX, butterflies, sixteenths};
use crate::engine::fft::roots::Turns;
use crate::engine::fft::rows::{Line, Source, WIDTH};
use crate::engine::real::Real;
use crate::engine::simd::{Loop, vectorised};
use crate::parallel;
use ndarray::{ArrayViewMut2, Axis};
use num_complex::Complex;

/// Numbers between the rows, so that a column does not fall into one set of the cache when rows are a power of two long.
const GAP: usize = 16;

/// How many columns are a piece of work.
const PIECE: usize = 256;

/// A transform of `n = 16·len` numbers, seen as a matrix of sixteen rows: first its columns, sixteen streams through memory
/// side by side, then twiddle factors `e^{−2πik₁j₂/n}`, then the rows, each of which fits into a cache (Gentleman & Sande
/// 1966; Bailey 1990). Row `k₁` then has the frequencies `k₁ + 16k₂`: whoever reads them puts them in order, in the pass
/// over the result that units, phases and symmetries need anyway.
#[derive(Debug)]
pub(super) struct Streams<T> {
    row: Short<T>,
    roots: Turns<T>,
    sixteenths: [Complex<T>; RADIX],
    /// The twiddle factors of the first columns of every row.
    first: [Line<T>; RADIX],
    rooms: Pool<T>,
}

impl<T: Real> Streams<T> {
    /// For `n` numbers, a multiple of sixteen.
    pub(super) fn new(n: usize, butterflies: Butterflies) -> Self {
        debug_assert!(n.is_multiple_of(RADIX));
        let roots = Turns::roots(n, n);
        let first = std::array::from_fn(|k| Line::from_fn(|j| roots.at(k * j % n)));
        let row = Short::new(n / RADIX, butterflies);
        Self { row, roots, sixteenths: sixteenths(), first, rooms: Pool::new() }
    }

    /// How many numbers a row has.
    pub(super) fn len(&self) -> usize {
        self.row.len()
    }

    /// From one row to the next.
    pub(super) fn stride(&self) -> usize {
        self.row.len() + GAP
    }

    /// How many numbers a store has.
    pub(super) fn room(&self) -> usize {
        RADIX * self.stride()
    }

    /// Columns and twiddle factors.
    pub(super) fn columns(&self, source: &impl Source<T>, store: &mut [Complex<T>]) {
        self.pieces(store, |from, out| vectorised(Columns { streams: self, source, from, out }));
    }

    /// The rows, and `f` of each with its number.
    pub(super) fn rows(&self, store: &mut [Complex<T>], f: impl Fn(usize, &mut [Complex<T>]) + Sync + Send) {
        parallel::chunks(store, self.stride(), |k, row| {
            let row = &mut row[..self.row.len()];
            self.transform_row(row);
            f(k, row);
        });
    }

    /// One row once more.
    pub(super) fn transform_row(&self, row: &mut [Complex<T>]) {
        self.rooms.lend(self.row.room(), |room| self.row.run(row, room));
    }

    /// The twiddle factors of one row.
    pub(super) fn twist_row(&self, k: usize, row: &mut [Complex<T>]) {
        vectorised(Twist { streams: self, k, row });
    }

    /// The columns alone, of a store whose rows have been transformed back to where they came from: number `j` then stands
    /// in row `j/len`, times `factors[j]`, conjugated before.
    pub(super) fn columns_back(&self, factors: &[Complex<T>], store: &mut [Complex<T>]) {
        self.pieces(store, |from, out| vectorised(ColumnsBack { streams: self, factors, from, out }));
    }

    /// `f` of the columns from a first one on.
    fn pieces(&self, store: &mut [Complex<T>], f: impl Fn(usize, ArrayViewMut2<'_, Complex<T>>) + Sync + Send) {
        let shape = (RADIX, self.stride());
        let mut matrix = ArrayViewMut2::from_shape(shape, store).expect("a store has the room of its rows");
        let mut pieces: Vec<_> = matrix.axis_chunks_iter_mut(Axis(1), PIECE).collect();
        parallel::chunks(&mut pieces, 1, |i, piece| piece.iter_mut().for_each(|out| f(i * PIECE, out.view_mut())));
    }
}

struct Columns<'a, T, S> {
    streams: &'a Streams<T>,
    source: &'a S,
    from: usize,
    out: ArrayViewMut2<'a, Complex<T>>,
}

impl<T: Real, S: Source<T>> Loop for Columns<'_, T, S> {
    #[inline(always)]
    fn run(mut self) {
        let Streams { row, roots, sixteenths, first: twiddles, .. } = self.streams;
        let (len, n) = (row.len(), RADIX * row.len());
        let end = (self.from + self.out.ncols()).min(len);
        let mut block = [Line::default(); RADIX];
        for first in (self.from..end).step_by(WIDTH) {
            let count = WIDTH.min(len - first);
            for (j, line) in block.iter_mut().enumerate() {
                self.source.read(j * len + first, count, line);
            }
            butterflies(&mut block, sixteenths);
            for (line, k) in block.iter_mut().zip(ORDER) {
                line.times(&twiddles[k].turned(roots.at(k * first % n)));
                if let Some(out) = self.out.row_mut(k).as_slice_mut() {
                    line.write(&mut out[first - self.from..]);
                }
            }
        }
    }
}

struct Twist<'a, T> {
    streams: &'a Streams<T>,
    k: usize,
    row: &'a mut [Complex<T>],
}

impl<T: Real> Loop for Twist<'_, T> {
    #[inline(always)]
    fn run(self) {
        let Streams { row, roots, first, .. } = self.streams;
        let n = RADIX * row.len();
        let mut line = Line::default();
        for (i, piece) in self.row.chunks_mut(WIDTH).enumerate() {
            line.read(piece);
            line.times(&first[self.k].turned(roots.at(self.k * i * WIDTH % n)));
            line.write(piece);
        }
    }
}

struct ColumnsBack<'a, T> {
    streams: &'a Streams<T>,
    factors: &'a [Complex<T>],
    from: usize,
    out: ArrayViewMut2<'a, Complex<T>>,
}

impl<T: Real> Loop for ColumnsBack<'_, T> {
    #[inline(always)]
    fn run(mut self) {
        let len = self.streams.row.len();
        let end = (self.from + self.out.ncols()).min(len);
        let (mut block, mut factor) = ([Line::default(); RADIX], Line::default());
        for first in (self.from..end).step_by(WIDTH) {
            let within = first - self.from..(end - self.from).min(first - self.from + WIDTH);
            for (line, row) in block.iter_mut().zip(self.out.rows()) {
                if let Some(row) = row.to_slice() {
                    line.read(&row[within.clone()]);
                }
            }
            butterflies(&mut block, &self.streams.sixteenths);
            for (line, j) in block.iter_mut().zip(ORDER) {
                line.conjugate();
                factor.read(self.factors.get(j * len + first..).unwrap_or_default());
                line.times(&factor);
                if let Some(row) = self.out.row_mut(j).as_slice_mut() {
                    line.write(&mut row[within.clone()]);
                }
            }
        }
    }
}
