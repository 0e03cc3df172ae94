//! A wheel in a film: folding in time, with a direction.

// %% en F03
// # The wheel that turns backwards
//
// A wheel with so many equal spokes makes so many turns a second, and is filmed with so many frames a second. How many
// turns a second does it seem to make? Negative is backwards. The eye joins every spoke to the nearest one in the next
// frame, and equal spokes cannot be told apart.
// %% ru
// # Колесо, которое крутится назад
//
// Колесо с одинаковыми спицами делает столько-то оборотов в секунду, и его снимают с такой-то частотой кадров. Сколько
// оборотов в секунду оно делает на экране? Минус — назад. Глаз соединяет каждую спицу с ближайшей на следующем кадре, а
// одинаковые спицы неразличимы.
// %% hint en
// How many spokes pass the top in one second? That is the frequency which is sampled, not the turns.
// %% hint ru
// Сколько спиц проходит верхнюю точку за секунду? Дискретизируется эта частота, а не обороты.
// %% hint en
// Between two frames the wheel moves by a number of spokes. Take away the nearest whole number: that part is not seen.
// %% hint ru
// Между кадрами колесо смещается на какое-то число спиц. Отнимите ближайшее целое: этого сдвига не видно.

// %% answer
// %% ru Сколько оборотов в секунду видно на экране.
/// The turns a second that are seen.
pub fn seen(turns: f64, spokes: f64, frames: f64) -> f64 {
    // %% start 0.0
    let passing = turns * spokes;
    (passing - frames * (passing / frames).round()) / spokes
    // %% end
}

// %% check
use nyquist::exercise::{Line, Mistake};
use nyquist::text;

pub type Answer = fn(f64, f64, f64) -> f64;
pub const ANSWER: Answer = seen;

pub const MISTAKES: [Mistake<Answer>; 4] = [
    Mistake::new(
        |turns, _, frames| turns - frames * (turns / frames).round(),
        "You folded the turns. The picture repeats with every spoke: fold the number of spokes a second.",
        "Вы свернули частоту оборотов. Картина повторяется с каждой спицей: сворачивайте число спиц в секунду.",
    ),
    Mistake::new(
        |turns, spokes, frames| turns * spokes - frames * (turns * spokes / frames).round(),
        "Those are spokes a second, and turns were asked for: divide by the number of spokes.",
        "Это спицы в секунду, а спрашивали обороты: разделите на число спиц.",
    ),
    Mistake::new(
        |turns, spokes, frames| ((turns * spokes - frames * (turns * spokes / frames).round()) / spokes).abs(),
        "The speed is right and the direction is lost: a wheel can seem to turn backwards.",
        "Скорость верна, но потеряно направление: колесо может крутиться назад.",
    ),
    Mistake::new(
        |turns, spokes, frames| turns * spokes % frames / spokes,
        "You took the remainder, which is always forward. The eye takes the nearest spoke, ahead or behind.",
        "Вы взяли остаток — он всегда вперёд. Глаз берёт ближайшую спицу, впереди или позади.",
    ),
];

pub fn demands(seen: Answer) -> Vec<Line> {
    // the truth by looking: of all speeds that put spokes on spokes, whole spokes a frame apart, the slowest
    let truth = |turns: f64, spokes: f64, frames: f64| {
        let same = (-60..=60).map(|k| turns - f64::from(k) * frames / spokes);
        same.reduce(|slow, speed| if speed.abs() < slow.abs() { speed } else { slow }).unwrap_or(f64::NAN)
    };
    // ten roundings of numbers below 64 spokes a second
    let allowed = 10.0 * f64::EPSILON * 64.0;
    let case = |spokes: f64, frames: f64| {
        move |turns: f64| {
            (format!("seen({turns}, {spokes}, {frames})"), seen(turns, spokes, frames), truth(turns, spokes, frames))
        }
    };
    vec![
        Line::new(text!("slow wheels are seen as they are", "медленное колесо видно как есть"), allowed)
            .over([0.0, 0.5, 1.25], case(8.0, 24.0)),
        Line::new(text!("8 spokes, 24 frames a second", "8 спиц, 24 кадра в секунду"), allowed)
            .along(text!("turns a second", "оборотов в секунду"))
            .over((0..70).map(|i| 0.05 + f64::from(i) / 10.0), case(8.0, 24.0)),
        Line::new(text!("other wheels and films", "другие колёса и фильмы"), allowed)
            .over([-2.9, 1.1, 2.9], case(5.0, 25.0))
            .over([-2.9, 1.1, 2.9], case(12.0, 30.0)),
    ]
}
