//! Transforms of a few numbers each, many side by side.

use crate::engine::fft::vectors::number::Number;
use crate::engine::real::Real;
use crate::engine::simd::{Simd, Wide};
use num_complex::Complex;

/// Transforms of `R` points.
pub(super) trait Points<const R: usize> {
    /// `X_k = Σ_j x_j e^{−2πijk/R}`, by the roots `e^{−2πik/R}`.
    fn transform<T: Real, S: Simd>(simd: S, roots: &[Complex<T>; R], x: [Number<T, S>; R]) -> [Number<T, S>; R];
}

/// The transforms that there are.
pub(super) struct Few;

impl Points<2> for Few {
    #[inline(always)]
    fn transform<T: Real, S: Simd>(_: S, _: &[Complex<T>; 2], [a, b]: [Number<T, S>; 2]) -> [Number<T, S>; 2] {
        [a + b, a - b]
    }
}

impl Points<4> for Few {
    #[inline(always)]
    fn transform<T: Real, S: Simd>(_: S, _: &[Complex<T>; 4], x: [Number<T, S>; 4]) -> [Number<T, S>; 4] {
        four(x)
    }
}

#[inline(always)]
fn four<T: Real, S: Simd>([a, b, c, d]: [Number<T, S>; 4]) -> [Number<T, S>; 4] {
    let (sum, less, other, cross) = (a + c, a - c, b + d, b - d);
    [sum + other, less.plus_quarter(cross), sum - other, less.less_quarter(cross)]
}

impl Points<8> for Few {
    #[inline(always)]
    fn transform<T: Real, S: Simd>(simd: S, _: &[Complex<T>; 8], x: [Number<T, S>; 8]) -> [Number<T, S>; 8] {
        let even = four([x[0], x[2], x[4], x[6]]);
        let odd = four([x[1], x[3], x[5], x[7]]);
        let half = Wide::splat(simd, T::of(std::f64::consts::FRAC_1_SQRT_2));
        let (first, third) = (odd[1].eighth(), odd[3].eighth());
        [
            even[0] + odd[0],
            even[1].plus_scaled(first, half),
            even[2].plus_quarter(odd[2]),
            Number { re: even[3].re.plus_product(third.im, half), im: even[3].im.less_product(third.re, half) },
            even[0] - odd[0],
            even[1].less_scaled(first, half),
            even[2].less_quarter(odd[2]),
            Number { re: even[3].re.less_product(third.im, half), im: even[3].im.plus_product(third.re, half) },
        ]
    }
}

impl Points<16> for Few {
    #[inline(always)]
    fn transform<T: Real, S: Simd>(simd: S, roots: &[Complex<T>; 16], x: [Number<T, S>; 16]) -> [Number<T, S>; 16] {
        let mut rows = x;
        for j in 0..4 {
            let column = four([x[j], x[j + 4], x[j + 8], x[j + 12]]);
            for k in 0..4 {
                rows[4 * k + j] =
                    if j * k == 0 { column[k] } else { column[k].times(Number::splat(simd, roots[j * k])) };
            }
        }
        let mut out = x;
        for k in 0..4 {
            let row = four([rows[4 * k], rows[4 * k + 1], rows[4 * k + 2], rows[4 * k + 3]]);
            for i in 0..4 {
                out[k + 4 * i] = row[i];
            }
        }
        out
    }
}

macro_rules! odd {
    ($($r:literal)*) => {$(
        impl Points<$r> for Few {
            #[inline(always)]
            fn transform<T: Real, S: Simd>(simd: S, roots: &[Complex<T>; $r], x: [Number<T, S>; $r]) -> [Number<T, S>; $r] {
                odd(simd, roots, x)
            }
        }
    )*};
}

odd!(3 5 7);

/// An odd number of points: sums and differences of mirrored ones, times cosines and sines.
#[inline(always)]
fn odd<T: Real, S: Simd, const R: usize>(simd: S, roots: &[Complex<T>; R], x: [Number<T, S>; R]) -> [Number<T, S>; R] {
    let mut out = x;
    for x in &x[1..] {
        out[0] = out[0] + *x;
    }
    for k in 1..=R / 2 {
        let root = Number::splat(simd, roots[k]);
        let mut even = x[0].plus_scaled(x[1] + x[R - 1], root.re);
        let mut cross = (x[1] - x[R - 1]).scaled(root.im);
        for j in 2..=R / 2 {
            let root = Number::splat(simd, roots[j * k % R]);
            even = even.plus_scaled(x[j] + x[R - j], root.re);
            cross = cross.plus_scaled(x[j] - x[R - j], root.im);
        }
        (out[k], out[R - k]) = (even.less_quarter(cross), even.plus_quarter(cross));
    }
    out
}
