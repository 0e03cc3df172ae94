//! The power spectrum of points.

use crate::engine::nonuniform::PlaneNufft;
use crate::error::{Error, Result};
use crate::num::random::bits;
use crate::num::{cos_pi, sin_pi};
use crate::pattern::Pattern;
use crate::pattern::measure::in_cube;
use ndarray::Array2;

/// `P(u, v) = (1/N)|Σ_j e^{−2πi(u x_j + v y_j)}|²` at the integer frequencies `|u|, |v| ≤ reach`, of one set of points or
/// averaged over many.
///
/// Integer frequencies are those at which the unit square, seen as a torus, does not leak. `P(0, 0) = N`; independent
/// points have the mean 1 everywhere else, and one pattern's value is about exponentially distributed around its
/// expectation, so that the mean over `R` patterns deviates by `P/√R`. `P(−u, −v) = P(u, v)`.
///
/// Up to 2²⁴ products `N·(reach + 1)²` they are summed, each for four frequencies: exponentials are separable, and their
/// powers come by recurrence. Rounding: each power is off by `2ε·reach`, so `P` by `8ε·reach·√(N·P)` and less. Beyond, in
/// `O(N + reach² log reach)`, by the [non-uniform transform](PlaneNufft) with an error of at most `10⁻¹²N` of the sum, so
/// of `2·10⁻¹²N·√(P/N)` of `P` and, where `P` vanishes, of `10⁻²⁴N`.
///
/// ```
/// use nyquist::prelude::*;
/// // a regular grid: N at the multiples of 8, nothing elsewhere
/// let lines = Periodogram::of(&Regular::new([8, 8])?.points(0), 16)?;
/// assert!((lines.at(8, -16) - 64.0).abs() < 1e-11 && lines.at(3, 8) < 1e-11);
/// // jitter: the lines are gone, and the floor is 1 − sinc²(u/8)·sinc²(v/8)
/// let floor = Periodogram::mean(&Jittered::<2>::new([8, 8])?, 1, 2000, 16)?;
/// assert!((floor.at(4, 0) - 0.5947).abs() < 4.0 * 0.5947 / 2000f64.sqrt());
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Periodogram {
    reach: usize,
    patterns: u32,
    points: f64,
    power: Array2<f64>,
}

/// The largest reach: four million frequencies.
pub const MOST_REACH: usize = 1024;

impl Periodogram {
    /// Of one set of points in the unit square.
    ///
    /// # Errors
    /// No points, points outside the square, or a reach beyond [`MOST_REACH`].
    pub fn of(points: &[[f64; 2]], reach: usize) -> Result<Self> {
        in_cube(points)?;
        Self::sum([points], reachable(reach)?)
    }

    /// The mean over `patterns` patterns, whose seeds are made of `seed` and their number.
    ///
    /// # Errors
    /// No patterns, or a reach beyond [`MOST_REACH`].
    pub fn mean(pattern: &dyn Pattern<2>, seed: u64, patterns: u32, reach: usize) -> Result<Self> {
        Self::sum((0..patterns).map(|p| pattern.points(pattern_seed(seed, p))), reachable(reach)?)
    }

    fn sum<P: AsRef<[[f64; 2]]>>(sets: impl IntoIterator<Item = P>, reach: usize) -> Result<Self> {
        let side = 2 * reach + 1;
        let (mut power, mut patterns, mut total) = (Array2::zeros([side, side]), 0, 0.0);
        let mut fast = None;
        for points in sets {
            let points = points.as_ref();
            if points.len().saturating_mul((reach + 1).pow(2)) <= SHORT {
                add_power(points, reach, &mut power);
            } else {
                fast.get_or_insert_with(|| Fast::new(reach)).add_power(points, &mut power);
            }
            patterns += 1;
            total += points.len() as f64;
        }
        if patterns == 0 {
            return Err(Error::TooFew { what: "patterns to average", least: 1, got: 0 });
        }
        power.mapv_inplace(|p| p / f64::from(patterns));
        Ok(Self { reach, patterns, points: total / f64::from(patterns), power })
    }

    /// The largest frequency along each axis.
    pub fn reach(&self) -> usize {
        self.reach
    }

    /// How many patterns this is the mean of.
    pub fn patterns(&self) -> u32 {
        self.patterns
    }

    /// The number of points `N`, its mean where patterns differ.
    pub fn points(&self) -> f64 {
        self.points
    }

    /// The power at frequency `(u, v)`; beyond the reach, `NaN`.
    pub fn at(&self, u: i64, v: i64) -> f64 {
        let [column, row] = [u, v].map(|f| usize::try_from(f + self.reach as i64).unwrap_or(usize::MAX));
        self.power.get([row, column]).copied().unwrap_or(f64::NAN)
    }

    /// All of it, `[[v + reach, u + reach]]`: zero frequency in the middle.
    pub fn power(&self) -> &Array2<f64> {
        &self.power
    }

    /// Frequencies and powers of one half of the plane, without zero: those that are independent.
    pub fn half(&self) -> impl Iterator<Item = ([i64; 2], f64)> + '_ {
        let reach = self.reach as i64;
        let rows = (0..=reach).flat_map(move |v| (-reach..=reach).map(move |u| [u, v]));
        rows.filter(|&[u, v]| v > 0 || u > 0).map(|[u, v]| ([u, v], self.at(u, v)))
    }
}

