//! How much of a pixel a half-plane covers.

// %% en F36 E13
// # Exact coverage
//
// The pixel is the square from −½ to ½ in x and y. Which part of its area lies in the half-plane u·x + v·y ≤ d? The normal
// (u, v) has length 1 and any direction.
// %% ru
// # Точное покрытие
//
// Пиксель — квадрат от −½ до ½ по x и y. Какая доля его площади лежит в полуплоскости u·x + v·y ≤ d? Нормаль (u, v)
// длины 1 направлена куда угодно.
// %% hint en
// Only |u| and |v| matter: the square is symmetric. Begin with an upright edge: u = 1, v = 0.
// %% hint ru
// Важны только |u| и |v|: квадрат симметричен. Начните с вертикальной границы: u = 1, v = 0.
// %% hint en
// Integrate the upright case over y: each row is covered by clamp((d − v·y)/u + ½, 0, 1). The integral is a sum of squares.
// %% hint ru
// Проинтегрируйте вертикальный случай по y: строка покрыта на clamp((d − v·y)/u + ½, 0, 1). Интеграл — сумма квадратов.
// %% hint en
// With g(t) = max(t, 0)²/2, a = |u|, b = |v| the area is
// (g(d + (a+b)/2) − g(d + (a−b)/2) − g(d − (a−b)/2) + g(d − (a+b)/2))/(ab). What if a or b is zero?
// %% hint ru
// Пусть g(t) = max(t, 0)²/2, a = |u|, b = |v|. Тогда площадь равна
// (g(d + (a+b)/2) − g(d + (a−b)/2) − g(d − (a−b)/2) + g(d − (a+b)/2))/(ab). А если a или b — нуль?

// %% answer
// %% ru Доля пикселя в полуплоскости u·x + v·y ≤ d; длина нормали — 1.
/// The part of the pixel that lies in u·x + v·y ≤ d, for a normal of length one.
pub fn coverage(u: f64, v: f64, d: f64) -> f64 {
    // %% start 0.0
    let (a, b) = (u.abs(), v.abs());
    if a * b < 1e-9 {
        return (d + 0.5).clamp(0.0, 1.0); // upright or level, up to a part of 10⁻⁹
    }
    let g = |t: f64| 0.5 * t.max(0.0) * t.max(0.0);
    let (sum, difference) = (0.5 * (a + b), 0.5 * (a - b));
    (g(d + sum) - g(d + difference) - g(d - difference) + g(d - sum)) / (a * b)
    // %% end
}

// %% check
use nyquist::exercise::{Line, Mistake};
use nyquist::num::quadrature::integrate_pieces;
use nyquist::text;

pub type Answer = fn(f64, f64, f64) -> f64;
pub const ANSWER: Answer = coverage;

pub const MISTAKES: [Mistake<Answer>; 4] = [
    Mistake::new(
        |_, _, d| (d + 0.5).clamp(0.0, 1.0),
        "You measure along the normal as if the edge were upright. A slanted edge enters the pixel at a corner.",
        "Вы измеряете вдоль нормали, будто граница вертикальна. Наклонная входит в пиксель через угол.",
    ),
    Mistake::new(
        |_, _, d| if d >= 0.0 { 1.0 } else { 0.0 },
        "That is one sample in the middle: black or white. Asked is the area.",
        "Это один отсчёт в середине: чёрное или белое. Спрашивают площадь.",
    ),
    Mistake::new(
        |u, v, d| (d / (u.abs() + v.abs()) + 0.5).clamp(0.0, 1.0),
        "Begin and end are right. Between them the area does not grow evenly: in the corners it is a square of the depth.",
        "Начало и конец верны. Между ними площадь растёт неравномерно: в углах — как квадрат глубины.",
    ),
    Mistake::new(
        |u, v, d| {
            let g = |t: f64| 0.5 * t.max(0.0) * t.max(0.0);
            let (a, b) = (u.abs(), v.abs());
            let (sum, difference) = (0.5 * (a + b), 0.5 * (a - b));
            (g(d + sum) - g(d + difference) - g(d - difference) + g(d - sum)) / (a * b)
        },
        "The formula is right, but for upright and level edges it is 0/0, which is NaN.",
        "Формула верна, но для вертикальных и горизонтальных границ она даёт 0/0, то есть NaN.",
    ),
];

pub fn demands(coverage: Answer) -> Vec<Line> {
    // row by row: the covered length of a row is linear in y between the places where it begins and ends
    let truth = |u: f64, v: f64, d: f64| {
        let (u, v) = if u.abs() < v.abs() { (v.abs(), u.abs()) } else { (u.abs(), v.abs()) };
        let row = |y: f64| ((d - v * y) / u + 0.5).clamp(0.0, 1.0);
        let mut breaks = vec![-0.5, 0.5];
        if v > 0.0 {
            breaks.extend([(d - 0.5 * u) / v, (d + 0.5 * u) / v].into_iter().filter(|y| y.abs() < 0.5));
        }
        breaks.sort_by(f64::total_cmp);
        integrate_pieces(row, &breaks, 1e-14).value
    };
    // squares up to 1 are subtracted and divided by uv, which is 0.03 at least where it is not zero
    let allowed = 16.0 * f64::EPSILON / 0.03;
    let case = |degrees: f64| {
        let (v, u) = f64::to_radians(degrees).sin_cos();
        move |d: f64| (format!("coverage({u:.4}, {v:.4}, {d})"), coverage(u, v, d), truth(u, v, d))
    };
    let places = || (-16..=16).map(|i| f64::from(i) / 20.0);
    let upright = |d: f64| (format!("coverage(1, 0, {d})"), coverage(1.0, 0.0, d), (d + 0.5).clamp(0.0, 1.0));
    let level = |d: f64| (format!("coverage(0, −1, {d})"), coverage(0.0, -1.0, d), (d + 0.5).clamp(0.0, 1.0));
    vec![
        Line::new(text!("upright and level edges", "вертикальные и горизонтальные границы"), allowed)
            .over(places(), upright)
            .over(places(), level),
        Line::new(text!("an edge at 20°", "граница под углом 20°"), allowed)
            .along(text!("distance d", "расстояние d"))
            .over(places(), case(20.0)),
        Line::new(text!("other directions", "другие направления"), allowed)
            .over(places(), case(45.0))
            .over(places(), case(110.0))
            .over(places(), case(-62.0)),
    ]
}
