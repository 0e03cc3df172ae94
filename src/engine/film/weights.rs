//! A kernel as polynomials between pixels.

use crate::engine::real::Real;
use crate::error::{Error, Result};
use std::f64::consts::PI;

/// The highest degree of the polynomials.
pub const MOST_DEGREE: usize = 23;

/// The values of an even kernel of radius `w/2` at `w` successive pixels around a place.
///
/// Pixel `j` of them is at `t = j + x − w/2` from the place, `0 ≤ x < 1`; its weight is a polynomial in `z = 2x − 1`. The
/// kernel being even, that of pixel `w − 1 − j` is the same at `−z`: so one even and one odd part serve two pixels.
#[derive(Debug, Clone)]
pub(super) struct Weights<T> {
    taps: usize,
    radius: f64,
    /// Of each pixel of the first half, coefficients of `z⁰, z², …` and of `z¹, z³, …`, the highest first.
    pairs: Vec<Vec<[T; 2]>>,
    error: f64,
}

impl<T: Real> Weights<T> {
    pub(super) fn new(radius: f64, kernel: impl Fn(f64) -> f64) -> Result<Self> {
        let taps = 2.0 * radius;
        if ![1.0, 2.0, 3.0, 4.0, 5.0, 6.0].contains(&taps) {
            let what = "a film of the engine with a kernel whose radius is not ½, 1, 1½, 2, 2½ or 3";
            return Err(Error::Unsupported(what));
        }
        let taps = taps as usize;
        let value = |tap: usize, z: f64| kernel(tap as f64 + 0.5 * (z + 1.0) - radius);
        // places between those that the polynomials go through, and near the ends, where they err most
        let places: Vec<f64> = (0..200).map(|i| -(PI * (f64::from(i) + 0.5) / 200.0).cos()).collect();
        let known: Vec<Vec<f64>> = (0..taps).map(|tap| places.iter().map(|z| value(tap, *z)).collect()).collect();
        let largest = known.iter().flatten().fold(0.0, |most: f64, v| most.max(v.abs()));
        let mut best: Option<Self> = None;
        for degree in (1..=MOST_DEGREE).step_by(2) {
            let pairs: Vec<_> = (0..taps.div_ceil(2)).map(|tap| pair(degree, |z| value(tap, z))).collect();
            let mut weights = Self { taps, radius, pairs, error: 0.0 };
            for (z, i) in places.iter().zip(0..) {
                for (tap, known) in known.iter().enumerate() {
                    let found = weights.of_tap(tap, T::of(*z)).to_f64().unwrap_or(f64::NAN);
                    let apart = (found - known[i]).abs() / largest;
                    if apart.is_nan() {
                        return Err(unsmooth());
                    }
                    weights.error = weights.error.max(apart);
                }
            }
            if best.as_ref().is_none_or(|b| weights.error < b.error) {
                best = Some(weights);
            }
            if best.as_ref().is_some_and(|b| b.error <= 16.0 * T::epsilon().to_f64().unwrap_or(0.0)) {
                break;
            }
        }
        match best {
            Some(weights) if weights.error <= 1e-3 => Ok(weights),
            _ => Err(unsmooth()),
        }
    }

    pub(super) fn taps(&self) -> usize {
        self.taps
    }

    pub(super) fn error(&self) -> f64 {
        self.error
    }

    /// The first pixel within reach of a place, `⌈at − ½ − radius⌉`, as a number.
    #[inline(always)]
    pub(super) fn first(&self, at: T) -> T {
        (at - T::of(0.5 + self.radius)).ceil()
    }

    /// How far the first pixel within reach is beyond where the reach begins: `0 ≤ x < 1`.
    #[inline(always)]
    pub(super) fn beyond(&self, first: T, at: T) -> T {
        first - (at - T::of(0.5 + self.radius))
    }

    fn of_tap(&self, tap: usize, z: T) -> T {
        let mirrored = self.taps - 1 - tap;
        let (pair, z) = if mirrored < tap { (mirrored, -z) } else { (tap, z) };
        let sum = |part: usize| self.pairs[pair].iter().fold(T::zero(), |sum, c| sum * (z * z) + c[part]);
        sum(0) + z * sum(1)
    }

    /// The weights of all pixels around `N` places: `places[i]` is from the first pixel within reach, `0 ≤ x < 1` as above.
    #[inline(always)]
    pub(super) fn of<const W: usize, const N: usize>(&self, places: &[T; N]) -> [[T; N]; W] {
        let z = places.map(|x| x + x - T::one());
        let squares = z.map(|z| z * z);
        let mut all = [[T::zero(); N]; W];
        for (tap, pair) in self.pairs.iter().enumerate() {
            let (mut even, mut odd) = ([T::zero(); N], [T::zero(); N]);
            for [e, o] in pair {
                for i in 0..N {
                    even[i] = even[i] * squares[i] + *e;
                    odd[i] = odd[i] * squares[i] + *o;
                }
            }
            for i in 0..N {
                let odd = z[i] * odd[i];
                all[W - 1 - tap][i] = even[i] - odd;
                all[tap][i] = even[i] + odd;
            }
        }
        all
    }
}

fn unsmooth() -> Error {
    Error::Unsupported("a film of the engine with a kernel that is not smooth between pixels")
}

/// The polynomial of an odd degree that goes through a function at Chebyshev's points, as coefficients of even and odd
/// powers, the highest first: his sums, and then the powers of his polynomials' recurrence.
fn pair<T: Real>(degree: usize, f: impl Fn(f64) -> f64) -> Vec<[T; 2]> {
    let n = degree + 1;
    let angle = |i: usize| PI * (i as f64 + 0.5) / n as f64;
    let values: Vec<f64> = (0..n).map(|i| f(angle(i).cos())).collect();
    let mut powers = vec![0.0; n];
    let (mut before, mut last) = (vec![0.0; n], vec![0.0; n]);
    last[0] = 1.0;
    for k in 0..n {
        let sum: f64 = values.iter().enumerate().map(|(i, v)| v * (k as f64 * angle(i)).cos()).sum();
        let scale = if k == 0 { 1.0 } else { 2.0 } / n as f64;
        powers.iter_mut().zip(&last).for_each(|(p, c)| *p += scale * sum * c);
        // T_{k+1} = 2z·T_k − T_{k−1}
        let factor = if k == 0 { 1.0 } else { 2.0 };
        let next = (0..n).map(|i| if i > 0 { factor * last[i - 1] } else { 0.0 } - before[i]).collect();
        before = std::mem::replace(&mut last, next);
    }
    powers.chunks(2).rev().map(|c| [T::of(c[0]), T::of(c[1])]).collect()
}
