//! Putting a transform in order where it stands, with its factors: nothing is copied.

use crate::engine::fft::block::{BLOCK, Block, block, block_mut, conjugate, each, reversed, times};
use crate::engine::fft::order::PIECE;
use crate::engine::fft::roots::{Factors, Turns};
use crate::engine::real::Real;
use crate::engine::simd::{Loop, vectorised};
use crate::parallel;
use num_complex::Complex;

/// Frequencies from zero on to rising ones, zero in the middle: the halves of an even number of them exchanged, each
/// number times its factor.
pub(super) fn centre<T: Real>(numbers: &mut [Complex<T>], factors: &Turns<T>) {
    let middle = numbers.len() / 2;
    let (low, high) = numbers.split_at_mut(middle);
    if low.len() <= PIECE {
        return vectorised(Exchange { first: 0, middle, low, high, factors });
    }
    let mut pieces: Vec<_> = low.chunks_mut(PIECE).zip(high.chunks_mut(PIECE)).collect();
    parallel::chunks(&mut pieces, 1, |i, piece| {
        for (low, high) in piece {
            vectorised(Exchange { first: i * PIECE, middle, low, high, factors });
        }
    });
}

struct Exchange<'a, T> {
    first: usize,
    middle: usize,
    low: &'a mut [Complex<T>],
    high: &'a mut [Complex<T>],
    factors: &'a Turns<T>,
}

impl<T: Real> Loop for Exchange<'_, T> {
    #[inline(always)]
    fn run(self) {
        match self.factors.table() {
            Some(table) => self.with(table),
            None => {
                let products = self.factors.products();
                self.with(products);
            }
        }
    }
}

impl<T: Real> Exchange<'_, T> {
    #[inline(always)]
    fn with(self, factors: impl Factors<T>) {
        let Self { first, middle, low, high, .. } = self;
        let whole = low.len() / BLOCK * BLOCK;
        for i in (0..whole).step_by(BLOCK) {
            let (here, there) = (block_mut(low, i), block_mut(high, i));
            let moved = times(there, &factors.block(first + i));
            *there = times(here, &factors.block(middle + first + i));
            *here = moved;
        }
        for i in whole..low.len() {
            let moved = high[i] * factors.one(first + i);
            high[i] = low[i] * factors.one(middle + first + i);
            low[i] = moved;
        }
    }
}

/// The spectrum of an even number `n` of real values from that of half as many complex ones `Z`, which stands in all places
/// but the last: the Hermitian part of `Z` belongs to the even, the anti-Hermitian one to the odd values, so
/// `2X_k = E_k + t_k` and `2X_{M−k} = (E_k − t_k)*` with `M = n/2`, `E_k = Z_k + Z̄_{M−k}`,
/// `t_k = −i·e^{−2πik/n}·(Z_k − Z̄_{M−k})` (Sorensen et al. 1987). Each times its factor, which has the ½ in it.
pub(super) fn unfold<T: Real>(numbers: &mut [Complex<T>], roots: &Turns<T>, factors: Option<&Turns<T>>) {
    let middle = numbers.len() - 1;
    // zero is its own mirror
    numbers[middle] = numbers[0];
    let (front, back) = numbers.split_at_mut(middle.div_ceil(2));
    let (between, back) = back.split_at_mut(1 - middle % 2);
    if front.len() <= PIECE {
        vectorised(Ends { first: 0, middle, front, back, roots, factors });
    } else {
        let mut ends: Vec<_> = front.chunks_mut(PIECE).zip(back.rchunks_mut(PIECE)).collect();
        parallel::chunks(&mut ends, 1, |i, ends| {
            for (front, back) in ends {
                vectorised(Ends { first: i * PIECE, middle, front, back, roots, factors });
            }
        });
    }
    for z in between {
        let twice = *z + *z;
        *z = factors.map_or(z.conj(), |factors| twice.conj() * factors.at(middle / 2));
    }
}

/// The conjugate of what an even number `n` of real values have as the spectrum of half as many complex ones, from half of
/// the spectrum of the values: with `E_k = X̄_k + X_{M−k}` and `t_k = −i·e^{−2πik/n}·(X̄_k − X_{M−k})`, `M = n/2`, it is
/// `E_k + t_k` and its mirror `(E_k − t_k)*` (twice of it).
pub(super) fn fold<T: Real>(half: &[Complex<T>], roots: &Turns<T>, to: &mut [Complex<T>]) {
    vectorised(Fold { half, roots, to });
}

struct Fold<'a, T> {
    half: &'a [Complex<T>],
    roots: &'a Turns<T>,
    to: &'a mut [Complex<T>],
}

impl<T: Real> Loop for Fold<'_, T> {
    #[inline(always)]
    fn run(self) {
        match self.roots.table() {
            Some(roots) => self.with(roots),
            None => {
                let roots = self.roots.products();
                self.with(roots);
            }
        }
    }
}

