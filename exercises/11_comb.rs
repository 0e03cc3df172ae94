//! The weights that a comb takes from a signal.

// %% en F14
// # The Dirac comb takes weights
//
// Ш_T(x) f(x) = T Σ δ(x − iT) f(iT): arrows, one every T. Give the weights of the arrows i = 0, 1, …, n − 1.
// %% ru
// # Гребень Дирака берёт веса
//
// Ш_T(x) f(x) = T Σ δ(x − iT) f(iT): стрелки через каждые T. Верните веса стрелок i = 0, 1, …, n − 1.
// %% hint en
// A delta times a function keeps the function's value at that one place.
// %% hint ru
// Дельта-функция, умноженная на функцию, сохраняет её значение в этой одной точке.
// %% hint en
// Do not forget the T before the sum: with it the weights add up to the integral of f, exactly if 1/T is above the band of f.
// %% hint ru
// Не забудьте T перед суммой: с ним сумма весов — интеграл от f, причём точно, если 1/T больше полосы f.

// %% answer
// %% ru Веса первых n стрелок.
/// The weights of the first n arrows.
pub fn weights(f: &dyn Fn(f64) -> f64, step: f64, n: usize) -> Vec<f64> {
    // %% start Vec::new()
    (0..n).map(|i| step * f(i as f64 * step)).collect()
    // %% end
}

// %% check
use nyquist::exercise::{Line, Mistake};
use nyquist::text;
use std::f64::consts;

pub type Answer = fn(&dyn Fn(f64) -> f64, f64, usize) -> Vec<f64>;
pub const ANSWER: Answer = weights;

pub const MISTAKES: [Mistake<Answer>; 4] = [
    Mistake::new(
        |f, step, n| (0..n).map(|i| f(i as f64 * step)).collect(),
        "Those are the samples. The arrows of this comb weigh T times as much: the T before the sum is missing.",
        "Это отсчёты. Стрелки этого гребня весят в T раз больше: не хватает T перед суммой.",
    ),
    Mistake::new(
        |f, step, n| (0..n).map(|i| step * f(i as f64)).collect(),
        "The i-th arrow stands at iT, not at i.",
        "Стрелка номер i стоит в точке iT, а не i.",
    ),
    Mistake::new(
        |f, step, n| (0..n).map(|i| f(i as f64 * step) / step).collect(),
        "You divided by T; the comb has the factor T.",
        "Вы разделили на T, а у гребня множитель T.",
    ),
    Mistake::new(
        |f, step, n| (1..=n).map(|i| step * f(i as f64 * step)).collect(),
        "The first arrow stands at x = 0.",
        "Первая стрелка стоит в точке x = 0.",
    ),
];

pub fn demands(weights: Answer) -> Vec<Line> {
    let bump = |x: f64| (-consts::PI * (x - 4.0) * (x - 4.0)).exp();
    let by_hand = weights(&|x| x * x, 0.5, 6);
    let steps = [1.0 / 3.0, 0.25, 0.2];
    // Poisson's sum: T Σ f(iT) = Σ F(k/T), here 1 + 2e^(−π/T²) with T ≤ ⅓; what lies outside 0 … 8 is below e^(−16π)
    let tail = 2.0 * (-9.0 * consts::PI).exp() + 64.0 * f64::EPSILON;
    vec![
        Line::new(text!("x² with T = ½", "x² при T = ½"), 0.0).list(
            "weights(x², 0.5, 6)",
            &by_hand,
            &[0.0, 0.125, 0.5, 1.125, 2.0, 3.125],
        ),
        Line::new(text!("the weights add up to the integral", "сумма весов — интеграл"), tail).over(steps, |step| {
            let n = (8.0 / step).round() as usize + 1;
            (format!("Σ weights(e^(−π(x−4)²), {step:.3}, {n})"), weights(&bump, step, n).iter().sum(), 1.0)
        }),
    ]
}
