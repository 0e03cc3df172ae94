//! Roots of unity, and tables of turns.

use crate::engine::fft::block::{BLOCK, Block, block, times};
use crate::engine::fft::rows::{Line, WIDTH};
use crate::engine::real::Real;
use crate::num::{cos_pi, sin_pi};
use num_complex::Complex;

/// `e^{−2πik/n}`, right to about one rounding: the angle is folded into the first octant as a ratio of integers.
pub(super) fn root(k: usize, n: usize) -> Complex<f64> {
    let (n, eighths) = (n as u64, 8 * (k % n) as u64);
    let (octant, rest) = (eighths / n, eighths % n);
    let part = if octant.is_multiple_of(2) { rest } else { n - rest };
    let turns = 0.25 * (part as f64 / n as f64);
    let (c, s) = (cos_pi(turns), sin_pi(turns));
    let (re, im) = match octant {
        0 => (c, s),
        1 => (s, c),
        2 => (-s, c),
        3 => (-c, s),
        4 => (-c, -s),
        5 => (-s, -c),
        6 => (s, -c),
        _ => (c, -s),
    };
    Complex::new(re, -im)
}

/// The nearest number in `T`.
pub(super) fn rounded<T: Real>(z: Complex<f64>) -> Complex<T> {
    Complex::new(T::of(z.re), T::of(z.im))
}

/// Up to so many numbers, turns stand in a table: more would take the room in the nearest cache that the numbers need.
const TABLE: usize = 1 << 14;

/// Factors of numbers in a row.
pub(super) trait Factors<T: Real> {
    /// Those of the numbers from `k` on.
    fn block(&self, k: usize) -> Block<T>;

    /// That of number `k`.
    fn one(&self, k: usize) -> Complex<T>;

    /// The numbers from `k` on, times theirs.
    #[inline(always)]
    fn times(&self, z: &Block<T>, k: usize) -> Block<T> {
        times(z, &self.block(k))
    }

    /// Number `k` times its own.
    #[inline(always)]
    fn times_one(&self, z: Complex<T>, k: usize) -> Complex<T> {
        z * self.one(k)
    }
}

/// Factors in a table.
impl<T: Real> Factors<T> for &[Complex<T>] {
    #[inline(always)]
    fn block(&self, k: usize) -> Block<T> {
        block(self, k)
    }

    #[inline(always)]
    fn one(&self, k: usize) -> Complex<T> {
        self[k]
    }
}

/// [Turns] as products.
pub(super) struct Products<'a, T>(&'a Turns<T>);

impl<T: Real> Factors<T> for Products<'_, T> {
    /// A block may reach behind its line, where the near ones go on.
    #[inline(always)]
    fn block(&self, k: usize) -> Block<T> {
        let far = self.0.far(k / WIDTH);
        let far = std::array::from_fn(|i| if i % 2 == 0 { far.re } else { far.im });
        times(&block(&self.0.near_on, k % WIDTH), &far)
    }

    #[inline(always)]
    fn one(&self, k: usize) -> Complex<T> {
        self.0.at(k)
    }
}

/// `f(k) = gain·unit(k)` for `0 ≤ k < n`, where `unit(j + k) = unit(j)·unit(k)`: a line of near ones times a product of two
/// from short tables, instead of a sine and a cosine for each; all of them in a table, if they are few.
///
/// Every entry is rounded, by at most `ε`, and every product by at most `√2·ε` (Higham 2002, lemma 3.5): the result is
/// within `4ε + 3·√2·ε < 9ε` of `f(k)`, relatively.
#[derive(Debug)]
pub(super) struct Turns<T> {
    gain: T,
    near: Line<T>,
    /// The same in turn, and as many behind them as a block can reach.
    near_on: [Complex<T>; WIDTH + BLOCK],
    low: Vec<Complex<T>>,
    high: Vec<Complex<T>>,
    all: Vec<Complex<T>>,
}

impl<T: Real> Turns<T> {
    pub(super) fn new(n: usize, gain: Complex<f64>, unit: impl Fn(usize) -> Complex<f64>) -> Self {
        let lines = n.div_ceil(WIDTH).max(1);
        let low = 1usize << lines.ilog2().div_ceil(2);
        let mut turns = Self {
            gain: T::of(gain.norm()),
            near: Line::from_fn(|k| rounded(unit(k))),
            near_on: std::array::from_fn(|k| rounded(unit(k))),
            low: (0..low).map(|j| rounded(unit(j * WIDTH))).collect(),
            high: (0..lines.div_ceil(low)).map(|j| rounded(gain * unit(j * low * WIDTH))).collect(),
            all: Vec::new(),
        };
        if n <= TABLE {
            turns.all = (0..n).map(|k| turns.at(k)).collect();
        }
        turns
    }

    /// The first `count` of `e^{−2πik/n}`.
    pub(super) fn roots(n: usize, count: usize) -> Self {
        Self::new(count, Complex::new(1.0, 0.0), |k| root(k, n))
    }

    /// The first `count` of `−i·e^{−2πik/n}`.
    pub(super) fn roots_a_quarter_back(n: usize, count: usize) -> Self {
        Self::new(count, Complex::new(0.0, -1.0), |k| root(k, n))
    }

    /// `|f(k)|`.
    #[inline(always)]
    pub(super) fn gain(&self) -> T {
        self.gain
    }

    #[inline(always)]
    fn far(&self, line: usize) -> Complex<T> {
        let low = self.low.len();
        self.high[line / low] * self.low[line & (low - 1)]
    }

    /// All of them, if there is a table.
    #[inline(always)]
    pub(super) fn table(&self) -> Option<&[Complex<T>]> {
        if self.all.is_empty() { None } else { Some(&self.all) }
    }

    /// All of them as products.
    #[inline(always)]
    pub(super) fn products(&self) -> Products<'_, T> {
        Products(self)
    }

    /// `f(k), f(k + 1), …`
    #[inline(always)]
    pub(super) fn line(&self, k: usize) -> Line<T> {
        self.near.turned(self.at(k))
    }

    /// `f(k)`.
    #[inline(always)]
    pub(super) fn at(&self, k: usize) -> Complex<T> {
        match k % WIDTH {
            0 => self.far(k / WIDTH),
            i => self.far(k / WIDTH) * Complex::new(self.near.re[i], self.near.im[i]),
        }
    }
}
