//! The shift theorem.

// %% en F12 F17
// # Shift a signal
//
// The transform of f has the value re + i·im at the frequency ν. Which value has the transform of f(x − a), the same
// signal moved by a to the right? Give [real part, imaginary part].
// %% ru
// # Сдвинуть сигнал
//
// Спектр функции f на частоте ν равен re + i·im. Чему там равен спектр f(x − a) — того же сигнала, сдвинутого на a
// вправо? Верните [действительную часть, мнимую часть].
// %% hint en
// Put x = y + a into the integral: a factor comes out that does not depend on y.
// %% hint ru
// Подставьте в интеграл x = y + a: вынесется множитель, не зависящий от y.
// %% hint en
// The factor is e^(−2πiνa) = cos(2πνa) − i sin(2πνa). (p + iq)(r + is) = pr − qs + i(ps + qr).
// %% hint ru
// Множитель — e^(−2πiνa) = cos(2πνa) − i sin(2πνa). (p + iq)(r + is) = pr − qs + i(ps + qr).

// %% answer
use std::f64::consts::PI;

// %% ru Спектр сигнала, сдвинутого на `a` вправо, на частоте ν.
/// The transform at ν of the signal moved by `a` to the right.
pub fn shifted([re, im]: [f64; 2], nu: f64, a: f64) -> [f64; 2] {
    // %% start [0.0, 0.0]
    let (sin, cos) = (2.0 * PI * nu * a).sin_cos();
    [re * cos + im * sin, im * cos - re * sin]
    // %% end
}

// %% check
use nyquist::exercise::{Line, Mistake};
use nyquist::num::quadrature::{even_breaks, integrate_pieces};
use nyquist::text;
use std::f64::consts;

pub type Answer = fn([f64; 2], f64, f64) -> [f64; 2];
pub const ANSWER: Answer = shifted;

/// (re + i·im)·(cos + i·sin) of an angle.
fn turned([re, im]: [f64; 2], angle: f64) -> [f64; 2] {
    let (sin, cos) = angle.sin_cos();
    [re * cos - im * sin, re * sin + im * cos]
}

pub const MISTAKES: [Mistake<Answer>; 4] = [
    Mistake::new(
        |f, nu, a| turned(f, consts::TAU * nu * a),
        "The phase turns the other way: that is f(x + a), moved to the left.",
        "Фаза вращается в другую сторону: это f(x + a), сдвиг влево.",
    ),
    Mistake::new(
        |f, nu, a| turned(f, -nu * a),
        "You forgot 2π: a frequency of one cycle and a shift of one unit make a whole turn.",
        "Забыто 2π: частота в один период и сдвиг на единицу дают полный оборот.",
    ),
    Mistake::new(
        |[re, im], nu, a| [re * (consts::TAU * nu * a).cos(), -im * (consts::TAU * nu * a).sin()],
        "Complex numbers are not multiplied part by part: real and imaginary part mix.",
        "Комплексные числа умножаются не почастно: действительная и мнимая части смешиваются.",
    ),
    Mistake::new(
        |f, _, a| turned(f, -consts::TAU * a),
        "The turn must grow with the frequency: each wave is moved by the same a, which is more of a shorter wave.",
        "Поворот растёт с частотой: все волны сдвинуты на одно и то же a, а для короткой это бо́льшая доля периода.",
    ),
];

pub fn demands(shifted: Answer) -> Vec<Line> {
    // both transforms as integrals: of 1 + x over [−½, ½], and of the same moved; each is asked for 10⁻¹³
    const ALLOWED: f64 = 4e-13;
    let transform = |nu: f64, a: f64| {
        let pieces = even_breaks(a - 0.5, a + 0.5, 0.125);
        let part = |wave: fn(f64) -> f64| {
            integrate_pieces(|x| (1.0 + x - a) * wave(consts::TAU * nu * x), &pieces, 1e-13).value
        };
        [part(f64::cos), -part(f64::sin)]
    };
    let ask = |a: f64, i: usize| {
        move |nu: f64| {
            let call = format!("shifted(F({nu}), {nu}, {a})[{i}]");
            (call, shifted(transform(nu, 0.0), nu, a)[i], transform(nu, a)[i])
        }
    };
    let places = || (0..=32).map(|i| f64::from(i) / 16.0);
    vec![
        Line::new(text!("no shift, no change", "без сдвига ничего не меняется"), ALLOWED)
            .over([0.25, 1.5], ask(0.0, 0)),
        Line::new(text!("a = 0.7, real part", "a = 0.7, действительная часть"), ALLOWED)
            .along(text!("frequency ν", "частота ν"))
            .over(places(), ask(0.7, 0)),
        Line::new(text!("a = 0.7, imaginary part", "a = 0.7, мнимая часть"), ALLOWED)
            .along(text!("frequency ν", "частота ν"))
            .over(places(), ask(0.7, 1)),
        Line::new(text!("a = −2.3", "a = −2.3"), ALLOWED).over([0.3, 0.9, 1.3], ask(-2.3, 1)),
    ]
}
