//! The lines of a cosine: a row of the lecture's table that is printed wrong.

// %% en F13 E01
// # The lines of a cosine
//
// The transform of A cos(bx) is two lines (deltas). Where are they on the axis of frequencies in cycles per unit, and
// which weight has each? Give [[position, weight], [position, weight]], the negative position first.
//
// The lecture's table says: cos x ↔ π(δ(½ − ω) + δ(½ + ω)). Do not believe it.
// %% ru
// # Линии косинуса
//
// Спектр A cos(bx) — две линии (дельта-функции). Где они на оси частот в периодах на единицу и каков вес каждой?
// Верните [[место, вес], [место, вес]], сначала отрицательное место.
//
// В таблице лекции написано: cos x ↔ π(δ(½ − ω) + δ(½ + ω)). Не верьте.
// %% hint en
// Euler: cos a = (e^(ia) + e^(−ia))/2. Each exponential e^(2πiνx) is one line of weight one at ν.
// %% hint ru
// Формула Эйлера: cos a = (e^(ia) + e^(−ia))/2. Каждая экспонента e^(2πiνx) — одна линия веса 1 на частоте ν.
// %% hint en
// Which ν makes 2πν equal to b?
// %% hint ru
// При каком ν величина 2πν равна b?

// %% answer
use std::f64::consts::PI;

// %% ru Две линии спектра A cos(bx): место и вес каждой.
/// The two lines of A cos(bx), each as position and weight.
pub fn lines(amplitude: f64, b: f64) -> [[f64; 2]; 2] {
    // %% start [[0.0, 0.0], [0.0, 0.0]]
    let (at, weight) = (b / (2.0 * PI), 0.5 * amplitude);
    [[-at, weight], [at, weight]]
    // %% end
}

// %% check
use nyquist::exercise::{Line, Mistake};
use nyquist::num::quadrature::integrate;
use nyquist::text;
use std::f64::consts;

pub type Answer = fn(f64, f64) -> [[f64; 2]; 2];
pub const ANSWER: Answer = lines;

/// Two lines of one weight.
const fn pair(at: f64, weight: f64) -> [[f64; 2]; 2] {
    [[-at, weight], [at, weight]]
}

pub const MISTAKES: [Mistake<Answer>; 4] = [
    Mistake::new(
        |amplitude, b| pair(0.5 * b, consts::PI * amplitude),
        "That is the lecture's row, which mixes two conventions: it is the transform of 2π·cos(πx).",
        "Это строка из лекции, где смешаны два соглашения: так выглядит спектр 2π·cos(πx).",
    ),
    Mistake::new(
        |amplitude, b| pair(b, 0.5 * amplitude),
        "b is an angular frequency, in radians per unit; asked are cycles per unit.",
        "b — угловая частота, в радианах на единицу, а спрашивают периоды на единицу.",
    ),
    Mistake::new(
        |amplitude, b| pair(b / consts::TAU, amplitude),
        "The amplitude is shared by two lines: together they make A at x = 0.",
        "Амплитуду делят две линии: вместе они дают A при x = 0.",
    ),
    Mistake::new(
        |amplitude, b| pair(b / consts::TAU, consts::PI * amplitude),
        "The places are right. The weight π belongs to angular frequency; in cycles per unit there is no π.",
        "Места верны. Вес π — из соглашения с угловой частотой; в периодах на единицу π не появляется.",
    ),
];

pub fn demands(lines: Answer) -> Vec<Line> {
    let waves = [[1.0, 1.0], [2.5, 4.0], [1.0, consts::TAU], [0.3, 0.1]];
    // a line stands at one over the period; its weight is the mean over a period of A cos(bx)·cos(2πνx)
    let period = |b: f64| consts::TAU / b;
    let mean = |[amplitude, b]: [f64; 2]| {
        let wave = |x: f64| amplitude * (b * x).cos() * (consts::TAU / period(b) * x).cos();
        integrate(wave, 0.0, period(b), 1e-13).value / period(b)
    };
    // positions up to 1: rounding; weights: the quadrature, asked for 10⁻¹³ and divided by periods from 1 on
    let ask = |line: Line, i: usize| {
        waves.iter().fold(line, |line, &[amplitude, b]| {
            let said = lines(amplitude, b);
            let truth = if i == 0 { 1.0 / period(b) } else { mean([amplitude, b]) };
            let sign = if i == 0 { -1.0 } else { 1.0 };
            line.case(format!("lines({amplitude}, {b})[0][{i}]"), said[0][i], sign * truth).case(
                format!("lines({amplitude}, {b})[1][{i}]"),
                said[1][i],
                truth,
            )
        })
    };
    vec![
        ask(Line::new(text!("where the lines are", "где стоят линии"), 4.0 * f64::EPSILON), 0),
        ask(Line::new(text!("what they weigh", "каков их вес"), 2e-13), 1),
    ]
}
