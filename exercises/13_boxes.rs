//! The convolution of two boxes.

// %% en F17
// # Convolve two boxes
//
// f is 1 on an interval of width a around zero and 0 elsewhere; g is the same with width b. What is their convolution
//
//     (f ⊗ g)(x) = ∫ f(y) g(x − y) dy ?
// %% ru
// # Свернуть два прямоугольника
//
// f равна 1 на интервале ширины a вокруг нуля и 0 вне его; g — то же с шириной b. Чему равна их свёртка
//
//     (f ⊗ g)(x) = ∫ f(y) g(x − y) dy ?
// %% hint en
// The integrand is 1 where both boxes are: the integral is the length of the overlap of two intervals.
// %% hint ru
// Подынтегральная функция равна 1 там, где есть оба: интеграл — длина пересечения двух интервалов.
// %% hint en
// The overlap is at most min(a, b), never below 0, and between that falls as (a + b)/2 − |x|.
// %% hint ru
// Пересечение не больше min(a, b), не меньше 0, а между ними убывает как (a + b)/2 − |x|.

// %% answer
// %% ru Свёртка прямоугольников ширины a и b в точке x.
/// The convolution at x of boxes of widths a and b.
pub fn convolved(a: f64, b: f64, x: f64) -> f64 {
    // %% start 0.0
    (0.5 * (a + b) - x.abs()).clamp(0.0, a.min(b))
    // %% end
}

// %% check
use nyquist::exercise::{Line, Mistake};
use nyquist::text;

pub type Answer = fn(f64, f64, f64) -> f64;
pub const ANSWER: Answer = convolved;

pub const MISTAKES: [Mistake<Answer>; 4] = [
    Mistake::new(
        |a, b, x| (0.5 * (a + b) - x.abs()).max(0.0),
        "The top is flat if the widths differ: the overlap cannot be longer than the shorter box.",
        "При разной ширине вершина плоская: пересечение не длиннее короткого прямоугольника.",
    ),
    Mistake::new(
        |a, b, x| a.min(b) * (1.0 - x.abs() / a.max(b)).max(0.0),
        "A tent comes only from two equal boxes; from different ones comes a trapezium.",
        "Треугольник получается только из двух равных прямоугольников, из разных — трапеция.",
    ),
    Mistake::new(
        |a, b, x| if x.abs() < 0.5 * a.min(b) { 1.0 } else { 0.0 },
        "That is the product of the boxes. In a convolution one of them slides along the other.",
        "Это произведение прямоугольников. В свёртке один из них скользит вдоль другого.",
    ),
    Mistake::new(
        |a, b, x| ((0.5 * (a + b) - x.abs()) / a.max(b)).clamp(0.0, a.min(b) / a.max(b)),
        "You have divided by the wider box: that is a mean, as of a pixel. The convolution is the integral itself.",
        "Вы разделили на более широкий: это среднее, как у пикселя. Свёртка — сам интеграл.",
    ),
];

pub fn demands(convolved: Answer) -> Vec<Line> {
    // the length of what both intervals share
    let truth = |a: f64, b: f64, x: f64| ((0.5 * a).min(x + 0.5 * b) - (-0.5 * a).max(x - 0.5 * b)).max(0.0);
    // a few additions of numbers below 4
    let allowed = 8.0 * f64::EPSILON * 4.0;
    let case = |a: f64, b: f64| move |x: f64| (format!("convolved({a}, {b}, {x})"), convolved(a, b, x), truth(a, b, x));
    let places = || (-40..=40).map(|i| f64::from(i) / 20.0);
    vec![
        Line::new(text!("a = b = 1: a tent", "a = b = 1: треугольник"), allowed).over(places(), case(1.0, 1.0)),
        Line::new(text!("a = 1, b = 2.5", "a = 1, b = 2.5"), allowed)
            .along(text!("x", "x"))
            .over(places(), case(1.0, 2.5)),
        Line::new(text!("a = 0.8, b = 0.3", "a = 0.8, b = 0.3"), allowed).over(places(), case(0.8, 0.3)),
    ]
}
