//! Random, regular and jittered points side by side (slide «Стратифицированный сэмплинг»).

use crate::error::Result;
use crate::figure::params::{Param, Params};
use crate::figure::patterns::square::{SEED, SEEDS, boxes_panel, for_all_seeds, mean, power_panel};
use crate::figure::{Bar, Entry, Figure, Layer, Meaning};
use crate::laws::discrepancy::grid_discrepancy;
use crate::pattern::Pattern;
use crate::pattern::cells::Cells;
use crate::pattern::jittered::Jittered;
use crate::pattern::measure::discrepancy::star_discrepancy;
use crate::pattern::measure::distance::min_distance;
use crate::pattern::measure::elementary::{occupancy, unfairness};
use crate::pattern::measure::periodogram::{Periodogram, pattern_seed};
use crate::pattern::random::Random;
use crate::pattern::regular::Regular;
use crate::residual::Residual;
use crate::text;
use crate::text::{Text, number};

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[STRATIFIED];

const STRATIFIED: Entry = Entry {
    id: "f49-stratified",
    inventory: &["F49"],
    errata: &["E11"],
    title: &Text::fixed("256 points: random, regular, jittered", "256 точек: случайные, сетка, джиттер"),
    caption: &Text::fixed(
        "Independent points cluster: more than a third of the cells stay empty (crossed out), and their noise is white. The \
         grid has one point in every cell, but its spectrum is spikes: aliases are copies. One random point in every cell \
         joins both: no spikes, little noise at low frequencies, and the lowest star discrepancy of the three.",
        "Независимые точки сбиваются в кучи: более трети ячеек пусты (перечёркнуты), а шум белый. У сетки по точке в каждой \
         ячейке, но её спектр — пики: алиасы становятся копиями. Одна случайная точка в ячейке соединяет оба достоинства: \
         пиков нет, шума на низких частотах мало, а звёздное расхождение — наименьшее из трёх.",
    ),
    params: &[Param::count("seed", &SEED, 1, 1, SEEDS)],
    build: |params| stratified(params),
};

/// The largest frequency: two spikes of the grid on every side of zero, and a margin.
const REACH: usize = 5 * SIDE / 2;
/// Cells along a side.
const SIDE: usize = 16;
/// How many patterns means are taken over.
const PATTERNS: u32 = 60;

/// Crosses through the cells that hold no point.
fn crosses(counts: &[u32]) -> Layer {
    let crossed = counts.iter().enumerate().filter(|(_, count)| **count == 0).flat_map(|(i, _)| {
        let at = |dx: f64, dy: f64| [(i % SIDE) as f64 + dx, (i / SIDE) as f64 + dy].map(|c| c / SIDE as f64);
        [at(0.25, 0.25), at(0.75, 0.75), [f64::NAN; 2], at(0.25, 0.75), at(0.75, 0.25), [f64::NAN; 2]]
    });
    Layer::line("empty", Meaning::Error, crossed)
}

