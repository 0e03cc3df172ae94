//! A tilted square, sampled in seven ways (after a study in Levoy's course CS248).

use crate::antialias::supersample::supersample;
use crate::error::Result;
use crate::field::polygon::ConvexPolygon;
use crate::field::{ExactMean, Field};
use crate::figure::params::{Param, Params};
use crate::figure::picture::picture;
use crate::figure::{Entry, Figure};
use crate::grid::Grid;
use crate::image::Image;
use crate::kernel::box_kernel::BoxKernel;
use crate::laws::jitter::deviations;
use crate::num::{cos_pi, sin_pi};
use crate::pattern::Pattern;
use crate::pattern::jittered::Jittered;
use crate::pattern::regular::Regular;
use crate::residual::Residual;
use crate::text;
use crate::text::{Text, number};

static STEEP: Text = Text::fixed("tilt of the upper square", "наклон верхнего квадрата");
static FLAT: Text = Text::fixed("tilt of the lower square", "наклон нижнего квадрата");
static SEED: Text = Text::fixed("seed of the jitter", "начальное число джиттера");

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[TILTED];

const TILTED: Entry = Entry {
    id: "x-tilted-square",
    inventory: &["F33", "F40"],
    errata: &["E11"],
    title: &Text::fixed("A tilted square: how many samples, and where", "Наклонный квадрат: сколько отсчётов и где"),
    caption: &Text::fixed(
        "A tilted square, with n×n samples a pixel averaged; the number is the RMSE to the exact coverage. At \
         20° a regular grid does best: the edge meets its samples one by one. At 2° it meets a whole row at once, so that \
         n×n samples give little more than n + 1 greys, and stairs; jittered samples give all greys, and with 7×7 the smaller \
         error: which is better depends on the scene.",
        "Наклонённый квадрат, среднее n×n отсчётов на пиксель; число — СКО от точного покрытия. При 20° лучше \
         всего регулярная сетка: граница встречает её отсчёты по одному. При 2° — сразу целый ряд: n×n отсчётов дают чуть \
         больше n + 1 градаций и ступени; отсчёты с джиттером дают все градации, а при 7×7 и меньшую ошибку. Что лучше, \
         зависит от сцены.",
    ),
    params: &[
        Param::real("steep", &STEEP, 20.0, 10.0, 45.0, "°"),
        Param::real("flat", &FLAT, 2.0, 1.0, 9.0, "°"),
        Param::count("seed", &SEED, 1, 1, 100),
    ],
    build: tilted,
};

/// Pixels along a side of the picture, and of the square.
const SIDE: usize = 32;
const SQUARE: f64 = 20.0;

/// What stands in a column: its panels' names in both rows, how many samples along each axis, and whether jittered.
const WAYS: [([&str; 2], usize, bool); 5] = [
    (["steep-1", "flat-1"], 1, false),
    (["steep-3", "flat-3"], 3, false),
    (["steep-7", "flat-7"], 7, false),
    (["steep-3-jittered", "flat-3-jittered"], 3, true),
    (["steep-7-jittered", "flat-7-jittered"], 7, true),
];

fn square(degrees: f64) -> Result<ConvexPolygon> {
    let half = 0.5 * SQUARE;
    let (c, s) = (cos_pi(degrees / 180.0), sin_pi(degrees / 180.0));
    let corners = [[-half, -half], [half, -half], [half, half], [-half, half]];
    ConvexPolygon::new(&corners.map(|[x, y]| [16.1 + c * x - s * y, 15.8 + s * x + c * y]))
}

/// The mean of the samples in every pixel.
fn sampled(scene: &(impl Field + Sync), n: usize, jittered: bool, seed: u64) -> Result<Image> {
    let pattern: Box<dyn Pattern<2>> =
        if jittered { Box::new(Jittered::new([n, n])?) } else { Box::new(Regular::new([n, n])?) };
    supersample(scene, Grid::pixels(SIDE, SIDE)?, &pattern, &BoxKernel, seed)
}

/// What theory says of the mean squared error of `n × n` samples a pixel.
struct Expected {
    /// The mean for jittered samples, and its standard deviation.
    jittered: [f64; 2],
    /// The most that any samples, one a cell, can have.
    most: f64,
}

