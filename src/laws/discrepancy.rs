//! How evenly points fill: star discrepancy (V18), what it is good for (V19), and elementary intervals (V20).

use crate::error::{Error, Result};
use crate::laws::Law;
use crate::pattern::Pattern;
use crate::pattern::cells::Cells;
use crate::pattern::halton::Halton;
use crate::pattern::hammersley::Hammersley;
use crate::pattern::jittered::Jittered;
use crate::pattern::measure::discrepancy::{star_discrepancy, star_discrepancy_line};
use crate::pattern::measure::elementary::{compositions, unfairness};
use crate::pattern::random::Random;
use crate::pattern::regular::Regular;
use crate::pattern::scrambling::Scrambling;
use crate::pattern::sobol::Sobol;
use crate::pattern::zero_two::ZeroTwo;
use crate::residual::Residual;
use crate::signal::{Signal, from_fn};
use crate::text::Text;

/// What rounding can do to a discrepancy: products and differences of numbers below one, 4ε.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// No `N` points on a line have a star discrepancy below `1/(2N)`, and the centred grid has just that (V18).
///
/// Measured: the difference to `1/(2N)`. Niederreiter 1992, theorem 2.6.
///
/// # Errors
/// No points, or points outside `[0, 1]`.
pub fn least_on_a_line(points: &[f64]) -> Result<Residual> {
    let least = 0.5 / points.len() as f64;
    Ok(Residual::near("D* of a centred grid = 1/(2N)", star_discrepancy_line(points)?, least, ROUNDING))
}

/// The star discrepancy of a centred `n × n` grid is `1/n − 1/(4n²)` (V18): the open box that ends at the last row and
/// column has the area `(1 − 1/(2n))²` and misses both.
///
/// ```
/// use nyquist::laws::discrepancy::grid_discrepancy;
/// use nyquist::prelude::*;
/// assert!(grid_discrepancy(&Regular::new([16, 16])?.points(0), 16)?.holds()); // 0.06152
/// # Ok::<(), Error>(())
/// ```
///
/// # Errors
/// No points, or points outside the unit square.
pub fn grid_discrepancy(points: &[[f64; 2]], n: usize) -> Result<Residual> {
    let step = 1.0 / n as f64;
    let expected = step - 0.25 * step * step;
    Ok(Residual::near("D* of a centred n×n grid = 1/n − 1/(4n²)", star_discrepancy(points)?, expected, ROUNDING))
}

/// The star discrepancy of `N = 2^m ≥ 4` Hammersley points is `(m/3 + 13/9 − (−1)^m·4/(9·2^m))/N` (Halton, Zaremba 1969).
///
/// # Errors
/// No points, or points outside the unit square; a number that is no power of two.
pub fn hammersley_discrepancy(points: &[[f64; 2]]) -> Result<Residual> {
    let (n, m) = (points.len(), points.len().max(1).ilog2());
    if !n.is_power_of_two() {
        let what = "Hammersley points with a known discrepancy";
        return Err(Error::Count { what, given: n, below: 1 << m, above: 2 << m });
    }
    let sign = if m % 2 == 0 { 1.0 } else { -1.0 };
    let (count, m) = (n as f64, f64::from(m));
    let expected = (m / 3.0 + 13.0 / 9.0 - sign * 4.0 / (9.0 * count)) / count;
    Ok(Residual::near("D* of Hammersley's points, Halton–Zaremba", star_discrepancy(points)?, expected, ROUNDING))
}

/// `|∫f − (1/N)Σf(x_i)| ≤ D*·V(f)`: the error of a mean is at most the discrepancy of the points times the variation of
/// the function (Koksma 1942; V19).
///
/// Measured: the error against `integral`. Allowed: `D*` times the `variation` claimed, for a monotone function
/// `|f(1) − f(0)|`, and the rounding `ε·N` of the mean of values of that size.
///
/// # Errors
/// No points, or points outside `[0, 1]`.
pub fn koksma_hlawka(f: &impl Signal, integral: f64, variation: f64, points: &[f64]) -> Result<Residual> {
    let discrepancy = star_discrepancy_line(points)?;
    let n = points.len() as f64;
    let (sum, size) = points.iter().fold((0.0, 0.0), |(sum, size), &x| (sum + f.at(x), size + f.at(x).abs()));
    let bound = discrepancy * variation + f64::EPSILON * (size + integral.abs());
    Ok(Residual::at_most("|∫f − mean| ≤ D*·V(f)", (sum / n - integral).abs(), bound))
}

