//! The Fourier integral as a sum.

// %% en F12
// # The Fourier transform as a sum
//
// F(ν) = ∫ f(x) e^(−2πiνx) dx. Compute it from `from` to `to` by the midpoint rule: n equal steps, the function read in
// the middle of each. Give [real part, imaginary part].
// %% ru
// # Преобразование Фурье суммой
//
// F(ν) = ∫ f(x) e^(−2πiνx) dx. Вычислите его от `from` до `to` по формуле средних: n равных шагов, функция читается в
// середине каждого. Верните [действительную часть, мнимую часть].
// %% hint en
// e^(−ia) = cos a − i sin a: two sums at once.
// %% hint ru
// e^(−ia) = cos a − i sin a: две суммы сразу.
// %% hint en
// The middle of step i is from + (i + ½)·(to − from)/n, and each term is multiplied by the width of its step.
// %% hint ru
// Середина шага i — from + (i + ½)·(to − from)/n, и каждое слагаемое умножается на ширину шага.

// %% answer
use std::f64::consts::PI;

// %% ru F(ν) функции f на отрезке по формуле средних с n шагами: действительная и мнимая части.
/// F(ν) of f between two ends, by the midpoint rule of n steps: real and imaginary part.
pub fn transform(f: &dyn Fn(f64) -> f64, from: f64, to: f64, n: usize, nu: f64) -> [f64; 2] {
    // %% start [0.0, 0.0]
    let step = (to - from) / n as f64;
    let mut sum = [0.0, 0.0];
    for i in 0..n {
        let x = from + (i as f64 + 0.5) * step;
        let (sin, cos) = (2.0 * PI * nu * x).sin_cos();
        sum[0] += step * f(x) * cos;
        sum[1] -= step * f(x) * sin;
    }
    sum
    // %% end
}

// %% check
use nyquist::exercise::{Line, Mistake};
use nyquist::text;
use std::f64::consts;

pub type Answer = fn(&dyn Fn(f64) -> f64, f64, f64, usize, f64) -> [f64; 2];
pub const ANSWER: Answer = transform;

/// The midpoint rule with another factor in the exponent.
fn midpoint(f: &dyn Fn(f64) -> f64, [from, to]: [f64; 2], n: usize, turn: f64) -> [f64; 2] {
    let step = (to - from) / n as f64;
    let terms = (0..n).map(|i| from + (i as f64 + 0.5) * step).map(|x| (f(x), (turn * x).sin_cos()));
    terms.fold([0.0, 0.0], |[re, im], (f, (sin, cos))| [re + step * f * cos, im + step * f * sin])
}

pub const MISTAKES: [Mistake<Answer>; 4] = [
    Mistake::new(
        |f, from, to, n, nu| midpoint(f, [from, to], n, consts::TAU * nu),
        "The exponent has a minus: e^(−2πiνx). Yours is the inverse transform, and the imaginary part has the wrong sign.",
        "В показателе минус: e^(−2πiνx). У вас обратное преобразование, и знак мнимой части неверен.",
    ),
    Mistake::new(
        |f, from, to, n, nu| midpoint(f, [from, to], n, -consts::TAU * nu).map(|sum| sum * n as f64 / (to - from)),
        "You forgot the width of the step: the sum grows with n instead of coming to the integral.",
        "Забыта ширина шага: сумма растёт с n, а не сходится к интегралу.",
    ),
    Mistake::new(
        |f, from, to, n, nu| midpoint(f, [from, to], n, -nu),
        "You forgot 2π: frequencies are in cycles per unit, and a cycle is 2π.",
        "Забыто 2π: частоты — в периодах на единицу, а период — это 2π.",
    ),
    Mistake::new(
        |f, from, to, n, nu| [midpoint(f, [from, to], n, -consts::TAU * nu)[0], 0.0],
        "Only the real part is there. The imaginary part is zero for even functions alone.",
        "Есть только действительная часть. Мнимая равна нулю лишь у чётных функций.",
    ),
];

pub fn demands(transform: Answer) -> Vec<Line> {
    const STEPS: usize = 2000;
    // the midpoint rule errs by less than L³/(24n²)·max|g″|; for g = f·e^(…), f up to 1 and linear on [0, 1], and ν up to
    // 3, |g″| ≤ (2πν)² + 2·2πν
    let turn = consts::TAU * 3.0;
    let allowed = (turn * turn + 2.0 * turn) / (24.0 * (STEPS * STEPS) as f64);
    let places = || (0..=24).map(|i| f64::from(i) / 8.0);
    let flat = |nu: f64| transform(&|_| 1.0, -0.5, 0.5, STEPS, nu);
    let ramp = |nu: f64| transform(&|x| x, 0.0, 1.0, STEPS, nu);
    // ∫ x e^(−iax) dx over [0, 1] = (cos a + a sin a − 1)/a² + i(a cos a − sin a)/a², and ½ for a = 0
    let truth = |nu: f64| {
        let a = consts::TAU * nu;
        let (sin, cos) = a.sin_cos();
        if a == 0.0 { [0.5, 0.0] } else { [(cos + a * sin - 1.0) / (a * a), (a * cos - sin) / (a * a)] }
    };
    vec![
        Line::new(text!("a box: sinc ν", "прямоугольник: sinc ν"), allowed)
            .along(text!("frequency ν", "частота ν"))
            .over(places(), |nu| {
                (format!("transform(1, −½, ½, {STEPS}, {nu})[0]"), flat(nu)[0], nyquist::num::sinc(nu))
            }),
        Line::new(text!("a ramp, real part", "линейный рост, действительная часть"), allowed)
            .over(places(), |nu| (format!("transform(x, 0, 1, {STEPS}, {nu})[0]"), ramp(nu)[0], truth(nu)[0])),
        Line::new(text!("a ramp, imaginary part", "линейный рост, мнимая часть"), allowed)
            .along(text!("frequency ν", "частота ν"))
            .over(places(), |nu| (format!("transform(x, 0, 1, {STEPS}, {nu})[1]"), ramp(nu)[1], truth(nu)[1])),
    ]
}
