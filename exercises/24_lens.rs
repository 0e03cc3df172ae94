//! How large a point out of focus becomes.

// %% en F47 F53
// # The circle of confusion
//
// A thin lens of focal length f and aperture (diameter) A is focused on the distance s: the film stands where 1/d = 1/f − 1/s.
// Which diameter has the image of a point at the distance z on the film?
// %% ru
// # Кружок нерезкости
//
// Тонкая линза с фокусным расстоянием f и апертурой (диаметром) A наведена на расстояние s: плёнка стоит там, где
// 1/d = 1/f − 1/s. Каков на плёнке диаметр изображения точки, лежащей на расстоянии z?
// %% hint en
// The rays of the point meet at z′ with 1/z′ = 1/f − 1/z. Draw the cone from the rim of the lens to there.
// %% hint ru
// Лучи точки сходятся в z′, где 1/z′ = 1/f − 1/z. Нарисуйте конус от края линзы до этого места.
// %% hint en
// Similar triangles: at the film the cone is A·|z′ − d|/z′ wide.
// %% hint ru
// Подобные треугольники: на плёнке ширина конуса — A·|z′ − d|/z′.

// %% answer
// %% ru Диаметр изображения на плёнке точки, лежащей на расстоянии z.
/// The diameter on the film of the image of a point at the distance z.
pub fn blur(f: f64, aperture: f64, s: f64, z: f64) -> f64 {
    // %% start 0.0
    let film = 1.0 / (1.0 / f - 1.0 / s);
    let image = 1.0 / (1.0 / f - 1.0 / z);
    aperture * (image - film).abs() / image
    // %% end
}

// %% check
use nyquist::exercise::{Line, Mistake};
use nyquist::text;

pub type Answer = fn(f64, f64, f64, f64) -> f64;
pub const ANSWER: Answer = blur;

/// Where the image of a point at that distance is.
fn image(f: f64, distance: f64) -> f64 {
    1.0 / (1.0 / f - 1.0 / distance)
}

pub const MISTAKES: [Mistake<Answer>; 4] = [
    Mistake::new(
        |f, aperture, s, z| 0.5 * aperture * (image(f, z) - image(f, s)).abs() / image(f, z),
        "That is the radius; the diameter was asked for.",
        "Это радиус, а спрашивали диаметр.",
    ),
    Mistake::new(
        |f, aperture, s, z| aperture * (image(f, z) - image(f, s)) / image(f, z),
        "Nearer than the focus the point meets behind the film, and your diameter becomes negative beyond it: take the absolute value.",
        "Перед плоскостью фокуса лучи сходятся за плёнкой, за ней — перед плёнкой, и диаметр у вас меняет знак: возьмите модуль.",
    ),
    Mistake::new(
        |_, aperture, s, z| aperture * (z - s).abs() / z,
        "That circle lies in the plane in focus, among the objects. On the film it is smaller, by d/s.",
        "Этот кружок лежит в плоскости наводки, среди предметов. На плёнке он меньше в d/s раз.",
    ),
    Mistake::new(
        |f, aperture, _, z| aperture * (image(f, z) - f).abs() / image(f, z),
        "Your film stands at the focal length: that is a lens focused on infinity. It must be at the image of s.",
        "Ваша плёнка стоит в фокусе — так наводят на бесконечность. Она должна быть там, где изображение s.",
    ),
];

pub fn demands(blur: Answer) -> Vec<Line> {
    // two rays through the rim: from the axis at z to the height A/2, bent by h/f, on to the film
    let truth = |f: f64, aperture: f64, s: f64, z: f64| {
        let (height, film) = (0.5 * aperture, f * s / (s - f));
        2.0 * (height + film * (height / z - height / f)).abs()
    };
    // differences of numbers that nearly cancel: roundings of A, magnified by z′/f
    let allowed = 16.0 * f64::EPSILON;
    let case = |f: f64, aperture: f64, s: f64| {
        move |z: f64| (format!("blur({f}, {aperture}, {s}, {z})"), blur(f, aperture, s, z), truth(f, aperture, s, z))
    };
    vec![
        Line::new(text!("in focus: a point", "в фокусе: точка"), allowed).over([2.0], case(0.05, 0.025, 2.0)),
        Line::new(text!("50 mm, f/2, focused on 2 m", "50 мм, f/2, наводка на 2 м"), allowed)
            .along(text!("distance z, m", "расстояние z, м"))
            .over((4..=60).map(|i| f64::from(i) / 8.0), case(0.05, 0.025, 2.0)),
        Line::new(text!("another lens", "другая линза"), allowed).over([0.5, 3.0, 100.0], case(0.2, 0.05, 10.0)),
    ]
}
