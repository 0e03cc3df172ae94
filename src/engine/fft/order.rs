//! The pass over a result that puts it in order, with its factors.

use crate::engine::fft::radix::RADIX;
use crate::engine::fft::roots::Turns;
use crate::engine::fft::rows::{Line, WIDTH};
use crate::engine::real::Real;
use crate::engine::simd::Loop;
use crate::parallel;
use num_complex::Complex;

/// How many numbers of a result are a piece of work.
pub(super) const PIECE: usize = 1 << 15;

/// `f` of every piece of `out`, with the number of its first value.
pub(super) fn pieces<T: Send>(out: &mut [T], f: impl Fn(usize, &mut [T]) + Sync + Send) {
    if out.len() <= PIECE {
        f(0, out);
    } else {
        parallel::chunks(out, PIECE, |i, piece| f(i * PIECE, piece));
    }
}

/// Where the frequencies stand.
#[derive(Debug, Clone, Copy)]
pub(super) enum Order {
    /// One after another.
    Plain,
    /// `k` in column `k/16` of sixteen rows, from one to the next of which it is so far.
    Columns(usize),
    /// Row after row of that length, from one to the next of which it is so far.
    Rows(usize, usize),
}

/// The frequencies of a transform, wherever they stand.
#[derive(Debug, Clone, Copy)]
pub(super) struct Frequencies<'a, T> {
    store: &'a [Complex<T>],
    order: Order,
    n: usize,
}

impl<'a, T: Real> Frequencies<'a, T> {
    pub(super) fn new(store: &'a [Complex<T>], order: Order, n: usize) -> Self {
        Self { store, order, n }
    }

    /// How many there are.
    #[inline(always)]
    pub(super) fn len(&self) -> usize {
        self.n
    }

    /// Frequency `k < 2n`, modulo `n`.
    #[inline(always)]
    pub(super) fn at(&self, k: usize) -> Complex<T> {
        let k = if k < self.n { k } else { k - self.n };
        match self.order {
            Order::Plain => self.store[k],
            Order::Columns(stride) => self.store[(k % RADIX) * stride + k / RADIX],
            Order::Rows(len, stride) => self.store[k / len * stride + k % len],
        }
    }

    /// Those from `k` on; `count` of them are needed.
    #[inline(always)]
    pub(super) fn read(&self, k: usize, count: usize, line: &mut Line<T>) {
        let inside = k + count <= self.n;
        match self.order {
            Order::Plain if inside => line.read(&self.store[k..k + count]),
            Order::Columns(stride) if inside && k.is_multiple_of(RADIX) => {
                for (i, row) in self.store.chunks_exact(stride).enumerate() {
                    (line.re[i], line.im[i]) = (row[k / RADIX].re, row[k / RADIX].im);
                }
            }
            Order::Rows(len, stride) if inside && k % len + count <= len => {
                line.read(&self.store[k / len * stride + k % len..][..count]);
            }
            _ => (0..count).for_each(|i| {
                let value = self.at(k + i);
                (line.re[i], line.im[i]) = (value.re, value.im);
            }),
        }
    }

    /// Those from `k` on downwards; `count ≤ k + 1` of them are needed.
    #[inline(always)]
    pub(super) fn read_down(&self, k: usize, count: usize, line: &mut Line<T>) {
        match self.order {
            Order::Plain if k < self.n => line.read_down(&self.store[..=k]),
            _ => (0..count).for_each(|i| {
                let value = self.at(k - i);
                (line.re[i], line.im[i]) = (value.re, value.im);
            }),
        }
    }
}

/// Frequencies as they rise from `−shift` on, each times its factor.
pub(super) struct InOrder<'a, T> {
    pub(super) frequencies: Frequencies<'a, T>,
    pub(super) first: usize,
    pub(super) shift: usize,
    pub(super) factors: Option<&'a Turns<T>>,
    pub(super) out: &'a mut [Complex<T>],
}

impl<T: Real> Loop for InOrder<'_, T> {
    #[inline(always)]
    fn run(self) {
        let n = self.frequencies.n;
        let mut line = Line::default();
        for (i, piece) in self.out.chunks_mut(WIDTH).enumerate() {
            let at = self.first + i * WIDTH;
            let k = if at < self.shift { at + n - self.shift } else { at - self.shift };
            self.frequencies.read(k, piece.len(), &mut line);
            if let Some(factors) = self.factors {
                line.times(&factors.line(at));
            }
            line.write(piece);
        }
    }
}
