//! Folding with its sign: what happens to a sine.

// %% en F08
// # Fold a frequency
//
// A sine comes back with the folded frequency and perhaps upside down: the samples of sin(2πνk/rate), k = 0, 1, 2, …
// are those of sign·sin(2πfk/rate) with f between 0 and half the rate. Give [f, sign], the sign being 1 or −1.
// (Frequencies whose sine is sampled only at zeros are not asked for.)
// %% ru
// # Свернуть частоту
//
// Синус возвращается со свёрнутой частотой и, возможно, перевёрнутым: отсчёты sin(2πνk/rate), k = 0, 1, 2, … — это
// отсчёты sign·sin(2πfk/rate), где f от 0 до половины частоты дискретизации. Верните [f, sign]; знак — 1 или −1.
// (Частоты, у которых все отсчёты синуса — нули, не спрашиваются.)
// %% hint en
// Take the nearest multiple of the rate away from ν. The rest may be negative, and sin(−a) = −sin(a).
// %% hint ru
// Отнимите от ν ближайшее кратное частоты дискретизации. Остаток может быть отрицательным, а sin(−a) = −sin(a).
// %% hint en
// `f64::signum` gives the sign, `f64::abs` the frequency.
// %% hint ru
// `f64::signum` даёт знак, `f64::abs` — частоту.

// %% answer
// %% ru Свёрнутая частота и знак, с которым возвращается синус.
/// The folded frequency, and the sign with which a sine comes back.
pub fn fold(frequency: f64, rate: f64) -> [f64; 2] {
    // %% start [0.0, 1.0]
    let signed = frequency - rate * (frequency / rate).round();
    [signed.abs(), signed.signum()]
    // %% end
}

// %% check
use nyquist::exercise::{Line, Mistake};
use nyquist::text;
use std::f64::consts;

pub type Answer = fn(f64, f64) -> [f64; 2];
pub const ANSWER: Answer = fold;

pub const MISTAKES: [Mistake<Answer>; 4] = [
    Mistake::new(
        |frequency, rate| [nyquist::nyquist::fold(frequency, rate), 1.0],
        "The frequency is right. But sin(2π·0.9k) = −sin(2π·0.1k): look at the first sample after zero.",
        "Частота верна. Но sin(2π·0,9k) = −sin(2π·0,1k): посмотрите на первый отсчёт после нуля.",
    ),
    Mistake::new(
        |frequency, rate| {
            let folded = nyquist::nyquist::fold(frequency, rate);
            [folded, if frequency > 0.5 * rate { -1.0 } else { 1.0 }]
        },
        "Not everything that is folded is turned over: the sign changes with every half of the rate.",
        "Переворачивается не всё, что сворачивается: знак меняется с каждой половиной частоты дискретизации.",
    ),
    Mistake::new(
        |frequency, rate| {
            let sign = if (frequency / rate).floor() as i64 % 2 == 0 { 1.0 } else { -1.0 };
            [nyquist::nyquist::fold(frequency, rate), sign]
        },
        "You count whole rates; the axis is folded at every half.",
        "Вы считаете целые частоты дискретизации, а ось складывается на каждой половине.",
    ),
    Mistake::new(
        |frequency, rate| [frequency - rate * (frequency / rate).round(), 1.0],
        "The sign has stayed in the frequency: make it positive and give the sign apart.",
        "Знак остался в частоте: сделайте её положительной, а знак верните отдельно.",
    ),
];

pub fn demands(fold: Answer) -> Vec<Line> {
    let frequencies = || [0.1, 0.45, 0.55, 0.9, 1.2, 1.7, 2.05, 2.6, 3.3].into_iter();
    let sample = |nu: f64, k: f64| (consts::TAU * nu * k).sin();
    // rounding: 5ε of a frequency; an angle of up to 2π·3.3·12, its error times a slope of one
    let allowed = 16.0 * f64::EPSILON * consts::TAU * 3.3 * 12.0;
    let seen = |rate: f64| {
        move |nu: f64| {
            let [folded, sign] = fold(rate * nu, rate);
            // the samples decide, those of one turn and more
            let misfit = (1..=12).map(f64::from).map(|k| (sign * sample(folded / rate, k) - sample(nu, k)).abs());
            (format!("misfit of the samples at {}", rate * nu), misfit.fold(0.0, f64::max), 0.0)
        }
    };
    let low = |nu: f64| {
        let [folded, _] = fold(nu, 1.0);
        (format!("fold({nu}, 1)[0]"), folded, folded.clamp(0.0, 0.5))
    };
    let sign = |nu: f64| {
        let [_, sign] = fold(nu, 1.0);
        // the first sample after zero says which way up the sine is
        (format!("fold({nu}, 1)[1]"), sign, sample(nu, 1.0).signum())
    };
    vec![
        Line::new(text!("f lies between 0 and half the rate", "f — от 0 до половины частоты дискретизации"), allowed)
            .over(frequencies(), low),
        Line::new(text!("the sign", "знак"), 0.0).along(text!("frequency ν", "частота ν")).over(frequencies(), sign),
        Line::new(text!("the samples agree, rate 1", "отсчёты совпадают, частота 1"), allowed)
            .over(frequencies(), seen(1.0)),
        Line::new(text!("the samples agree, rate 8", "отсчёты совпадают, частота 8"), allowed)
            .over(frequencies(), seen(8.0)),
    ]
}
