//! Numbers that are read and written a line at a time.

use crate::engine::real::Real;
use num_complex::Complex;

/// How many numbers are taken at a time: four lines of a cache in `f64`.
pub(super) const WIDTH: usize = 16;

/// Numbers in a row, real and imaginary parts apart: arithmetic on them needs no shuffling.
#[derive(Debug, Clone, Copy)]
pub(super) struct Line<T> {
    pub(super) re: [T; WIDTH],
    pub(super) im: [T; WIDTH],
}

impl<T: Real> Line<T> {
    /// `f(0), f(1), …`
    #[inline(always)]
    pub(super) fn from_fn(f: impl Fn(usize) -> Complex<T>) -> Self {
        let mut line = Self::default();
        for (i, (re, im)) in line.re.iter_mut().zip(&mut line.im).enumerate() {
            let value = f(i);
            (*re, *im) = (value.re, value.im);
        }
        line
    }

    /// The start of `from`, as far as both go. (A loop of unknown length is vectorised; one that is unrolled is not.)
    #[inline(always)]
    pub(super) fn read(&mut self, from: &[Complex<T>]) {
        for ((re, im), z) in self.re.iter_mut().zip(&mut self.im).zip(from) {
            (*re, *im) = (z.re, z.im);
        }
    }

    /// Its start to `to`, as far as both go.
    #[inline(always)]
    pub(super) fn write(&self, to: &mut [Complex<T>]) {
        for ((re, im), z) in self.re.iter().zip(&self.im).zip(to) {
            *z = Complex::new(*re, *im);
        }
    }

    /// The end of `from`, as far as both go, the last number first.
    #[inline(always)]
    pub(super) fn read_down(&mut self, from: &[Complex<T>]) {
        match from.len().checked_sub(WIDTH) {
            Some(start) => {
                self.read(&from[start..]);
                *self = self.reversed();
            }
            None => {
                for ((re, im), z) in self.re.iter_mut().zip(&mut self.im).zip(from.iter().rev()) {
                    (*re, *im) = (z.re, z.im);
                }
            }
        }
    }

    /// Its start to the end of `to`, as far as both go, the last number first.
    #[inline(always)]
    pub(super) fn write_down(&self, to: &mut [Complex<T>]) {
        match to.len().checked_sub(WIDTH) {
            Some(start) => self.reversed().write(&mut to[start..]),
            None => {
                for ((re, im), z) in self.re.iter().zip(&self.im).zip(to.iter_mut().rev()) {
                    *z = Complex::new(*re, *im);
                }
            }
        }
    }

    /// The last number first.
    #[inline(always)]
    fn reversed(&self) -> Self {
        let mut line = *self;
        for i in 0..WIDTH {
            line.re[i] = self.re[WIDTH - 1 - i];
            line.im[i] = self.im[WIDTH - 1 - i];
        }
        line
    }

    /// Every number times its own one.
    #[inline(always)]
    pub(super) fn times(&mut self, other: &Self) {
        for i in 0..WIDTH {
            let (re, im) = (self.re[i], self.im[i]);
            self.re[i] = re * other.re[i] - im * other.im[i];
            self.im[i] = re * other.im[i] + im * other.re[i];
        }
    }

    /// Every number times the same one.
    #[inline(always)]
    pub(super) fn turned(&self, by: Complex<T>) -> Self {
        let mut line = *self;
        for i in 0..WIDTH {
            line.re[i] = self.re[i] * by.re - self.im[i] * by.im;
            line.im[i] = self.re[i] * by.im + self.im[i] * by.re;
        }
        line
    }

    /// The conjugates.
    #[inline(always)]
    pub(super) fn conjugate(&mut self) {
        self.im.iter_mut().for_each(|im| *im = -*im);
    }
}

impl<T: Real> Default for Line<T> {
    fn default() -> Self {
        Self { re: [T::zero(); WIDTH], im: [T::zero(); WIDTH] }
    }
}

/// What a transform reads. Implementations are `#[inline(always)]`: they are compiled into the loop that reads.
pub(super) trait Source<T: Real>: Sync {
    /// The numbers from `at` on; `count` of them are needed, and what stands behind them may be anything.
    fn read(&self, at: usize, count: usize, line: &mut Line<T>);

    /// All of them, if they stand in a row already.
    fn in_a_row(&self) -> Option<&[Complex<T>]> {
        None
    }

    /// All of them.
    #[inline(always)]
    fn read_all(&self, to: &mut [Complex<T>]) {
        let mut line = Line::default();
        for (i, piece) in to.chunks_mut(WIDTH).enumerate() {
            self.read(i * WIDTH, piece.len(), &mut line);
            line.write(piece);
        }
    }
}

/// The numbers themselves.
pub(super) struct Numbers<'a, T>(pub(super) &'a [Complex<T>]);

impl<T: Real> Source<T> for Numbers<'_, T> {
    #[inline(always)]
    fn read(&self, at: usize, count: usize, line: &mut Line<T>) {
        line.read(&self.0[at..at + count]);
    }

    fn in_a_row(&self) -> Option<&[Complex<T>]> {
        Some(self.0)
    }
}

/// Their conjugates: a forward transform of them is the conjugate of the inverse one.
pub(super) struct Conjugates<'a, T>(pub(super) &'a [Complex<T>]);

impl<T: Real> Source<T> for Conjugates<'_, T> {
    #[inline(always)]
    fn read(&self, at: usize, count: usize, line: &mut Line<T>) {
        line.read(&self.0[at..at + count]);
        line.conjugate();
    }
}
