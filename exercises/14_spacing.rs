//! The spectrum of the comb: another row of the lecture's table.

// %% en F13 F18 E02
// # The spectrum of the comb
//
// Ш_T(x) = T Σ δ(x − iT). Its transform is a comb, too: which lines are there? Give [position, weight] of those with the
// numbers −n, …, n, from left to right.
//
// The lecture's table has (1/T) Σ δ(ω − i/T). Test its weight: Ш_T has the mean value 1.
// %% ru
// # Спектр гребня
//
// Ш_T(x) = T Σ δ(x − iT). Его преобразование Фурье — тоже гребень. Какие в нём линии? Верните [место, вес] линий с
// номерами −n, …, n слева направо.
//
// В таблице лекции стоит (1/T) Σ δ(ω − i/T). Проверьте вес: среднее значение Ш_T равно 1.
// %% hint en
// A function with period T has lines at multiples of 1/T.
// %% hint ru
// У функции с периодом T линии стоят на кратных 1/T.
// %% hint en
// The weight of the line at zero is the mean value; and all the coefficients of a comb are equal.
// %% hint ru
// Вес линии в нуле — среднее значение; а все коэффициенты гребня равны.

// %% answer
// %% ru Линии с номерами −n, …, n спектра гребня Ш_T: место и вес каждой.
/// The lines −n, …, n of the transform of Ш_T, each as position and weight.
pub fn lines(step: f64, n: i32) -> Vec<[f64; 2]> {
    // %% start Vec::new()
    (-n..=n).map(|k| [f64::from(k) / step, 1.0]).collect()
    // %% end
}

// %% check
use nyquist::comb::Comb;
use nyquist::exercise::{Line, Mistake};
use nyquist::text;
use std::f64::consts;

pub type Answer = fn(f64, i32) -> Vec<[f64; 2]>;
pub const ANSWER: Answer = lines;

pub const MISTAKES: [Mistake<Answer>; 4] = [
    Mistake::new(
        |step, n| (-n..=n).map(|k| [f64::from(k) / step, 1.0 / step]).collect(),
        "The places are right; the weight is the lecture's, which holds for T = 1 only. The mean of Ш_T is 1.",
        "Места верны, а вес — как в лекции, где он годится лишь для T = 1. Среднее Ш_T равно 1.",
    ),
    Mistake::new(
        |step, n| (-n..=n).map(|k| [f64::from(k) * step, 1.0]).collect(),
        "You took the spacing T. The closer the arrows in space, the farther the lines in frequency: 1/T.",
        "Вы взяли шаг T. Чем ближе стрелки в пространстве, тем дальше линии по частоте: 1/T.",
    ),
    Mistake::new(
        |step, n| (-n..=n).map(|k| [consts::TAU * f64::from(k) / step, 1.0]).collect(),
        "2π/T is the spacing in radians per unit; this course counts cycles.",
        "2π/T — шаг в радианах на единицу, а в этом курсе частота в периодах.",
    ),
    Mistake::new(
        |step, n| (0..=n).map(|k| [f64::from(k) / step, 1.0]).collect(),
        "The lines left of zero are missing.",
        "Не хватает линий слева от нуля.",
    ),
];

pub fn demands(lines: Answer) -> Vec<Line> {
    let combs = [(1.0, 2), (0.5, 3), (2.5, 3)];
    // the library's comb
    let truth = |step: f64, n: i32| {
        let comb = Comb::new(step).expect("the steps are positive");
        (-n..=n).map(|k| comb.line(i64::from(k))).map(|line| [line.at, line.weight.re]).collect::<Vec<_>>()
    };
    let ask = |line: Line, i: usize| {
        combs.iter().fold(line, |line, &(step, n)| {
            let part = |lines: Vec<[f64; 2]>| lines.into_iter().map(|line| line[i]).collect::<Vec<_>>();
            line.list(&format!("lines({step}, {n})[{i}]"), &part(lines(step, n)), &part(truth(step, n)))
        })
    };
    // one division of numbers up to 6
    vec![
        ask(Line::new(text!("where the lines are", "где стоят линии"), 6.0 * f64::EPSILON), 0),
        ask(Line::new(text!("what they weigh", "каков их вес"), 4.0 * f64::EPSILON), 1),
    ]
}
