//! The kernel of Lanczos.

// %% en F57 F58
// # Lanczos' kernel
//
// The sinc is infinitely wide. Lanczos multiplies it by the middle lobe of a wider sinc, which is zero at ±a and is cut off
// there: k(t) = sinc(t)·sinc(t/a) for |t| < a and 0 beyond, with sinc(t) = sin(πt)/(πt). Write it for any a.
// %% ru
// # Ядро Ланцоша
//
// Sinc бесконечно широк. Ланцош умножает его на средний лепесток более широкого sinc, который обращается в нуль в ±a, и
// там обрезает: k(t) = sinc(t)·sinc(t/a) при |t| < a и 0 дальше, где sinc(t) = sin(πt)/(πt). Напишите его для любого a.
// %% hint en
// A function sinc of its own, right at zero, makes it one line.
// %% hint ru
// С отдельной функцией sinc, верной в нуле, остаётся одна строка.
// %% hint en
// sinc(0) = 1. The window is as wide as a: sinc(t/a), not sinc(t·a).
// %% hint ru
// sinc(0) = 1. Окно шириной a: sinc(t/a), а не sinc(t·a).

// %% answer
use std::f64::consts::PI;

// %% ru Ядро Ланцоша радиуса a.
/// Lanczos' kernel of radius a.
pub fn lanczos(t: f64, a: f64) -> f64 {
    // %% start 0.0
    let sinc = |t: f64| if t == 0.0 { 1.0 } else { (PI * t).sin() / (PI * t) };
    if t.abs() < a { sinc(t) * sinc(t / a) } else { 0.0 }
    // %% end
}

// %% check
use nyquist::exercise::{Line, Mistake};
use nyquist::num::sinc;
use nyquist::prelude::{Lanczos, Signal};
use nyquist::text;
use std::f64::consts;

pub type Answer = fn(f64, f64) -> f64;
pub const ANSWER: Answer = lanczos;

pub const MISTAKES: [Mistake<Answer>; 5] = [
    Mistake::new(
        |t, a| sinc(t) * sinc(t / a),
        "It is not cut off: beyond ±a your window comes back with its side lobes.",
        "Ядро не обрезано: за ±a окно возвращается боковыми лепестками.",
    ),
    Mistake::new(
        |t, a| if t.abs() < a { sinc(t) } else { 0.0 },
        "The window is missing: that is a sinc, cut off hard, which rings.",
        "Не хватает окна: это грубо обрезанный sinc, он звенит.",
    ),
    Mistake::new(
        |t, a| if t.abs() < a { sinc(t) * sinc(t) } else { 0.0 },
        "The window is as narrow as the sinc itself: stretch it to sinc(t/a).",
        "Окно такое же узкое, как сам sinc: растяните его до sinc(t/a).",
    ),
    Mistake::new(
        |t, a| {
            let raw = |t: f64| (consts::PI * t).sin() / (consts::PI * t);
            if t.abs() < a { raw(t) * raw(t / a) } else { 0.0 }
        },
        "The formula is right, but at t = 0 it is 0/0, which is NaN.",
        "Формула верна, но при t = 0 она даёт 0/0, то есть NaN.",
    ),
    Mistake::new(
        |t, a| if t.abs() < a { sinc(t / consts::PI) * sinc(t / consts::PI / a) } else { 0.0 },
        "You forgot π: this sinc is sin(πt)/(πt), zero at the whole numbers.",
        "Забыто π: здесь sinc — это sin(πt)/(πt) с нулями в целых точках.",
    ),
];

pub fn demands(lanczos: Answer) -> Vec<Line> {
    let truth = |t: f64, a: f64| Lanczos::new(a).map_or(f64::NAN, |kernel| kernel.at(t));
    // sin(πt) of angles up to 4π is off by ε·4π, and divided by πt of at least a tenth
    let allowed = 4.0 * f64::EPSILON * 4.0 * consts::PI / 0.1;
    let case = |a: f64| move |t: f64| (format!("lanczos({t}, {a})"), lanczos(t, a), truth(t, a));
    let places = || (-35..=35).map(|i| f64::from(i) / 10.0);
    vec![
        Line::new(text!("one at zero", "единица в нуле"), 0.0).case("lanczos(0, 3)", lanczos(0.0, 3.0), 1.0),
        Line::new(text!("a = 3", "a = 3"), allowed).along(text!("t, steps", "t, шаги")).over(places(), case(3.0)),
        Line::new(text!("a = 2", "a = 2"), allowed).over(places(), case(2.0)),
    ]
}
