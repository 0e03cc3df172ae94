//! Jittered samples.

// %% en F39 F49
// # Jitter
//
// Divide the interval from 0 to 1 into as many equal cells as there are random numbers, each of them from 0 up to, but not
// including, 1, and put one sample into every cell, anywhere in it with equal probability.
// %% ru
// # Джиттер
//
// Разделите отрезок от 0 до 1 на столько равных ячеек, сколько дано случайных чисел (каждое от 0 до 1, не включая 1), и
// поставьте в каждую ячейку по отсчёту — равновероятно в любом её месте.
// %% hint en
// Cell i begins at i/n and is 1/n wide.
// %% hint ru
// Ячейка i начинается в i/n, а ширина её 1/n.
// %% hint en
// The i-th random number says how far into its cell the i-th sample goes.
// %% hint ru
// Случайное число номер i говорит, какую часть своей ячейки пройдёт отсчёт номер i.

// %% answer
// %% ru По отсчёту в каждой из `random.len()` равных ячеек отрезка 0 … 1.
/// One sample in each of `random.len()` equal cells of 0 … 1.
pub fn jittered(random: &[f64]) -> Vec<f64> {
    // %% start Vec::new()
    let n = random.len() as f64;
    random.iter().enumerate().map(|(i, r)| (i as f64 + r) / n).collect()
    // %% end
}

// %% check
use nyquist::exercise::{Line, Mistake};
use nyquist::num::random::uniform;
use nyquist::text;

pub type Answer = fn(&[f64]) -> Vec<f64>;
pub const ANSWER: Answer = jittered;

/// The samples of n cells, by number of cell and random number.
fn each(random: &[f64], place: impl Fn(f64, f64, f64) -> f64) -> Vec<f64> {
    let n = random.len() as f64;
    random.iter().enumerate().map(|(i, r)| place(i as f64, *r, n)).collect()
}

pub const MISTAKES: [Mistake<Answer>; 4] = [
    Mistake::new(
        |random| random.to_vec(),
        "That is random sampling without cells: some stay empty, others get several.",
        "Это случайные отсчёты без ячеек: одни ячейки пусты, в других по нескольку.",
    ),
    Mistake::new(
        |random| each(random, |i, _, n| (i + 0.5) / n),
        "That is the regular grid: nothing is jittered.",
        "Это регулярная сетка: джиттера нет.",
    ),
    Mistake::new(
        |random| each(random, |i, r, n| (i + 0.5 + r) / n),
        "The jitter begins in the middle of the cell, and half of the samples fall into the next one.",
        "Сдвиг отсчитан от середины ячейки, и половина отсчётов попадает в соседнюю.",
    ),
    Mistake::new(
        |random| each(random, |i, r, n| i / n + r),
        "The jitter is as large as the whole interval: it must be one cell wide, 1/n.",
        "Сдвиг размером с весь отрезок, а должен быть в одну ячейку, 1/n.",
    ),
];

pub fn demands(jittered: Answer) -> Vec<Line> {
    let random: Vec<f64> = (0..64).map(|i| uniform(7, i, 0)).collect();
    let samples = jittered(&random);
    let mut counts = vec![0.0; 64];
    for sample in &samples {
        if let Some(count) = counts.get_mut((sample * 64.0).floor() as usize).filter(|_| *sample >= 0.0) {
            *count += 1.0;
        }
    }
    // where in its cell each sample stands; equally likely numbers have these means and squares, up to their own scatter
    let inside: Vec<f64> = samples.iter().zip(0..).map(|(sample, i)| sample * 64.0 - f64::from(i)).collect();
    let moment = |f: fn(f64) -> f64| inside.iter().map(|r| f(*r)).sum::<f64>() / 64.0;
    // the products with 64 are exact, sums up to 64 round
    let rounding = 64.0 * f64::EPSILON;
    // a mean of 64 numbers with the variances 1/12 and 4/45 strays by four deviations once in 16 000 seeds
    let scatter = |variance: f64| 4.0 * (variance / 64.0_f64).sqrt();
    vec![
        Line::new(text!("one sample in every cell", "по отсчёту в каждой ячейке"), 0.0)
            .case("samples", samples.len() as f64, 64.0)
            .over((0..64).map(f64::from), |i| (format!("samples in cell {i}"), counts[i as usize], 1.0)),
        Line::new(text!("no end of the cell is preferred", "ни один край ячейки не предпочтён"), scatter(1.0 / 12.0))
            .case("mean place in the cell", moment(|r| r), 0.5),
        Line::new(text!("all of the cell is used", "используется вся ячейка"), scatter(4.0 / 45.0)).case(
            "mean of squares, places counted from −1 to 1",
            moment(|r| (2.0 * r - 1.0) * (2.0 * r - 1.0)),
            1.0 / 3.0,
        ),
        Line::new(text!("the places are those of the random numbers", "места — по случайным числам"), rounding)
            .along(text!("cell", "ячейка"))
            .over((0..64).map(f64::from), |i| {
                let said = inside.get(i as usize).copied().unwrap_or(f64::NAN);
                (format!("place in cell {i}"), said, random[i as usize])
            }),
    ]
}
