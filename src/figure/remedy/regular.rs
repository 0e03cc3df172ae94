//! Regular places for samples (slide «Равномерное сэмплирование»).

use crate::axis::Axis;
use crate::beyond::jitter::{Jitter, JitteredComb};
use crate::error::Result;
use crate::figure::common::{frequency, signal_curve, space, values};
use crate::figure::params::Param;
use crate::figure::remedy::stochastic::{both_sides, impulses};
use crate::figure::{Entry, Figure, Layer, Legend, Meaning, Panel, Scale};
use crate::nyquist::Alias;
use crate::residual::Residual;
use crate::sampled::Samples;
use crate::sampled::dft::forward;
use crate::signal::tone::Cosine;
use crate::signal::{FourierPair, Signal};
use crate::text;
use crate::text::{Text, number};

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[UNIFORM];

static CYCLES: Text = Text::fixed("periods of the tone per 16 samples", "периодов синусоиды на 16 отсчётов");

const UNIFORM: Entry = Entry {
    id: "f37-uniform",
    inventory: &["F37"],
    errata: &["E10", "E33"],
    title: &Text::fixed("Regular samples: coherent artefacts", "Регулярные отсчёты: когерентные артефакты"),
    caption: &Text::fixed(
        "The spectrum of a regular comb is a comb. Sampling puts a copy of the signal's spectrum on every spike, so a \
         tone above the Nyquist frequency comes back as another pure tone, just as strong: a regular pattern that the \
         eye cannot miss. (The slide multiplies the signal by the comb of the spectrum; it is the comb in space.)",
        "Спектр регулярного гребня — тоже гребень. Дискретизация ставит копию спектра сигнала на каждый его пик, и \
         синусоида выше частоты Найквиста возвращается другой чистой синусоидой той же силы: регулярный узор, который \
         нельзя не заметить. (На слайде сигнал умножают на гребёнку спектра; умножают на гребень в пространстве.)",
    ),
    params: &[Param::count("cycles", &CYCLES, 13, 9, 15)],
    build: |params| uniform(params.count("cycles")),
};

fn uniform(cycles: usize) -> Result<Figure> {
    const COUNT: usize = 16;
    const ORDER: usize = 2;
    let comb = JitteredComb::new(1.0, Jitter::None)?;
    let positions = comb.positions(0, COUNT);
    let power: Vec<f64> = comb.mean_periodogram(0, COUNT, 1, ORDER).iter().map(|p| p[1]).collect();
    let top = COUNT as f64;
    let power_panel = Panel::new(
        "power",
        text!("its power spectrum", "его спектр мощности"),
        frequency(-2.3, 2.3),
        Scale::linear(text!("power", "мощность"), 0.0, 1.2 * top),
    )
    .with(Layer::stems("power", Meaning::Samples, both_sides(&power, COUNT)));

    let tone = Cosine::new(cycles as f64 / top)?;
    let alias = Alias::of(cycles as f64 / top, 1.0)?;
    let false_tone = Cosine::new(alias.frequency())?;
    let samples = Samples::of(&tone, Axis::new(0.0, 1.0, COUNT)?);
    let space_panel = Panel::new(
        "tone",
        text!("a tone, sampled", "синусоида и отсчёты"),
        space(-0.2, 8.2),
        values("f(x)", -1.2, 1.2),
    )
    .legend(Legend::Above)
    .with(signal_curve("tone", Meaning::Signal, &tone, 0.0, 8.0).label(text!("tone", "синусоида")))
    .with(signal_curve("alias", Meaning::Leaked, &false_tone, 0.0, 8.0).thick().label(text!("alias", "алиас")))
    .with(Layer::dots("samples", Meaning::Samples, samples.points().filter(|p| p[0] <= 8.0)));

    let lines = tone.spectrum().replicated(1.0, ORDER + 1)?;
    let arrows = |name, meaning, keep: &dyn Fn(f64) -> bool| {
        let kept = lines.lines().iter().filter(|l| l.at.abs() < 2.25 && keep(l.at.abs()));
        Layer::arrows(name, meaning, kept.map(|l| [l.at, l.weight.re]))
    };
    let own = cycles as f64 / top;
    let spectrum_panel = Panel::new(
        "spectrum",
        text!("the samples' spectrum", "спектр отсчётов"),
        frequency(-2.3, 2.3),
        values("F(ν)", 0.0, 0.65),
    )
    .legend(Legend::Above)
    .with(Layer::verticals("nyquist", Meaning::Guide, [-0.5, 0.5]).dashed())
    .with(arrows("copies", Meaning::Replica, &|nu| nu > 0.5 && (nu - own).abs() > 1e-9).label(text!("copies", "копии")))
    .with(arrows("own", Meaning::Signal, &|nu| (nu - own).abs() < 1e-9).thick().label(text!("tone", "синусоида")))
    .with(arrows("leaked", Meaning::Leaked, &|nu| nu < 0.5).thick().label(text!("alias", "алиас")));

    // every wave is computed as a power, up to the exponent m = 2n, to 4mε; |S|² ≤ n², hence 2·|δS| in |S|²/n
    let rounding = 8.0 * f64::EPSILON * (COUNT * COUNT * ORDER) as f64;
    let expected = |m: usize| if m.is_multiple_of(COUNT) { top } else { 0.0 };
    let worst = power.iter().enumerate().map(|(m, p)| (p - expected(m)).abs()).fold(0.0, f64::max);
    let same = samples.points().map(|[x, v]| (v - false_tone.at(x)).abs()).fold(0.0, f64::max);
    // the argument 2πνx of the last sample is rounded to ε of itself, in either tone
    let argument = 4.0 * f64::EPSILON * std::f64::consts::PI * top;
    let weight = forward(&samples).near(alias.frequency()).norm() / top;
    // twice the same samples: four times the power of one tone
    let together = samples.points().map(|[x, v]| (v + false_tone.at(x)).powi(2)).sum::<f64>() / top;
    Ok(Figure::new(2)
        .with(impulses("comb", text!("regular places", "регулярные позиции"), &positions))
        .with(power_panel)
        .with(space_panel)
        .with(spectrum_panel)
        .claim(
            text!(
                "the power is {COUNT} at multiples of the rate and 0 at all other frequencies m/{COUNT}",
                "мощность равна {COUNT} на кратных частоты дискретизации и 0 на остальных частотах m/{COUNT}"
            ),
            Residual::at_most("power of a regular comb: n at the rate's multiples, else 0", worst, rounding),
        )
        .claim(
            text!(
                "tones at {} and {} have the same samples",
                "синусоиды с частотами {} и {} имеют одни и те же отсчёты",
                number(own, 4),
                number(alias.frequency(), 4)
            ),
            Residual::at_most("samples of the tone = samples of its alias", same, argument),
        )
        .claim(
            text!(
                "the alias is a line of weight {}, like the tone itself",
                "алиас — линия веса {}, как у самой синусоиды",
                number(weight, 3)
            ),
            Residual::near("weight of the alias", weight, 0.5, argument),
        )
        .claim(
            text!(
                "tone and alias sampled together have the power {}, not ½ + ½: coherent powers do not add up",
                "мощность отсчётов синусоиды вместе с алиасом равна {}, а не ½ + ½: когерентные мощности не складываются",
                number(together, 3)
            ),
            Residual::near("power of a tone with its alias", together, 2.0, 8.0 * argument),
        ))
}
