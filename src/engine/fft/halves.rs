//! Real numbers as complex ones, and their spectra, of which symmetry repeats one half.

use crate::engine::fft::order::{Frequencies, PIECE};
use crate::engine::fft::roots::Turns;
use crate::engine::fft::rows::{Line, Numbers, Source, WIDTH};
use crate::engine::real::Real;
use crate::engine::simd::{Loop, vectorised};
use crate::parallel;
use num_complex::Complex;

/// An even number of real values as half as many complex ones, `z_j = x_{2j} + i·x_{2j+1}`: the same memory.
pub(super) fn packed<T: Real>(values: &[T]) -> Numbers<'_, T> {
    Numbers(bytemuck::cast_slice(values))
}

/// The conjugate of what [packed] values have as their spectrum, from half the spectrum of the values:
/// `X̄_k + X_{M−k} − i·e^{−2πik/n}·(X̄_k − X_{M−k})`, `M = n/2` (twice of it).
pub(super) struct Folded<'a, T> {
    pub(super) half: &'a [Complex<T>],
    /// `−i·e^{−2πik/n}`.
    pub(super) roots: &'a Turns<T>,
}

impl<T: Real> Source<T> for Folded<'_, T> {
    #[inline(always)]
    fn read(&self, at: usize, count: usize, line: &mut Line<T>) {
        let middle = self.half.len() - 1;
        let (mut here, mut there) = (Line::default(), Line::default());
        here.read(&self.half[at..at + count]);
        here.conjugate();
        there.read_down(&self.half[..=middle - at]);
        if at == 0 {
            // no real signal has imaginary parts there
            (here.im[0], there.im[0]) = (T::zero(), T::zero());
        }
        let roots = self.roots.line(at);
        for i in 0..WIDTH {
            let (re, im) = (here.re[i] - there.re[i], here.im[i] - there.im[i]);
            let odd_re = re * roots.re[i] - im * roots.im[i];
            let odd_im = re * roots.im[i] + im * roots.re[i];
            line.re[i] = here.re[i] + there.re[i] + odd_re;
            line.im[i] = here.im[i] + there.im[i] + odd_im;
        }
    }
}

/// Conjugated numbers in pairs: what [packed] numbers were.
pub(super) struct Unpacked<'a, T> {
    pub(super) frequencies: Frequencies<'a, T>,
    pub(super) first: usize,
    pub(super) out: &'a mut [T],
}

impl<T: Real> Loop for Unpacked<'_, T> {
    #[inline(always)]
    fn run(self) {
        let mut line = Line::default();
        for (i, piece) in self.out.chunks_mut(2 * WIDTH).enumerate() {
            self.frequencies.read(self.first / 2 + i * WIDTH, piece.len() / 2, &mut line);
            for (pair, (re, im)) in piece.chunks_exact_mut(2).zip(line.re.iter().zip(&line.im)) {
                (pair[0], pair[1]) = (*re, -*im);
            }
        }
    }
}

/// Real values with imaginary parts of zero.
pub(super) struct Zeroed<'a, T>(pub(super) &'a [T]);

impl<T: Real> Source<T> for Zeroed<'_, T> {
    #[inline(always)]
    fn read(&self, at: usize, count: usize, line: &mut Line<T>) {
        line.im = [T::zero(); WIDTH];
        for (re, x) in line.re.iter_mut().zip(&self.0[at..at + count]) {
            *re = *x;
        }
    }
}

/// The conjugate of a whole spectrum of `n` real values, from its half.
pub(super) struct Extended<'a, T> {
    pub(super) half: &'a [Complex<T>],
    pub(super) n: usize,
}

impl<T: Real> Source<T> for Extended<'_, T> {
    #[inline(always)]
    fn read(&self, at: usize, count: usize, line: &mut Line<T>) {
        for (i, (re, im)) in line.re.iter_mut().zip(&mut line.im).take(count).enumerate() {
            let k = at + i;
            let value = if k < self.half.len() { self.half[k].conj() } else { self.half[self.n - k] };
            (*re, *im) = (value.re, if k == 0 { T::zero() } else { value.im });
        }
    }
}

