//! The least rate that recovers given tones.

// %% en F29 F30 E08
// # Choose the rate
//
// A signal is a sum of tones A cos(2πνx + φ) of the given frequencies, with any amplitudes and phases. Which is the least
// whole-numbered rate at which it can be recovered from its samples?
// %% ru
// # Выбрать частоту дискретизации
//
// Сигнал — сумма A cos(2πνx + φ) данных частот с любыми амплитудами и фазами. Какова наименьшая целая частота
// дискретизации, при которой его можно восстановить по отсчётам?
// %% hint en
// Which of the tones decides?
// %% hint ru
// Какая из частот решает дело?
// %% hint en
// At exactly twice the highest frequency a sine is sampled at its zeros. Can that be undone?
// %% hint ru
// Ровно при удвоенной высшей частоте синус попадает отсчётами в свои нули. Можно ли это исправить?

// %% answer
// %% ru Наименьшая целая частота дискретизации, при которой сумма синусоид этих частот восстановима.
/// The least whole rate that recovers a sum of tones of these frequencies.
pub fn rate(tones: &[f64]) -> u32 {
    // %% start 0
    let highest = tones.iter().copied().fold(0.0, f64::max);
    (2.0 * highest).floor() as u32 + 1
    // %% end
}

// %% check
use nyquist::exercise::{Line, Mistake};
use nyquist::text;

pub type Answer = fn(&[f64]) -> u32;
pub const ANSWER: Answer = rate;

/// The highest of the tones.
fn highest(tones: &[f64]) -> f64 {
    tones.iter().copied().fold(0.0, f64::max)
}

pub const MISTAKES: [Mistake<Answer>; 4] = [
    Mistake::new(
        |tones| (2.0 * highest(tones)).ceil() as u32,
        "«At least 2B», as the lecture has it, is not enough for a tone at B: its sine has samples 0, 0, 0, … It must be more.",
        "«Как минимум 2B», как в лекции, мало для синусоиды частоты B: отсчёты синуса — 0, 0, 0, … Нужно больше.",
    ),
    Mistake::new(
        |tones| highest(tones).floor() as u32 + 1,
        "You forgot the two: a period needs more than two samples.",
        "Забыта двойка: на период нужно больше двух отсчётов.",
    ),
    Mistake::new(
        |tones| (2.0 * tones.iter().sum::<f64>()).floor() as u32 + 1,
        "Frequencies do not add up: the highest alone decides.",
        "Частоты не складываются: решает одна, самая высокая.",
    ),
    Mistake::new(
        |tones| (2.0 * tones.iter().sum::<f64>() / tones.len() as f64).floor() as u32 + 1,
        "The mean frequency does not decide: one tone that is too high spoils everything.",
        "Решает не средняя частота: всё портит и одна слишком высокая.",
    ),
];

pub fn demands(rate: Answer) -> Vec<Line> {
    let signals: [&[f64]; 6] = [&[0.3], &[3.2, 1.1], &[1.0, 7.75, 2.5], &[4.0, 1.0], &[2.5], &[0.25, 12.0, 11.9]];
    // by search: the first rate whose half is above every tone
    let truth = |tones: &[f64]| {
        let recovers = |rate: &u32| tones.iter().all(|tone| f64::from(*rate) > 2.0 * tone);
        (1..100).find(recovers).map_or(f64::NAN, f64::from)
    };
    let ask = |line: Line, signals: &[&[f64]]| {
        signals
            .iter()
            .fold(line, |line, tones| line.case(format!("rate(&{tones:?})"), f64::from(rate(tones)), truth(tones)))
    };
    vec![
        ask(Line::new(text!("frequencies between the whole numbers", "2B — не целое"), 0.0), &signals[..3]),
        ask(Line::new(text!("2B is a whole number", "2B — целое"), 0.0), &signals[3..]),
    ]
}
