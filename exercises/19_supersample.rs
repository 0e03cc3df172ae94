//! A pixel from several samples.

// %% en F33 F35
// # Supersample
//
// Pixel i covers the interval from i to i + 1. Read f at n points in it, evenly spread and symmetric about its middle (each
// in the middle of its n-th part), and give their mean: Pixel = Σ w_s · Sample_s.
// %% ru
// # Суперсэмплинг
//
// Пиксель i занимает интервал от i до i + 1. Прочтите f в n точках, равномерно и симметрично относительно середины
// (каждая в середине своей n-й части), и верните среднее: Pixel = Σ w_s · Sample_s.
// %% hint en
// With n = 1 the only sample is in the middle of the pixel.
// %% hint ru
// При n = 1 единственный отсчёт стоит в середине пикселя.
// %% hint en
// The samples stand at i + (j + ½)/n for j = 0, …, n − 1; all weights are 1/n, so that a constant stays what it is.
// %% hint ru
// Отсчёты стоят в точках i + (j + ½)/n, j = 0, …, n − 1; все веса — 1/n, чтобы константа не менялась.

// %% answer
// %% ru Среднее n отсчётов f в пикселе от i до i + 1.
/// The mean of n samples of f in the pixel from i to i + 1.
pub fn pixel(f: &dyn Fn(f64) -> f64, i: i32, n: u32) -> f64 {
    // %% start 0.0
    let place = |j: u32| f64::from(i) + (f64::from(j) + 0.5) / f64::from(n);
    (0..n).map(|j| f(place(j))).sum::<f64>() / f64::from(n)
    // %% end
}

// %% check
use nyquist::exercise::{Line, Mistake};
use nyquist::text;
use std::f64::consts;

pub type Answer = fn(&dyn Fn(f64) -> f64, i32, u32) -> f64;
pub const ANSWER: Answer = pixel;

/// The sum over n samples, the first at an offset in units of the pixel.
fn sum(f: &dyn Fn(f64) -> f64, i: i32, n: u32, offset: f64, step: f64) -> f64 {
    (0..n).map(|j| f(f64::from(i) + offset + step * f64::from(j))).sum()
}

pub const MISTAKES: [Mistake<Answer>; 4] = [
    Mistake::new(
        |f, i, n| sum(f, i, n, 0.0, 1.0 / f64::from(n)) / f64::from(n),
        "Your samples begin at the left edge: the picture is moved by half of their spacing.",
        "Ваши отсчёты начинаются с левого края: картина сдвинута на половину их шага.",
    ),
    Mistake::new(
        |f, i, n| sum(f, i, n, 0.5 / f64::from(n), 1.0 / f64::from(n)),
        "The weights must add up to one, or the picture becomes n times as bright: divide by n.",
        "Сумма весов должна быть 1, иначе картина станет ярче в n раз: разделите на n.",
    ),
    Mistake::new(
        |f, i, n| {
            let step = if n > 1 { 1.0 / f64::from(n - 1) } else { 0.0 };
            sum(f, i, n, if n > 1 { 0.0 } else { 0.5 }, step) / f64::from(n)
        },
        "Both edges of the pixel are samples of yours: the neighbours read the same points once more.",
        "Вы ставите отсчёты на оба края пикселя, и соседние пиксели читают те же точки ещё раз.",
    ),
    Mistake::new(
        |f, i, n| sum(f, i, n, -0.5 + 0.5 / f64::from(n), 1.0 / f64::from(n)) / f64::from(n),
        "You centred the samples on i. Here pixel i goes from i to i + 1, and its middle is i + ½.",
        "Вы расставили отсчёты вокруг i. Здесь пиксель занимает место от i до i + 1, середина — i + ½.",
    ),
];

pub fn demands(pixel: Answer) -> Vec<Line> {
    // n equal weights multiply a tone by D = sin(πν)/(n sin(πν/n)) and leave it in the pixel's middle
    let transfer = |nu: f64, n: f64| {
        let below = (consts::PI * nu / n).sin();
        if below == 0.0 { 1.0 } else { (consts::PI * nu).sin() / (n * below) }
    };
    // cosines of angles up to 2π·3.9·9, each off by ε·angle; D near its peaks divides by sin ≥ 0.07
    let allowed = 2.0 * f64::EPSILON * consts::TAU * 3.9 * 9.0 / 0.07;
    let case = |i: i32, n: u32| {
        move |nu: f64| {
            let said = pixel(&|x| (consts::TAU * nu * x).cos(), i, n);
            let middle = (consts::TAU * nu * (f64::from(i) + 0.5)).cos();
            (format!("pixel(cos(2π·{nu}·x), {i}, {n})"), said, middle * transfer(nu, f64::from(n)))
        }
    };
    vec![
        Line::new(text!("a constant is left as it is", "константа не меняется"), 8.0 * f64::EPSILON)
            .case("pixel(1, 3, 4)", pixel(&|_| 1.0, 3, 4), 1.0)
            .case("pixel(1, 0, 7)", pixel(&|_| 1.0, 0, 7), 1.0),
        Line::new(text!("n = 1: the middle", "n = 1: середина"), allowed).over([0.1, 0.3, 0.7], case(2, 1)),
        Line::new(
            text!("n = 4: nothing of frequency 1, nearly all of 3.9", "n = 4: от частоты 1 ничего, от 3,9 почти всё"),
            allowed,
        )
        .along(text!("frequency ν", "частота ν"))
        .over((0..=39).map(|i| f64::from(i) / 10.0), case(0, 4)),
        Line::new(text!("another pixel, n = 5", "другой пиксель, n = 5"), allowed).over([0.2, 0.9, 2.4], case(8, 5)),
    ]
}
