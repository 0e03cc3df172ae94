//! How fast means over points converge: exponents (V14) and constants (V15, V16).

use crate::error::Result;
use crate::laws::Law;
use crate::laws::jitter::deviations;
use crate::num::quadrature::integrate_pieces;
use crate::num::random::uniform;
use crate::num::{cos_pi, sin_pi};
use crate::pattern::Pattern;
use crate::pattern::jittered::Jittered;
use crate::pattern::measure::integration::{Errors, errors, rate};
use crate::pattern::multi_jittered::MultiJittered;
use crate::pattern::n_rooks::NRooks;
use crate::pattern::poisson_disk::PoissonDisk;
use crate::pattern::random::Random;
use crate::pattern::regular::Regular;
use crate::pattern::scrambling::Scrambling;
use crate::pattern::sobol::Sobol;
use crate::residual::Residual;
use crate::text::Text;

/// The variance of a mean over `N` points of one kind falls as `N^exponent` (V14).
///
/// Fits the exponent to measurements at several `N`. Allowed: [`deviations`] of the fit, as the trials show them, and
/// `bias`, what the next term of the law does to the slope at these `N`.
///
/// # Errors
/// Fewer than two measurements, or measurements without error.
pub fn exponent(measured: &[Errors], expected: f64, bias: f64) -> Result<Residual> {
    let fit = rate(measured)?;
    Ok(Residual::near("exponent of the variance", fit.exponent, expected, deviations(1) * fit.deviation + bias))
}

/// The mean square error of one kind of points is `expected` (V15, V16).
///
/// Allowed: [`deviations`] of the mean over the trials, as they show it, and the part `correction` of it that a law which
/// is only asymptotic leaves out.
pub fn mean_square(measured: Errors, expected: f64, correction: f64) -> Residual {
    let bound = deviations(1) * measured.deviation + correction * expected;
    Residual::near("mean square error", measured.mean_square, expected, bound)
}

/// An edge along an axis at a random place: one to its left.
pub fn axis_edge<const D: usize>(seed: u64) -> (impl Fn([f64; D]) -> f64, f64) {
    let edge = uniform(seed, 0, 97);
    (move |p: [f64; D]| f64::from(u8::from(p[0] < edge)), edge)
}

/// An edge in a random direction through a random place of the unit square, and the area behind it.
pub fn random_edge(seed: u64) -> (impl Fn([f64; 2]) -> f64, f64) {
    let [x, y, turn] = [0, 1, 2].map(|k| uniform(seed, k, 98));
    let (c, s) = (cos_pi(2.0 * turn), sin_pi(2.0 * turn));
    let level = c * x + s * y;
    (move |p: [f64; 2]| f64::from(u8::from(c * p[0] + s * p[1] < level)), area_below([c, s], level))
}

/// The area of `{c·x + s·y < level}` within the unit square: a quarter plane for each corner, with signs.
fn area_below([c, s]: [f64; 2], level: f64) -> f64 {
    // reflect both axes so that the normal points up and right
    let level = level - c.min(0.0) - s.min(0.0);
    let (c, s) = (c.abs(), s.abs());
    let (long, short) = (c.max(s), c.min(s));
    let behind = |d: f64| d.max(0.0).powi(2);
    if short < 1e-9 {
        return (level / long).clamp(0.0, 1.0); // the triangles' areas would cancel
    }
    (behind(level) - behind(level - c) - behind(level - s) + behind(level - c - s)) / (2.0 * c * s)
}

/// `lim N^{3/2}·MSE` of jitter for [`random_edge`]: 0.16310.
///
/// A line with normal at angle `θ`, `t = tan θ`, that crosses a unit cell leaves the variance `∫ F(1 − F)` of one point
/// behind it, `(1/6 + t²/12 − t³/60)·cos θ` for `0 ≤ θ ≤ π/4`; lines through uniform places cross cells with the
/// density `∫g²` of the square's projection `g`, `(1 − t/3)/cos θ`. The mean of the product over all directions.
pub fn jitter_edge_constant() -> f64 {
    let quarter = std::f64::consts::FRAC_PI_4;
    let product = |angle: f64| {
        let t = angle.tan();
        (1.0 / 6.0 + t * t / 12.0 - t * t * t / 60.0) * (1.0 - t / 3.0)
    };
    integrate_pieces(product, &[0.0, quarter], 1e-14).value / quarter
}

