//! Elementary intervals: one point in every box of every division.

use crate::error::Result;
use crate::figure::params::{Param, Params};
use crate::figure::patterns::square::{SEED, SEEDS, boxes_panel, for_all_seeds};
use crate::figure::{Entry, Figure, Layer, Meaning};
use crate::laws::discrepancy::elementary_intervals;
use crate::pattern::Pattern;
use crate::pattern::cells::Cells;
use crate::pattern::jittered::Jittered;
use crate::pattern::measure::elementary::occupancy;
use crate::pattern::measure::periodogram::pattern_seed;
use crate::pattern::zero_two::ZeroTwo;
use crate::residual::Residual;
use crate::text;
use crate::text::{Text, number};

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[ELEMENTARY];

const ELEMENTARY: Entry = Entry {
    id: "x-elementary",
    inventory: &[],
    errata: &[],
    title: &Text::fixed("One point in every elementary interval", "По точке в каждом элементарном интервале"),
    caption: &Text::fixed(
        "The same 16 points of a (0,2)-sequence in five divisions of the square into 16 boxes: each box of each division holds \
         exactly one. That is jitter and N rooks at once, and all that is in between. Sixteen jittered points, last, keep only \
         the division 4 × 4; of 16 columns about five stay empty (shaded).",
        "Одни и те же 16 точек (0,2)-последовательности в пяти разбиениях квадрата на 16 ящиков: в каждом ящике каждого \
         разбиения ровно одна. Это сразу и джиттер, и N ладей, и всё, что между ними. Шестнадцать точек с джиттером \
         (последний рисунок) соблюдают лишь разбиение 4 × 4: из 16 столбцов пусты около пяти (закрашены).",
    ),
    params: &[Param::count("seed", &SEED, 1, 1, SEEDS)],
    build: |params| elementary(params),
};

fn elementary(params: &Params) -> Result<Figure> {
    const TRIALS: u32 = 2000;
    let seed = params.count("seed") as u64;
    let points = ZeroTwo::new(16)?.points(seed);
    let jitter = Jittered::<2>::new([4, 4])?;
    let columns = Cells::new([16, 1])?;
    let mut figure = Figure::new(3);
    for (name, [across, up]) in
        [("1x16", [1, 16]), ("2x8", [2, 8]), ("4x4", [4, 4]), ("8x2", [8, 2]), ("16x1", [16, 1])]
    {
        figure = figure.with(boxes_panel(name, text!("{across} × {up}", "{across} × {up}"), [across, up], &points));
    }
    let drawn = jitter.points(pattern_seed(seed, 0));
    let counts = occupancy(&drawn, columns)?;
    let empty = |points: &[[f64; 2]]| Ok(occupancy(points, columns)?.iter().filter(|&&c| c == 0).count() as f64);
    let empties = (0..TRIALS).map(|t| empty(&jitter.points(pattern_seed(seed, t)))).collect::<Result<Vec<f64>>>()?;
    let mean = empties.iter().sum::<f64>() / f64::from(TRIALS);
    // four points into the four columns of each column of cells: one stays empty with (3/4)⁴, two with (2/4)⁴
    let (one, two) = (0.75f64.powi(4), 0.5f64.powi(4));
    let (expected, variance) = (16.0 * one, 4.0 * (4.0 * one + 12.0 * two - (4.0 * one).powi(2)));
    let gaps = counts.iter().zip(0..).filter(|(count, _)| **count == 0).map(|(_, i)| i);
    let gaps: Vec<[f64; 2]> = gaps.map(|i| [f64::from(i), f64::from(i) + 1.0].map(|c| c / 16.0)).collect();
    let title = text!("jitter: {} columns empty", "джиттер: пусто {} из 16", gaps.len());
    let mut last = boxes_panel("jittered", title, [16, 1], &drawn);
    last.layers.insert(0, Layer::spans("empty", Meaning::Error, gaps));
    Ok(figure
        .with(last)
        .claim(
            text!(
                "(0,2): one point in each box of all five divisions",
                "(0,2): по точке в каждом ящике всех пяти разбиений"
            ),
            elementary_intervals(&points)?,
        )
        .claim(
            text!(
                "jitter leaves on average {} of 16 columns empty; theory 16·(3/4)⁴ = {}",
                "у джиттера в среднем пусты {} из 16 столбцов; теория 16·(3/4)⁴ = {}",
                number(mean, 3),
                number(expected, 3)
            ),
            Residual::near(
                "empty columns of jitter = 16·(3/4)⁴",
                mean,
                expected,
                for_all_seeds(1) * (variance / f64::from(TRIALS)).sqrt(),
            ),
        ))
}
