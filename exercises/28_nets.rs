//! Counting in elementary intervals.

// %% en F54
// # Is it a (0, 2)-net?
//
// 2^m points of the unit square are a (0, m, 2)-net in base 2 if every elementary interval of area 2^(−m) holds exactly one
// of them: for every a from 0 to m the square is cut into 2^a columns and 2^(m−a) rows. Count the intervals, over all a,
// that do not hold exactly one point. (Intervals contain their left and lower edge.)
// %% ru
// # Сеть ли это?
//
// 2^m точек единичного квадрата — (0, m, 2)-сеть по основанию 2, если в каждом элементарном интервале площади 2^(−m) ровно
// одна точка: при каждом a от 0 до m квадрат режут на 2^a столбцов и 2^(m−a) строк. Сосчитайте по всем a интервалы, в
// которых не ровно одна точка. (Левый и нижний края интервалу принадлежат.)
// %% hint en
// For one a: a list of 2^m counters; point (x, y) belongs to column ⌊x·2^a⌋ and row ⌊y·2^(m−a)⌋.
// %% hint ru
// При одном a: список из 2^m счётчиков; точка (x, y) — в столбце ⌊x·2^a⌋ и строке ⌊y·2^(m−a)⌋.
// %% hint en
// Count the counters that differ from one, and sum over a = 0, …, m: both ends belong to it.
// %% hint ru
// Сосчитайте счётчики, не равные единице, и сложите по a = 0, …, m, включая оба конца.

// %% answer
// %% ru В скольких элементарных интервалах не ровно одна из 2^m точек.
/// How many elementary intervals do not hold exactly one of the 2^m points.
pub fn unfair(points: &[[f64; 2]], m: u32) -> usize {
    // %% start 0
    let mut unfair = 0;
    for a in 0..=m {
        let (columns, rows) = (1 << a, 1 << (m - a));
        let mut counts = vec![0; columns * rows];
        for [x, y] in points {
            let (column, row) = ((x * columns as f64) as usize, (y * rows as f64) as usize);
            counts[row * columns + column] += 1;
        }
        unfair += counts.iter().filter(|count| **count != 1).count();
    }
    unfair
    // %% end
}

// %% check
use nyquist::exercise::{Line, Mistake};
use nyquist::prelude::{Hammersley, Jittered, Pattern, Random, Regular, Sobol};
use nyquist::text;

pub type Answer = fn(&[[f64; 2]], u32) -> usize;
pub const ANSWER: Answer = unfair;

/// How many points lie in column i of 2^a and row k of 2^(m−a).
fn held(points: &[[f64; 2]], [a, m]: [u32; 2], [i, k]: [u32; 2]) -> usize {
    let inside = |x: f64, part: u32, i: u32| {
        let width = 0.5_f64.powi(part as i32);
        (f64::from(i) * width..f64::from(i + 1) * width).contains(&x)
    };
    points.iter().filter(|[x, y]| inside(*x, a, i) && inside(*y, m - a, k)).count()
}

/// How many intervals of those divisions hold so many points.
fn count(points: &[[f64; 2]], m: u32, divisions: impl Iterator<Item = u32>, bad: fn(usize) -> bool) -> usize {
    let of = |a: u32| (0..1 << a).flat_map(move |i| (0..1 << (m - a)).map(move |k| (a, [i, k])));
    divisions.flat_map(of).filter(|(a, cell)| bad(held(points, [*a, m], *cell))).count()
}

pub const MISTAKES: [Mistake<Answer>; 4] = [
    Mistake::new(
        |points, m| count(points, m, std::iter::once(m / 2), |held| held != 1),
        "Only one division is counted, the squares. All divisions into 2^a columns and 2^(m−a) rows belong to it.",
        "Сосчитано одно деление, на квадраты. Нужны все деления на 2^a столбцов и 2^(m−a) строк.",
    ),
    Mistake::new(
        |points, m| count(points, m, 0..=m, |held| held == 0),
        "Those are the empty intervals; those with two points and more are unfair as well.",
        "Это пустые интервалы; те, где точек две и больше, тоже считаются.",
    ),
    Mistake::new(
        |points, m| count(points, m, 0..=m, |held| held > 1),
        "Those are the crowded intervals; empty ones are unfair as well.",
        "Это переполненные интервалы; пустые тоже считаются.",
    ),
    Mistake::new(
        |points, m| count(points, m, 0..m, |held| held != 1),
        "One division is missing: a runs up to m, where every point has a column of its own.",
        "Не хватает одного деления: a доходит до m, когда у каждой точки свой столбец.",
    ),
];

pub fn demands(unfair: Answer) -> Vec<Line> {
    const M: u32 = 4;
    let points = |pattern: nyquist::error::Result<Box<dyn Pattern<2>>>| {
        pattern.map(|pattern| pattern.points(3)).expect("there are such patterns of sixteen points")
    };
    let patterns = [
        ("hammersley", points(Hammersley::new(16).map(|p| Box::new(p) as _))),
        ("sobol", points(Sobol::new(16).map(|p| Box::new(p) as _))),
        ("regular", points(Regular::new([4, 4]).map(|p| Box::new(p) as _))),
        ("jittered", points(Jittered::new([4, 4]).map(|p| Box::new(p) as _))),
        ("random", points(Random::new(16).map(|p| Box::new(p) as _))),
    ];
    // each interval asked by itself
    let ask = |line: Line, patterns: &[(&str, Vec<[f64; 2]>)]| {
        patterns.iter().fold(line, |line, (name, points)| {
            let truth = count(points, M, 0..=M, |held| held != 1);
            line.case(format!("unfair({name}, {M})"), unfair(points, M) as f64, truth as f64)
        })
    };
    vec![
        ask(Line::new(text!("nets have none", "у сетей таких нет"), 0.0), &patterns[..2]),
        ask(Line::new(text!("others have some", "у других есть"), 0.0), &patterns[2..]),
    ]
}
