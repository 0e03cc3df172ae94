//! A slow drift, fitted to samples.

use crate::inspect::table::frame::Frame;

/// Coefficients of a polynomial of degree five, which follows up to two periods of anything.
const COUNT: usize = 6;

/// `Σ c_k p_k(u)`, `u = t/L`, of polynomials that are orthogonal at the frame's times under its weights.
#[derive(Debug, Clone, Default)]
pub(super) struct Drift {
    coefficients: [f64; COUNT],
    /// The polynomials by their recurrence `p_{k+1} = (u − a_k)p_k − b_k p_{k−1}`.
    recurrence: [[f64; 2]; COUNT - 1],
}

impl Drift {
    /// Its values added to those at the frame's times, `scale` times.
    pub(super) fn add(&self, frame: &Frame, values: &mut [f64], scale: f64) {
        for (value, t) in values.iter_mut().zip(&frame.times) {
            let basis = self.basis(t / frame.length);
            *value += scale * basis.iter().zip(&self.coefficients).map(|(p, c)| p * c).sum::<f64>();
        }
    }

    /// Fitted again in what `rest` and itself are together, of which it leaves the rest.
    pub(super) fn relax(&mut self, frame: &Frame, rest: &mut [f64]) {
        self.add(frame, rest, 1.0);
        self.fit(frame, rest);
        self.add(frame, rest, -1.0);
    }

    fn basis(&self, u: f64) -> [f64; COUNT] {
        let (mut basis, mut before) = ([1.0; COUNT], 0.0);
        for (k, [a, b]) in self.recurrence.iter().enumerate() {
            basis[k + 1] = (u - a) * basis[k] - b * before;
            before = basis[k];
        }
        basis
    }

    /// Stieltjes' procedure: each polynomial from the sums of the one before.
    fn fit(&mut self, frame: &Frame, values: &[f64]) {
        *self = Self::default();
        let mut before = 0.0;
        for k in 0..COUNT {
            let (mut square, mut moment, mut along) = (0.0, 0.0, 0.0);
            for ((t, w), value) in frame.times.iter().zip(&frame.weights).zip(values) {
                let u = t / frame.length;
                let p = self.basis(u)[k];
                square += w * p * p;
                moment += w * u * p * p;
                along += w * p * value;
            }
            // each polynomial is smaller than the one before by about a quarter of the length; one that vanishes at all
            // weighted times is one too many
            if square <= 1e-6 * before {
                return;
            }
            self.coefficients[k] = along / square;
            if k + 1 < COUNT {
                self.recurrence[k] = [moment / square, if k == 0 { 0.0 } else { square / before }];
            }
            before = square;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::Sampling;
    use crate::sampled::window::Window;

    #[test]
    fn a_polynomial_is_taken_away_whole() {
        let times = [0.0, 1.0, 2.0, 3.5, 5.0, 6.0, 8.0, 9.0, 9.5];
        let sampling = Sampling::of(&times, &[0.0; 9]).unwrap();
        let frame = Frame::new(&sampling, Window::Hann, None).unwrap();
        let value = |t: f64| 100.0 - 30.0 * t + 4.0 * t * t - 0.2 * t * t * t;
        // sums of nine terms, and a basis whose norms differ by 4⁵
        let rounding = 4096.0 * f64::EPSILON * 300.0;
        let mut rest: Vec<f64> = times.iter().map(|&t| value(t)).collect();
        let mut drift = Drift::default();
        for _ in 0..2 {
            drift.relax(&frame, &mut rest);
            assert!(rest.iter().all(|v| v.abs() < rounding), "{rest:?}");
        }
        drift.add(&frame, &mut rest, 1.0);
        assert!(rest.iter().zip(times).all(|(v, t)| (v - value(t)).abs() < rounding));
    }
}
