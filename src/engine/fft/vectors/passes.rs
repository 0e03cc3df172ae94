//! A transform in passes.

use crate::engine::fft::roots::{root, rounded};
use crate::engine::fft::vectors::aligned::Aligned;
use crate::engine::fft::vectors::number::{Block, Number};
use crate::engine::fft::vectors::points::{Few, Points};
use crate::engine::fft::vectors::streams::{Input, Output};
use crate::engine::real::Real;
use crate::engine::simd::{LANES, Simd, Task, Wide, turned, unrolled, with_vectors};
use num_complex::Complex;

/// Points of the first transforms: as many as the widest vector holds.
const FIRST: usize = LANES;

const ROOTS: &str = "a pass has as many roots as points";

/// `X_k = Σ_j x_j e^{−2πijk/n}` in passes that read one array from front to back and write another (Stockham; Van Loan
/// 1992, section 1.7): a pass with `s` numbers side by side takes those at `q + s(p + mj)` to `q + s(rp + k)` by a transform
/// of `r` points over `j` and factors `e^{−2πipk/rm}`. The first, with nothing side by side, takes `p` as vectors and turns
/// squares of them; the last has no factors of its own.
#[derive(Debug)]
pub(in crate::engine::fft) struct Passes<T> {
    n: usize,
    roots: [Complex<T>; FIRST],
    /// The factors of the first pass: those of a block of `p` for each `k` in turn, of `k` from one on.
    first: Aligned<T>,
    middle: Vec<Pass<T>>,
    last: Pass<T>,
}

#[derive(Debug)]
struct Pass<T> {
    radix: usize,
    /// How many numbers are side by side.
    side: usize,
    /// `e^{−2πik/r}`.
    roots: Vec<Complex<T>>,
    /// The factors for each `p`, of `k` from one on; of the last pass those of all `k`, if there are any.
    turns: Vec<Complex<T>>,
}

impl<T: Real> Pass<T> {
    fn new(radix: usize, side: usize, n: usize, unit: impl Fn(i64) -> Complex<f64>) -> Self {
        let (len, mut turns) = (n / side, Vec::new());
        let units: Vec<_> = (0..radix).map(|k| unit((side * k) as i64)).collect();
        for p in 0..len / radix {
            turns.extend((1..radix).map(|k| rounded(root(p * k, len) * units[k])));
        }
        Self { radix, side, roots: (0..radix).map(|k| rounded(root(k, radix))).collect(), turns }
    }
}

impl<T: Real> Passes<T> {
    /// For `n` numbers, if that is a multiple of 256 above it that has no prime factors but 2, 3, 5 and 7.
    pub(in crate::engine::fft) fn new(n: usize) -> Option<Self> {
        let mut passes = Self::with(n, 1.0, |_| 1.0.into())?;
        passes.last.turns.clear();
        Some(passes)
    }

    /// The same times `gain·unit(k)` for `−n/2 ≤ k < n/2`, which must obey `unit(j + k) = unit(j)·unit(k)`: frequency `k`
    /// is a sum of digits, one from each pass, and so the factors of units are factors of those of the passes. Only the
    /// last, which had none, has one more product for every number.
    pub(in crate::engine::fft) fn with(n: usize, gain: f64, unit: impl Fn(i64) -> Complex<f64>) -> Option<Self> {
        let radices = radices(n)?;
        let units: [_; FIRST] = std::array::from_fn(|k| unit(k as i64));
        let len = n / FIRST;
        let mut first = Vec::with_capacity(2 * n);
        for p in (0..len).step_by(FIRST) {
            for (k, unit) in units.iter().enumerate().skip(1) {
                let line: [Complex<T>; FIRST] = std::array::from_fn(|i| rounded(root((p + i) * k, n) * unit));
                first.extend(line.iter().map(|z| z.re).chain(line.iter().map(|z| z.im)));
            }
        }
        let (mut side, mut middle) = (FIRST, Vec::new());
        for radix in radices {
            middle.push(Pass::new(radix, side, n, &unit));
            side *= radix;
        }
        let mut last = middle.pop()?;
        let signed = |k: usize| if 2 * k < n { k as i64 } else { k as i64 - n as i64 };
        last.turns = (0..last.radix).map(|k| rounded(unit(signed(last.side * k)) * gain)).collect();
        let roots = std::array::from_fn(|k| rounded(root(k, FIRST)));
        Some(Self { n, roots, first: Aligned::new(first), middle, last })
    }

