//! The kernels of Mitchell and Netravali.

// %% en F57 F58
// # Write Mitchell's kernel
//
// Mitchell and Netravali (1988) give all smooth cubic kernels of radius 2 that leave constants as they are:
//
//     6k(t) = (12 − 9B − 6C)|t|³ + (−18 + 12B + 6C)|t|² + 6 − 2B                        for |t| < 1
//     6k(t) = (−B − 6C)|t|³ + (6B + 30C)|t|² + (−12B − 48C)|t| + 8B + 24C               for 1 ≤ |t| < 2
//
// and 0 beyond. Write it. B = C = ⅓ is the one that they recommend.
// %% ru
// # Написать ядро Митчелла
//
// Митчелл и Нетравали (1988) описали все гладкие кубические ядра радиуса 2, сохраняющие константы:
//
//     6k(t) = (12 − 9B − 6C)|t|³ + (−18 + 12B + 6C)|t|² + 6 − 2B                        при |t| < 1
//     6k(t) = (−B − 6C)|t|³ + (6B + 30C)|t|² + (−12B − 48C)|t| + 8B + 24C               при 1 ≤ |t| < 2
//
// и 0 дальше. Напишите его. Сами авторы советуют B = C = ⅓.
// %% hint en
// Three cases by |t|: below 1, below 2, and the rest.
// %% hint ru
// Три случая по |t|: меньше 1, меньше 2 и остальное.
// %% hint en
// The formula is for 6k. For B = C = ⅓ you must get k(0) = 8/9 and k(1) = 1/18.
// %% hint ru
// Формула — для 6k. При B = C = ⅓ должно выйти k(0) = 8/9 и k(1) = 1/18.

// %% answer
// %% ru Ядро Митчелла и Нетравали с параметрами B и C.
/// The kernel of Mitchell and Netravali with the parameters B and C.
pub fn mitchell(b: f64, c: f64, t: f64) -> f64 {
    // %% start 0.0
    let t = t.abs();
    let six = if t < 1.0 {
        ((12.0 - 9.0 * b - 6.0 * c) * t + (-18.0 + 12.0 * b + 6.0 * c)) * t * t + 6.0 - 2.0 * b
    } else if t < 2.0 {
        (((-b - 6.0 * c) * t + (6.0 * b + 30.0 * c)) * t + (-12.0 * b - 48.0 * c)) * t + 8.0 * b + 24.0 * c
    } else {
        0.0
    };
    six / 6.0
    // %% end
}

// %% check
use nyquist::exercise::{Line, Mistake};
use nyquist::prelude::{Cubic, Signal};
use nyquist::text;

pub type Answer = fn(f64, f64, f64) -> f64;
pub const ANSWER: Answer = mitchell;

/// The kernel, from the library.
fn cubic(b: f64, c: f64, t: f64) -> f64 {
    Cubic::new(b, c).map_or(f64::NAN, |kernel| kernel.at(t))
}

/// The inner piece, anywhere.
fn inner(b: f64, c: f64, t: f64) -> f64 {
    (((12.0 - 9.0 * b - 6.0 * c) * t + (-18.0 + 12.0 * b + 6.0 * c)) * t * t + 6.0 - 2.0 * b) / 6.0
}

/// The outer piece, anywhere.
fn outer(b: f64, c: f64, t: f64) -> f64 {
    ((((-b - 6.0 * c) * t + (6.0 * b + 30.0 * c)) * t + (-12.0 * b - 48.0 * c)) * t + 8.0 * b + 24.0 * c) / 6.0
}

pub const MISTAKES: [Mistake<Answer>; 5] = [
    Mistake::new(
        |b, c, t| 6.0 * cubic(b, c, t),
        "You forgot the 6 on the left side: the formula gives 6k(t).",
        "Забыта шестёрка слева: формула даёт 6k(t).",
    ),
    Mistake::new(
        |b, c, t| {
            if t < 1.0 {
                inner(b, c, t)
            } else if t < 2.0 {
                outer(b, c, t)
            } else {
                0.0
            }
        },
        "You forgot the absolute value: the kernel is even, and left of zero yours grows without bound.",
        "Забыт модуль: ядро чётное, а у вас слева от нуля оно растёт неограниченно.",
    ),
    Mistake::new(|b, c, t| cubic(c, b, t), "B and C have changed places.", "B и C перепутаны местами."),
    Mistake::new(
        |b, c, t| if t.abs() < 1.0 { inner(b, c, t.abs()) } else { 0.0 },
        "The outer piece is missing, from 1 to 2: there are the negative lobes that make it sharp.",
        "Не хватает внешней части, от 1 до 2: там отрицательные лепестки, от которых резкость.",
    ),
    Mistake::new(
        |b, c, t| if t.abs() < 1.0 { inner(b, c, t.abs()) } else { outer(b, c, t.abs()) },
        "Beyond 2 the kernel is 0; your outer piece goes on.",
        "За 2 ядро равно 0, а у вас внешняя часть продолжается.",
    ),
];

pub fn demands(mitchell: Answer) -> Vec<Line> {
    const THIRD: f64 = 1.0 / 3.0;
    // four terms of up to 64·8, rounded
    let allowed = 512.0 * f64::EPSILON;
    let case =
        |b: f64, c: f64| move |t: f64| (format!("mitchell({b:.3}, {c:.3}, {t})"), mitchell(b, c, t), cubic(b, c, t));
    let places = || (-40..=40).map(|i| f64::from(i) / 16.0);
    let sum = |t: f64| (-3..=3).map(|i| mitchell(THIRD, THIRD, t - f64::from(i))).sum::<f64>();
    vec![
        Line::new(text!("k(0) = 8/9 and k(1) = 1/18 for B = C = ⅓", "k(0) = 8/9 и k(1) = 1/18 при B = C = ⅓"), allowed)
            .case("mitchell(⅓, ⅓, 0)", mitchell(THIRD, THIRD, 0.0), 8.0 / 9.0)
            .case("mitchell(⅓, ⅓, 1)", mitchell(THIRD, THIRD, 1.0), 1.0 / 18.0),
        Line::new(text!("B = C = ⅓", "B = C = ⅓"), allowed)
            .along(text!("t, steps", "t, шаги"))
            .over(places(), case(THIRD, THIRD)),
        Line::new(text!("the copies add up to one", "сумма сдвинутых ядер — единица"), 7.0 * allowed)
            .over([0.0, 0.3, 0.5, 0.9], |t| (format!("Σ mitchell(⅓, ⅓, {t} − i)"), sum(t), 1.0)),
        Line::new(text!("B = 1, C = 0: the B-spline", "B = 1, C = 0: B-сплайн"), allowed)
            .over(places(), case(1.0, 0.0)),
        Line::new(text!("B = 0, C = ½: Catmull–Rom", "B = 0, C = ½: Катмулл — Ром"), allowed)
            .along(text!("t, steps", "t, шаги"))
            .over(places(), case(0.0, 0.5)),
    ]
}
