//! Sixteen-point transforms, one for each column of a line.

use crate::engine::fft::roots::{root, rounded};
use crate::engine::fft::rows::{Line, WIDTH};
use crate::engine::real::Real;
use num_complex::Complex;

/// How many rows.
pub(super) const RADIX: usize = 16;

/// Which frequency each row stands for after [`butterflies`]: its number with the digits to base four exchanged.
pub(super) const ORDER: [usize; RADIX] = [0, 4, 8, 12, 1, 5, 9, 13, 2, 6, 10, 14, 3, 7, 11, 15];

/// `e^{−2πik/16}`.
pub(super) fn sixteenths<T: Real>() -> [Complex<T>; RADIX] {
    std::array::from_fn(|k| rounded(root(k, RADIX)))
}

/// The transform of every column of sixteen rows, in place: two times radix 4 (Gentleman & Sande 1966). The frequencies
/// come in [`ORDER`].
#[inline(always)]
pub(super) fn butterflies<T: Real>(rows: &mut [Line<T>; RADIX], turns: &[Complex<T>; RADIX]) {
    for j in 0..4 {
        four(rows, [j, j + 4, j + 8, j + 12]);
        if j > 0 {
            for (part, row) in [j + 4, j + 8, j + 12].into_iter().enumerate() {
                rows[row] = rows[row].turned(turns[(part + 1) * j]);
            }
        }
    }
    for j in 0..4 {
        four(rows, [4 * j, 4 * j + 1, 4 * j + 2, 4 * j + 3]);
    }
}

/// The transform of four rows.
#[inline(always)]
fn four<T: Real>(rows: &mut [Line<T>; RADIX], at: [usize; 4]) {
    let [a, b, c, d] = at.map(|i| rows[i]);
    let mut out = [Line::default(); 4];
    for i in 0..WIDTH {
        let (sum_re, sum_im) = (a.re[i] + c.re[i], a.im[i] + c.im[i]);
        let (less_re, less_im) = (a.re[i] - c.re[i], a.im[i] - c.im[i]);
        let (other_re, other_im) = (b.re[i] + d.re[i], b.im[i] + d.im[i]);
        // times −i
        let (cross_re, cross_im) = (b.im[i] - d.im[i], d.re[i] - b.re[i]);
        (out[0].re[i], out[0].im[i]) = (sum_re + other_re, sum_im + other_im);
        (out[1].re[i], out[1].im[i]) = (less_re + cross_re, less_im + cross_im);
        (out[2].re[i], out[2].im[i]) = (sum_re - other_re, sum_im - other_im);
        (out[3].re[i], out[3].im[i]) = (less_re - cross_re, less_im - cross_im);
    }
    for (i, line) in at.into_iter().zip(out) {
        rows[i] = line;
    }
}
