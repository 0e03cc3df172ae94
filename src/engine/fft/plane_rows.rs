//! Rows of images and of their spectra, where symmetry repeats one half.

use crate::engine::fft::columns::{Piece, Rows, block};
use crate::engine::fft::order::{Frequencies, Order};
use crate::engine::fft::roots::Turns;
use crate::engine::fft::rows::{Line, WIDTH};
use crate::engine::real::Real;
use crate::engine::simd::Loop;
use num_complex::Complex;

/// The rows of a real image, two columns as one complex.
pub(super) struct ImageRows<'a, T> {
    pub(super) image: &'a [T],
    pub(super) width: usize,
}

impl<T: Real> Rows<T> for ImageRows<'_, T> {
    #[inline(always)]
    fn read(&self, row: usize, first: usize, piece: &mut Piece<T>) {
        let row = &self.image[row * self.width..][..self.width][2 * first..];
        if let Some(whole) = bytemuck::cast_slice(&row[..row.len() & !1]).get(..block::<T>()) {
            return piece[..block::<T>()].copy_from_slice(whole);
        }
        let pairs = row.chunks_exact(2);
        if let (Some(z), [last]) = (piece.get_mut(row.len() / 2), pairs.remainder()) {
            *z = Complex::new(*last, T::zero());
        }
        for (z, pair) in piece[..block::<T>()].iter_mut().zip(pairs) {
            *z = Complex::new(pair[0], pair[1]);
        }
    }
}

/// The conjugate of the Hermitian part of a centred spectrum, times a factor for each column and one for each row, in plain
/// order; columns up to half the width.
pub(super) struct HermitianPart<'a, T> {
    pub(super) bins: &'a [Complex<T>],
    pub(super) across: &'a [Complex<T>],
    pub(super) down: &'a [Complex<T>],
}

impl<T: Real> Rows<T> for HermitianPart<'_, T> {
    #[inline(always)]
    fn read(&self, row: usize, first: usize, piece: &mut Piece<T>) {
        let (nx, ny) = (self.across.len(), self.down.len());
        let place = |k: usize, n: usize| (k + n / 2) % n;
        let (here, there) = (place(row, ny), place(ny - row, ny));
        let at = |l: usize, k: usize| self.bins[l * nx + k].conj() * (self.across[k] * self.down[l]);
        for (i, z) in piece.iter_mut().take(block::<T>().min(nx / 2 + 1 - first)).enumerate() {
            let k = first + i;
            *z = at(here, place(k, nx)) + at(there, place(nx - k, nx)).conj();
        }
    }
}

/// `|F|²` of a row, at its place and at that of its opposite.
pub(super) struct Power<'a, T> {
    pub(super) row: &'a [Complex<T>],
    pub(super) scale: T,
    pub(super) here: Option<&'a mut [T]>,
    pub(super) there: Option<&'a mut [T]>,
}

impl<T: Real> Loop for Power<'_, T> {
    #[inline(always)]
    fn run(self) {
        let n = self.row.len();
        let power = |z: &Complex<T>| self.scale * (z.re * z.re + z.im * z.im);
        if let Some(here) = self.here {
            let (low, high) = self.row.split_at(n - n / 2);
            let (negative, positive) = here.split_at_mut(n / 2);
            positive.iter_mut().zip(low).for_each(|(p, z)| *p = power(z));
            negative.iter_mut().zip(high).for_each(|(p, z)| *p = power(z));
        }
        if let Some(there) = self.there {
            // where −k stands
            let (low, high) = self.row.split_at(n / 2 + 1);
            let (negative, positive) = there.split_at_mut(n / 2 + 1);
            negative.iter_mut().rev().zip(low).for_each(|(p, z)| *p = power(z));
            positive.iter_mut().rev().zip(high).for_each(|(p, z)| *p = power(z));
        }
    }
}

/// A row of a spectrum in physical units, at its place and, conjugated, at that of its opposite.
pub(super) struct Spectrum<'a, T> {
    pub(super) row: &'a [Complex<T>],
    /// A factor for each column.
    pub(super) turns: &'a Turns<T>,
    /// Each with the factor of its row.
    pub(super) here: Option<(&'a mut [Complex<T>], Complex<T>)>,
    pub(super) there: Option<(&'a mut [Complex<T>], Complex<T>)>,
}

impl<T: Real> Loop for Spectrum<'_, T> {
    #[inline(always)]
    fn run(self) {
        let (n, zero) = (self.row.len(), self.row.len() / 2);
        let frequencies = Frequencies::new(self.row, Order::Plain, n);
        let mut line = Line::default();
        if let Some((out, turn)) = self.here {
            for (i, piece) in out.chunks_mut(WIDTH).enumerate() {
                let at = i * WIDTH;
                frequencies.read(if at < zero { at + n - zero } else { at - zero }, piece.len(), &mut line);
                line.times(&self.turns.line(at).turned(turn));
                line.write(piece);
            }
        }
        if let Some((out, turn)) = self.there {
            for (i, piece) in out.chunks_mut(WIDTH).enumerate() {
                let at = i * WIDTH;
                let whole = at + piece.len() <= zero + 1;
                frequencies.read_down(if whole { zero - at } else { n + zero - at }, piece.len(), &mut line);
                line.conjugate();
                line.times(&self.turns.line(at).turned(turn));
                line.write(piece);
            }
        }
    }
}

/// The conjugated half spectra `a`, `b` of two real rows as the whole spectrum of one complex row.
pub(super) fn together<T: Real>(a: &[Complex<T>], b: &[Complex<T>], both: &mut [Complex<T>]) {
    let n = both.len();
    for (k, (a, b)) in a.iter().zip(b).enumerate() {
        both[k] = Complex::new(a.re - b.im, a.im + b.re);
        if k > 0 && 2 * k < n {
            both[n - k] = Complex::new(a.re + b.im, b.re - a.im);
        }
    }
}

/// A complex row as two real ones, or as one.
pub(super) struct Apart<'a, T> {
    pub(super) both: &'a [Complex<T>],
    pub(super) pair: &'a mut [T],
}

impl<T: Real> Loop for Apart<'_, T> {
    #[inline(always)]
    fn run(self) {
        let (first, second) = self.pair.split_at_mut(self.both.len());
        first.iter_mut().zip(self.both).for_each(|(x, z)| *x = z.re);
        second.iter_mut().zip(self.both).for_each(|(x, z)| *x = z.im);
    }
}
