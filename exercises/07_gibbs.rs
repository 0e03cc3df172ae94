//! By how much partial sums of a square wave overshoot.

// %% en F11 F48
// # Gibbs' overshoot
//
// S(x) = 4/π · (sin(2πx) + sin(2π·3x)/3 + …) with n terms approximates the square wave between −1 and 1. By how much is
// its first maximum after x = 0 above 1, as a part of the jump at x = 0?
// %% ru
// # Выброс Гиббса
//
// S(x) = 4/π · (sin(2πx) + sin(2π·3x)/3 + …) из n слагаемых приближает прямоугольную волну между −1 и 1. На какую долю
// скачка в точке x = 0 первый максимум после неё выше единицы?
// %% hint en
// The derivative of the sum is 4 sin(4πnx)/sin(2πx). Where does it become zero for the first time?
// %% hint ru
// Производная суммы — 4 sin(4πnx)/sin(2πx). Где она впервые обращается в нуль?
// %% hint en
// Sum up the terms at x = 1/(4n). The jump goes from −1 to 1.
// %% hint ru
// Сложите слагаемые в точке x = 1/(4n). Скачок — от −1 до 1.

// %% answer
use std::f64::consts::PI;

// %% ru Насколько первый максимум суммы n слагаемых выше 1, в долях скачка.
/// How far the first maximum of the sum of n terms is above 1, in units of the jump.
pub fn overshoot(n: u32) -> f64 {
    // %% start 0.0
    let x = 1.0 / (4.0 * f64::from(n));
    let odd = (0..n).map(|i| f64::from(2 * i + 1));
    let sum: f64 = odd.map(|k| (2.0 * PI * k * x).sin() / k).sum();
    (4.0 / PI * sum - 1.0) / 2.0
    // %% end
}

// %% check
use nyquist::exercise::{Line, Mistake};
use nyquist::num::quadrature::integrate;
use nyquist::text;
use std::f64::consts;

pub type Answer = fn(u32) -> f64;
pub const ANSWER: Answer = overshoot;

/// The sum of n terms at x, times 4/π.
fn partial(n: u32, x: f64) -> f64 {
    let terms = (0..n).map(|i| f64::from(2 * i + 1)).map(|k| (consts::TAU * k * x).sin() / k);
    4.0 / consts::PI * terms.sum::<f64>()
}

pub const MISTAKES: [Mistake<Answer>; 4] = [
    Mistake::new(
        |n| partial(n, 0.25 / f64::from(n)) - 1.0,
        "The jump is 2 high, from −1 to 1: you have measured in units of the wave's amplitude.",
        "Высота скачка — 2, от −1 до 1: вы измерили в единицах амплитуды волны.",
    ),
    Mistake::new(
        |_| 0.089_489_872_236_083_64,
        "That is the limit for many terms. With few terms the overshoot is larger: sum up the n terms.",
        "Это предел при большом числе слагаемых. При малом выброс больше: сложите n слагаемых.",
    ),
    Mistake::new(
        |n| (partial(n, 0.5 / f64::from(n)) - 1.0) / 2.0,
        "You look at x = 1/(2n), where the sum has its next minimum; the first maximum is half as far.",
        "Вы смотрите в x = 1/(2n), где у суммы следующий минимум; первый максимум вдвое ближе.",
    ),
    Mistake::new(
        |n| (partial(n, 0.25) - 1.0) / 2.0,
        "You look at the middle of the half period. The first maximum stands right beside the jump.",
        "Вы смотрите в середину полупериода, а первый максимум стоит у самого скачка.",
    ),
];

pub fn demands(overshoot: Answer) -> Vec<Line> {
    // S(x) = ∫ 4 sin(4πnt)/sin(2πt) dt from 0 to x, asked for 10⁻¹⁴; the sum of n ≤ 500 terms, in all about one, rounds by
    // less than 500ε·4/π, of which half is left
    let slope = |n: f64| {
        move |t: f64| if t == 0.0 { 8.0 * n } else { 4.0 * (4.0 * consts::PI * n * t).sin() / (consts::TAU * t).sin() }
    };
    let truth = |n: f64| 0.5 * (integrate(slope(n), 0.0, 0.25 / n, 1e-14).value - 1.0);
    let case = |n: f64| (format!("overshoot({n})"), overshoot(n as u32), truth(n));
    const ALLOWED: f64 = 1e-13;
    vec![
        Line::new(text!("one term: a sine, 4/π high", "одно слагаемое: синус высотой 4/π"), ALLOWED).over([1.0], case),
        Line::new(text!("up to 40 terms", "до 40 слагаемых"), ALLOWED)
            .along(text!("terms n", "слагаемых n"))
            .over((1..=40).map(f64::from), case),
        Line::new(text!("many terms: 8.95 % of the jump", "много слагаемых: 8,95 % скачка"), ALLOWED)
            .over([500.0], case),
    ]
}