    /// How many numbers.
    pub(in crate::engine::fft) fn len(&self) -> usize {
        self.n
    }

    /// How much room they need.
    pub(in crate::engine::fft) fn room(&self) -> usize {
        2 * self.n
    }

    /// The transform.
    pub(in crate::engine::fft) fn run(&self, input: impl Input<T>, output: impl Output<T>, room: &mut [Complex<T>]) {
        self.begin(input, room);
        self.end(output, room);
    }

    /// All of it that reads `input`.
    pub(in crate::engine::fft) fn begin(&self, input: impl Input<T>, room: &mut [Complex<T>]) {
        let [here, there] = self.halves(room);
        with_vectors(Begin { passes: self, input, here, there });
    }

    /// The rest of it, to `output`.
    pub(in crate::engine::fft) fn end(&self, output: impl Output<T>, room: &mut [Complex<T>]) {
        let from: &[Block<T>] = self.halves(room)[self.middle.len() % 2];
        with_vectors(End { pass: &self.last, from, output });
    }

    /// Two arrays between which the passes go.
    fn halves<'a>(&self, room: &'a mut [Complex<T>]) -> [&'a mut [Block<T>]; 2] {
        let (here, there) = room[..self.room()].split_at_mut(self.n);
        [bytemuck::cast_slice_mut(here), bytemuck::cast_slice_mut(there)]
    }
}

/// The radices after the first: odd ones, a four or a sixteen where eights alone do not do, eights.
fn radices(n: usize) -> Option<Vec<usize>> {
    if n <= FIRST * FIRST || !n.is_multiple_of(FIRST * FIRST) {
        return None;
    }
    let twos = n.trailing_zeros() as usize;
    let (mut rest, mut radices) = (n >> twos, Vec::new());
    for odd in [7, 5, 3] {
        while rest.is_multiple_of(odd) {
            rest /= odd;
            radices.push(odd);
        }
    }
    let twos = twos - FIRST.ilog2() as usize;
    let eights = match twos % 3 {
        0 => twos / 3,
        1 => {
            radices.push(16);
            (twos - 4) / 3
        }
        _ => {
            radices.push(4);
            twos / 3
        }
    };
    radices.resize(radices.len() + eights, 8);
    (rest == 1).then_some(radices)
}

struct Begin<'a, T, I> {
    passes: &'a Passes<T>,
    input: I,
    here: &'a mut [Block<T>],
    there: &'a mut [Block<T>],
}

impl<T: Real, I: Input<T>> Task for Begin<'_, T, I> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let Self { passes, input, mut here, mut there } = self;
        passes.first(simd, &input, here);
        for pass in &passes.middle {
            match pass.radix {
                3 => pass.middle::<S, 3>(simd, here, there),
                4 => pass.middle::<S, 4>(simd, here, there),
                5 => pass.middle::<S, 5>(simd, here, there),
                7 => pass.middle::<S, 7>(simd, here, there),
                8 => pass.middle::<S, 8>(simd, here, there),
                _ => pass.middle::<S, 16>(simd, here, there),
            }
            (here, there) = (there, here);
        }
    }
}

struct End<'a, T, O> {
    pass: &'a Pass<T>,
    from: &'a [Block<T>],
    output: O,
}

impl<T: Real, O: Output<T>> Task for End<'_, T, O> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let Self { pass, from, mut output } = self;
        match (pass.radix, pass.turns.is_empty()) {
            (8, true) => pass.last::<S, 8, false>(simd, from, &mut output),
            (8, false) => pass.last::<S, 8, true>(simd, from, &mut output),
            (_, true) => pass.last::<S, 16, false>(simd, from, &mut output),
            (_, false) => pass.last::<S, 16, true>(simd, from, &mut output),
        }
    }
}

