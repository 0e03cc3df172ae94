//! Reconstruction with any kernel.

// %% en F15 F16 F23 E06
// # Reconstruct
//
// Samples stand at x = 0, T, 2T, … Rebuild a function from them with a kernel k that is written for the step 1:
//
//     f̃(x) = Σ f(iT) k((x − iT)/T)
//
// Box, tent and sinc all go through this one sum.
// %% ru
// # Реконструировать
//
// Отсчёты стоят в точках x = 0, T, 2T, … Восстановите по ним функцию ядром k, записанным для единичного шага:
//
//     f̃(x) = Σ f(iT) k((x − iT)/T)
//
// Через эту сумму проходят и прямоугольное ядро, и линейное, и sinc.
// %% hint en
// `samples.iter().enumerate()` gives i and f(iT).
// %% hint ru
// `samples.iter().enumerate()` даёт i и f(iT).
// %% hint en
// The distance to a sample is counted in steps before the kernel sees it.
// %% hint ru
// Расстояние до отсчёта ядро получает в шагах.

// %% answer
// %% ru Значение в точке x функции, восстановленной по отсчётам в точках 0, T, 2T, …
/// The value at x of the function rebuilt from samples at 0, T, 2T, …
pub fn reconstructed(samples: &[f64], step: f64, kernel: &dyn Fn(f64) -> f64, x: f64) -> f64 {
    // %% start 0.0
    samples.iter().enumerate().map(|(i, sample)| sample * kernel(x / step - i as f64)).sum()
    // %% end
}

// %% check
use nyquist::exercise::{Line, Mistake};
use nyquist::num::sinc;
use nyquist::text;
use std::f64::consts;

pub type Answer = fn(&[f64], f64, &dyn Fn(f64) -> f64, f64) -> f64;
pub const ANSWER: Answer = reconstructed;

pub const MISTAKES: [Mistake<Answer>; 4] = [
    Mistake::new(
        |samples, step, kernel, x| samples.iter().enumerate().map(|(i, s)| s * kernel(x - i as f64 * step)).sum(),
        "The kernel is as wide as the unit and not as the step: scale its argument by T. (The lecture's tents work for T = 1.)",
        "Ядро шириной в единицу, а не в шаг: разделите его аргумент на T. (Треугольники лекции годятся лишь для T = 1.)",
    ),
    Mistake::new(
        |samples, step, kernel, x| {
            step * samples.iter().enumerate().map(|(i, s)| s * kernel(x / step - i as f64)).sum::<f64>()
        },
        "T too much: the T of the comb and the 1/T of the kernel r(x) = k(x/T)/T have cancelled already.",
        "Лишнее T: T у гребня и 1/T у ядра r(x) = k(x/T)/T уже сократились.",
    ),
    Mistake::new(
        |samples, step, kernel, x| samples.iter().enumerate().map(|(i, s)| s * kernel((x - i as f64) / step)).sum(),
        "The i-th sample stands at iT, not at i.",
        "Отсчёт номер i стоит в точке iT, а не i.",
    ),
    Mistake::new(
        |samples, step, kernel, x| {
            let weights = samples.iter().enumerate().map(|(i, s)| (s, kernel(x / step - i as f64)));
            let [sum, total] = weights.fold([0.0, 0.0], |[sum, total], (s, w)| [sum + s * w, total + w]);
            sum / total
        },
        "You divide by the sum of the weights. That is for scattered samples; here it spoils the ends and the sinc.",
        "Вы делите на сумму весов. Это для разбросанных отсчётов; здесь портятся края и sinc.",
    ),
];

pub fn demands(reconstructed: Answer) -> Vec<Line> {
    const SAMPLES: [f64; 9] = [0.385, 0.9, 0.796, 0.311, 0.512, 0.592, 0.651, 0.223, 0.521];
    let tent = |t: f64| (1.0 - t.abs()).max(0.0);
    let rectangle = |t: f64| if (-0.5..0.5).contains(&t) { 1.0 } else { 0.0 };
    // linear interpolation, by the two neighbours
    let linear = |t: f64| {
        let i = (t.floor() as usize).min(SAMPLES.len() - 2);
        SAMPLES[i] + (SAMPLES[i + 1] - SAMPLES[i]) * (t - i as f64)
    };
    // nine products of numbers up to one
    let allowed = 16.0 * f64::EPSILON * 9.0;
    // a tone of 0.1 cycles a step, cut off after N = 400 steps, in their middle: |e| ≤ 2/(π cos(πν)(N/2)) (Abel summation)
    let tone: Vec<f64> = (0..=400).map(|i| (consts::TAU * 0.1 * f64::from(i)).cos()).collect();
    let tail = 2.0 / (consts::PI * (0.1 * consts::PI).cos() * 200.0);
    let quarter = |line: Line, x: f64| {
        let said = reconstructed(&tone, 0.25, &sinc, x);
        line.case(format!("reconstructed(tone, 0.25, sinc, {x})"), said, (consts::TAU * 0.4 * x).cos())
    };
    vec![
        Line::new(text!("tents, T = ½: straight lines between the samples", "треугольники, T = ½: ломаная"), allowed)
            .along(text!("x", "x"))
            .over((0..=64).map(|i| f64::from(i) / 16.0), |x| {
                (
                    format!("reconstructed(samples, 0.5, tent, {x})"),
                    reconstructed(&SAMPLES, 0.5, &tent, x),
                    linear(x / 0.5),
                )
            }),
        Line::new(text!("tents fade beyond the ends", "за краями треугольники сходят на нет"), allowed).over(
            [-0.3, 4.2],
            |x| {
                let truth = if x < 0.0 { SAMPLES[0] * (1.0 + x / 0.5) } else { SAMPLES[8] * (9.0 - x / 0.5) };
                (format!("reconstructed(samples, 0.5, tent, {x})"), reconstructed(&SAMPLES, 0.5, &tent, x), truth)
            },
        ),
        Line::new(text!("boxes, T = 2: the nearest sample", "прямоугольники, T = 2: ближайший отсчёт"), allowed).over(
            [0.3, 1.7, 8.9, 15.2],
            |x| {
                let nearest = SAMPLES[(x / 2.0 + 0.5) as usize];
                (format!("reconstructed(samples, 2, box, {x})"), reconstructed(&SAMPLES, 2.0, &rectangle, x), nearest)
            },
        ),
        [49.97, 50.0, 50.1].into_iter().fold(
            Line::new(text!("sinc, T = ¼: a tone comes back", "sinc, T = ¼: синусоида вернулась"), tail),
            quarter,
        ),
    ]
}
