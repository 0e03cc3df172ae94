//! Copies of a spectrum.

// %% en F19 F20 F26 F27
// # Build the replicas
//
// Sampling with the step T multiplies by Ш_T and so convolves the spectrum F with lines of weight 1 at multiples of 1/T.
// What is the spectrum of the samples at ν, with the copies −n, …, n?
// %% ru
// # Построить копии спектра
//
// Дискретизация с шагом T — умножение на Ш_T, то есть свёртка спектра F с линиями веса 1 на кратных 1/T. Чему равен
// спектр отсчётов на частоте ν с учётом копий −n, …, n?
// %% hint en
// Convolution with a line at a moves the spectrum by a: F(ν − a).
// %% hint ru
// Свёртка с линией в точке a сдвигает спектр на a: F(ν − a).
// %% hint en
// Sum F(ν − k/T) over k from −n to n. The copies are as high as the original.
// %% hint ru
// Сложите F(ν − k/T) по k от −n до n. Копии той же высоты, что и оригинал.

// %% answer
// %% ru Спектр на частоте ν отсчётов с шагом T, с n копиями с каждой стороны.
/// The spectrum at ν of samples with the step T, with n copies on either side.
pub fn replicated(spectrum: &dyn Fn(f64) -> f64, step: f64, n: i32, nu: f64) -> f64 {
    // %% start 0.0
    (-n..=n).map(|k| spectrum(nu - f64::from(k) / step)).sum()
    // %% end
}

// %% check
use nyquist::exercise::{Line, Mistake};
use nyquist::text;
use std::f64::consts;

pub type Answer = fn(&dyn Fn(f64) -> f64, f64, i32, f64) -> f64;
pub const ANSWER: Answer = replicated;

pub const MISTAKES: [Mistake<Answer>; 4] = [
    Mistake::new(
        |spectrum, step, n, nu| (-n..=n).map(|k| spectrum(nu - f64::from(k) * step)).sum(),
        "The copies are T apart in your sum; they are 1/T apart: the larger T, the closer.",
        "Копии у вас через T, а должны быть через 1/T: чем больше T, тем они ближе.",
    ),
    Mistake::new(
        |spectrum, step, n, nu| (-n..=n).map(|k| spectrum(nu - f64::from(k) / step)).sum::<f64>() / step,
        "The factor 1/T is the one of the lecture's table. With Ш_T = T Σ δ the copies have the height of F.",
        "Множитель 1/T — из таблицы лекции. Для Ш_T = T Σ δ копии той же высоты, что F.",
    ),
    Mistake::new(
        |spectrum, step, n, nu| (0..=n).map(|k| spectrum(nu - f64::from(k) / step)).sum(),
        "The copies to the left are missing: k runs from −n.",
        "Не хватает копий слева: k начинается с −n.",
    ),
    Mistake::new(
        |spectrum, step, n, nu| (-n..=n).map(|k| spectrum(nu - f64::from(k) / step)).fold(0.0, f64::max),
        "Where copies overlap they add up; you take the highest.",
        "Где копии перекрываются, они складываются, а вы берёте наибольшую.",
    ),
];

pub fn demands(replicated: Answer) -> Vec<Line> {
    const COPIES: i32 = 12;
    // the samples know: T Σ f(kT) e^(−2πiνkT) (Poisson's sum), for the pair e^(−πx²) ↔ e^(−πν²)
    let gaussian = |t: f64| (-consts::PI * t * t).exp();
    let truth = |step: f64, nu: f64| {
        (-40..=40).map(f64::from).map(|k| step * gaussian(k * step) * (consts::TAU * nu * k * step).cos()).sum::<f64>()
    };
    // what both sums leave out is below e^(−40π); roundings of 81 terms up to 1
    let allowed = 81.0 * 4.0 * f64::EPSILON;
    let case = |step: f64| {
        move |nu: f64| {
            let said = replicated(&gaussian, step, COPIES, nu);
            (format!("replicated(gaussian, {step}, {COPIES}, {nu})"), said, truth(step, nu))
        }
    };
    let places = || (-30..=30).map(|i| f64::from(i) / 20.0);
    vec![
        Line::new(text!("T = 0.4: copies apart", "T = 0.4: копии врозь"), allowed)
            .along(text!("frequency ν", "частота ν"))
            .over(places(), case(0.4)),
        Line::new(text!("T = 1.25: copies overlap", "T = 1.25: копии перекрываются"), allowed)
            .along(text!("frequency ν", "частота ν"))
            .over(places(), case(1.25)),
    ]
}
