//! A place of a picture under a window, and its spectrum at any frequency.

use crate::grid::Grid;
use crate::image::Image;
use crate::image::dft::forward;
use crate::num::{cos_pi, sin_pi};
use crate::sampled::window::Window;
use ndarray::Array2;
use num_complex::Complex;

/// Pixels of a rectangle, without their mean, under a Hann window in both directions.
pub(super) struct Patch {
    /// `w·(f − m)`, `[[iy, ix]]`.
    faded: Array2<f64>,
    across: Vec<f64>,
    down: Vec<f64>,
    /// The mean `m` under the window.
    pub(super) mean: f64,
}

/// The window over `n` pixels: its values at their middles, so that one pixel has the weight 1.
fn window(n: usize) -> Vec<f64> {
    (0..n).map(|j| Window::Hann.at((j as f64 + 0.5) / n as f64)).collect()
}

/// `e^{−2πiνx}` at the pixels of an axis, counted from its middle.
fn wave(n: usize, nu: f64) -> impl Iterator<Item = (f64, Complex<f64>)> {
    let middle = 0.5 * (n as f64 - 1.0);
    (0..n).map(move |j| {
        let x = j as f64 - middle;
        (x, Complex::new(cos_pi(2.0 * nu * x), -sin_pi(2.0 * nu * x)))
    })
}

impl Patch {
    /// The `nx × ny` pixels from `left`, `top` on; they lie inside.
    pub(super) fn of(image: &Image, corner: [usize; 2], [nx, ny]: [usize; 2]) -> Self {
        let (across, down) = (window(nx), window(ny));
        let part = image.part(corner, [nx, ny]).expect("a part of the picture");
        let part = part.pixels();
        let weighed = |f: &dyn Fn(f64) -> f64| {
            let mut sum = 0.0;
            for (row, b) in part.rows().into_iter().zip(&down) {
                sum += b * row.iter().zip(&across).map(|(v, a)| a * f(*v)).sum::<f64>();
            }
            sum
        };
        let mean = weighed(&|v| v) / weighed(&|_| 1.0);
        let faded = Array2::from_shape_fn((ny, nx), |(j, i)| across[i] * down[j] * (part[[j, i]] - mean));
        Self { faded, across, down, mean }
    }

    fn weight(&self) -> f64 {
        self.across.iter().sum::<f64>() * self.down.iter().sum::<f64>()
    }

    /// The transform of the window itself at a frequency, relative to that at zero: real, as the window is even.
    fn leak(&self, [u, v]: [f64; 2]) -> f64 {
        let of = |weights: &[f64], nu: f64| {
            let sum: f64 = weights.iter().zip(wave(weights.len(), nu)).map(|(w, (_, e))| w * e.re).sum();
            sum / weights.iter().sum::<f64>()
        };
        of(&self.across, u) * of(&self.down, v)
    }

    /// The moments `Σ x^p y^q w(f − m) e^{−2πi(ux + vy)}` for `p + q ≤ 2`: `[1, x, y, x², xy, y²]`.
    fn moments(&self, [u, v]: [f64; 2]) -> [Complex<f64>; 6] {
        let across: Vec<(f64, Complex<f64>)> = wave(self.across.len(), u).collect();
        let mut sums = [Complex::ZERO; 6];
        for (row, (y, turn)) in self.faded.rows().into_iter().zip(wave(self.down.len(), v)) {
            let mut line = [Complex::<f64>::ZERO; 3];
            for (f, (x, e)) in row.iter().zip(&across) {
                let value = e * f;
                line[0] += value;
                line[1] += value * x;
                line[2] += value * (x * x);
            }
            let [one, x, xx] = line.map(|sum| sum * turn);
            let terms = [one, x, one * y, xx, x * y, one * (y * y)];
            sums.iter_mut().zip(terms).for_each(|(sum, term)| *sum += term);
        }
        sums
    }

    /// The amplitude of the wave `a·cos(2π(ux + vy) + φ)` at that frequency.
    ///
    /// The wave at `−(u, v)` that belongs to it leaks in where `2(u, v)` is near a whole number, at the Nyquist frequencies:
    /// `D = (a·e^{iφ} + a·e^{−iφ}·L)/2` with the window's leak `L` there is solved. At such a frequency itself only one phase
    /// can be seen; the other counts as not there.
    pub(super) fn amplitude(&self, frequency: [f64; 2]) -> f64 {
        self.phasor(frequency).norm()
    }

    /// `a·e^{iφ}` of that wave, its phase counted from the middle of the patch.
    pub(super) fn phasor(&self, frequency: [f64; 2]) -> Complex<f64> {
        self.solved(self.moments(frequency)[0], frequency)
    }

    fn solved(&self, sum: Complex<f64>, [u, v]: [f64; 2]) -> Complex<f64> {
        let d = 2.0 * sum / self.weight();
        let leak = self.leak([2.0 * u, 2.0 * v]);
        let part = |value: f64, gain: f64| if gain.abs() > 0.1 { value / gain } else { 0.0 };
        Complex::new(part(d.re, 1.0 + leak), part(d.im, 1.0 - leak))
    }

