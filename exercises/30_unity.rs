//! Weights that add up to one.

// %% en F57 F56
// # Weights that add up to one
//
// A kernel k reaches `radius` steps to either side. Between two samples, a part t of a step (0 ≤ t < 1) right of sample 0,
// the samples 1 − radius, …, radius take part. Give their weights, divided by their sum: then a constant stays what it is
// with any kernel (the weights of Lanczos-3 itself add up to 0.994 … 1).
// %% ru
// # Веса с единичной суммой
//
// Ядро k простирается на `radius` шагов в каждую сторону. Между двумя отсчётами, на долю t шага (0 ≤ t < 1) правее отсчёта
// 0, участвуют отсчёты 1 − radius, …, radius. Верните их веса, делённые на их сумму: тогда константа сохраняется с любым
// ядром (у самого ядра Ланцоша радиуса 3 сумма весов — от 0,994 до 1).
// %% hint en
// Sample i is t − i steps away.
// %% hint ru
// До отсчёта i — расстояние t − i шагов.
// %% hint en
// First all weights, then their sum, then the division.
// %% hint ru
// Сначала все веса, потом их сумма, потом деление.

// %% answer
// %% ru Веса отсчётов 1 − radius, …, radius в месте t; их сумма — единица.
/// The weights of the samples 1 − radius, …, radius at the place t, adding up to one.
pub fn weights(kernel: &dyn Fn(f64) -> f64, radius: i32, t: f64) -> Vec<f64> {
    // %% start Vec::new()
    let raw: Vec<f64> = (1 - radius..=radius).map(|i| kernel(t - f64::from(i))).collect();
    let sum: f64 = raw.iter().sum();
    raw.iter().map(|weight| weight / sum).collect()
    // %% end
}

// %% check
use nyquist::exercise::{Line, Mistake};
use nyquist::num::sinc;
use nyquist::text;

pub type Answer = fn(&dyn Fn(f64) -> f64, i32, f64) -> Vec<f64>;
pub const ANSWER: Answer = weights;

/// Raw weights, with the place of sample 0 moved, divided by something made of them.
fn divided(kernel: &dyn Fn(f64) -> f64, radius: i32, t: f64, by: fn(&[f64]) -> f64) -> Vec<f64> {
    let raw: Vec<f64> = (1 - radius..=radius).map(|i| kernel(t - f64::from(i))).collect();
    let by = by(&raw);
    raw.into_iter().map(|weight| weight / by).collect()
}

pub const MISTAKES: [Mistake<Answer>; 4] = [
    Mistake::new(
        |kernel, radius, t| divided(kernel, radius, t, |_| 1.0),
        "The division is missing: your weights do not add up to one.",
        "Не хватает деления: сумма ваших весов — не единица.",
    ),
    Mistake::new(
        |kernel, radius, t| divided(kernel, radius, t, |raw| raw.iter().copied().fold(0.0, f64::max)),
        "You made the largest weight one; the sum has to be one.",
        "Вы сделали единицей наибольший вес, а единицей должна быть сумма.",
    ),
    Mistake::new(
        |kernel, radius, t| divided(kernel, radius, t, |raw| raw.iter().map(|weight| weight.abs()).sum()),
        "Negative weights count with their sign: without it the sum is too large, and the picture too dark.",
        "Отрицательные веса входят со своим знаком: иначе сумма завышена, а картина темнее.",
    ),
    Mistake::new(
        |kernel, radius, t| divided(kernel, radius, -t, |raw| raw.iter().sum()),
        "The place is left of sample 0 in yours: sample i is t − i steps away.",
        "У вас место левее отсчёта 0: до отсчёта i — t − i шагов.",
    ),
];

pub fn demands(weights: Answer) -> Vec<Line> {
    let lanczos = |t: f64| if t.abs() < 3.0 { sinc(t) * sinc(t / 3.0) } else { 0.0 };
    let tent = |t: f64| (1.0 - t.abs()).max(0.0);
    let places = || (0..16).map(|i| f64::from(i) / 16.0);
    // six weights below 1.2, summed and divided
    let allowed = 12.0 * 1.2 * f64::EPSILON;
    // the ratio of two weights is that of the kernel's values, whatever they are divided by
    let ratio = |t: f64| {
        let said = weights(&lanczos, 3, t);
        let [here, next] = [2, 3].map(|i| said.get(i).copied().unwrap_or(f64::NAN));
        (
            format!("w[3]·k({t}) − w[2]·k({t} − 1), w = weights(lanczos3, 3, {t})"),
            next * lanczos(t) - here * lanczos(t - 1.0),
            0.0,
        )
    };
    vec![
        Line::new(text!("they add up to one", "их сумма — единица"), allowed)
            .along(text!("place t", "место t"))
            .over(places(), |t| (format!("Σ weights(lanczos3, 3, {t})"), weights(&lanczos, 3, t).iter().sum(), 1.0)),
        Line::new(text!("a tent: 1 − t and t", "треугольник: 1 − t и t"), allowed)
            .list("weights(tent, 1, 0.25)", &weights(&tent, 1, 0.25), &[0.75, 0.25])
            .list("weights(tent, 1, 0)", &weights(&tent, 1, 0.0), &[1.0, 0.0]),
        Line::new(text!("they keep the kernel's proportions", "они сохраняют пропорции ядра"), 4.0 * allowed)
            .over(places(), ratio),
    ]
}