impl<T: Real> Fold<'_, T> {
    #[inline(always)]
    fn with(self, roots: impl Factors<T>) {
        let Self { half, to, .. } = self;
        let middle = to.len();
        // no real signal has imaginary parts there
        let (first, last) = (half[0].re, half[middle].re);
        to[0] = Complex::new(first + last, last - first);
        let end = middle.div_ceil(2);
        let whole = end.saturating_sub(1) / BLOCK * BLOCK;
        for k in (1..=whole).step_by(BLOCK) {
            let mirror = middle - k + 1 - BLOCK;
            let (here, there) = (conjugate(&block(half, k)), reversed(&block(half, mirror)));
            let (even, odd) = (each(&here, &there, |a, b| a + b), each(&here, &there, |a, b| a - b));
            let odd = times(&odd, &roots.block(k));
            *block_mut(to, k) = each(&even, &odd, |a, b| a + b);
            *block_mut(to, mirror) = reversed(&each(&conjugate(&even), &conjugate(&odd), |a, b| a - b));
        }
        for k in 1 + whole..end {
            let (here, there) = (half[k].conj(), half[middle - k]);
            let (even, odd) = (here + there, (here - there) * roots.one(k));
            to[k] = even + odd;
            to[middle - k] = even.conj() - odd.conj();
        }
        if middle.is_multiple_of(2) {
            // the root is −1
            to[middle / 2] = half[middle / 2].scale(T::of(2.0));
        }
    }
}

/// The conjugates of numbers in their own places.
pub(super) struct Conjugated<'a, T>(pub(super) &'a mut [Complex<T>]);

impl<T: Real> Loop for Conjugated<'_, T> {
    #[inline(always)]
    fn run(self) {
        self.0.iter_mut().for_each(|z| z.im = -z.im);
    }
}

struct Ends<'a, T> {
    first: usize,
    middle: usize,
    front: &'a mut [Complex<T>],
    back: &'a mut [Complex<T>],
    roots: &'a Turns<T>,
    factors: Option<&'a Turns<T>>,
}

impl<T: Real> Loop for Ends<'_, T> {
    #[inline(always)]
    fn run(self) {
        let (roots, factors) = (self.roots, self.factors);
        match (roots.table(), factors.map(|factors| (factors.table(), factors))) {
            (Some(roots), None) => self.with(roots, Half),
            (Some(roots), Some((Some(factors), _))) => self.with(roots, factors),
            (_, None) => self.with(roots.products(), Half),
            (_, Some((_, factors))) => self.with(roots.products(), factors.products()),
        }
    }
}

impl<T: Real> Ends<'_, T> {
    #[inline(always)]
    fn with(self, roots: impl Factors<T>, factors: impl Factors<T>) {
        let Self { first, middle, front, back, .. } = self;
        let (count, last) = (front.len(), back.len() - 1);
        let whole = count / BLOCK * BLOCK;
        for i in (0..whole).step_by(BLOCK) {
            let (k, end) = (first + i, last - i + 1 - BLOCK);
            let (z, mirrored) = (block(front, i), conjugate(&reversed(&block(back, end))));
            let (even, odd) = (each(&z, &mirrored, |a, b| a + b), each(&z, &mirrored, |a, b| a - b));
            let odd = times(&odd, &roots.block(k));
            let up = each(&even, &odd, |a, b| a + b);
            let down = reversed(&each(&conjugate(&even), &conjugate(&odd), |a, b| a - b));
            *block_mut(front, i) = factors.times(&up, k);
            *block_mut(back, end) = factors.times(&down, middle - k + 1 - BLOCK);
        }
        for i in whole..count {
            let k = first + i;
            let (z, mirrored) = (front[i], back[last - i].conj());
            let (even, odd) = (z + mirrored, (z - mirrored) * roots.one(k));
            front[i] = factors.times_one(even + odd, k);
            back[last - i] = factors.times_one(even.conj() - odd.conj(), middle - k);
        }
    }
}

/// ½ for everybody.
struct Half;

impl<T: Real> Factors<T> for Half {
    #[inline(always)]
    fn block(&self, _: usize) -> Block<T> {
        std::array::from_fn(|i| if i % 2 == 0 { T::of(0.5) } else { T::zero() })
    }

    #[inline(always)]
    fn one(&self, _: usize) -> Complex<T> {
        T::of(0.5).into()
    }

    #[inline(always)]
    fn times(&self, z: &Block<T>, _: usize) -> Block<T> {
        z.map(|part| part * T::of(0.5))
    }

    #[inline(always)]
    fn times_one(&self, z: Complex<T>, _: usize) -> Complex<T> {
        z.scale(T::of(0.5))
    }
}
