//! The exact mean of a sine over a pixel.

// %% en F32 F36
// # The exact mean of a sine
//
// Prefiltering with a box is done exactly where the mean has a formula. What is the mean of sin(2πνx) over the pixel from
// a to b? It must be right for ν = 0, too.
// %% ru
// # Точное среднее синуса
//
// Предфильтр-прямоугольник точен там, где для среднего есть формула. Чему равно среднее sin(2πνx) по пикселю от a до b?
// Ответ должен быть верен и при ν = 0.
// %% hint en
// The integral of sin(2πνx) is −cos(2πνx)/(2πν).
// %% hint ru
// Первообразная sin(2πνx) — это −cos(2πνx)/(2πν).
// %% hint en
// A mean is the integral divided by b − a. For ν = 0 the function is zero everywhere.
// %% hint ru
// Среднее — интеграл, делённый на b − a. При ν = 0 функция всюду равна нулю.

// %% answer
use std::f64::consts::PI;

// %% ru Среднее sin(2πνx) от a до b.
/// The mean of sin(2πνx) from a to b.
pub fn mean(nu: f64, a: f64, b: f64) -> f64 {
    // %% start 0.0
    if nu == 0.0 {
        return 0.0;
    }
    let turn = 2.0 * PI * nu;
    ((turn * a).cos() - (turn * b).cos()) / (turn * (b - a))
    // %% end
}

// %% check
use nyquist::exercise::{Line, Mistake};
use nyquist::num::quadrature::integrate;
use nyquist::text;
use std::f64::consts;

pub type Answer = fn(f64, f64, f64) -> f64;
pub const ANSWER: Answer = mean;

/// The difference of the integral's ends.
fn ends(turn: f64, a: f64, b: f64) -> f64 {
    ((turn * a).cos() - (turn * b).cos()) / turn
}

pub const MISTAKES: [Mistake<Answer>; 5] = [
    Mistake::new(
        |nu, a, b| ends(consts::TAU * nu, a, b) / (b - a),
        "The formula is right, but at ν = 0 it is 0/0, which is NaN.",
        "Формула верна, но при ν = 0 она даёт 0/0, то есть NaN.",
    ),
    Mistake::new(
        |nu, a, b| if nu == 0.0 { 0.0 } else { ends(consts::TAU * nu, a, b) },
        "That is the integral; a mean is divided by the width b − a.",
        "Это интеграл; среднее ещё делится на ширину b − a.",
    ),
    Mistake::new(
        |nu, a, b| if nu == 0.0 { 0.0 } else { -ends(consts::TAU * nu, a, b) / (b - a) },
        "The sign: the integral of the sine is minus the cosine.",
        "Знак: первообразная синуса — минус косинус.",
    ),
    Mistake::new(
        |nu, a, b| (consts::PI * nu * (a + b)).sin(),
        "That is the value in the middle: a point sample, which no prefilter has touched.",
        "Это значение в середине — точечный отсчёт без всякого предфильтра.",
    ),
    Mistake::new(
        |nu, a, b| 0.5 * ((consts::TAU * nu * a).sin() + (consts::TAU * nu * b).sin()),
        "That is the mean of two samples at the ends, not of all points between.",
        "Это среднее двух отсчётов по краям, а не всех точек между ними.",
    ),
];

pub fn demands(mean: Answer) -> Vec<Line> {
    // the quadrature is asked for 10⁻¹³ and divided by widths from ¼ on; 1/ν up to 16 magnifies the answer's rounding
    const ALLOWED: f64 = 4e-13 + 32.0 * f64::EPSILON;
    let truth = |nu: f64, a: f64, b: f64| integrate(|x| (consts::TAU * nu * x).sin(), a, b, 1e-13).value / (b - a);
    let case = |a: f64, b: f64| move |nu: f64| (format!("mean({nu}, {a}, {b})"), mean(nu, a, b), truth(nu, a, b));
    vec![
        Line::new(text!("ν = 0", "ν = 0"), 0.0).case("mean(0, 2, 3)", mean(0.0, 2.0, 3.0), 0.0),
        Line::new(text!("a pixel of width 1, from 0.2", "пиксель шириной 1, от 0,2"), ALLOWED)
            .along(text!("frequency ν", "частота ν"))
            .over((1..=48).map(|i| f64::from(i) / 16.0), case(0.2, 1.2)),
        Line::new(text!("other pixels", "другие пиксели"), ALLOWED)
            .over([-0.7, 0.125, 1.3], case(-0.4, 0.1))
            .over([0.3, 2.2], case(3.0, 3.25)),
    ]
}
