//! A pixel from scattered samples.

// %% en F56
// # The film's sum
//
// Samples (x_i, y_i, L_i) lie around a pixel at (x, y). The pixel's value is
//
//     I(x, y) = Σ f(x − x_i, y − y_i) L_i / Σ f(x − x_i, y − y_i)
//
// Compute it for any filter f. If the weights add up to zero, the pixel is 0.
// %% ru
// # Сумма на плёнке
//
// Отсчёты (x_i, y_i, L_i) разбросаны вокруг пикселя (x, y). Значение пикселя —
//
//     I(x, y) = Σ f(x − x_i, y − y_i) L_i / Σ f(x − x_i, y − y_i)
//
// Вычислите его для любого фильтра f. Если сумма весов — нуль, пиксель равен 0.
// %% hint en
// Two sums in one loop: of the weights, and of weights times values.
// %% hint ru
// Две суммы в одном цикле: весов и весов, умноженных на значения.
// %% hint en
// The filter sees the distance from the sample to the pixel, not the place of the sample.
// %% hint ru
// Фильтр получает расстояние от отсчёта до пикселя, а не место отсчёта.

// %% answer
// %% ru Значение пикселя (x, y) по отсчётам [x_i, y_i, L_i].
/// The value of the pixel at (x, y) from samples [x_i, y_i, L_i].
pub fn pixel(samples: &[[f64; 3]], [x, y]: [f64; 2], filter: &dyn Fn(f64, f64) -> f64) -> f64 {
    // %% start 0.0
    let (mut sum, mut weights) = (0.0, 0.0);
    for [at_x, at_y, light] in samples {
        let weight = filter(x - at_x, y - at_y);
        sum += weight * light;
        weights += weight;
    }
    if weights == 0.0 { 0.0 } else { sum / weights }
    // %% end
}

// %% check
use nyquist::exercise::{Line, Mistake};
use nyquist::num::random::uniform;
use nyquist::text;

pub type Answer = fn(&[[f64; 3]], [f64; 2], &dyn Fn(f64, f64) -> f64) -> f64;
pub const ANSWER: Answer = pixel;

/// Σ w L and Σ w for weights of the samples.
fn sums(samples: &[[f64; 3]], weight: impl Fn(f64, f64) -> f64) -> [f64; 2] {
    let each = samples.iter().map(|[x, y, light]| (weight(*x, *y), light));
    each.fold([0.0, 0.0], |[sum, weights], (weight, light)| [sum + weight * light, weights + weight])
}

/// Their quotient; zero for no weight.
fn quotient([sum, weights]: [f64; 2]) -> f64 {
    if weights == 0.0 { 0.0 } else { sum / weights }
}

pub const MISTAKES: [Mistake<Answer>; 4] = [
    Mistake::new(
        |samples, [x, y], filter| sums(samples, |at_x, at_y| filter(x - at_x, y - at_y))[0],
        "The division by the sum of the weights is missing: where samples are dense the picture becomes brighter.",
        "Не хватает деления на сумму весов: где отсчётов больше, там картина ярче.",
    ),
    Mistake::new(
        |samples, [x, y], filter| {
            let [sum, _] = sums(samples, |at_x, at_y| filter(x - at_x, y - at_y));
            if samples.is_empty() { 0.0 } else { sum / samples.len() as f64 }
        },
        "You divide by the number of samples; divide by the sum of their weights.",
        "Вы делите на число отсчётов, а надо на сумму их весов.",
    ),
    Mistake::new(
        |samples, _, filter| quotient(sums(samples, filter)),
        "You weigh the samples by their own place: the filter stands on the pixel, f(x − x_i, y − y_i).",
        "Вы взвешиваете отсчёты по их собственному месту, а фильтр стоит на пикселе: f(x − x_i, y − y_i).",
    ),
    Mistake::new(
        |samples, [x, y], filter| {
            let [sum, weights] = sums(samples, |at_x, at_y| filter(x - at_x, y - at_y));
            sum / weights
        },
        "Right, except where no sample is near: 0/0 is NaN, and the pixel should be 0.",
        "Верно, но там, где отсчётов рядом нет, 0/0 — это NaN, а пиксель должен быть 0.",
    ),
];

pub fn demands(pixel: Answer) -> Vec<Line> {
    let at = |i: u64, d: u32| 3.0 * uniform(5, i, d) - 0.5;
    let light = |x: f64, y: f64| 1.0 + 2.0 * x - 0.5 * y;
    let samples: Vec<[f64; 3]> = (0..24).map(|i| [at(i, 0), at(i, 1), uniform(5, i, 2)]).collect();
    let even: Vec<[f64; 3]> = samples.iter().map(|[x, y, _]| [*x, *y, 0.75]).collect();
    // symmetric pairs around a place: a plane has its own value in the middle
    let place = [0.8, 1.1];
    let pairs: Vec<[f64; 3]> = samples
        .iter()
        .flat_map(|[x, y, _]| [[*x, *y], [2.0 * place[0] - x, 2.0 * place[1] - y]])
        .map(|[x, y]| [x, y, light(x, y)])
        .collect();
    let tent = |x: f64, y: f64| (2.0 - x.abs()).max(0.0) * (2.0 - y.abs()).max(0.0);
    let near = |x: f64, y: f64| if x.abs() < 1.0 && y.abs() < 1.0 { 1.0 } else { 0.0 };
    // a box filter takes the plain mean of what lies in it
    let inside: Vec<f64> = samples.iter().filter(|[x, y, _]| near(1.0 - x, 1.0 - y) > 0.0).map(|s| s[2]).collect();
    let mean = inside.iter().sum::<f64>() / inside.len() as f64;
    // sums of 48 products of weights up to 4 with values up to 6, divided by at least one
    let allowed = 48.0 * 4.0 * 6.0 * 2.0 * f64::EPSILON;
    vec![
        Line::new(text!("even light stays even", "ровный свет остаётся ровным"), allowed)
            .case("pixel(even, [1, 1], tent)", pixel(&even, [1.0, 1.0], &tent), 0.75)
            .case("pixel(even, [0, 2], tent)", pixel(&even, [0.0, 2.0], &tent), 0.75),
        Line::new(text!("a box takes the mean of its samples", "прямоугольник усредняет свои отсчёты"), allowed).case(
            "pixel(samples, [1, 1], box)",
            pixel(&samples, [1.0, 1.0], &near),
            mean,
        ),
        Line::new(
            text!("in the middle of pairs a plane has its value", "в середине пар у плоскости своё значение"),
            allowed,
        )
        .case("pixel(pairs, [0.8, 1.1], tent)", pixel(&pairs, place, &tent), light(place[0], place[1])),
        Line::new(text!("no samples near: zero", "рядом нет отсчётов: нуль"), 0.0)
            .case("pixel(samples, [50, 50], tent)", pixel(&samples, [50.0, 50.0], &tent), 0.0)
            .case("pixel(&[], [0, 0], tent)", pixel(&[], [0.0, 0.0], &tent), 0.0),
    ]
}
