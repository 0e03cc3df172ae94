//! Recovery from irregular samples: they do help (V24, V25).

use crate::axis::{Axis, Edge};
use crate::beyond::irregular::Irregular;
use crate::signal::trigonometric::TrigPolynomial;

use crate::error::Result;
use crate::figure::common::{signal_curve, space, values};
use crate::figure::params::{Param, Params};
use crate::figure::{Entry, Figure, Layer, Legend, Meaning, Panel, Scale};
use crate::kernel::ideal::Ideal;
use crate::laws::frames::{
    grochenig, irregular_recovery, jittered_cells, kadec, kadec_bounds, levinson, random_polynomial, riesz_bounds,
};
use crate::num::random::uniform;
use crate::reconstruct::reconstruct;
use crate::residual::Residual;
use crate::sampled::Samples;
use crate::signal::Signal;
use crate::text;
use crate::text::{Text, number};

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[IRREGULAR];

static BAND: Text = Text::fixed("band of the signal, as a part of Nyquist", "полоса сигнала в долях частоты Найквиста");
static SEED: Text = Text::fixed("seed of the random numbers", "начальное число генератора");

const IRREGULAR: Entry = Entry {
    id: "x-irregular",
    inventory: &[],
    errata: &["E12"],
    title: &Text::fixed("Irregular samples restore the signal", "Нерегулярные отсчёты восстанавливают сигнал"),
    caption: &Text::fixed(
        "One sample somewhere in every cell, and least squares find the band-limited signal exactly; only the sinc, which \
         takes them for regular, does not. (The slide says they would not help.) Irregularity costs noise: the condition \
         number grows towards Nyquist, slowly for jittered samples, hopelessly for independent ones.",
        "По одному отсчёту где-то в каждой ячейке — и метод наименьших квадратов точно находит сигнал с ограниченной \
         полосой; не справляется лишь sinc, принимая их за регулярные. (На слайде сказано, что это не поможет.) Плата — шум: \
         число обусловленности растёт к частоте Найквиста, у джиттера медленно, у независимых — безнадёжно.",
    ),
    params: &[Param::real("band", &BAND, 0.85, 0.1, 0.95, ""), Param::count("seed", &SEED, 1, 1, 20)],
    build: |params| irregular(params),
};

/// Cells, and samples, of a period.
const CELLS: usize = 48;

/// The degree of the polynomial that fills that part of the band below Nyquist.
fn degree(part: f64) -> usize {
    (0.5 * part * CELLS as f64).floor() as usize
}

/// The band of that degree.
fn band(part: f64) -> f64 {
    degree(part) as f64 / CELLS as f64
}

