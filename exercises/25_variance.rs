//! Random and stratified samples of the simplest function.

// %% en F49 F51 F53
// # What strata are worth
//
// ∫ x dx from 0 to 1 is estimated by the mean of n samples. Give two variances of this mean: for n independent random
// samples, and for one random sample in each of n equal strata (jitter).
// %% ru
// # Чего стоят страты
//
// ∫ x dx от 0 до 1 оценивают средним n отсчётов. Верните две дисперсии этого среднего: для n независимых случайных
// отсчётов и для одного случайного отсчёта в каждой из n равных страт (джиттер).
// %% hint en
// A number spread evenly over an interval of width w has the variance w²/12.
// %% hint ru
// У числа, равномерно распределённого на отрезке длины w, дисперсия w²/12.
// %% hint en
// The mean of n independent numbers has the sum of their variances divided by n². In both cases they are independent.
// %% hint ru
// Дисперсия среднего n независимых чисел — сумма их дисперсий, делённая на n². В обоих случаях они независимы.

// %% answer
// %% ru Дисперсии среднего n отсчётов f(x) = x: случайных и по одному в каждой из n страт.
/// The variance of the mean of n samples of f(x) = x: random, and one in each of n strata.
pub fn variances(n: u32) -> [f64; 2] {
    // %% start [0.0, 0.0]
    let n = f64::from(n);
    [1.0 / (12.0 * n), 1.0 / (12.0 * n.powi(3))]
    // %% end
}

// %% check
use nyquist::exercise::{Line, Mistake};
use nyquist::num::quadrature::integrate;
use nyquist::text;

pub type Answer = fn(u32) -> [f64; 2];
pub const ANSWER: Answer = variances;

pub const MISTAKES: [Mistake<Answer>; 4] = [
    Mistake::new(
        |n| [1.0 / 12.0, 1.0 / (12.0 * f64::from(n).powi(2))],
        "Those are the variances of one sample. The mean of n independent ones has an n-th part of that.",
        "Это дисперсии одного отсчёта. У среднего n независимых — в n раз меньше.",
    ),
    Mistake::new(
        |n| [1.0 / (12.0 * f64::from(n)), 1.0 / (12.0 * f64::from(n).powi(2))],
        "Random is right. In a stratum the width is 1/n, so the variance of a sample 1/(12n²); the mean then has an n-th of it.",
        "Случайные верно. В страте ширина 1/n, дисперсия отсчёта 1/(12n²), а у среднего — ещё в n раз меньше.",
    ),
    Mistake::new(
        |n| [1.0 / (12.0 * f64::from(n)).sqrt(), 1.0 / (12.0 * f64::from(n).powi(3)).sqrt()],
        "Those are standard deviations; their squares are the variances.",
        "Это стандартные отклонения, а дисперсии — их квадраты.",
    ),
    Mistake::new(
        |n| [1.0 / (12.0 * f64::from(n)); 2],
        "Strata do help: within one of them x varies by 1/n only.",
        "Страты помогают: внутри одной x меняется лишь на 1/n.",
    ),
];

pub fn demands(variances: Answer) -> Vec<Line> {
    // the sum over strata of the variance within, by the integral of the squared deviation, divided by n²
    let within = |a: f64, b: f64| integrate(|x| (x - 0.5 * (a + b)) * (x - 0.5 * (a + b)), a, b, 1e-16).value / (b - a);
    let random = |n: f64| within(0.0, 1.0) / n;
    let strata =
        |n: f64| (0..n as u32).map(|i| within(f64::from(i) / n, (f64::from(i) + 1.0) / n)).sum::<f64>() / (n * n);
    // relative errors: the quadrature's 10⁻¹⁶ beside variances of a stratum from 1/(12·16²) on, over widths of 1/16
    const ALLOWED: f64 = 1e-16 * 16.0 * 12.0 * 256.0 + 64.0 * f64::EPSILON;
    let ask =
        |i: usize, truth: f64, n: f64| (format!("variances({n})[{i}] / truth"), variances(n as u32)[i] / truth, 1.0);
    let counts = || [1.0, 2.0, 5.0, 16.0];
    vec![
        Line::new(text!("random", "случайные отсчёты"), ALLOWED).over(counts(), |n| ask(0, random(n), n)),
        Line::new(text!("stratified", "со стратами"), ALLOWED).over(counts(), |n| ask(1, strata(n), n)),
    ]
}
