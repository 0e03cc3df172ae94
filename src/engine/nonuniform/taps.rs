//! The window's values at the cells around a point, by polynomials.

use crate::engine::nonuniform::window::Window;
use crate::engine::real::Real;
use crate::num::cos_pi;

/// Into how many pieces the width of a cell is cut, each with polynomials of its own.
const PIECES: usize = 1 << PIECE_BITS;
pub(crate) const PIECE_BITS: u32 = 5;
/// The greatest degree of the polynomials.
const MOST_DEGREE: usize = 9;

/// How many bits of a code are the fraction of a cell.
pub(super) const FRACTION_BITS: u32 = 52;
pub(super) const FRACTION: u64 = (1 << FRACTION_BITS) - 1;

/// The values `φ(j − (w/2 − 1) − f)`, `0 ≤ j < w`, of a window at the cells around a point that stands the fraction
/// `0 ≤ f < 1` of a cell behind number `w/2 − 1` of them.
///
/// Polynomials in `f`, one for each `j` and each of 32 pieces of the cell, of the least degree that keeps the sum of
/// all errors at one place below what is allowed; few of them are needed on so small a piece, and the table (16 kB or
/// so) stays in the nearest cache. Interpolated at the nodes of Chebyshev, evaluated by Horner's rule for all `j` at
/// once.
#[derive(Debug, Clone)]
pub(crate) struct Taps<T> {
    width: usize,
    degree: usize,
    /// Piece by piece, from the highest power to the lowest, `width` coefficients each.
    rows: Vec<T>,
}

impl<T: Real> Taps<T> {
    /// Polynomials for a window whose sum of errors at any place is at most `allowed`, or as small as rounding lets it
    /// be.
    pub(crate) fn new(window: &Window, allowed: f64) -> Self {
        let least = 4.0 * f64::EPSILON * window.width() as f64;
        let table = |degree| Table::new(window, degree);
        let fits = |table: &Table| table.error(window) <= allowed.max(least);
        let found = (2..MOST_DEGREE).map(table).find(fits).unwrap_or_else(|| Table::new(window, MOST_DEGREE));
        let rows = found.rows.iter().map(|&c| T::of(c)).collect();
        Self { width: window.width(), degree: found.degree, rows }
    }

    pub(crate) fn width(&self) -> usize {
        self.width
    }

    /// The coefficients, `width` together: piece by piece, from the highest power to the lowest.
    pub(crate) fn rows(&self) -> &[T] {
        &self.rows
    }

    /// The polynomials of a window whose width is known to the compiler.
    #[inline(always)]
    pub(super) fn fixed<const W: usize>(&self) -> FixedTaps<'_, T, W> {
        debug_assert_eq!(W, self.width);
        FixedTaps { degree: self.degree, rows: self.rows.as_chunks().0 }
    }
}

/// [`Taps`] of `W` cells.
#[derive(Debug, Clone, Copy)]
pub(super) struct FixedTaps<'a, T, const W: usize> {
    degree: usize,
    rows: &'a [[T; W]],
}

impl<T: Real, const W: usize> FixedTaps<'_, T, W> {
    /// The values at the fraction that the lower bits of a code hold.
    #[inline(always)]
    pub(super) fn at(&self, code: u64) -> [T; W] {
        let piece = (code >> (FRACTION_BITS - PIECE_BITS)) as usize % PIECES;
        let u = T::of(f64::from_bits(1f64.to_bits() | ((code << PIECE_BITS) & FRACTION)) - 1.0);
        let rows = &self.rows[piece * (self.degree + 1)..][..self.degree + 1];
        let mut values = rows[0];
        for row in &rows[1..] {
            for j in 0..W {
                values[j] = values[j] * u + row[j];
            }
        }
        values
    }
}

/// [`Taps`] of one degree, in `f64`.
struct Table {
    degree: usize,
    rows: Vec<f64>,
}

impl Table {
    fn new(window: &Window, degree: usize) -> Self {
        let (width, count) = (window.width(), degree + 1);
        let nodes: Vec<f64> = (0..count).map(|i| 0.5 - 0.5 * cos_pi((i as f64 + 0.5) / count as f64)).collect();
        let mut rows = vec![0.0; PIECES * count * width];
        for (piece, rows) in rows.chunks_exact_mut(count * width).enumerate() {
            for j in 0..width {
                let values = nodes.iter().map(|u| value(window, j, piece, *u)).collect();
                let powers = monomials(&nodes, values);
                powers.iter().rev().zip(rows[j..].iter_mut().step_by(width)).for_each(|(c, row)| *row = *c);
            }
        }
        Self { degree, rows }
    }

    /// The largest sum of errors, at the places between the nodes where each is about largest.
    fn error(&self, window: &Window) -> f64 {
        let (width, count) = (window.width(), self.degree + 1);
        let places = (0..=count).map(|i| 0.5 - 0.5 * cos_pi(i as f64 / count as f64));
        let sum = |(piece, u): (usize, f64)| {
            let rows = &self.rows[piece * count * width..][..count * width];
            let error = |j: usize| {
                let polynomial = rows[j..].iter().step_by(width).fold(0.0, |sum, c| sum * u + c);
                (polynomial - value(window, j, piece, u)).abs()
            };
            (0..width).map(error).sum::<f64>()
        };
        places.flat_map(|u| (0..PIECES).map(move |piece| (piece, u))).map(sum).fold(0.0, f64::max)
    }
}

/// The window at cell `j`, at the part `u` of a piece.
fn value(window: &Window, j: usize, piece: usize, u: f64) -> f64 {
    let middle = (window.width() / 2 - 1) as f64;
    window.at((j as f64 - middle) - (piece as f64 + u) / PIECES as f64)
}

/// The coefficients, from the lowest power up, of the polynomial with those values at those nodes, by Newton's divided
/// differences.
fn monomials(nodes: &[f64], mut values: Vec<f64>) -> Vec<f64> {
    let n = nodes.len();
    for k in 1..n {
        for i in (k..n).rev() {
            values[i] = (values[i] - values[i - 1]) / (nodes[i] - nodes[i - k]);
        }
    }
    let mut powers = vec![0.0; n];
    for k in (0..n).rev() {
        for d in (1..n).rev() {
            powers[d] = powers[d - 1] - powers[d] * nodes[k];
        }
        powers[0] = values[k] - powers[0] * nodes[k];
    }
    powers
}

/// Runs an expression with the width as a constant that the compiler knows.
macro_rules! with_width {
    ($width:expr, $name:ident => $body:expr) => {
        match $width {
            4 => with_width!(@ 4, $name, $body),
            6 => with_width!(@ 6, $name, $body),
            8 => with_width!(@ 8, $name, $body),
            10 => with_width!(@ 10, $name, $body),
            12 => with_width!(@ 12, $name, $body),
            14 => with_width!(@ 14, $name, $body),
            _ => with_width!(@ 16, $name, $body),
        }
    };
    (@ $constant:literal, $name:ident, $body:expr) => {{
        const $name: usize = $constant;
        $body
    }};
}
pub(super) use with_width;
