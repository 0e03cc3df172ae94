//! Moiré: a grating too fine for the pixels, folded in both directions.

// %% en F03
// # Find the moiré
//
// A grating has (u, v) cycles per pixel along x and along y. It is sampled once a pixel. Which frequency (cycles per
// pixel) has the grating that is seen, and which angle? Give [frequency, angle]: the angle in degrees from 0 up to, but
// not including, 180, of the direction across the stripes, since (u, v) and (−u, −v) are the same stripes.
// %% ru
// # Найти муар
//
// У решётки (u, v) периодов на пиксель по x и по y. Её дискретизируют по отсчёту на пиксель. Какова частота (периодов на
// пиксель) видимой решётки и под каким она углом? Верните [частота, угол]: угол в градусах от 0 до 180, не включая 180,
// — направление поперёк полос; ведь (u, v) и (−u, −v) — одни и те же полосы.
// %% hint en
// Samples on a square lattice cannot see whole cycles per pixel, in x and in y separately.
// %% hint ru
// Отсчёты на квадратной решётке не видят целых периодов на пиксель — отдельно по x и отдельно по y.
// %% hint en
// Take the nearest whole number away from u and from v, keeping the signs: they decide which way the stripes lean. Then
// `hypot` and `atan2`, and 180° more where the angle is negative.
// %% hint ru
// Отнимите от u и от v ближайшие целые, сохранив знаки: они решают, куда наклонены полосы. Затем `hypot` и `atan2`, а к
// отрицательному углу прибавьте 180°.

// %% answer
// %% ru Частота и угол (в градусах) видимых полос.
/// The frequency and the angle in degrees of the stripes that are seen.
pub fn moire(u: f64, v: f64) -> [f64; 2] {
    // %% start [0.0, 0.0]
    let (u, v) = (u - u.round(), v - v.round());
    [u.hypot(v), v.atan2(u).to_degrees().rem_euclid(180.0)]
    // %% end
}

// %% check
use nyquist::exercise::{Line, Mistake};
use nyquist::text;
use std::f64::consts;

pub type Answer = fn(f64, f64) -> [f64; 2];
pub const ANSWER: Answer = moire;

/// Frequency and angle of a vector.
fn polar(u: f64, v: f64) -> [f64; 2] {
    [u.hypot(v), v.atan2(u).to_degrees().rem_euclid(180.0)]
}

pub const MISTAKES: [Mistake<Answer>; 4] = [
    Mistake::new(
        |u, v| polar((u - u.round()).abs(), (v - v.round()).abs()),
        "The signs of the two folded frequencies are lost: the stripes lean the wrong way.",
        "Потеряны знаки свёрнутых частот: полосы наклонены не в ту сторону.",
    ),
    Mistake::new(
        |u, v| {
            let (frequency, angle) = (u.hypot(v), v.atan2(u).to_degrees().rem_euclid(180.0));
            [(frequency - frequency.round()).abs(), angle]
        },
        "You folded the length of (u, v). Folding takes whole cycles from u and from v, each by itself.",
        "Вы свернули длину вектора (u, v). Сворачиваются u и v, каждая сама по себе.",
    ),
    Mistake::new(
        |u, v| [polar(u - u.round(), v - v.round())[0], (v - v.round()).atan2(u - u.round()).rem_euclid(consts::PI)],
        "The angle is in radians; degrees were asked for.",
        "Угол в радианах, а спрашивали градусы.",
    ),
    Mistake::new(
        |u, v| polar(u.fract(), v.fract()),
        "You cut off the whole part; the nearest whole number is the one to take away: 0.9 cycles look like −0.1.",
        "Вы отбросили целую часть, а отнимать надо ближайшее целое: 0,9 периода выглядят как −0,1.",
    ),
];

pub fn demands(moire: Answer) -> Vec<Line> {
    let gratings = [[0.9, 0.05], [1.02, 0.97], [0.96, 1.1], [2.3, -0.8], [-0.7, 3.1], [0.2, 0.1], [1.0, 0.75]];
    // the truth by search: of all gratings with the same samples, the coarsest
    let truth = |[u, v]: [f64; 2]| {
        let all = (-5..=5).flat_map(|i| (-5..=5).map(move |k| [u + f64::from(i), v + f64::from(k)]));
        let coarsest = all.reduce(|best, w| if w[0].hypot(w[1]) < best[0].hypot(best[1]) { w } else { best });
        coarsest.map_or([f64::NAN; 2], |[u, v]| polar(u, v))
    };
    // the subtraction of whole numbers loses 5ε; a direction is known to that over the length, here above 0.03
    let allowed = 5.0 * f64::EPSILON;
    let ask = |line: Line, i: usize| {
        gratings
            .iter()
            .fold(line, |line, &[u, v]| line.case(format!("moire({u}, {v})[{i}]"), moire(u, v)[i], truth([u, v])[i]))
    };
    vec![
        ask(Line::new(text!("the frequency of the stripes", "частота полос"), allowed), 0),
        ask(Line::new(text!("the angle of the stripes, degrees", "угол полос, градусы"), allowed / 0.03 * 180.0), 1),
    ]
}
