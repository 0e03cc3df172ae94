//! Recovery from many irregular samples: weights by their gaps, conjugate gradients, a Toeplitz matrix.

use crate::beyond::toeplitz::Toeplitz;
use crate::error::{Error, Result, all_finite};
use crate::num::random::normal;
use crate::num::scale::scale;
use crate::sampled::harmonics::Places;
use crate::signal::trigonometric::{TrigPolynomial, rising};
use num_complex::Complex;
use std::ops::Range;

/// The equations of the trigonometric polynomial `p` of degree `K` that makes `Σ w_j (p(x_j) − v_j)²` least, where each
/// sample weighs as much as the way half to both its neighbours is long.
///
/// Their matrix `Σ_j w_j e^{−2πi(k−l)u_j}` depends on `k − l` alone, so that a product with it is two Fourier transforms,
/// and conjugate gradients need nothing else: "ACT" (Feichtinger, Gröchenig and Strohmer, *Efficient numerical methods in
/// non-uniform sampling theory*, 1995). Where the largest gap `δ` is below `1/(2B)` the weights bound the condition number
/// of the problem by `(1 + 2Bδ)/(1 − 2Bδ)`, however the samples crowd elsewhere. [`Irregular`] solves the same problem
/// without weights and by singular values, for hundreds of samples.
///
/// [`Irregular`]: crate::beyond::irregular::Irregular
///
/// ```
/// use nyquist::beyond::Weighted;
/// use nyquist::prelude::*;
/// use nyquist::num::random::uniform;
/// use nyquist::sampled::harmonics::Places;
/// // one sample somewhere in each of 1000 cells, and a tone at 0.8 of their Nyquist frequency
/// let parts: Vec<f64> = (0..1000u32).map(|i| (f64::from(i) + 0.8 * uniform(1, i.into(), 0)) / 1000.0).collect();
/// let values: Vec<f64> = parts.iter().map(|u| nyquist::num::cos_pi(800.0 * u)).collect();
/// let equations = Weighted::new(0.0..1.0, Places::Anywhere(parts), 420)?;
/// let found = equations.fit(&values, 420)?;
/// assert!((found.coefficients()[400].re - 0.5).abs() < 1e-12);
/// assert!(equations.condition(420, 100.0)? < 10.0);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Weighted {
    start: f64,
    period: f64,
    places: Places,
    even: bool,
    weights: Vec<f64>,
    /// The transform of the weights up to twice the highest degree.
    gram: Vec<Complex<f64>>,
}

/// Steps of conjugate gradients after which they are given up.
const MOST_STEPS: usize = 10_000;
/// Unknowns up to which all directions are kept orthogonal where conjugate gradients do not settle by themselves.
const MOST_KEPT: usize = 2001;

/// What is left of a residual when it is lost in rounding.
const LOST: f64 = f64::EPSILON;
/// What is left of a random one when all eigenvalues have been seen: of a million components the smallest is seldom below a
/// millionth of the whole, and of that less than a hundredth is left.
const SEEN: f64 = 1e-8;

const UNDETERMINED: &str = "recovery from irregular samples by normal equations in double precision";
const UNSETTLED: &str = "recovery from irregular samples by 10000 steps of conjugate gradients";

/// The condition number `κ` up to which rounding leaves something of the smallest eigenvalue: `1/√(nε)` of `n` unknowns,
/// since the matrix has `κ²`, and entries that are off by about `ε` move its eigenvalues by `nε` at most.
fn determined(unknowns: usize) -> f64 {
    1.0 / (unknowns as f64 * f64::EPSILON).sqrt()
}

/// The condition number up to which `s` steps are sure to suffice: errors fall as `2e^{−2s/κ}`, from `κ/ε` on.
fn sure() -> f64 {
    let steps = MOST_STEPS as f64;
    2.0 * steps / (4.0 * steps / f64::EPSILON).ln()
}