/// `e^{x+y}`, whose mean square gradient is `(e² − 1)²/2`, so that jitter has `N²·Var → (e² − 1)²/24 = 1.70083` (V16).
fn smooth<const D: usize>(_: u64) -> (impl Fn([f64; D]) -> f64, f64) {
    (|p: [f64; D]| p.iter().sum::<f64>().exp(), 1f64.exp_m1().powi(D as i32))
}

/// One period of a cosine along x, at a random phase.
fn wave(seed: u64) -> (impl Fn([f64; 2]) -> f64, f64) {
    let phase = 2.0 * uniform(seed, 0, 96);
    (move |p: [f64; 2]| cos_pi(2.0 * p[0] + phase), 0.0)
}

/// Trials of patterns that cost nothing, and of those that do.
const TRIALS: u32 = 1500;
const FEW: u32 = 150;

fn measure<const D: usize, F: Fn([f64; D]) -> f64>(
    pattern: Result<impl Pattern<D>>,
    problem: impl Fn(u64) -> (F, f64),
) -> Errors {
    errors(&pattern.expect("there are points"), 21, TRIALS, problem).expect("more than one trial")
}

/// Errors at 64, 256 and 1024 points.
fn series<const D: usize, P: Pattern<D>, F: Fn([f64; D]) -> f64>(
    pattern: fn(usize) -> Result<P>,
    problem: impl Fn(u64) -> (F, f64) + Copy,
) -> [Errors; 3] {
    [64, 256, 1024].map(|n| measure(pattern(n), problem))
}

fn disks() -> [Errors; 3] {
    let measure = |n| errors(&PoissonDisk::with_about(n).expect("enough points"), 21, FEW, wave);
    [64, 256, 1024].map(|n| measure(n).expect("more than one trial"))
}

/// What a next term of relative size `1/n`, `n²` points, does to the slope between 64 and 1024 points: less than
/// `ln(1 + 1/8)/ln 16`, and about a third of that for the fit.
const BIAS: f64 = 0.015;

fn slope(measured: [Errors; 3], expected: f64) -> Residual {
    exponent(&measured, expected, BIAS).expect("errors at three numbers of points")
}

fn square(n: usize) -> Result<Jittered<2>> {
    Jittered::with_count(n)
}

fn line(n: usize) -> Result<Jittered<1>> {
    Jittered::with_count(n)
}

