//! The matrix of the equations of irregular samples, which is one of differences.

use crate::engine::fft::{Butterflies, RealFft, fast_length, long_length};
use crate::num::{cos_pi, sin_pi};
use num_complex::Complex;

const NODES: &str = "rooms are as long as their transform";

/// From so many nodes on a power of two in their number is worth some more of them.
const MANY: usize = 1 << 16;

/// The Hermitian Toeplitz matrix `t_{k−l}`, `|k|, |l| ≤ K`, on coefficients of real signals, of which those from zero on
/// are enough. A product with it is one of signals: the transform of the weights, cut off at `2K`, times the polynomial, on
/// so many nodes (`4K + 1` at least) that what folds stays beyond `K`.
///
/// Where all is even, as of a record and its reflection, coefficients are real, and half of the nodes say all: those half a
/// step from the middle, from which cosine transforms lead to coefficients and back. They are transforms of real numbers of
/// that length, with the even nodes first and the odd ones behind them in falling order (Makhoul, *A fast cosine transform
/// in one and two dimensions*, 1980), an order that a product of signals does not mind.
pub(super) struct Toeplitz {
    degree: usize,
    density: Vec<f64>,
    fft: RealFft<f64>,
    half: Vec<Complex<f64>>,
    values: Vec<f64>,
    /// `e^{iπk/2n}`, up to the degree, where all is even.
    turns: Option<Vec<Complex<f64>>>,
}

impl Toeplitz {
    /// Of the transform of the weights up to `2K`; of its real part if all is `even`.
    pub(super) fn new(gram: &[Complex<f64>], degree: usize, even: bool) -> Self {
        let least = if even { 2 * degree + 1 } else { 4 * degree + 2 };
        let n = if least < MANY { fast_length(least) } else { long_length(least) };
        let fft = RealFft::with(n, Butterflies::Scalar).expect(NODES);
        let mut half = vec![Complex::ZERO; n / 2 + 1];
        if even {
            let at = |m: usize| gram.get(m).filter(|_| m <= 2 * degree).map_or(0.0, |t| t.re);
            for (k, value) in half.iter_mut().enumerate() {
                *value = turn(k, n) * Complex::new(at(k), -at(n - k));
            }
        } else {
            half[..=2 * degree].copy_from_slice(&gram[..=2 * degree]);
        }
        let mut density = vec![0.0; n];
        fft.inverse(&half, &mut density).expect(NODES);
        density.iter_mut().for_each(|v| *v /= n as f64);
        let turns = even.then(|| (0..=degree).map(|k| turn(k, n)).collect());
        Self { degree, density, fft, half, values: vec![0.0; n], turns }
    }

    /// The highest degree.
    pub(super) fn degree(&self) -> usize {
        self.degree
    }

    /// The product with coefficients from zero on.
    pub(super) fn times(&mut self, coefficients: &[Complex<f64>]) -> &[Complex<f64>] {
        let (low, high) = self.half.split_at_mut(self.degree + 1);
        match &self.turns {
            Some(turns) => {
                let turned = turns.iter().zip(coefficients).map(|(turn, c)| turn * c.re);
                low.iter_mut().zip(turned).for_each(|(value, turned)| *value = turned);
            }
            None => low.copy_from_slice(coefficients),
        }
        high.fill(Complex::ZERO);
        self.fft.inverse(&self.half, &mut self.values).expect(NODES);
        self.values.iter_mut().zip(&self.density).for_each(|(v, d)| *v *= d);
        self.fft.forward(&self.values, &mut self.half).expect(NODES);
        let low = &mut self.half[..=self.degree];
        if let Some(turns) = &self.turns {
            low.iter_mut().zip(turns).for_each(|(z, turn)| *z = (z.re * turn.re + z.im * turn.im).into());
        }
        low
    }
}

fn turn(k: usize, n: usize) -> Complex<f64> {
    let angle = k as f64 / (2 * n) as f64;
    Complex::new(cos_pi(angle), sin_pi(angle))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::num::random::normal;

    #[test]
    fn even_and_general_products_are_the_sums_they_stand_for() {
        for degree in [0, 1, 2, 9, 40] {
            let number = |k: usize, d: u32| normal(3, k as u64, d);
            for even in [false, true] {
                let part = |im: f64| if even { 0.0 } else { im };
                let gram: Vec<_> = (0..=2 * degree)
                    .map(|m| Complex::new(number(m, 0), part(if m > 0 { number(m, 1) } else { 0.0 })))
                    .collect();
                let coefficients: Vec<_> = (0..=degree)
                    .map(|k| Complex::new(number(k, 2), part(if k > 0 { number(k, 3) } else { 0.0 })))
                    .collect();
                let both = |list: &[Complex<f64>], k: i64| {
                    let value = list[k.unsigned_abs() as usize];
                    if k < 0 { value.conj() } else { value }
                };
                let mut matrix = Toeplitz::new(&gram, degree, even);
                let found = matrix.times(&coefficients);
                let top = degree as i64;
                let size: f64 = gram.iter().map(|t| t.norm()).sum::<f64>()
                    * 2.0
                    * coefficients.iter().map(|c| c.norm()).sum::<f64>()
                    * 2.0;
                for k in 0..=top {
                    let known: Complex<f64> = (-top..=top).map(|l| both(&gram, k - l) * both(&coefficients, l)).sum();
                    // two transforms of a few hundred values
                    assert!((found[k as usize] - known).norm() < 16.0 * f64::EPSILON * size, "{degree} {even} {k}");
                }
            }
        }
    }
}