impl Weighted {
    /// The equations for places of a period, up to a degree.
    ///
    /// # Errors
    /// A period that is not finite and rising; places that are not finite, not strictly rising or not within `0..1`; fewer
    /// places than the `2K + 1` coefficients; sums that are too long ([`Places::harmonics`]).
    pub fn new(period: Range<f64>, places: Places, most_degree: usize) -> Result<Self> {
        let (start, length) = rising("the start of a period", "the end of a period", &period)?;
        let n = places.len();
        if n < 2 * most_degree + 1 {
            let what = "samples that determine so many coefficients";
            return Err(Error::TooFew { what, least: 2 * most_degree + 1, got: n });
        }
        let parts: Vec<f64> = (0..n).map(|i| places.part(i)).collect();
        all_finite("irregular places", &parts)?;
        if let Some(&value) = parts.iter().find(|u| !(0.0..1.0).contains(*u)) {
            return Err(Error::OutOfRange { what: "a place as a part of the period", value, low: 0.0, high: 1.0 });
        }
        if let Some(pair) = parts.windows(2).find(|pair| pair[0] >= pair[1]) {
            let what = "the gap between neighbouring irregular places";
            return Err(Error::NotPositive { what, value: pair[1] - pair[0] });
        }
        let around = |i: usize| match i {
            _ if n == 1 => 2.0,
            0 => parts[1] - (parts[n - 1] - 1.0),
            _ if i == n - 1 => parts[0] + 1.0 - parts[n - 2],
            _ => parts[i + 1] - parts[i - 1],
        };
        let weights: Vec<f64> = (0..n).map(|i| 0.5 * around(i)).collect();
        let gram = places.harmonics(&weights, 2 * most_degree)?;
        Ok(Self { start, period: length, places, even: false, weights, gram })
    }

    /// The same equations for places and values that are their own reflection at the start of the period: all coefficients
    /// are real then, and a step costs half. The rest of other values is not looked at.
    #[must_use]
    pub fn even(self) -> Self {
        Self { even: true, ..self }
    }

    /// The highest degree that the equations were prepared for.
    pub fn most_degree(&self) -> usize {
        self.gram.len() / 2
    }

    /// The length of the period.
    pub fn period(&self) -> f64 {
        self.period
    }

    /// The weights of the samples, parts of the period; their sum is one.
    pub fn weights(&self) -> &[f64] {
        &self.weights
    }

    /// The polynomial of that degree nearest to `values`; exact to rounding, `κ²ε` of its size, where they are values of
    /// such a polynomial.
    ///
    /// # Errors
    /// Values of another number than the places, or that are not finite; a degree above the one prepared for; sums that
    /// are too long; [`Error::IllConditioned`] where ten thousand steps do not suffice, for more than 2001 unknowns.
    pub fn fit(&self, values: &[f64], degree: usize) -> Result<TrigPolynomial> {
        self.prepared(degree)?;
        if values.len() != self.weights.len() {
            let what = "values at irregular places";
            return Err(Error::Length { what, expected: self.weights.len(), got: values.len() });
        }
        all_finite("values at irregular places", values)?;
        let unit = scale(values.iter().copied());
        let weighted: Vec<f64> = values.iter().zip(&self.weights).map(|(v, w)| v / unit * w).collect();
        let mut wanted = self.places.harmonics(&weighted, degree)?;
        if self.even {
            wanted.iter_mut().for_each(|sum| sum.im = 0.0);
        }
        let (mut coefficients, ritz) =
            Toeplitz::new(&self.gram, degree, self.even).settled(&wanted, f64::INFINITY, LOST);
        if !ritz.settled {
            return Err(ill_conditioned(UNSETTLED, ritz.condition(), sure()));
        }
        coefficients[0].im = 0.0;
        coefficients.iter_mut().for_each(|coefficient| *coefficient *= unit);
        TrigPolynomial::new(self.start..self.start + self.period, coefficients)
    }