impl<T: Real> Passes<T> {
    #[inline(always)]
    fn first<S: Simd>(&self, simd: S, input: &impl Input<T>, to: &mut [Block<T>]) {
        match Wide::<T, S>::COUNT {
            16 => self.first_by::<S, 16>(simd, input, to),
            8 => self.first_by::<S, 8>(simd, input, to),
            4 => self.first_by::<S, 4>(simd, input, to),
            2 => self.first_by::<S, 2>(simd, input, to),
            _ => self.first_by::<S, 1>(simd, input, to),
        }
    }

    /// With vectors of `N`.
    #[inline(always)]
    fn first_by<S: Simd, const N: usize>(&self, simd: S, input: &impl Input<T>, to: &mut [Block<T>]) {
        let len = self.n / FIRST;
        let turns: &[Block<T>] = bytemuck::cast_slice(&self.first);
        for (line, (to, turns)) in to.chunks_exact_mut(FIRST).zip(turns.chunks_exact(FIRST - 1)).enumerate() {
            for part in (0..FIRST).step_by(N) {
                let mut z = [Number::splat(simd, Complex::default()); FIRST];
                unrolled!(j < FIRST, z[j] = input.read(simd, FIRST * line + part + j * len));
                z = Few::transform(simd, &self.roots, z);
                unrolled!(i < FIRST - 1, z[i + 1] = z[i + 1].times(Number::part(simd, &turns[i], part)));
                unrolled!(group < FIRST / N, {
                    let k = N * group;
                    let (mut re, mut im) = ([z[0].re; N], [z[0].im; N]);
                    unrolled!(i < N, (re[i], im[i]) = (z[k + i].re, z[k + i].im));
                    (re, im) = (turned(re), turned(im));
                    unrolled!(i < N, Number { re: re[i], im: im[i] }.to_part(&mut to[part + i], k));
                });
            }
        }
    }
}

impl<T: Real> Pass<T> {
    #[inline(always)]
    fn middle<S: Simd, const R: usize>(&self, simd: S, from: &[Block<T>], to: &mut [Block<T>])
    where
        Few: Points<R>,
    {
        let side = self.side / LANES;
        let len = from.len() / (R * side);
        let roots: &[Complex<T>; R] = self.roots.as_slice().try_into().expect(ROOTS);
        let turns = self.turns.chunks_exact(R - 1);
        for (p, (to, turns)) in to.chunks_exact_mut(R * side).zip(turns).enumerate() {
            let mut rows = [&from[..0]; R];
            unrolled!(j < R, rows[j] = &from[side * (p + len * j)..][..side]);
            for q in 0..side {
                for part in (0..LANES).step_by(Wide::<T, S>::COUNT) {
                    let mut z = [Number::splat(simd, roots[0]); R];
                    unrolled!(j < R, z[j] = Number::part(simd, &rows[j][q], part));
                    z = Few::transform(simd, roots, z);
                    z[0].to_part(&mut to[q], part);
                    unrolled!(k < R - 1, {
                        z[k + 1].times(Number::splat(simd, turns[k])).to_part(&mut to[q + side * (k + 1)], part);
                    });
                }
            }
        }
    }

    #[inline(always)]
    fn last<S: Simd, const R: usize, const TURNED: bool>(&self, simd: S, from: &[Block<T>], output: &mut impl Output<T>)
    where
        Few: Points<R>,
    {
        let side = self.side / LANES;
        let roots: &[Complex<T>; R] = self.roots.as_slice().try_into().expect(ROOTS);
        let mut rows = [&from[..0]; R];
        unrolled!(j < R, rows[j] = &from[side * j..][..side]);
        #[expect(clippy::needless_range_loop, reason = "place q of every row")]
        for q in 0..side {
            for part in (0..LANES).step_by(Wide::<T, S>::COUNT) {
                let mut z = [Number::splat(simd, roots[0]); R];
                unrolled!(j < R, z[j] = Number::part(simd, &rows[j][q], part));
                z = Few::transform(simd, roots, z);
                unrolled!(k < R, {
                    let z = if TURNED { z[k].times(Number::splat(simd, self.turns[k])) } else { z[k] };
                    output.write(simd, LANES * (q + side * k) + part, z);
                });
            }
        }
    }
}
