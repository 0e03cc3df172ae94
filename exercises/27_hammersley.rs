//! The points of Hammersley.

// %% en F54
// # Hammersley's points
//
// The i-th of n points of Hammersley is (i/n, Φ₂(i)), i = 0, …, n − 1: evenly spread in x, and in y by the radical inverse
// in base 2 (exercise 26; `reverse_bits` helps). Give all n.
// %% ru
// # Точки Хаммерсли
//
// Точка номер i из n точек Хаммерсли — (i/n, Φ₂(i)), i = 0, …, n − 1: по x они равномерны, по y идут обращения разрядов
// по основанию 2 (упражнение 26; поможет `reverse_bits`). Верните все n.
// %% hint en
// `i.reverse_bits()` reflects the 32 bits of a u32. Which number must it be divided by to lie between 0 and 1?
// %% hint ru
// `i.reverse_bits()` отражает 32 бита числа u32. На что его разделить, чтобы получить число от 0 до 1?
// %% hint en
// The point stands before the highest bit: divide by 2³².
// %% hint ru
// Запятая — перед старшим битом: разделите на 2³².

// %% answer
// %% ru Все n точек Хаммерсли в единичном квадрате.
/// The n points of Hammersley in the unit square.
pub fn hammersley(n: u32) -> Vec<[f64; 2]> {
    // %% start Vec::new()
    let inverse = |i: u32| f64::from(i.reverse_bits()) / 4_294_967_296.0;
    (0..n).map(|i| [f64::from(i) / f64::from(n), inverse(i)]).collect()
    // %% end
}

// %% check
use nyquist::exercise::{Line, Mistake};
use nyquist::pattern::radical::radical_inverse;
use nyquist::text;

pub type Answer = fn(u32) -> Vec<[f64; 2]>;
pub const ANSWER: Answer = hammersley;

/// The radical inverse, from the library.
fn inverse(base: u32, index: u32) -> f64 {
    radical_inverse(base, index).map_or(f64::NAN, |fraction| fraction.value())
}

pub const MISTAKES: [Mistake<Answer>; 4] = [
    Mistake::new(
        |n| (0..n).map(|i| [inverse(2, i), inverse(3, i)]).collect(),
        "Those are Halton's points. Hammersley's know their number beforehand, and x is simply i/n.",
        "Это точки Холтона. Точки Хаммерсли заранее знают своё число, и x — просто i/n.",
    ),
    Mistake::new(
        |n| (1..=n).map(|i| [f64::from(i) / f64::from(n), inverse(2, i)]).collect(),
        "Count from zero: the first point is (0, 0), and none stands at x = 1.",
        "Считайте с нуля: первая точка — (0, 0), а на x = 1 точек нет.",
    ),
    Mistake::new(
        |n| (0..n).map(|i| [f64::from(i) / f64::from(n - 1), inverse(2, i)]).collect(),
        "Divide by n and not by n − 1: the square is half-open, its right edge is the left one of the next.",
        "Делите на n, а не на n − 1: квадрат полуоткрыт, его правый край — левый край соседнего.",
    ),
    Mistake::new(
        |n| (0..n).map(|i| [f64::from(i) / f64::from(n), f64::from(i) / f64::from(n)]).collect(),
        "All points stand on the diagonal: reflect the digits of i for y.",
        "Все точки стоят на диагонали: для y отразите цифры числа i.",
    ),
];

pub fn demands(hammersley: Answer) -> Vec<Line> {
    let part = |points: Vec<[f64; 2]>, i: usize| points.into_iter().map(|point| point[i]).collect::<Vec<_>>();
    let truth = |n: u32| (0..n).map(|i| [f64::from(i) / f64::from(n), inverse(2, i)]).collect::<Vec<_>>();
    let ask = |line: Line, i: usize| {
        [2, 16, 27].into_iter().fold(line, |line, n| {
            line.list(&format!("hammersley({n})[{i}]"), &part(hammersley(n), i), &part(truth(n), i))
        })
    };
    // a division each
    vec![
        ask(Line::new(text!("x is evenly spread", "x распределены равномерно"), 2.0 * f64::EPSILON), 0),
        ask(Line::new(text!("y is the radical inverse", "y — обращения разрядов"), 2.0 * f64::EPSILON), 1),
    ]
}