/// The laws of this theme.
pub static LAWS: &[Law] = &[
    Law {
        name: "variance-rates",
        inventory: &["V14"],
        says: &Text::fixed(
            "Random points: N^{−1}. Jitter in d dimensions: N^{−1−2/d} for smooth functions, N^{−1−1/d} for edges",
            "Независимые точки: N^{−1}. Джиттер в d измерениях: N^{−1−2/d} для гладких функций, N^{−1−1/d} для границ",
        ),
        holds: || {
            vec![
                slope(series(Random::new, smooth::<1>), -1.0),
                slope(series(Random::new, smooth::<2>), -1.0),
                slope(series(Random::new, random_edge), -1.0),
                slope(series(line, smooth::<1>), -3.0),
                slope(series(line, axis_edge::<1>), -2.0),
                slope(series(square, smooth::<2>), -2.0),
                slope(series(square, random_edge), -1.5),
                slope(series(Regular::with_count, axis_edge::<2>), -1.0),
            ]
        },
        breaks: || {
            vec![
                slope(series(Random::new, smooth::<2>), -2.0),
                slope(series(square, random_edge), -2.0), // an edge is not smooth
                slope(series(square, smooth::<2>), -1.0),
                slope(disks(), -2.0), // blue noise, but with a plateau
            ]
        },
    },
    Law {
        name: "scrambled-net-rate",
        inventory: &["V14", "V20"],
        says: &Text::fixed(
            "Owen's scrambling of Sobol's points: nearly N^{−3} for smooth functions; Poisson disks only N^{−1}",
            "Перемешивание Оуэна для точек Соболя: почти N^{−3} для гладких функций; у пуассоновских дисков лишь N^{−1}",
        ),
        holds: || {
            let owen = |n| Sobol::new(n).map(|p| p.scrambled(Scrambling::Owen));
            // N⁻³ ln N: the logarithm adds ln(ln 1024/ln 64)/ln 16 = 0.18 to the slope
            let nets = exponent(&series(owen, smooth::<2>), -2.9, 0.1).expect("errors at three numbers of points");
            vec![nets, slope(disks(), -1.0)]
        },
        breaks: || {
            let check = |measured: [Errors; 3]| exponent(&measured, -2.9, 0.1).expect("errors at three numbers");
            vec![check(series(square, smooth::<2>)), check(series(NRooks::new, smooth::<2>))]
        },
    },
    Law {
        name: "edge-constants",
        inventory: &["V15"],
        says: &Text::fixed(
            "An edge along an axis: random 1/(6N), regular 1/(12N), jitter 1/(6N^{3/2}), N rooks and multi-jitter 1/(6N²)",
            "Граница вдоль оси: независимые 1/(6N), регулярные 1/(12N), джиттер 1/(6N^{3/2}), N ладей и мультиджиттер 1/(6N²)",
        ),
        holds: || {
            let n = 64.0f64;
            let limit = jitter_edge_constant();
            vec![
                mean_square(measure(Random::new(64), axis_edge::<2>), 1.0 / (6.0 * n), 0.0),
                mean_square(measure(Regular::new([8, 8]), axis_edge::<2>), 1.0 / (12.0 * n), 0.0),
                mean_square(measure(square(64), axis_edge::<2>), n.powf(-1.5) / 6.0, 0.0),
                mean_square(measure(NRooks::new(64), axis_edge::<2>), n.powi(-2) / 6.0, 0.0),
                mean_square(measure(MultiJittered::new([8, 8]), axis_edge::<2>), n.powi(-2) / 6.0, 0.0),
                mean_square(measure(line(64), axis_edge::<1>), n.powi(-2) / 6.0, 0.0),
                // cells at the square's edge are crossed as others are: the correction is that of the density, O(1/n)
                mean_square(measure(square(1024), random_edge), 1024f64.powf(-1.5) * limit, 1.0 / 32.0),
            ]
        },
        breaks: || {
            let n = 64.0f64;
            vec![
                mean_square(measure(square(64), axis_edge::<2>), 1.0 / (6.0 * n), 0.0),
                mean_square(measure(NRooks::new(64), axis_edge::<2>), n.powf(-1.5) / 6.0, 0.0),
                mean_square(measure(Random::new(64), axis_edge::<2>), 1.0 / (12.0 * n), 0.0),
                // any edge is not one along an axis
                mean_square(measure(NRooks::new(64), random_edge), n.powi(-2) / 6.0, 0.0),
            ]
        },
    },
    Law {
        name: "jitter-constant",
        inventory: &["V16"],
        says: &Text::fixed(
            "Jitter: Var → N^{−1−2/d}·∫|∇f|²/12; for e^{x+y} N²·Var → 1.7008",
            "Джиттер: Var → N^{−1−2/d}·∫|∇f|²/12; для e^{x+y} N²·Var → 1,7008",
        ),
        holds: || {
            let plane = 2f64.exp_m1().powi(2) / 24.0;
            let line_constant = 2f64.exp_m1() / 24.0;
            // the sum over cells is a midpoint rule: corrections of order 1/n², with n cells along an axis
            vec![
                mean_square(measure(square(256), smooth::<2>), plane / 256f64.powi(2), 1.0 / 256.0),
                mean_square(measure(square(1024), smooth::<2>), plane / 1024f64.powi(2), 1.0 / 1024.0),
                mean_square(measure(line(64), smooth::<1>), line_constant / 64f64.powi(3), 1.0 / 4096.0),
            ]
        },
        breaks: || {
            let plane = 2f64.exp_m1().powi(2) / 24.0;
            let half = square(256).and_then(|p| p.with_width(0.5));
            vec![mean_square(measure(half, smooth::<2>), plane / 256f64.powi(2), 1.0 / 256.0)]
        },
    },
];