    /// The frequency near the given one where `|D|` is largest, no farther than one bin.
    ///
    /// By Newton's method on `ln|D|²`, which under this window is close to a parabola over the whole main lobe, so that it is
    /// safe from half a bin away; six steps, each of which gains about as many digits as there were.
    pub(super) fn refined(&self, [u0, v0]: [f64; 2]) -> [f64; 2] {
        let tau = std::f64::consts::TAU;
        let (bin_u, bin_v) = (1.0 / self.across.len() as f64, 1.0 / self.down.len() as f64);
        let both = |a: Complex<f64>, b: Complex<f64>| (a.conj() * b).re;
        let [mut u, mut v] = [u0, v0];
        for _ in 0..6 {
            let [d, dx, dy, dxx, dxy, dyy] = self.moments([u, v]);
            let turn = Complex::new(0.0, -tau);
            let (du, dv) = (dx * turn, dy * turn);
            let (duu, duv, dvv) = (dxx * -(tau * tau), dxy * -(tau * tau), dyy * -(tau * tau));
            let size = d.norm_sqr();
            if size == 0.0 {
                break;
            }
            // half the slope and half the curvature of the logarithm
            let slope = [both(d, du) / size, both(d, dv) / size];
            let curvature = |first: f64, second: f64, product: f64| (first + second) / size - 2.0 * product;
            let a = curvature(both(du, du), both(d, duu), slope[0] * slope[0]);
            let b = curvature(both(du, dv), both(d, duv), slope[0] * slope[1]);
            let c = curvature(both(dv, dv), both(d, dvv), slope[1] * slope[1]);
            let (step_u, step_v) = if self.down.len() == 1 || self.across.len() == 1 {
                let along = |slope: f64, curvature: f64| if curvature < 0.0 { -slope / curvature } else { 0.0 };
                (along(slope[0], a), along(slope[1], c))
            } else {
                let determinant = a * c - b * b;
                if a >= 0.0 || determinant <= 0.0 {
                    break; // no hill: as far as it goes
                }
                ((b * slope[1] - c * slope[0]) / determinant, (b * slope[0] - a * slope[1]) / determinant)
            };
            u = (u + step_u).clamp(u0 - bin_u, u0 + bin_u);
            v = (v + step_v).clamp(v0 - bin_v, v0 + bin_v);
        }
        [u, v]
    }

    /// The frequencies of bins that stand out like lines, with their amplitudes. Of `±(u, v)` one; only those that `wanted`
    /// wants.
    ///
    /// A line is higher than its neighbours, twice as high as whatever lies three or four bins away, where a wave that fills
    /// the patch has left less than 2 % under this window (edges and texture spread), and has 20 times the mean power of what
    /// lies three to six bins away: of a million bins of noise 0.002 do, their powers being exponential.
    pub(super) fn lines(&self, wanted: impl Fn([f64; 2]) -> bool, least: f64) -> Vec<([f64; 2], f64)> {
        let (ny, nx) = self.faded.dim();
        let grid = Grid::pixels(nx, ny).expect("a part of a picture");
        let bins = forward(&Image::trusted(grid, self.faded.clone()));
        let size = |k: i64, l: i64| bins.bin(k, l).norm_sqr();
        let (rx, ry) = ((nx as i64 - 1) / 2, (ny as i64 - 1) / 2);
        let scale = 2.0 / self.weight();
        let mut found = Vec::new();
        for l in 0..=ny as i64 / 2 {
            for k in -(nx as i64 / 2)..(nx as i64 + 1) / 2 {
                let at = [k as f64 / nx as f64, l as f64 / ny as f64];
                let here = size(k, l);
                let own = l == 0 || 2 * l == ny as i64;
                let repeated = own && k < 0 && 2 * k != -(nx as i64);
                if repeated || scale * here.sqrt() < 0.5 * least || !wanted(at) {
                    continue;
                }
                let around = |reach: i64| {
                    let (x, y) = (reach.min(rx), reach.min(ry));
                    (-y..=y).flat_map(move |j| (-x..=x).map(move |i| (i, j)))
                };
                let highest = around(1).all(|(i, j)| (i, j) == (0, 0) || size(k + i, l + j) <= here);
                let mirrored = |i: i64, j: i64| {
                    let near = |d: i64, n: i64| d.rem_euclid(n).min((-d).rem_euclid(n)) <= 2;
                    near(2 * k + i, nx as i64) && near(2 * l + j, ny as i64)
                };
                let alone = || {
                    let beside = |&(i, j): &(i64, i64)| i.abs().max(j.abs()) >= 3 && !mirrored(i, j);
                    let near = around(4).filter(beside).all(|(i, j)| size(k + i, l + j) <= 0.25 * here);
                    let (mut sum, mut count) = (0.0, 0.0);
                    for (i, j) in around(6).filter(beside) {
                        sum += size(k + i, l + j);
                        count += 1.0;
                    }
                    near && 20.0 * sum <= here * count
                };
                if highest && alone() {
                    let at = self.refined(at);
                    let amplitude = self.amplitude(at);
                    if amplitude >= least && wanted(at) {
                        found.push((at, amplitude));
                    }
                }
            }
        }
        found
    }
}
