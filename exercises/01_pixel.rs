//! A pixel is a box filter, and then a sample.

// %% en F01
// # The pixel as a filter
//
// A pixel does not read the light at a point: it takes the mean over its width a. What is left of the amplitude of
// a tone cos(2πνx) after that? Give the factor with its sign: a negative one swaps light and dark.
//
//     1/a ∫ cos(2πνx) dx  from −a/2 to a/2
// %% ru
// # Пиксель как фильтр
//
// Пиксель не читает свет в точке, а усредняет его по своей ширине a. Какая доля амплитуды синусоиды cos(2πνx) после
// этого остаётся? Ответ — множитель со знаком: отрицательный меняет местами светлое и тёмное.
//
//     1/a ∫ cos(2πνx) dx  от −a/2 до a/2
// %% hint en
// The integral of cos(2πνx) is sin(2πνx)/(2πν). Put in both ends.
// %% hint ru
// Первообразная cos(2πνx) — sin(2πνx)/(2πν). Подставьте оба конца.
// %% hint en
// What comes out is sin(πaν)/(πaν). Which value has it at ν = 0, and what does the computer make of 0/0?
// %% hint ru
// Получается sin(πaν)/(πaν). Чему это равно при ν = 0 и что получит компьютер из 0/0?

// %% answer
use std::f64::consts::PI;

// %% ru Множитель, на который пиксель такой ширины умножает амплитуду синусоиды.
/// The factor by which a pixel of that width multiplies the amplitude of a tone.
pub fn kept(frequency: f64, width: f64) -> f64 {
    // %% start 0.0
    let half_turns = width * frequency;
    if half_turns == 0.0 { 1.0 } else { (PI * half_turns).sin() / (PI * half_turns) }
    // %% end
}

// %% check
use nyquist::exercise::{Line, Mistake};
use nyquist::num::{quadrature::integrate, sinc};
use nyquist::text;
use std::f64::consts;

pub type Answer = fn(f64, f64) -> f64;
pub const ANSWER: Answer = kept;

pub const MISTAKES: [Mistake<Answer>; 4] = [
    Mistake::new(
        |frequency, width| (consts::PI * width * frequency).sin() / (consts::PI * width * frequency),
        "The formula is right, but at frequency 0 it is 0/0, which is NaN. A mean leaves a constant as it is.",
        "Формула верна, но на частоте 0 она даёт 0/0, то есть NaN. Константу усреднение не меняет.",
    ),
    Mistake::new(
        |frequency, width| sinc(width * frequency / consts::PI),
        "You forgot π: the sinc of this lecture is sin(πt)/(πt), not sin(t)/t.",
        "Забыто π: в этой лекции sinc — это sin(πt)/(πt), а не sin(t)/t.",
    ),
    Mistake::new(
        |frequency, width| sinc(width * frequency).abs(),
        "The sign is lost. Beyond ν = 1/a the factor is negative: light and dark change places.",
        "Потерян знак. За ν = 1/a множитель отрицателен: светлое и тёмное меняются местами.",
    ),
    Mistake::new(
        |frequency, width| width * sinc(width * frequency),
        "That is the integral over the pixel and not the mean: divide by its width.",
        "Это интеграл по пикселю, а не среднее: разделите на ширину.",
    ),
];

pub fn demands(kept: Answer) -> Vec<Line> {
    // the integral itself; it is asked for 10⁻¹³, and divided by widths from ½ on
    const ALLOWED: f64 = 2e-13;
    let truth = |frequency: f64, width: f64| {
        integrate(|x| (consts::TAU * frequency * x).cos(), -0.5 * width, 0.5 * width, 1e-13).value / width
    };
    let case = |width: f64| move |nu: f64| (format!("kept({nu}, {width})"), kept(nu, width), truth(nu, width));
    vec![
        Line::new(text!("a constant is left as it is", "константа не меняется"), 0.0).case(
            "kept(0.0, 1.0)",
            kept(0.0, 1.0),
            1.0,
        ),
        Line::new(text!("a full pixel, a = 1", "пиксель без зазора, a = 1"), ALLOWED)
            .along(text!("frequency ν", "частота ν"))
            .over((1..=60).map(|i| f64::from(i) / 16.0), case(1.0)),
        Line::new(text!("other widths", "другая ширина"), ALLOWED)
            .over([0.25, 0.5, 0.9, 1.5], case(0.5))
            .over([0.25, 0.5, 0.9, 1.5], case(1.75)),
    ]
}
