//! How many samples there are after the rate has been changed.

// %% en F33
// # How long is it afterwards?
//
// A record of n samples at the rate `from` is resampled to the rate `to`. It shall last as long as before, as nearly as a
// whole number of samples can (halves are rounded up). How many samples has it then? Records may be hours long: the
// answer must be exact.
// %% ru
// # Сколько станет отсчётов?
//
// Запись из n отсчётов с частотой `from` пересчитывают на частоту `to`. Длиться она должна столько же — насколько это
// возможно при целом числе отсчётов (половины округляются вверх). Сколько в ней станет отсчётов? Записи бывают
// многочасовыми: ответ должен быть точным.
// %% hint en
// It lasts n/from seconds, and a second has `to` samples.
// %% hint ru
// Она длится n/from секунд, а в секунде `to` отсчётов.
// %% hint en
// Whole numbers stay exact: round(p/q) is (2p + q)/(2q) in whole-numbered division. n·to may not fit into u64: `u128`.
// %% hint ru
// Целые числа точны: round(p/q) — это целочисленное (2p + q)/(2q). Произведение n·to может не поместиться в u64: `u128`.

// %% answer
// %% ru Сколько отсчётов станет из n после смены частоты.
/// How many samples become of n when the rate is changed.
pub fn resampled(n: u64, from: u64, to: u64) -> u64 {
    // %% start 0
    let (n, from, to) = (u128::from(n), u128::from(from), u128::from(to));
    ((2 * n * to + from) / (2 * from)) as u64
    // %% end
}

// %% check
use nyquist::exercise::{Line, Mistake};
use nyquist::text;

pub type Answer = fn(u64, u64, u64) -> u64;
pub const ANSWER: Answer = resampled;

/// The quotient of n·to and from, and the rest.
fn divided(n: u64, from: u64, to: u64) -> [u128; 2] {
    let product = u128::from(n) * u128::from(to);
    [product / u128::from(from), product % u128::from(from)]
}

pub const MISTAKES: [Mistake<Answer>; 4] = [
    Mistake::new(
        |n, from, to| divided(n, from, to)[0] as u64,
        "Whole-numbered division cuts off: up to one sample is lost at the end. Round to the nearest.",
        "Целочисленное деление отбрасывает дробь: в конце теряется почти отсчёт. Округляйте до ближайшего.",
    ),
    Mistake::new(
        |n, from, to| divided(n, from, to)[0] as u64 + 1,
        "Always one more is one too many: round to the nearest.",
        "Всегда на один больше — это слишком: округляйте до ближайшего.",
    ),
    Mistake::new(
        |n, from, to| ((2 * u128::from(n) * u128::from(from) + u128::from(to)) / (2 * u128::from(to))) as u64,
        "The ratio is upside down: at a higher rate there are more samples.",
        "Отношение перевёрнуто: при более высокой частоте отсчётов больше.",
    ),
    Mistake::new(
        |n, from, to| (n as f64 * to as f64 / from as f64).round() as u64,
        "Right for short records. f64 has 53 bits: a long one comes out wrong. Stay with whole numbers.",
        "Для коротких записей верно. Но в f64 53 бита, и длинная выходит неточной. Считайте в целых.",
    ),
];

pub fn demands(resampled: Answer) -> Vec<Line> {
    // rounding by hand: the quotient, and one more if the rest is a half or more. The difference is taken in whole
    // numbers, so that nothing of it is lost
    let off = |line: Line, n: u64, from: u64, to: u64| {
        let [quotient, rest] = divided(n, from, to);
        let truth = quotient + u128::from(2 * rest >= u128::from(from));
        let said = u128::from(resampled(n, from, to));
        let difference = said.abs_diff(truth) as f64;
        line.case(
            format!("resampled({n}, {from}, {to}) − {truth}"),
            if said < truth { -difference } else { difference },
            0.0,
        )
    };
    let short = Line::new(text!("short records", "короткие записи"), 0.0);
    let short = [(441, 44_100, 48_000), (1000, 48_000, 44_100), (7, 2, 1), (10, 3, 1), (1, 8000, 8000)]
        .into_iter()
        .fold(short, |line, (n, from, to)| off(line, n, from, to));
    let long = Line::new(text!("very long records", "очень длинные записи"), 0.0);
    let long = [(9_007_199_254_740_993, 44_100, 44_100), (3_000_000_000_000_000_001, 48_000, 96_000)]
        .into_iter()
        .fold(long, |line, (n, from, to)| off(line, n, from, to));
    vec![short, long]
}
