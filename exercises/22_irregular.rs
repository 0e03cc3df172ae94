//! Irregular samples can be undone.

// %% en F38 E12
// # Recover from irregular samples
//
// A function c₀ + c₁ cos(2πx) + c₂ sin(2πx) was read at irregular, known places. The lecture says that this «will not
// help to recover the signal exactly». Recover [c₀, c₁, c₂] by least squares.
//
// The normal equations are three: for each of the functions 1, cos, sin the rest (value minus fit), multiplied by it and
// summed over the places, is zero.
// %% ru
// # Восстановить по нерегулярным отсчётам
//
// Функцию c₀ + c₁ cos(2πx) + c₂ sin(2πx) прочли в нерегулярных, но известных местах. В лекции сказано, что это «не поможет
// восстановить исходный сигнал в точности». Восстановите [c₀, c₁, c₂] методом наименьших квадратов.
//
// Нормальных уравнений три: для каждой из функций 1, cos, sin сумма по всем местам произведений этой функции на остаток
// (значение минус приближение) равна нулю.
// %% hint en
// Build the 3 × 3 matrix of sums of products of 1, cos, sin, and the right side of sums of values times them.
// %% hint ru
// Составьте матрицу 3 × 3 из сумм попарных произведений 1, cos, sin и правую часть из сумм их произведений на значения.
// %% hint en
// Three unknowns: Cramer's rule with 3 × 3 determinants, or elimination.
// %% hint ru
// Неизвестных три: правило Крамера с определителями 3 × 3 или метод исключения.

// %% answer
use std::f64::consts::PI;

// %% ru c₀, c₁, c₂ функции c₀ + c₁ cos(2πx) + c₂ sin(2πx) по значениям в любых местах, методом наименьших квадратов.
/// c₀, c₁, c₂ of c₀ + c₁ cos(2πx) + c₂ sin(2πx) from values at any places, by least squares.
pub fn recovered(places: &[f64], values: &[f64]) -> [f64; 3] {
    // %% start [0.0, 0.0, 0.0]
    let mut matrix = [[0.0; 3]; 3];
    let mut right = [0.0; 3];
    for (x, value) in places.iter().zip(values) {
        let (sin, cos) = (2.0 * PI * x).sin_cos();
        let basis = [1.0, cos, sin];
        for i in 0..3 {
            right[i] += basis[i] * value;
            for k in 0..3 {
                matrix[i][k] += basis[i] * basis[k];
            }
        }
    }
    let determinant = |m: [[f64; 3]; 3]| {
        m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0])
            + m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0])
    };
    let whole = determinant(matrix);
    [0, 1, 2].map(|column| {
        let mut replaced = matrix;
        for (row, value) in replaced.iter_mut().zip(right) {
            row[column] = value;
        }
        determinant(replaced) / whole
    })
    // %% end
}

// %% check
use nyquist::exercise::{Line, Mistake};
use nyquist::num::random::uniform;
use nyquist::text;
use std::f64::consts;

pub type Answer = fn(&[f64], &[f64]) -> [f64; 3];
pub const ANSWER: Answer = recovered;

/// Means of values times 1, cos, sin of some positions, with factors.
fn means(places: &[f64], values: &[f64], factors: [f64; 3]) -> [f64; 3] {
    let n = values.len() as f64;
    let wave = [|_: f64| 1.0, |x: f64| (consts::TAU * x).cos(), |x: f64| (consts::TAU * x).sin()];
    let mean = |i: usize| places.iter().zip(values).map(|(x, value)| wave[i](*x) * value).sum::<f64>() / n;
    [0, 1, 2].map(|i| factors[i] * mean(i))
}

pub const MISTAKES: [Mistake<Answer>; 3] = [
    Mistake::new(
        |places, values| means(places, values, [1.0, 2.0, 2.0]),
        "Those are the sums for evenly spaced samples. Here 1, cos and sin are not orthogonal: solve the three equations together.",
        "Это суммы для равномерных отсчётов. Здесь 1, cos и sin не ортогональны: решайте три уравнения вместе.",
    ),
    Mistake::new(
        |places, values| means(places, values, [1.0, 1.0, 1.0]),
        "Those are the sums for evenly spaced samples, and without their factor 2. Here all three equations hang together.",
        "Это суммы для равномерных отсчётов, да ещё без множителя 2. Здесь все три уравнения связаны.",
    ),
    Mistake::new(
        |_, values| {
            let even: Vec<f64> = (0..values.len()).map(|i| i as f64 / values.len() as f64).collect();
            means(&even, values, [1.0, 2.0, 2.0])
        },
        "You treat the samples as if they stood at equal steps. The places are known: use them.",
        "Вы считаете, что отсчёты стоят через равный шаг. Места известны: используйте их.",
    ),
];

pub fn demands(recovered: Answer) -> Vec<Line> {
    const TRUE: [f64; 3] = [0.5, -1.25, 2.0];
    let basis = |x: f64| [1.0, (consts::TAU * x).cos(), (consts::TAU * x).sin()];
    let value = |c: [f64; 3], x: f64| basis(x).iter().zip(c).map(|(wave, c)| wave * c).sum::<f64>();
    // one place in each of twelve cells; the condition of their normal equations is below 100
    let places: Vec<f64> = (0..12).map(|i| (i as f64 + uniform(1, i, 0)) / 12.0).collect();
    let clean: Vec<f64> = places.iter().map(|x| value(TRUE, *x)).collect();
    let noisy: Vec<f64> = clean.iter().zip(0..).map(|(v, i)| v + uniform(2, i, 0) - 0.5).collect();
    // sums of 12 products up to 4 and determinants of them, times the condition
    let allowed = 100.0 * 12.0 * 4.0 * 6.0 * f64::EPSILON;
    let exact = recovered(&places, &clean);
    let fitted = recovered(&places, &noisy);
    let three = recovered(&[0.05, 0.3, 0.8], &[0.05, 0.3, 0.8].map(|x| value(TRUE, x)));
    let normal = |i: usize| places.iter().zip(&noisy).map(|(x, v)| basis(*x)[i] * (v - value(fitted, *x))).sum::<f64>();
    vec![
        Line::new(text!("twelve irregular samples: exact", "двенадцать нерегулярных отсчётов: точно"), allowed).list(
            "recovered(places, values)",
            &exact,
            &TRUE,
        ),
        Line::new(text!("three samples suffice", "хватает трёх отсчётов"), allowed).list(
            "recovered(three, values)",
            &three,
            &TRUE,
        ),
        Line::new(
            text!("with noise: the rest is orthogonal to 1, cos, sin", "с шумом: остаток ортогонален 1, cos, sin"),
            12.0 * allowed,
        )
        .case("Σ rest", normal(0), 0.0)
        .case("Σ rest·cos", normal(1), 0.0)
        .case("Σ rest·sin", normal(2), 0.0),
    ]
}
