//! The chirp that folds back (V27; Pharr & Humphreys, figure 7.9 of the second edition).

use crate::axis::{Axis, Edge};
use crate::error::Result;
use crate::figure::common::{signal_curve, space, values};
use crate::figure::params::Param;
use crate::figure::{Entry, Figure, Layer, Legend, Meaning, Panel, Scale};
use crate::kernel::ideal::Ideal;
use crate::nyquist::fold;
use crate::reconstruct::reconstruct;
use crate::residual::Residual;
use crate::sampled::Samples;
use crate::signal::Signal;
use crate::signal::lecture::LectureChirp;
use crate::text;
use crate::text::{Text, number};

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[CHIRP];

static RATE: Text = Text::fixed("samples per unit", "отсчётов на единицу");

const CHIRP: Entry = Entry {
    id: "x-chirp",
    inventory: &[],
    errata: &[],
    title: &Text::fixed("A rising tone comes back falling", "Растущая частота возвращается убывающей"),
    caption: &Text::fixed(
        "The chirp's frequency 4x grows without end; its samples know nothing above Nyquist. There the reconstruction turns \
         round: it is the exact mirror image of what came before, and then everything repeats. Not an approximation: with \
         these steps the samples are periodic.",
        "Частота 4x растёт неограниченно, но выше частоты Найквиста отсчёты её не различают. Там реконструкция \
         разворачивается: дальше идёт точное зеркальное отражение, а затем всё повторяется. Это не приближение: при таком \
         шаге отсчёты периодичны.",
    ),
    params: &[Param::choice("rate", &RATE, &["8", "4", "12", "16"])],
    build: |params| {
        chirp(match params.choice("rate") {
            "4" => 4,
            "12" => 12,
            "16" => 16,
            _ => 8,
        })
    },
};

/// Multiples of 4 a unit: then the phase `2x² = 2k²/n²` of sample `k` gains whole turns after `n²/4` samples.
fn chirp(rate: usize) -> Result<Figure> {
    let chirp = LectureChirp;
    let (step, period, end) = (1.0 / rate as f64, rate as f64 / 4.0, 4.0);
    let mirror = 0.5 * period;
    let one_period = Samples::of(&chirp, Axis::new(0.0, step, rate * rate / 4)?);
    let back = reconstruct(&one_period, Ideal).edge(Edge::Wrap);
    let shown = Samples::of(&chirp, Axis::new(0.0, step, 4 * rate + 1)?);
    let dots = || Layer::dots("samples", Meaning::Samples, shown.points()).label(text!("samples", "отсчёты"));
    let turns = (1..).map(|k| f64::from(k) * mirror).take_while(|x| *x < end - 1e-9);
    let mirrors = || Layer::verticals("mirrors", Meaning::Guide, turns.clone()).dashed();
    let panel = |name| {
        Panel::new(name, Text::EMPTY, space(-0.05, end + 0.05), values("f(x)", -0.45, 2.45)).legend(Legend::Above)
    };
    let before = panel("chirp")
        .with(
            Layer::curve("chirp", Meaning::Signal, 0.0, end, 2400, |x| chirp.at(x))
                .label(text!("1 + cos(4πx²)", "1 + cos(4πx²)")),
        )
        .with(dots());
    let after = panel("back")
        .with(mirrors())
        .with(
            signal_curve("back", Meaning::Reconstructed, &back, 0.0, end)
                .thick()
                .label(text!("sinc through the same samples", "sinc по тем же отсчётам")),
        )
        .with(dots());
    let frequencies = Panel::new(
        "frequency",
        Text::EMPTY,
        space(-0.05, end + 0.05),
        Scale::linear(Text::same("ν"), -0.5, 1.1 * rate as f64),
    )
    .legend(Legend::Above)
    .with(mirrors())
    .with(Layer::line("true", Meaning::Signal, [[0.0, 0.0], [end, 4.0 * end]]).label(text!("true: 4x", "истинная: 4x")))
    .with(
        Layer::curve("folded", Meaning::Leaked, 0.0, end, 800, |x| fold(4.0 * x, rate as f64)).thick().label(text!(
            "folded at {}",
            "с заворотом на {}",
            number(0.5 * rate as f64, 2)
        )),
    );

    let repeats = shown.points().zip(0..).map(|([_, v], k)| {
        let again = one_period.values()[k % one_period.values().len()];
        (v - again).abs()
    });
    let repeats = repeats.fold(0.0, f64::max);
    let places = (0..=64).map(|i| mirror * f64::from(i) / 64.0);
    let reflected = places.map(|d| (back.at(mirror + d) - back.at(mirror - d)).abs()).fold(0.0, f64::max);
    // the phase 4x² of the last sample, up to 64, is rounded once or twice
    let phase = 4.0 * f64::EPSILON * std::f64::consts::PI * 64.0;
    // Dirichlet's kernel sums to at most 2 + ln n in absolute value
    let rounding = (2.0 + (one_period.values().len() as f64).ln()) * (phase + 64.0 * f64::EPSILON);
    Ok(Figure::new(1)
        .heights([1.0, 1.0, 1.25])
        .with(before)
        .with(after)
        .with(frequencies)
        .claim(
            text!("the period of the samples is {}", "период отсчётов равен {}", number(period, 2)),
            Residual::at_most("samples = samples one period before", repeats, phase),
        )
        .claim(
            text!(
                "the reconstruction is mirrored about x = {}, where the frequency reaches Nyquist",
                "реконструкция симметрична относительно x = {}, где частота достигает частоты Найквиста",
                number(mirror, 2)
            ),
            Residual::at_most("reconstruction = its mirror image", reflected, rounding),
        ))
}