/// `2^m` points are a (0, m, 2)-net in base 2: one in each box `2^{−a} × 2^{−b}`, for every `a + b = m` (V20).
///
/// Measured: the largest deviation of a box from one point. None is allowed: the faces are binary fractions.
///
/// # Errors
/// No points, or points outside the unit square.
pub fn elementary_intervals(points: &[[f64; 2]]) -> Result<Residual> {
    let m = points.len().max(1).ilog2();
    let divisions = compositions::<2>(m).into_iter().map(|along| Cells::new(along.map(|a| 1 << a)));
    let worst = divisions.map(|cells| unfairness(points, cells?)).try_fold(0.0, |w: f64, u| u.map(|u| w.max(u)))?;
    Ok(Residual::at_most("one point in every elementary interval", worst, 0.0))
}

/// `2^a·3^b` successive points of Halton's sequence have one in each of `2^a × 3^b` boxes (V20).
///
/// # Errors
/// No points, or points outside the unit square; exponents whose boxes are too many.
pub fn halton_boxes(points: &[[f64; 2]], [a, b]: [u32; 2]) -> Result<Residual> {
    let cells = Cells::new([1 << a, 3usize.pow(b)])?;
    Ok(Residual::at_most("one Halton point in each of 2^a × 3^b boxes", unfairness(points, cells)?, 0.0))
}

fn plane(pattern: Result<impl Pattern<2>>) -> Vec<[f64; 2]> {
    pattern.expect("there are points").points(1)
}

fn line(pattern: Result<impl Pattern<1>>) -> Vec<f64> {
    pattern.expect("there are points").points(1).into_iter().map(|[x]| x).collect()
}

fn nets(m: u32) -> [Vec<[f64; 2]>; 5] {
    let n = 1 << m;
    let second = ZeroTwo::new(2 * n).map(|p| p.points(1)[n..].to_vec()); // every run of 2^m, not only the first
    [
        plane(Sobol::new(n)),
        plane(Sobol::new(n).map(|p| p.scrambled(Scrambling::Owen))),
        plane(ZeroTwo::new(n)),
        second.expect("there are points"),
        plane(Hammersley::new(n)),
    ]
}