    /// The condition number of the weighted problem of that degree, the root of that of its matrix: by so much relative
    /// errors of the values may grow. From the values that conjugate gradients pass through on their way to the solution of
    /// equations with a random right-hand side (Lanczos), up to 2001 unknowns with all directions kept orthogonal where
    /// that is needed; an estimate from below that is good to a few per cent.
    ///
    /// # Errors
    /// A degree above the one prepared for; [`Error::IllConditioned`], with a lower bound of the condition number, as soon
    /// as it is seen to exceed `most` or the `1/√(nε)` that `n` unknowns allow in double precision, or where ten thousand
    /// steps do not settle; its `most` is the limit that was met.
    pub fn condition(&self, degree: usize, most: f64) -> Result<f64> {
        const SEED: u64 = 1;
        self.prepared(degree)?;
        let imaginary = |k: u64| if k == 0 || self.even { 0.0 } else { normal(SEED, k, 1) };
        let random = |k: u64| Complex::new(normal(SEED, k, 0), imaginary(k));
        let wanted: Vec<Complex<f64>> = (0..=degree as u64).map(random).collect();
        let limit = determined(2 * degree + 1);
        let (_, ritz) = Toeplitz::new(&self.gram, degree, self.even).settled(&wanted, most.min(limit), SEEN);
        match ritz.condition() {
            // what rounding hides may be anything from there on
            condition if condition > limit && limit < most => {
                let least = if condition.is_finite() { condition } else { limit };
                Err(ill_conditioned(UNDETERMINED, least, limit))
            }
            condition if condition > most => Err(ill_conditioned("recovery from irregular samples", condition, most)),
            condition if !ritz.settled => Err(ill_conditioned(UNSETTLED, condition, sure())),
            condition => Ok(condition),
        }
    }

    fn prepared(&self, degree: usize) -> Result<()> {
        let (value, high) = (degree as f64, self.most_degree() as f64);
        let what = "the degree of a trigonometric polynomial";
        if degree <= self.most_degree() { Ok(()) } else { Err(Error::OutOfRange { what, value, low: 0.0, high }) }
    }
}

fn ill_conditioned(what: &'static str, condition: f64, most: f64) -> Error {
    Error::IllConditioned { what, condition, most }
}

impl Toeplitz {
    /// The solution, by steps whose directions are kept orthogonal if they do not settle otherwise.
    fn settled(&mut self, wanted: &[Complex<f64>], most: f64, enough: f64) -> (Vec<Complex<f64>>, Ritz) {
        let unknowns = 2 * self.degree() + 1;
        if unknowns > MOST_KEPT {
            return self.solve(wanted, [most, enough], MOST_STEPS, false);
        }
        // rounding may cost as many steps again as there are unknowns
        let plain = self.solve(wanted, [most, LOST], 2 * unknowns, false);
        if plain.1.settled || plain.1.condition() > most {
            return plain;
        }
        self.solve(wanted, [most, LOST], unknowns, true)
    }

    /// Conjugate gradients from zero until the residual is that small a part, or the condition number is seen to exceed
    /// `most`, but for so many steps at most; where residuals are `kept`, each is made orthogonal to all before it, and as
    /// many steps as there are unknowns leave nothing.
    fn solve(
        &mut self,
        wanted: &[Complex<f64>],
        [most, part]: [f64; 2],
        most_steps: usize,
        kept: bool,
    ) -> (Vec<Complex<f64>>, Ritz) {
        let mut solution = vec![Complex::ZERO; wanted.len()];
        let (mut residual, mut direction) = (wanted.to_vec(), wanted.to_vec());
        let mut square = inner(&residual, &residual);
        let enough = square * part * part;
        let (mut ritz, mut before) = (Ritz::default(), Vec::new());
        while square > enough && ritz.steps() < most_steps {
            let product = self.times(&direction);
            let curvature = inner(&direction, product);
            if curvature <= 0.0 {
                // only rounding makes a Gram matrix indefinite: it has lost rank
                ritz.lost = true;
                break;
            }
            let step = square / curvature;
            solution.iter_mut().zip(&direction).for_each(|(x, d)| *x += d * step);
            if kept {
                let size = 1.0 / square.sqrt();
                before.push(residual.iter().map(|r| r * size).collect::<Vec<_>>());
            }
            residual.iter_mut().zip(product).for_each(|(r, p)| *r -= p * step);
            for unit in &before {
                let part = inner(unit, &residual);
                residual.iter_mut().zip(unit).for_each(|(r, u)| *r -= u * part);
            }
            let next = inner(&residual, &residual);
            let turn = next / square;
            direction.iter_mut().zip(&residual).for_each(|(d, r)| *d = r + *d * turn);
            square = next;
            ritz.push(step, turn);
            if most.is_finite() && ritz.steps().is_multiple_of(16) && ritz.condition() > most {
                break;
            }
        }
        ritz.settled = square <= enough || (kept && (ritz.lost || ritz.steps() == most_steps));
        (solution, ritz)
    }
}

