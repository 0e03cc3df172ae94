//! The amplitudes that make a square wave out of sines.

// %% en F11 E16
// # The square wave
//
// The wave that is 1 in the first half of its period and −1 in the second is a sum of b_k sin(2πkx), k = 1, 2, 3, …
// (its period is 1). Which amplitude b_k has the k-th harmonic?
// %% ru
// # Прямоугольная волна
//
// Волна, равная 1 в первой половине периода и −1 во второй, — сумма b_k sin(2πkx), k = 1, 2, 3, … (период — 1). Какова
// амплитуда b_k у k-й гармоники?
// %% hint en
// b_k = 2 ∫ s(x) sin(2πkx) dx over one period. Do both halves of the period give the same?
// %% hint ru
// b_k = 2 ∫ s(x) sin(2πkx) dx по периоду. Одинаковы ли вклады двух половин?
// %% hint en
// It comes to 2(1 − cos πk)/(πk). What is cos πk for even and for odd k?
// %% hint ru
// Получается 2(1 − cos πk)/(πk). Чему равен cos πk при чётных и нечётных k?

// %% answer
use std::f64::consts::PI;

// %% ru Амплитуда k-й гармоники; k — от 1.
/// The amplitude of the k-th harmonic, from k = 1 on.
pub fn amplitude(k: u32) -> f64 {
    // %% start 0.0
    if k % 2 == 1 { 4.0 / (PI * f64::from(k)) } else { 0.0 }
    // %% end
}

// %% check
use nyquist::exercise::{Line, Mistake};
use nyquist::num::quadrature::{even_breaks, integrate_pieces};
use nyquist::text;
use std::f64::consts;

pub type Answer = fn(u32) -> f64;
pub const ANSWER: Answer = amplitude;

pub const MISTAKES: [Mistake<Answer>; 5] = [
    Mistake::new(
        |k| 4.0 / (consts::PI * f64::from(2 * k - 1)),
        "That is the amplitude of the k-th odd harmonic. Asked is the harmonic k itself, odd or even.",
        "Это амплитуда k-й нечётной гармоники. Спрашивают гармонику с номером k, чётную или нет.",
    ),
    Mistake::new(
        |k| 4.0 / (consts::PI * f64::from(k)),
        "You forgot that the even harmonics are not there: the second half of the wave is the first one upside down.",
        "Забыто, что чётных гармоник нет: вторая половина волны — перевёрнутая первая.",
    ),
    Mistake::new(
        |k| if k % 2 == 1 { 1.0 / f64::from(k) } else { 0.0 },
        "The factor 4/π is missing: the partial sums come to π/4 instead of 1.",
        "Не хватает множителя 4/π: суммы сходятся к π/4, а не к 1.",
    ),
    Mistake::new(
        |k| f64::from(k % 2),
        "f + 3f + 5f … with equal amplitudes, as the lecture's slide has it, is no square wave: higher harmonics are weaker.",
        "f + 3f + 5f … с равными амплитудами, как подписано на слайде, — не прямоугольная волна: высшие гармоники слабее.",
    ),
    Mistake::new(
        |k| if k % 2 == 1 { 2.0 / (consts::PI * f64::from(k)) } else { 0.0 },
        "Half of it: that is the wave between 0 and 1, or the factor 2 before the integral is missing.",
        "Вдвое меньше: это волна между 0 и 1, или забыта двойка перед интегралом.",
    ),
];

pub fn demands(amplitude: Answer) -> Vec<Line> {
    // the integral over both halves, 2 ∫ s(x) sin(2πkx) dx; it is asked for 10⁻¹³
    const ALLOWED: f64 = 4e-13;
    let half = |k: f64, a: f64| {
        let pieces = even_breaks(a, a + 0.5, 0.25 / k);
        2.0 * integrate_pieces(|x| (consts::TAU * k * x).sin(), &pieces, 1e-13).value
    };
    let case = |k: f64| (format!("amplitude({k})"), amplitude(k as u32), half(k, 0.0) - half(k, 0.5));
    vec![
        Line::new(text!("the fundamental", "основная частота"), ALLOWED).over([1.0], case),
        Line::new(text!("harmonics 1 to 15", "гармоники 1–15"), ALLOWED)
            .along(text!("harmonic k", "гармоника k"))
            .over((1..=15).map(f64::from), case),
    ]
}