/// Real parts.
pub(super) struct Backwards<'a, T> {
    pub(super) frequencies: Frequencies<'a, T>,
    pub(super) first: usize,
    pub(super) out: &'a mut [T],
}

impl<T: Real> Loop for Backwards<'_, T> {
    #[inline(always)]
    fn run(self) {
        let mut line = Line::default();
        for (i, piece) in self.out.chunks_mut(WIDTH).enumerate() {
            self.frequencies.read(self.first + i * WIDTH, piece.len(), &mut line);
            piece.iter_mut().zip(&line.re).for_each(|(x, re)| *x = *re);
        }
    }
}

/// What [unfold](crate::engine::fft::standing::unfold) does, from frequencies that stand elsewhere.
#[derive(Clone, Copy)]
pub(super) struct Halves<'a, T> {
    pub(super) frequencies: Frequencies<'a, T>,
    /// `−i·e^{−2πik/n}`.
    pub(super) roots: &'a Turns<T>,
    /// A factor of each, with the ½ in it; of absolute value `|f(0)|` all.
    pub(super) factors: Option<&'a Turns<T>>,
}

impl<T: Real> Halves<'_, T> {
    /// Into `out`, from both ends.
    pub(super) fn to(self, out: &mut [Complex<T>]) {
        let middle = out.len() - 1;
        let (front, back) = out.split_at_mut(middle.div_ceil(2));
        let (between, back) = back.split_at_mut(1 - middle % 2);
        if front.len() <= PIECE {
            vectorised(Ends { halves: self, first: 0, front, back });
        } else {
            let mut ends: Vec<_> = front.chunks_mut(PIECE).zip(back.rchunks_mut(PIECE)).collect();
            parallel::chunks(&mut ends, 1, |i, ends| {
                for (front, back) in ends {
                    vectorised(Ends { halves: self, first: i * PIECE, front, back });
                }
            });
        }
        for value in between {
            let z = self.frequencies.at(middle / 2).conj();
            *value = self.factors.map_or(z, |factors| (z + z) * factors.at(middle / 2));
        }
    }
}

struct Ends<'a, T> {
    halves: Halves<'a, T>,
    first: usize,
    front: &'a mut [Complex<T>],
    back: &'a mut [Complex<T>],
}

impl<T: Real> Loop for Ends<'_, T> {
    #[inline(always)]
    fn run(self) {
        let Halves { frequencies, roots, factors } = self.halves;
        let middle = frequencies.len();
        let half = T::of(0.5);
        // f(M − k) = f(M)·f̄(k)/|f(0)|
        let end = factors.map(|factors| factors.at(middle).conj().unscale(factors.gain()));
        let (mut here, mut there, mut up, mut down) =
            (Line::default(), Line::default(), Line::default(), Line::default());
        for (i, (front, back)) in self.front.chunks_mut(WIDTH).zip(self.back.rchunks_mut(WIDTH)).enumerate() {
            let k = self.first + i * WIDTH;
            frequencies.read(k, front.len(), &mut here);
            frequencies.read_down(middle - k, front.len(), &mut there);
            let roots = roots.line(k);
            for i in 0..WIDTH {
                let (even_re, even_im) = (here.re[i] + there.re[i], here.im[i] - there.im[i]);
                let (re, im) = (here.re[i] - there.re[i], here.im[i] + there.im[i]);
                let odd_re = re * roots.re[i] - im * roots.im[i];
                let odd_im = im * roots.re[i] + re * roots.im[i];
                (up.re[i], up.im[i]) = (even_re + odd_re, even_im + odd_im);
                (down.re[i], down.im[i]) = (even_re - odd_re, odd_im - even_im);
            }
            match (factors, end) {
                (Some(factors), Some(end)) => {
                    let factors = factors.line(k);
                    up.times(&factors);
                    down.conjugate();
                    down.times(&factors);
                    down = down.turned(end);
                    down.conjugate();
                }
                _ => {
                    for i in 0..WIDTH {
                        (up.re[i], up.im[i]) = (up.re[i] * half, up.im[i] * half);
                        (down.re[i], down.im[i]) = (down.re[i] * half, down.im[i] * half);
                    }
                }
            }
            up.write(front);
            down.write_down(back);
        }
    }
}