fn irregular(params: &Params) -> Result<Figure> {
    let (part, seed) = (params.real("band"), params.count("seed") as u64);
    let period = CELLS as f64;
    let jittered = jittered_cells(seed, CELLS, 1.0);
    let independent: Vec<f64> = (0..CELLS as u64).map(|k| period * uniform(seed, k, 7)).collect();
    let f = random_polynomial(seed, period, degree(part))?;
    let rms = f.rms();
    let f = TrigPolynomial::new(0.0..period, f.coefficients().iter().map(|c| c / rms).collect())?;
    let samples = Irregular::of(&f, 0.0..period, &jittered)?;
    let recovery = samples.least_squares(band(part), 1e12)?;
    let mistaken = Samples::new(Axis::cells(0.0..period, CELLS)?, samples.points().iter().map(|p| p[1]).collect())?;
    let sinc = reconstruct(&mistaken, Ideal).edge(Edge::Wrap);
    let (low, high) = (20.0, 36.0);
    let top = 1.15 * (0..=800).map(|i| f.at(low + (high - low) * f64::from(i) / 800.0).abs()).fold(0.0, f64::max);
    let space_panel = Panel::new(
        "space",
        text!("16 of {CELLS} cells", "16 ячеек из {CELLS}"),
        space(low, high),
        values("f(x)", -top, top),
    )
    .span(2)
    .legend(Legend::Above)
    .with(Layer::spans("cells", Meaning::Guide, (10..18).map(|k| [f64::from(2 * k), f64::from(2 * k + 1)])))
    .with(
        signal_curve("sinc", Meaning::Error, &sinc, low, high)
            .thin()
            .label(text!("sinc, as if regular", "sinc, как по регулярным")),
    )
    .with(signal_curve("signal", Meaning::Signal, &f, low, high).thick().label(text!("signal", "сигнал")))
    .with(
        signal_curve("recovered", Meaning::Reconstructed, &recovery, low, high)
            .dashed()
            .label(text!("recovered", "восстановлен")),
    )
    .with(
        Layer::dots("samples", Meaning::Samples, {
            samples.points().iter().copied().filter(|p| p[0] > low && p[0] < high)
        })
        .label(text!("samples", "отсчёты")),
    );

    let parts: Vec<f64> = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.97].into();
    let conditions = |positions: &[f64]| -> Result<Vec<[f64; 2]>> {
        let samples = Irregular::of(&f, 0.0..period, positions)?;
        let at = |&part: &f64| Ok([2.0 * band(part), samples.least_squares(band(part), f64::INFINITY)?.condition()]);
        parts.iter().map(at).collect()
    };
    let (of_jittered, of_independent) = (conditions(&jittered)?, conditions(&independent)?);
    let gap = samples.largest_gap();
    let condition_panel = Panel::new(
        "condition",
        text!("how much noise grows", "во сколько раз растёт шум"),
        Scale::linear(text!("band / Nyquist", "полоса / Найквист"), 0.0, 1.04),
        Scale::log(text!("condition", "обусловленность"), 0.7, 1e5),
    )
    .legend(Legend::Above)
    .with(Layer::verticals("limit", Meaning::Guide, [1.0 / gap]).dashed().label(text!("1/δ", "1/δ")))
    .with(Layer::line("independent-line", Meaning::Series(1), of_independent.iter().copied()))
    .with(
        Layer::dots("independent", Meaning::Series(1), of_independent.iter().copied())
            .label(text!("independent", "независимые")),
    )
    .with(Layer::line("jittered-line", Meaning::Series(0), of_jittered.iter().copied()))
    .with(Layer::dots("jittered", Meaning::Series(0), of_jittered.iter().copied()).label(text!("jittered", "джиттер")));

    let deviations: Vec<f64> = (0..=14).map(|i| f64::from(i) / 40.0).collect();
    const LEVINSON: i32 = 16;
    let least = |deviation: f64| Ok([deviation, riesz_bounds(&levinson(LEVINSON, deviation))?[0]]);
    let measured = deviations.iter().map(|&d| least(d)).collect::<Result<Vec<_>>>()?;
    let bound = (0..=100).map(|i| f64::from(i) / 400.0).map(|d| Ok([d, kadec_bounds(d)?[0]]));
    let kadec_panel = Panel::new(
        "kadec",
        text!("how far samples may stray", "насколько можно сдвигать"),
        Scale::linear(text!("shift L, in steps", "сдвиг L, в шагах"), -0.01, 0.36),
        Scale::linear(text!("least eigenvalue", "наим. собств. число"), -0.05, 1.1),
    )
    .legend(Legend::Above)
    .with(Layer::verticals("quarter", Meaning::Guide, [0.25]).dashed().label(Text::same("¼")))
    .with(
        Layer::line("kadec", Meaning::Theory, bound.collect::<Result<Vec<_>>>()?)
            .thick()
            .label(text!("Kadec's bound", "оценка Кадеца")),
    )
    .with(Layer::dots("eigenvalues", Meaning::Reconstructed, measured).label(text!("33 samples", "33 отсчёта")));

    // below 1/(2δ) the iteration converges without any equations
    let safe = degree(0.8 / gap) as f64 / period;
    let slow = random_polynomial(seed + 1, period, degree(0.8 / gap))?;
    let mut straying = Vec::new();
    for &deviation in deviations.iter().filter(|d| **d < 0.25) {
        straying.push(kadec(&levinson(LEVINSON, deviation), deviation)?);
    }
    let outside = straying.iter().map(|r| r.measured / r.bound).fold(0.0, f64::max);
    let (last, other) = (of_jittered[8][1], of_independent[8][1]);
    Ok(Figure::new(2)
        .heights([0.8, 1.0])
        .with(space_panel)
        .with(condition_panel)
        .with(kadec_panel)
        .claim(
            text!(
                "the signal is recovered to rounding, times the condition number {}",
                "сигнал восстановлен с точностью до округления, умноженного на число обусловленности {}",
                number(recovery.condition(), 2)
            ),
            irregular_recovery(&f, &jittered, band(part), 1e12)?,
        )
        .claim(
            text!(
                "at 0.9 of Nyquist noise grows up to {} times; with independent places {} times",
                "при 0,9 частоты Найквиста шум растёт до {} раз; при независимых позициях — до {} раз",
                number(last, 2),
                number(other, 2)
            ),
            Residual::at_least("condition of independent over jittered places", other / last, 1.0),
        )
        .claim(
            text!(
                "the largest gap is δ = {}: bands below 1/(2δ) are safe, and an iteration gains the factor {} a step",
                "наибольший промежуток δ = {}: полосы ниже 1/(2δ) безопасны, и каждая итерация даёт множитель {}",
                number(gap, 3),
                number(Irregular::of(&slow, 0.0..period, &jittered)?.contraction(safe)?, 2)
            ),
            grochenig(&slow, &jittered, safe, 12)?,
        )
        .claim(
            text!(
                "shifted by less than ¼ step, samples stay independent: eigenvalues above Kadec's bound",
                "при сдвиге меньше ¼ шага отсчёты независимы: собственные числа выше оценки Кадеца"
            ),
            Residual::at_most("Kadec's bounds, in units of rounding", outside, 1.0),
        ))
}
