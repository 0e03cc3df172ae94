//! Up to where a chirp is sampled fast enough.

// %% en F30 F32
// # How far is the chirp good?
//
// The chirp cos(πcx²) oscillates the faster the larger x is. It is sampled at a rate. Up to which x is its local
// frequency below the Nyquist frequency?
// %% ru
// # До какого места хорош ЛЧМ-сигнал?
//
// ЛЧМ-сигнал cos(πcx²) колеблется тем быстрее, чем больше x. Его дискретизируют с данной частотой. До какого x его местная
// частота ниже частоты Найквиста?
// %% hint en
// The local frequency is the derivative of the phase, in turns: φ(x) = πcx², so φ′/2π.
// %% hint ru
// Местная частота — производная фазы, в оборотах: φ(x) = πcx², значит φ′/2π.
// %% hint en
// cx is the local frequency. The Nyquist frequency is half the rate.
// %% hint ru
// Местная частота — cx. Частота Найквиста — половина частоты дискретизации.

// %% answer
// %% ru Где местная частота cos(πcx²) достигает частоты Найквиста.
/// Where the local frequency of cos(πcx²) reaches the Nyquist frequency.
pub fn reach(c: f64, rate: f64) -> f64 {
    // %% start 0.0
    rate / (2.0 * c)
    // %% end
}

// %% check
use nyquist::exercise::{Line, Mistake};
use nyquist::text;

pub type Answer = fn(f64, f64) -> f64;
pub const ANSWER: Answer = reach;

pub const MISTAKES: [Mistake<Answer>; 4] = [
    Mistake::new(
        |c, rate| rate / c,
        "Twice too far. Either you took the rate instead of its half, or the phase divided by x instead of its derivative.",
        "Вдвое дальше, чем надо: взята вся частота дискретизации, а не половина, — или фаза, делённая на x, а не производная.",
    ),
    Mistake::new(
        |c, rate| rate / (4.0 * c),
        "Half of the way only: the Nyquist frequency is the rate/2, and the local frequency is cx and not 2cx.",
        "Лишь половина пути: частота Найквиста — половина частоты дискретизации, а местная частота — cx, а не 2cx.",
    ),
    Mistake::new(
        |c, rate| std::f64::consts::PI * rate / (2.0 * c),
        "There is a π too much: the phase πcx² is in radians, and a turn has 2π of them.",
        "Лишнее π: фаза πcx² — в радианах, а в обороте их 2π.",
    ),
    Mistake::new(
        |c, rate| (rate / c).sqrt(),
        "You ask where the phase has turned so often. The frequency is how fast it turns: its derivative.",
        "Вы нашли, где фаза сделала столько оборотов. Частота — это скорость поворота, производная фазы.",
    ),
];

pub fn demands(reach: Answer) -> Vec<Line> {
    // halving: the first x where the turns of a short stretch, divided by its length, are half the rate; for a phase of
    // second degree the difference is the derivative, rounded by ε·turns/h
    const H: f64 = 0.25;
    let local = |c: f64, x: f64| (0.5 * c * (x + H) * (x + H) - 0.5 * c * (x - H) * (x - H)) / (2.0 * H);
    let truth = |c: f64, rate: f64| {
        let (mut low, mut high) = (0.0, 1024.0);
        for _ in 0..80 {
            let middle = 0.5 * (low + high);
            if local(c, middle) < 0.5 * rate { low = middle } else { high = middle }
        }
        low
    };
    let places = |c: f64, rate: f64| {
        let x = truth(c, rate);
        (x, 4.0 * f64::EPSILON * (x + H) * (x + H) / H + 4.0 * f64::EPSILON * x)
    };
    let (lecture, allowed) = places(4.0, 8.0);
    let others = [1.0, 3.0, 10.0, 44.1];
    let most = others.map(|rate| places(0.5, rate).1).into_iter().fold(0.0, f64::max);
    vec![
        Line::new(text!("the lecture's chirp, c = 4, rate 8", "ЛЧМ-сигнал лекции, c = 4, частота 8"), allowed).case(
            "reach(4, 8)",
            reach(4.0, 8.0),
            lecture,
        ),
        Line::new(text!("c = ½", "c = ½"), most)
            .along(text!("rate", "частота дискретизации"))
            .over(others, |rate| (format!("reach(0.5, {rate})"), reach(0.5, rate), places(0.5, rate).0)),
    ]
}