/// From the exact coverage `c` of every cell: a jittered sample in it is one with probability `c`, so that a pixel's error
/// is a sum of independent variables of variance `c(1 − c)/n⁴`.
fn expected(scene: &impl ExactMean, n: usize) -> Expected {
    let pixels = (SIDE * SIDE) as f64;
    let (mut mean, mut variance, mut most) = (0.0, 0.0, 0.0);
    let step = 1.0 / n as f64;
    for (j, i) in (0..SIDE).flat_map(|j| (0..SIDE).map(move |i| (j as f64, i as f64))) {
        let (mut v, mut excess, mut reach) = (0.0, 0.0, 0.0);
        for (b, a) in (0..n).flat_map(|b| (0..n).map(move |a| (b as f64, a as f64))) {
            let (x, y) = (i + a * step, j + b * step);
            let c = scene.mean([x, x + step], [y, y + step]);
            let spread = c * (1.0 - c);
            v += spread;
            // the fourth moment less three times the square of the variance
            excess += spread * (1.0 - 6.0 * spread);
            reach += if spread > 0.0 { c.max(1.0 - c) } else { 0.0 };
        }
        let cells = (n * n) as f64;
        mean += v / cells.powi(2);
        // Var e² = E e⁴ − v² = excess + 3v² − v²
        variance += (excess + 2.0 * v * v) / cells.powi(4);
        most += (reach / cells).powi(2);
    }
    Expected { jittered: [mean / pixels, variance.sqrt() / pixels], most: most / pixels }
}

fn tilted(params: &Params) -> Result<Figure> {
    let seed = params.count("seed") as u64;
    let mut figure = Figure::new(WAYS.len());
    let mut claims = Vec::new();
    for (row, degrees) in [params.real("steep"), params.real("flat")].into_iter().enumerate() {
        let scene = square(degrees)?;
        let exact = Image::averaged(&scene, Grid::pixels(SIDE, SIDE)?);
        let mut errors = Vec::with_capacity(WAYS.len());
        for (column, (names, n, jittered)) in WAYS.into_iter().enumerate() {
            let image = sampled(&scene, n, jittered, seed)?;
            let error = image.rmse(&exact)?;
            errors.push(error);
            let shown = format!("{error:.4}");
            let angle = number(degrees, 3);
            let title = match (column, jittered) {
                (0, _) => text!("{angle}°, 1×1: {shown}", "{angle}°, 1×1: {shown}"),
                (_, false) => text!("{n}×{n}: {shown}", "{n}×{n}: {shown}"),
                (_, true) => text!("{n}×{n} jitter: {shown}", "{n}×{n} джиттер: {shown}"),
            };
            figure = figure.with(picture(names[row], title, &image));
        }
        for (n, regular, jittered) in [(3, 1, 3), (7, 2, 4)] {
            let theory = expected(&scene, n);
            let [mean, deviation] = theory.jittered;
            let angle = number(degrees, 3);
            claims.push((
                text!(
                    "{angle}°, {n}×{n} jittered: RMSE {}, expected {}; regular {}",
                    "{angle}°, {n}×{n} с джиттером: СКО {}, ожидается {}; регулярно {}",
                    number(errors[jittered], 3),
                    number(mean.sqrt(), 3),
                    number(errors[regular], 3)
                ),
                // sums of over a hundred independent errors: all but normal, six deviations for all seeds and tilts
                Residual::near(
                    "MSE of jittered samples = Σ c(1 − c)",
                    errors[jittered].powi(2),
                    mean,
                    deviations(10_000) * deviation,
                ),
            ));
            claims.push((
                text!(
                    "{angle}°, {n}×{n} regular: no cell errs by more than its coverage allows",
                    "{angle}°, {n}×{n} регулярно: ни одна ячейка не ошибается больше, чем позволяет её покрытие"
                ),
                Residual::at_most("MSE of samples, one a cell", errors[regular].powi(2), theory.most),
            ));
        }
    }
    Ok(claims.into_iter().fold(figure, |figure, (says, residual)| figure.claim(says, residual)))
}
