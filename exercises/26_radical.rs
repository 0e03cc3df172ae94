//! The radical inverse.

// %% en F54
// # The radical inverse
//
// Write a number in some base, reflect its digits in the point, and read the result: in base 2 the number 6 = 110 becomes
// 0.011 = 3/8. Compute it for any base from 2 on.
// %% ru
// # Обращение разрядов
//
// Запишите число в какой-нибудь системе счисления, отразите его цифры относительно запятой и прочтите, что вышло:
// в двоичной 6 = 110 превращается в 0,011 = 3/8. Вычислите это для любого основания от 2.
// %% hint en
// `index % base` is the last digit, `index / base` the number without it.
// %% hint ru
// `index % base` — последняя цифра, `index / base` — число без неё.
// %% hint en
// The last digit becomes the first behind the point, worth 1/base; the next one 1/base²; and so on until nothing is left.
// %% hint ru
// Последняя цифра становится первой после запятой и весит 1/base, следующая — 1/base², и так пока число не кончится.

// %% answer
// %% ru Цифры числа `index` в этой системе счисления, отражённые относительно запятой.
/// The digits of `index` in that base, reflected in the point.
pub fn radical_inverse(base: u32, index: u32) -> f64 {
    // %% start 0.0
    let (mut rest, mut worth, mut sum) = (index, 1.0, 0.0);
    while rest > 0 {
        worth /= f64::from(base);
        sum += worth * f64::from(rest % base);
        rest /= base;
    }
    sum
    // %% end
}

// %% check
use nyquist::exercise::{Line, Mistake};
use nyquist::text;

pub type Answer = fn(u32, u32) -> f64;
pub const ANSWER: Answer = radical_inverse;

/// The digits of a number, the last one first.
fn digits(base: u32, index: u32) -> Vec<u32> {
    let rests = std::iter::successors(Some(index), |rest| Some(rest / base));
    rests.take_while(|rest| *rest > 0).map(|rest| rest % base).collect()
}

pub const MISTAKES: [Mistake<Answer>; 4] = [
    Mistake::new(
        |base, index| f64::from(index) / f64::from(base).powi(digits(base, index).len() as i32),
        "The point has moved, but the digits stand in their old order: the last one must come first.",
        "Запятая перенесена, но цифры в прежнем порядке: последняя должна стать первой.",
    ),
    Mistake::new(
        |base, index| digits(base, index).into_iter().fold(0.0, |sum, digit| sum * f64::from(base) + f64::from(digit)),
        "The digits are reversed, but there is no point before them: the result lies between 0 and 1.",
        "Цифры перевёрнуты, но перед ними нет запятой: ответ лежит между 0 и 1.",
    ),
    Mistake::new(
        |_, index| f64::from(index.reverse_bits()) / 4_294_967_296.0,
        "Right for base 2. Reversed bits are no reversed digits in another base.",
        "Для основания 2 верно. Но перевёрнутые биты — не перевёрнутые цифры в другой системе.",
    ),
    Mistake::new(
        |base, index| {
            let worth = |i: usize| f64::from(base).powi(-(i as i32));
            digits(base, index).into_iter().enumerate().map(|(i, digit)| f64::from(digit) * worth(i)).sum()
        },
        "The first digit behind the point is worth 1/base, not 1: all is too large by the base.",
        "Первая цифра после запятой весит 1/base, а не 1: всё завышено в base раз.",
    ),
];

pub fn demands(inverse: Answer) -> Vec<Line> {
    // as a fraction of whole numbers: the reversed number over the power of the base
    let truth = |base: u32, index: u32| {
        let digits = digits(base, index);
        let over = u64::from(base).pow(digits.len() as u32);
        digits.iter().fold(0, |sum, digit| sum * u64::from(base) + u64::from(*digit)) as f64 / over as f64
    };
    // at most 20 digits, each rounded below one
    let allowed = 20.0 * 2.0 * f64::EPSILON;
    let case = |base: u32| {
        move |i: f64| {
            let index = i as u32;
            (format!("radical_inverse({base}, {index})"), inverse(base, index), truth(base, index))
        }
    };
    vec![
        Line::new(
            text!("base 2: the sequence of van der Corput", "основание 2: последовательность ван дер Корпута"),
            allowed,
        )
        .along(text!("index", "номер"))
        .over((0..32).map(f64::from), case(2)),
        Line::new(text!("base 3", "основание 3"), allowed).over((0..30).map(f64::from), case(3)),
        Line::new(text!("base 10 and large numbers", "основание 10 и большие числа"), allowed)
            .over([7.0, 123.0, 90_210.0, 1_000_000.0], case(10)),
    ]
}