/// The seed of one of many patterns.
pub fn pattern_seed(seed: u64, pattern: u32) -> u64 {
    bits(seed, pattern.into(), u32::MAX)
}

fn reachable(reach: usize) -> Result<usize> {
    if reach <= MOST_REACH {
        return Ok(reach);
    }
    let what = "the reach of a periodogram";
    Err(Error::Overflow { what, value: reach as f64, most: MOST_REACH as f64 })
}

/// The most products that are summed.
const SHORT: usize = 1 << 24;

/// The fast way, kept from one pattern to the next.
struct Fast {
    nufft: PlaneNufft<f64>,
    power: Vec<f64>,
}

impl Fast {
    fn new(reach: usize) -> Self {
        let nufft = PlaneNufft::new([reach; 2], [1; 2], 1e-12).expect("a reach of at most 1024 is a degree");
        Self { power: vec![0.0; nufft.modes()], nufft }
    }

    /// Adds `|Σ e^{−2πi(ux + vy)}|²/N`.
    fn add_power(&mut self, points: &[[f64; 2]], power: &mut Array2<f64>) {
        let Ok(placed) = self.nufft.place(points) else {
            return add_power(points, self.nufft.degrees()[0], power); // points that are not finite: NaN
        };
        let found = self.nufft.power_into(&placed, &vec![1.0; points.len()], &mut self.power);
        found.expect("a weight for each point, and room");
        let (reach, gain) = (self.nufft.degrees()[0], 1.0 / points.len() as f64);
        for (u, column) in self.power.chunks_exact(2 * reach + 1).enumerate() {
            for k in 0..column.len() {
                // of the first column both halves are there, and need not agree to the last bit
                let p = column[if u == 0 { k.max(2 * reach - k) } else { k }] * gain;
                power[[k, reach + u]] += p;
                if u > 0 {
                    power[[2 * reach - k, reach - u]] += p;
                }
            }
        }
    }
}

/// How many points are taken together, so that the table of sums is read and written once for all of them.
const BATCH: usize = 8;

/// Adds `|Σ e^{−2πi(ux + vy)}|²/N`.
///
/// With `c + is = e^{2πiux}` and `d + it = e^{2πivy}` the four sums of `cd`, `st`, `ct`, `sd` give both `(u, v)` and
/// `(u, −v)`, and the other half of the plane by symmetry: a product of two real matrices.
fn add_power(points: &[[f64; 2]], reach: usize, power: &mut Array2<f64>) {
    let width = 2 * (reach + 1);
    let mut table = vec![0.0; width * width];
    let mut waves = [vec![[0.0; BATCH]; width], vec![[0.0; BATCH]; width]];
    let mut columns = vec![0.0; BATCH * width];
    for batch in points.chunks(BATCH) {
        for (axis, waves) in waves.iter_mut().enumerate() {
            waves.fill([0.0; BATCH]); // a last batch that is not full adds nothing
            for (b, point) in batch.iter().enumerate() {
                let (c, s) = (cos_pi(2.0 * point[axis]), sin_pi(2.0 * point[axis]));
                let (mut cosine, mut sine) = (1.0, 0.0);
                for pair in waves.chunks_exact_mut(2) {
                    (pair[0][b], pair[1][b]) = (cosine, sine);
                    (cosine, sine) = (cosine * c - sine * s, sine * c + cosine * s);
                }
            }
        }
        for (j, wave) in waves[1].iter().enumerate() {
            (0..BATCH).for_each(|b| columns[b * width + j] = wave[b]);
        }
        for (wave, sums) in waves[0].iter().zip(table.chunks_exact_mut(width)) {
            accumulate(wave, &columns, sums);
        }
    }
    let gain = 1.0 / points.len().max(1) as f64;
    let at = |u: usize, v: usize| table[u * width + v];
    for u in 0..=reach {
        for v in 0..=reach {
            let [cd, ct, sd, st] = [(0, 0), (0, 1), (1, 0), (1, 1)].map(|(a, b)| at(2 * u + a, 2 * v + b));
            let same = ((cd - st).powi(2) + (sd + ct).powi(2)) * gain;
            let opposite = ((cd + st).powi(2) + (sd - ct).powi(2)) * gain;
            let mut add = |u: usize, v: usize, p: f64| power[[v, u]] += p;
            add(reach + u, reach + v, same);
            if u > 0 {
                add(reach - u, reach + v, opposite);
            }
            if v > 0 {
                add(reach + u, reach - v, opposite);
            }
            if u > 0 && v > 0 {
                add(reach - u, reach - v, same);
            }
        }
    }
}

/// `sums_j += Σ_b wave_b·columns_{b,j}`, four of the batch at a time.
fn accumulate(wave: &[f64; BATCH], columns: &[f64], sums: &mut [f64]) {
    let width = sums.len();
    for (w, rows) in wave.chunks_exact(4).zip(columns.chunks_exact(4 * width)) {
        let (r0, rest) = rows.split_at(width);
        let (r1, rest) = rest.split_at(width);
        let (r2, r3) = rest.split_at(width);
        for ((((sum, a), b), c), d) in sums.iter_mut().zip(r0).zip(r1).zip(r2).zip(r3) {
            *sum += (w[0] * a + w[1] * b) + (w[2] * c + w[3] * d);
        }
    }
}
