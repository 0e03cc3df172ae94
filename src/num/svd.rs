//! The singular values of a small matrix, by Jacobi's method.

use crate::error::{Error, Result};
use ndarray::Array2;

/// Sweeps after which the iteration is given up; it needs about ten, since it converges quadratically.
const MOST_SWEEPS: usize = 60;

/// The singular value decomposition `A = U Σ Vᵀ` of a matrix with at least as many rows as columns.
///
/// One-sided Jacobi (Hestenes 1958): columns are rotated in pairs until all are orthogonal to each other; their lengths
/// are the singular values. It costs about ten times `m·n²` and finds small singular values to a relative accuracy that
/// bidiagonalisation does not reach (Demmel and Veselić, *Jacobi's method is more accurate than QR*, 1992), which is
/// what a condition number needs.
///
/// ```
/// use ndarray::array;
/// use nyquist::num::svd::Svd;
/// let svd = Svd::of(&array![[3.0, 0.0], [0.0, 0.0], [0.0, 4.0]])?;
/// assert_eq!(svd.values(), [4.0, 3.0]);
/// assert_eq!(svd.condition(), 4.0 / 3.0);
/// assert_eq!(svd.solve(&[3.0, 5.0, 8.0])?, [1.0, 2.0]); // the 5 is out of reach: least squares
/// # Ok::<(), nyquist::error::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Svd {
    /// `U Σ`, column by column.
    scaled: Vec<Vec<f64>>,
    /// `V`, column by column.
    right: Vec<Vec<f64>>,
    values: Vec<f64>,
}

impl Svd {
    /// The decomposition of `matrix`.
    ///
    /// # Errors
    /// No columns, fewer rows than columns, or entries that are not finite.
    pub fn of(matrix: &Array2<f64>) -> Result<Self> {
        let (m, n) = matrix.dim();
        if n == 0 {
            return Err(Error::TooFew { what: "columns of a matrix", least: 1, got: 0 });
        }
        if m < n {
            return Err(Error::TooFew { what: "rows of a matrix", least: n, got: m });
        }
        if let Some(index) = matrix.iter().position(|v| !v.is_finite()) {
            let value = matrix[[index / n, index % n]];
            return Err(Error::NotFiniteAt { what: "the entries of a matrix, row by row,", index, value });
        }
        let mut scaled: Vec<Vec<f64>> = matrix.columns().into_iter().map(|c| c.to_vec()).collect();
        let mut right: Vec<Vec<f64>> = (0..n).map(|i| (0..n).map(|j| f64::from(i == j)).collect()).collect();
        let orthogonal = f64::EPSILON * (m as f64).sqrt();
        for _ in 0..MOST_SWEEPS {
            let mut rotated = false;
            for q in 1..n {
                for p in 0..q {
                    rotated |= rotate(&mut scaled, &mut right, [p, q], orthogonal);
                }
            }
            if !rotated {
                break;
            }
        }
        let mut order: Vec<(f64, usize)> = scaled.iter().map(|c| dot(c, c).sqrt()).zip(0..).collect();
        order.sort_by(|a, b| b.0.total_cmp(&a.0));
        let take = |from: &mut Vec<Vec<f64>>| order.iter().map(|&(_, i)| std::mem::take(&mut from[i])).collect();
        let (scaled, right) = (take(&mut scaled), take(&mut right));
        Ok(Self { scaled, right, values: order.iter().map(|&(value, _)| value).collect() })
    }

    /// The singular values, falling. For a symmetric matrix without negative eigenvalues they are the eigenvalues.
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// The largest singular value over the smallest: by how much a relative error of the data may grow in the
    /// solution. Infinite for a matrix that has lost rank.
    pub fn condition(&self) -> f64 {
        self.values[0] / self.values[self.values.len() - 1]
    }

    /// The `x` that makes `‖A x − data‖` least, `x = V Σ⁻¹ Uᵀ data`; directions in which `A` is zero are left out.
    ///
    /// # Errors
    /// Data of another length than the matrix has rows.
    pub fn solve(&self, data: &[f64]) -> Result<Vec<f64>> {
        self.solve_above(data, 0.0)
    }

    /// The same without the directions whose singular values are `least` or below: those in which rounding would be
    /// amplified beyond what is worth it.
    ///
    /// # Errors
    /// As [`Svd::solve`].
    pub fn solve_above(&self, data: &[f64], least: f64) -> Result<Vec<f64>> {
        let rows = self.scaled[0].len();
        if data.len() != rows {
            return Err(Error::Length { what: "the right-hand side", expected: rows, got: data.len() });
        }
        let mut solution = vec![0.0; self.values.len()];
        for ((scaled, right), &value) in self.scaled.iter().zip(&self.right).zip(&self.values) {
            if value > least {
                let weight = dot(scaled, data) / (value * value);
                solution.iter_mut().zip(right).for_each(|(x, v)| *x += weight * v);
            }
        }
        Ok(solution)
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    // four independent sums, so that the additions need not wait for each other
    let mut sums = [0.0; 4];
    let (a4, b4) = (a.chunks_exact(4), b.chunks_exact(4));
    let rest: f64 = a4.remainder().iter().zip(b4.remainder()).map(|(x, y)| x * y).sum();
    for (x, y) in a4.zip(b4) {
        for i in 0..4 {
            sums[i] += x[i] * y[i];
        }
    }
    (sums[0] + sums[1]) + (sums[2] + sums[3]) + rest
}

/// Makes columns `p < q` orthogonal; false if they already were.
fn rotate(scaled: &mut [Vec<f64>], right: &mut [Vec<f64>], [p, q]: [usize; 2], orthogonal: f64) -> bool {
    let (alpha, beta, gamma) = (dot(&scaled[p], &scaled[p]), dot(&scaled[q], &scaled[q]), dot(&scaled[p], &scaled[q]));
    if gamma.abs() <= orthogonal * (alpha * beta).sqrt() {
        return false;
    }
    // the smaller of the two angles that diagonalise [[α, γ], [γ, β]]
    let zeta = (beta - alpha) / (2.0 * gamma);
    let tangent = zeta.signum() / (zeta.abs() + zeta.hypot(1.0));
    let cosine = 1.0 / tangent.hypot(1.0);
    let sine = cosine * tangent;
    for columns in [scaled, right] {
        let (before, after) = columns.split_at_mut(q);
        for (x, y) in before[p].iter_mut().zip(&mut after[0]) {
            (*x, *y) = (cosine * *x - sine * *y, sine * *x + cosine * *y);
        }
    }
    true
}