/// The laws of this theme.
pub static LAWS: &[Law] = &[
    Law {
        name: "grid-discrepancy",
        inventory: &["V18", "F49"],
        says: &Text::fixed(
            "The star discrepancy is 1/(2N) for a centred grid on a line, 1/n − 1/(4n²) for one of n × n",
            "Звёздное расхождение центрированной сетки на отрезке 1/(2N), сетки n × n — 1/n − 1/(4n²)",
        ),
        holds: || {
            let square = |n| grid_discrepancy(&plane(Regular::new([n, n])), n).expect("points in the square");
            let row = |n| least_on_a_line(&line(Regular::new([n]))).expect("points on the line");
            [1, 2, 7, 16, 64].map(square).into_iter().chain([1, 10, 1000].map(row)).collect()
        },
        breaks: || {
            let nodes: Vec<f64> = (0..10).map(|i| f64::from(i) / 10.0).collect();
            let offset = plane(Regular::new([16, 16]).map(Regular::with_random_offset));
            let jittered = plane(Jittered::new([16, 16]));
            vec![
                least_on_a_line(&nodes).expect("points on the line"),
                grid_discrepancy(&offset, 16).expect("points in the square"),
                grid_discrepancy(&jittered, 16).expect("points in the square"),
            ]
        },
    },
    Law {
        name: "hammersley-discrepancy",
        inventory: &["V18", "V20"],
        says: &Text::fixed(
            "The star discrepancy of 2^{m} Hammersley points is (m/3 + 13/9 ∓ 4/(9·2^{m}))/2^{m}",
            "Звёздное расхождение 2^{m} точек Хаммерсли равно (m/3 + 13/9 ∓ 4/(9·2^{m}))/2^{m}",
        ),
        holds: || {
            let check = |m: u32| hammersley_discrepancy(&plane(Hammersley::new(1 << m))).expect("a power of two");
            [2, 3, 4, 7, 10, 13].map(check).into()
        },
        breaks: || vec![hammersley_discrepancy(&plane(Halton::new(256))).expect("a power of two")],
    },
    Law {
        name: "koksma-hlawka",
        inventory: &["V19"],
        says: &Text::fixed(
            "The error of a mean is at most the discrepancy of the points times the variation of the function",
            "Ошибка среднего не больше расхождения точек, умноженного на вариацию функции",
        ),
        holds: || {
            let step = from_fn(|x| f64::from(u8::from(x > 0.3)));
            let exponential = from_fn(f64::exp);
            let growth = 1f64.exp() - 1.0;
            let sets = [
                line(Regular::new([100])),
                line(Random::new(100)),
                line(Jittered::new([100])),
                line(Halton::new(100)),
                vec![0.9],
            ];
            let check = |points: &Vec<f64>| {
                let both =
                    [koksma_hlawka(&step, 0.7, 1.0, points), koksma_hlawka(&exponential, growth, growth, points)];
                both.map(|residual| residual.expect("points on the line"))
            };
            sets.iter().flat_map(check).collect()
        },
        breaks: || {
            // one wave: as much down as up, which f(1) − f(0) does not count
            let wave = from_fn(|x| crate::num::cos_pi(2.0 * x));
            vec![koksma_hlawka(&wave, 0.0, 0.0, &line(Random::new(100))).expect("points on the line")]
        },
    },
    Law {
        name: "elementary-intervals",
        inventory: &["V20"],
        says: &Text::fixed(
            "Any 2^{m} points of a (0,2)-sequence from a multiple of 2^{m} on: one in every box 2^{−a} × 2^{−b}, a + b = m",
            "Любые 2^{m} точек (0,2)-последовательности с кратного 2^{m}: по одной в каждом ящике 2^{−a} × 2^{−b}, a + b = m",
        ),
        holds: || {
            let check = |points: &Vec<[f64; 2]>| elementary_intervals(points).expect("points in the square");
            [4, 6, 8, 12].into_iter().flat_map(|m| nets(m).iter().map(check).collect::<Vec<_>>()).collect()
        },
        breaks: || {
            let late = ZeroTwo::new(257).expect("there are points").points(1)[1..].to_vec(); // from 1 on, not 0
            let sets = [plane(Random::new(256)), plane(Jittered::new([16, 16])), plane(Halton::new(256)), late];
            sets.iter().map(|points| elementary_intervals(points).expect("points in the square")).collect()
        },
    },
    Law {
        name: "halton-boxes",
        inventory: &["V20"],
        says: &Text::fixed(
            "Any 2^{a}3^{b} successive Halton points: one in each of 2^{a} × 3^{b} boxes, scrambled or not",
            "Любые 2^{a}3^{b} последовательных точек Холтона: по одной в каждом из 2^{a} × 3^{b} ящиков, с перемешиванием цифр или без",
        ),
        holds: || {
            let kinds = [Scrambling::None, Scrambling::Digits, Scrambling::Owen];
            let check = |kind| {
                [[4, 2], [1, 3], [7, 0], [5, 4]].map(move |[a, b]: [u32; 2]| {
                    let n = 2usize.pow(a) * 3usize.pow(b);
                    let points = plane(Halton::new(2 * n).map(|p| p.scrambled(kind)));
                    let from = n / 2; // any run
                    halton_boxes(&points[from..from + n], [a, b]).expect("points in the square")
                })
            };
            kinds.into_iter().flat_map(check).collect()
        },
        breaks: || {
            let [sobol, jittered] = [plane(Sobol::new(144)), plane(Jittered::new([12, 12]))];
            [sobol, jittered].map(|points| halton_boxes(&points, [4, 2]).expect("points in the square")).into()
        },
    },
];
