//! Which frequency a tone seems to have when it is sampled too slowly.

// %% en F07 F08
// # Predict the alias
//
// A tone cos(2πνx) is sampled at a rate. Its samples are also those of a tone between 0 and half the rate. Which?
// %% ru
// # Предсказать ложную частоту
//
// Синусоиду cos(2πνx) дискретизируют с данной частотой. Те же отсчёты даёт синусоида с частотой от 0 до половины частоты
// дискретизации. Какая?
// %% hint en
// Adding the rate to a frequency changes no sample. Which multiple of the rate is nearest to ν?
// %% hint ru
// Если прибавить к частоте частоту дискретизации, отсчёты не изменятся. Какое её кратное ближе всего к ν?
// %% hint en
// A cosine does not know the sign of its frequency: the distance to the nearest multiple is the answer.
// %% hint ru
// Косинус не различает знак частоты: ответ — расстояние до ближайшего кратного.

// %% answer
// %% ru Частота от 0 до половины частоты дискретизации, косинус которой даёт те же отсчёты.
/// The frequency from 0 to half the rate whose cosine has the same samples.
pub fn alias(frequency: f64, rate: f64) -> f64 {
    // %% start 0.0
    (frequency - rate * (frequency / rate).round()).abs()
    // %% end
}

// %% check
use nyquist::exercise::{Line, Mistake};
use nyquist::text;

pub type Answer = fn(f64, f64) -> f64;
pub const ANSWER: Answer = alias;

pub const MISTAKES: [Mistake<Answer>; 4] = [
    Mistake::new(
        |frequency, rate| frequency % rate,
        "The remainder lies between 0 and the whole rate. What is above half of it is still to be mirrored.",
        "Остаток лежит от 0 до всей частоты дискретизации. Что выше её половины, надо ещё отразить.",
    ),
    Mistake::new(
        |frequency, rate| frequency - rate * (frequency / rate).round(),
        "The place is right, but a cosine of negative frequency is the one of positive frequency: take the absolute value.",
        "Место верное, но косинус отрицательной частоты — тот же, что положительной: возьмите модуль.",
    ),
    Mistake::new(
        |frequency, rate| if frequency > 0.5 * rate { (rate - frequency).abs() } else { frequency },
        "You fold once. The axis is folded at every multiple of half the rate: try a frequency above one and a half rates.",
        "Вы сворачиваете один раз, а ось складывается на каждом кратном половины частоты дискретизации.",
    ),
    Mistake::new(
        |frequency, rate| frequency.min(0.5 * rate),
        "What is too high is not cut off at half the rate: it comes back as something lower.",
        "Слишком высокая частота не обрезается на половине частоты дискретизации, а возвращается более низкой.",
    ),
];

pub fn demands(alias: Answer) -> Vec<Line> {
    // the truth by search: of all tones that differ by multiples of the rate, the slowest
    let truth = |nu: f64, rate: f64| (-99..=99).map(|k| (nu - rate * f64::from(k)).abs()).fold(f64::INFINITY, f64::min);
    // roundings of numbers below 64
    let allowed = 4.0 * f64::EPSILON * 64.0;
    let case = |rate: f64| move |nu: f64| (format!("alias({nu}, {rate})"), alias(nu, rate), truth(nu, rate));
    vec![
        Line::new(text!("up to half the rate nothing changes", "до половины частоты ничего не меняется"), allowed)
            .over([0.0, 0.25, 0.5], case(1.0)),
        Line::new(text!("rate 1", "частота дискретизации 1"), allowed)
            .along(text!("frequency ν", "частота ν"))
            .over((0..=70).map(|i| f64::from(i) / 20.0), case(1.0)),
        Line::new(text!("rate 8", "частота дискретизации 8"), allowed)
            .over([3.0, 5.0, 9.0, 12.5, 15.0, 50.0], case(8.0)),
    ]
}