fn stratified(params: &Params) -> Result<Figure> {
    let seed = params.count("seed") as u64;
    let cells = Cells::new([SIDE, SIDE])?;
    let n = cells.total() as f64;
    let (random, grid, jittered) =
        (Random::new(cells.total())?, Regular::new([SIDE, SIDE])?, Jittered::new([SIDE, SIDE])?);
    let kinds: [(&'static str, &'static str, Text, Text, &dyn Pattern<2>); 3] = [
        (
            "random",
            "random-power",
            text!("(a) random, × is empty", "(а) случайные, × — пусто"),
            text!("white noise", "белый шум"),
            &random,
        ),
        ("grid", "grid-power", text!("(b) regular", "(б) сетка"), text!("spikes", "пики"), &grid),
        (
            "jittered",
            "jittered-power",
            text!("(c) jittered", "(в) джиттер"),
            text!("little noise near zero", "у нуля шума мало"),
            &jittered,
        ),
    ];
    let mut figure = Figure::new(3);
    for (name, _, title, _, pattern) in &kinds {
        let points = pattern.points(pattern_seed(seed, 0));
        let counts = occupancy(&points, cells)?;
        let panel = boxes_panel(name, title.clone(), [SIDE, SIDE], &points);
        figure = figure.with(if counts.contains(&0) { panel.with(crosses(&counts)) } else { panel });
    }
    for (_, name, _, title, pattern) in &kinds {
        let patterns = if *name == "grid-power" { 1 } else { PATTERNS };
        let found = Periodogram::mean(*pattern, seed, patterns, REACH)?;
        let mut panel = power_panel(name, title.clone(), &found, SIDE as f64, (0.0, 1.5));
        if *name == "grid-power" {
            let far = REACH as i64;
            let all = (-far..=far).flat_map(|v| (-far..=far).map(move |u| [u, v]));
            let lines = all.filter(|[u, v]| found.at(*u, *v) > 0.5 * n).map(|f| f.map(|f| f as f64 / SIDE as f64));
            panel = panel.with(Layer::dots("lines", Meaning::Replica, lines));
        }
        // one scale for all three
        figure = figure.with(if *name == "jittered-power" { panel.bar(Bar::values(Text::EMPTY)) } else { panel });
    }

    let of =
        |pattern: &dyn Pattern<2>| (0..PATTERNS).map(|p| pattern.points(pattern_seed(seed, p))).collect::<Vec<_>>();
    let (loose, strict) = (of(&random), of(&jittered));
    let discrepancies = |sets: &[Vec<[f64; 2]>]| sets.iter().map(|p| star_discrepancy(p)).collect::<Result<Vec<_>>>();
    let [d_random, e_random] = mean(&discrepancies(&loose)?);
    let [d_jittered, e_jittered] = mean(&discrepancies(&strict)?);
    let regular = grid.points(0);
    let d_grid = star_discrepancy(&regular)?;
    let empty = |points: &Vec<[f64; 2]>| Ok(occupancy(points, cells)?.iter().filter(|&&c| c == 0).count() as f64 / n);
    let empties = loose.iter().map(empty).collect::<Result<Vec<_>>>()?;
    let [part, _] = mean(&empties);
    // each cell is missed by all with the probability q, two given cells with r
    let (q, r) = ((1.0 - 1.0 / n).powf(n), (1.0 - 2.0 / n).powf(n));
    let variance = (n * q + n * (n - 1.0) * r - (n * q).powi(2)) / (n * n);
    let mut unfair = unfairness(&regular, cells)?;
    for points in &strict {
        unfair = unfair.max(unfairness(points, cells)?);
    }
    let distance = |points: &[[f64; 2]]| min_distance(points);
    let z = for_all_seeds(1);
    Ok(figure
        .claim(
            text!(
                "(a) on average {} % of the cells are empty; theory (1 − 1/N)^{{N}} ≈ e^{{−1}}: {} %",
                "(а) в среднем пусты {} % ячеек; теория (1 − 1/N)^{{N}} ≈ e^{{−1}}: {} %",
                number(100.0 * part, 3),
                number(100.0 * q, 3)
            ),
            Residual::near("empty cells of independent points", part, q, z * (variance / f64::from(PATTERNS)).sqrt()),
        )
        .claim(
            text!("(b), (c) every cell has exactly one point", "(б), (в) в каждой ячейке ровно одна точка"),
            Residual::at_most("one point in every cell", unfair, 0.0),
        )
        .claim(
            text!(
                "the star discrepancy of the grid is 1/n − 1/(4n²) = {}",
                "звёздное расхождение сетки 1/n − 1/(4n²) = {}",
                number(d_grid, 4)
            ),
            grid_discrepancy(&regular, SIDE)?,
        )
        .claim(
            text!(
                "that of jitter is lower, on average {}; that of random points {}",
                "у джиттера оно ниже, в среднем {}; у случайных точек {}",
                number(d_jittered, 2),
                number(d_random, 2)
            ),
            Residual::at_most(
                "D*: jitter below the grid and below random points, with its statistical error",
                (d_jittered + z * e_jittered) / d_grid.min(d_random - z * e_random),
                1.0,
            ),
        )
        .claim(
            text!(
                "least distances: random {}, grid 1/16 = {}, jitter {}",
                "наименьшие расстояния: случайные {}, сетка 1/16 = {}, джиттер {}",
                number(distance(&loose[0])?, 2),
                number(distance(&regular)?, 4),
                number(distance(&strict[0])?, 2)
            ),
            Residual::near(
                "least distance in a grid = 1/n",
                distance(&regular)?,
                1.0 / SIDE as f64,
                2.0 * f64::EPSILON,
            ),
        ))
}