/// `Σ_k a̅_k b_k` over all `k` from `−K` to `K`, of real signals.
fn inner(a: &[Complex<f64>], b: &[Complex<f64>]) -> f64 {
    let upper: f64 = a[1..].iter().zip(&b[1..]).map(|(a, b)| a.re * b.re + a.im * b.im).sum();
    a[0].re * b[0].re + 2.0 * upper
}

/// The tridiagonal matrix that conjugate gradients build, whose eigenvalues approach the extreme ones of theirs.
#[derive(Default)]
struct Ritz {
    diagonal: Vec<f64>,
    /// Squares of what stands beside the diagonal.
    beside: Vec<f64>,
    /// What the next diagonal entry begins with.
    carried: f64,
    /// Whether nothing but rounding was left.
    settled: bool,
    /// Whether a direction without curvature was met.
    lost: bool,
}

impl Ritz {
    fn steps(&self) -> usize {
        self.diagonal.len()
    }

    fn push(&mut self, step: f64, turn: f64) {
        self.diagonal.push(1.0 / step + self.carried);
        self.beside.push(turn / (step * step));
        self.carried = turn / step;
    }

    /// The root of the ratio of the extreme eigenvalues; one if there are none.
    fn condition(&self) -> f64 {
        let n = self.steps();
        if self.lost {
            return f64::INFINITY;
        }
        if n == 0 {
            return 1.0;
        }
        let side = |i: usize| if i < n - 1 { self.beside[i].sqrt() } else { 0.0 };
        let reach = |i: usize| side(i) + if i > 0 { side(i - 1) } else { 0.0 };
        let top = (0..n).map(|i| self.diagonal[i] + reach(i)).fold(0.0, f64::max);
        let (least, most) = (self.eigenvalue(0, top), self.eigenvalue(n - 1, top));
        if least > 0.0 { (most / least).sqrt() } else { f64::INFINITY }
    }

    /// The eigenvalue with `index` smaller ones, all of which lie in `0..=top`, by counting sign changes (Sturm) and
    /// halving.
    fn eigenvalue(&self, index: usize, top: f64) -> f64 {
        let (mut low, mut high) = (0.0, top);
        for _ in 0..80 {
            let middle = if low > 0.0 { (low * high).sqrt() } else { high * 1e-3 };
            if middle <= f64::MIN_POSITIVE || middle <= low || middle >= high {
                break;
            }
            if self.below(middle) > index { high = middle } else { low = middle }
        }
        high
    }

    /// How many eigenvalues are below `value`.
    fn below(&self, value: f64) -> usize {
        let (mut count, mut pivot) = (0, 1.0);
        for i in 0..self.steps() {
            let before = if i > 0 { self.beside[i - 1] / pivot } else { 0.0 };
            pivot = self.diagonal[i] - value - before;
            if pivot == 0.0 {
                pivot = f64::MIN_POSITIVE;
            }
            count += usize::from(pivot < 0.0);
        }
        count
    }
}
