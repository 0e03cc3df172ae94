//! Integrals by adaptive Gauss–Kronrod quadrature: the oracle that closed forms are held against.

use num_complex::Complex;
use std::ops::{Add, Mul, Sub};

/// What can be integrated: real and complex numbers.
pub trait Value: Copy + Add<Output = Self> + Sub<Output = Self> + Mul<f64, Output = Self> {
    /// Nothing.
    const ZERO: Self;
    /// The absolute value.
    fn size(self) -> f64;
}

impl Value for f64 {
    const ZERO: Self = 0.0;
    fn size(self) -> f64 {
        self.abs()
    }
}

impl Value for Complex<f64> {
    const ZERO: Self = Self { re: 0.0, im: 0.0 };
    fn size(self) -> f64 {
        self.norm()
    }
}

/// An integral and an estimate of its error.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Integral<V = f64> {
    /// The integral.
    pub value: V,
    /// The sum over all pieces of the difference between the 15-point Kronrod and the 7-point Gauss rule, plus the
    /// rounding `16ε·∫|f|`. For smooth integrands the true error is far below it.
    pub error: f64,
}

// Kronrod's 15 nodes on [0, 1] (the rule is symmetric) and weights, and Gauss's 7 weights at every second node
// (Kronrod 1965; Piessens et al., QUADPACK, 1983, routine QK15).
const NODES: [f64; 8] = [
    0.991_455_371_120_812_6,
    0.949_107_912_342_758_5,
    0.864_864_423_359_769_1,
    0.741_531_185_599_394_4,
    0.586_087_235_467_691_1,
    0.405_845_151_377_397_2,
    0.207_784_955_007_898_47,
    0.0,
];
const KRONROD: [f64; 8] = [
    0.022_935_322_010_529_224,
    0.063_092_092_629_978_55,
    0.104_790_010_322_250_18,
    0.140_653_259_715_525_92,
    0.169_004_726_639_267_9,
    0.190_350_578_064_785_4,
    0.204_432_940_075_298_9,
    0.209_482_141_084_727_82,
];
const GAUSS: [f64; 4] =
    [0.129_484_966_168_869_7, 0.279_705_391_489_276_64, 0.381_830_050_505_118_9, 0.417_959_183_673_469_4];

/// More pieces than this are never made: an integrand that asks for them is not smooth between the given breaks.
const MOST_PIECES: usize = 4096;

#[derive(Clone, Copy)]
struct Piece<V> {
    a: f64,
    b: f64,
    value: V,
    error: f64,
    size: f64,
}

fn piece<V: Value>(f: &impl Fn(f64) -> V, a: f64, b: f64) -> Piece<V> {
    let (middle, half) = (0.5 * (a + b), 0.5 * (b - a));
    let center = f(middle);
    let (mut kronrod, mut gauss, mut size) = (center * KRONROD[7], center * GAUSS[3], center.size() * KRONROD[7]);
    for i in 0..7 {
        let (left, right) = (f(middle - half * NODES[i]), f(middle + half * NODES[i]));
        kronrod = kronrod + (left + right) * KRONROD[i];
        size += (left.size() + right.size()) * KRONROD[i];
        if i % 2 == 1 {
            gauss = gauss + (left + right) * GAUSS[i / 2];
        }
    }
    let error = (kronrod - gauss).size() * half.abs();
    Piece { a, b, value: kronrod * half, error, size: size * half.abs() }
}

/// `∫_a^b f(x) dx` to an absolute error of about `tolerance`, or as near as rounding and 4096 pieces allow; the
/// estimate is returned beside the value.
///
/// The interval is halved where the error is largest. `f` must be smooth on it; put jumps and kinks into
/// [`integrate_pieces`].
///
/// ```
/// use nyquist::num::quadrature::integrate;
/// let gaussian = integrate(|x| (-std::f64::consts::PI * x * x).exp(), -7.0, 7.0, 1e-14);
/// assert!((gaussian.value - 1.0).abs() <= gaussian.error);
/// ```
pub fn integrate<V: Value>(f: impl Fn(f64) -> V, a: f64, b: f64, tolerance: f64) -> Integral<V> {
    integrate_pieces(f, &[a, b], tolerance)
}

/// `∫ f(x) dx` from the first to the last of the rising `breaks`, where `f` is smooth between each two.
///
/// ```
/// use nyquist::num::quadrature::integrate_pieces;
/// let tent = integrate_pieces(|x: f64| (1.0 - x.abs()).max(0.0), &[-1.0, 0.0, 1.0], 1e-15);
/// assert!((tent.value - 1.0).abs() < 1e-15);
/// ```
pub fn integrate_pieces<V: Value>(f: impl Fn(f64) -> V, breaks: &[f64], tolerance: f64) -> Integral<V> {
    let mut pieces: Vec<Piece<V>> = breaks.windows(2).map(|w| piece(&f, w[0], w[1])).collect();
    loop {
        let error: f64 = pieces.iter().map(|p| p.error).sum();
        let rounding: f64 = 16.0 * f64::EPSILON * pieces.iter().map(|p| p.size).sum::<f64>();
        let worst = (0..pieces.len()).max_by(|&i, &j| pieces[i].error.total_cmp(&pieces[j].error));
        let splittable = worst.filter(|&i| {
            let middle = 0.5 * (pieces[i].a + pieces[i].b);
            error > tolerance.max(rounding)
                && pieces.len() < MOST_PIECES
                && pieces[i].a < middle
                && middle < pieces[i].b
        });
        let Some(i) = splittable else {
            let value = pieces.iter().fold(V::ZERO, |sum, p| sum + p.value);
            return Integral { value, error: error + rounding };
        };
        let Piece { a, b, .. } = pieces[i];
        let middle = 0.5 * (a + b);
        pieces[i] = piece(&f, a, middle);
        pieces.push(piece(&f, middle, b));
    }
}

/// Rising breaks that cut `[a, b]` into pieces no longer than `step`: for integrands that oscillate with a known
/// period, where adaptive halving from one piece could miss everything.
pub fn even_breaks(a: f64, b: f64, step: f64) -> Vec<f64> {
    let n = ((b - a) / step).ceil().clamp(1.0, (MOST_PIECES / 2) as f64) as usize;
    (0..=n).map(|i| a + (b - a) * i as f64 / n as f64).collect()
}
