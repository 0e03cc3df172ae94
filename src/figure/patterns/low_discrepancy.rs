//! Radical inverses, and what is made of them.

use crate::error::Result;
use crate::figure::params::Param;
use crate::figure::patterns::square::{SEED, SEEDS, for_all_seeds, points_panel, power_panel};
use crate::figure::{Bar, Entry, Figure, Layer, Meaning, Panel, Scale};
use crate::laws::discrepancy::{halton_boxes, hammersley_discrepancy};
use crate::pattern::Pattern;
use crate::pattern::halton::Halton;
use crate::pattern::hammersley::Hammersley;
use crate::pattern::measure::discrepancy::{star_discrepancy, star_discrepancy_line};
use crate::pattern::measure::periodogram::{Periodogram, pattern_seed};
use crate::pattern::radical::radical_inverse;
use crate::pattern::scrambling::Scrambling;
use crate::residual::Residual;
use crate::text;
use crate::text::{Text, number};

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[INVERSE, SCRAMBLING];

static POWER: Text = Text::fixed("N = 2^{m} points", "N = 2^{m} точек");

const INVERSE: Entry = Entry {
    id: "x-low-discrepancy",
    inventory: &[],
    errata: &[],
    title: &Text::fixed("Digits mirrored at the point", "Цифры, отражённые в запятой"),
    caption: &Text::fixed(
        "The radical inverse Φ₂(i) mirrors the binary digits of i at the point: 110 becomes 0.011. However many one takes, they \
         are spread evenly. Halton's points are (Φ₂(i), Φ₃(i)) and go on for ever; Hammersley's are (i/N, Φ₂(i)), lower in \
         discrepancy, but N must be known beforehand.",
        "Обращение Φ₂(i) отражает двоичные цифры числа i относительно запятой: 110 становится 0,011. Сколько их ни взять, они \
         лежат равномерно. Точки Холтона — (Φ₂(i), Φ₃(i)), их можно продолжать без конца; точки Хаммерсли — (i/N, Φ₂(i)), их \
         расхождение меньше, но N надо знать заранее.",
    ),
    params: &[Param::count("m", &POWER, 8, 4, 10)],
    build: |params| inverse(params.count("m") as u32),
};

fn inverse(m: u32) -> Result<Figure> {
    let n = 1usize << m;
    let values = |count: u32| (0..count).map(|i| Ok(radical_inverse(2, i)?.value())).collect::<Result<Vec<f64>>>();
    let eight = values(8)?;
    let places = |i: usize| format!("{i:03b}");
    let digits = Panel::new(
        "digits",
        text!("Φ₂: digits mirrored", "Φ₂: цифры отражены"),
        Scale::linear(Text::same("i"), -0.6, 7.6).ticks((0..8).map(|i| (i as f64, Text::of(places(i), places(i))))),
        Scale::linear(Text::same("Φ₂(i)"), -0.06, 1.0).ticks((0..8).map(|k| {
            let written = format!("0.{k:03b}");
            (f64::from(k) / 8.0, Text::of(written.clone(), written))
        })),
    )
    .with(Layer::stems("inverse", Meaning::Samples, eight.iter().zip(0..).map(|(&v, i)| [f64::from(i), v])));
    let halton: Vec<[f64; 2]> = Halton::new(n)?.points(0);
    let hammersley: Vec<[f64; 2]> = Hammersley::new(n)?.points(0);
    let all = values(n as u32)?;
    let (d_line, d_halton, d_hammersley) =
        (star_discrepancy_line(&all)?, star_discrepancy(&halton)?, star_discrepancy(&hammersley)?);
    // the largest 2^a·3^b near a square that fits
    let boxes = if n >= 144 {
        [4, 2]
    } else if n >= 36 {
        [2, 2]
    } else {
        [2, 1]
    };
    let [a, b] = [1usize << boxes[0], 3usize.pow(boxes[1])];
    Ok(Figure::new(3)
        .with(digits)
        .with(points_panel("halton", text!("Halton, N = {n}", "Холтон, N = {n}"), &halton))
        .with(points_panel("hammersley", text!("Hammersley, N = {n}", "Хаммерсли, N = {n}"), &hammersley))
        .claim(
            text!(
                "the first {n} values of Φ₂ are the multiples of 1/{n}: D* = 1/N",
                "первые {n} значений Φ₂ — кратные 1/{n}: D* = 1/N"
            ),
            Residual::near("D* of 2^m radical inverses = 1/N", d_line, 1.0 / n as f64, 4.0 * f64::EPSILON),
        )
        .claim(
            text!(
                "Halton: the first {} points, one in each of {a} × {b} boxes; D* = {}",
                "Холтон: из первых точек (их {}) — по одной в каждом из {a} × {b} ящиков; D* = {}",
                a * b,
                number(d_halton, 3)
            ),
            halton_boxes(&halton[..a * b], boxes)?,
        )
        .claim(
            text!(
                "Hammersley: D* = {}, as Halton and Zaremba have it",
                "Хаммерсли: D* = {}, по формуле Холтона и Зарембы",
                number(d_hammersley, 3)
            ),
            hammersley_discrepancy(&hammersley)?,
        ))
}

const SCRAMBLING: Entry = Entry {
    id: "x-halton-scrambling",
    inventory: &[],
    errata: &[],
    title: &Text::fixed("Halton in bases 29 and 31", "Холтон по основаниям 29 и 31"),
    caption: &Text::fixed(
        "Dimensions ten and eleven of Halton's sequence begin with lines, for both radical inverses climb in steps that are \
         nearly equal; their spectrum is a few strong spikes. Permuted digits and, better, Owen's nested scrambling break the \
         lines up and keep each coordinate as even as before.",
        "Десятая и одиннадцатая координаты последовательности Холтона начинаются с линий: оба обращения растут почти равными \
         шагами, и спектр — несколько сильных пиков. Перестановка цифр и, ещё лучше, вложенное перемешивание Оуэна ломают \
         линии, а каждая координата остаётся такой же равномерной.",
    ),
    params: &[Param::count("seed", &SEED, 1, 1, SEEDS)],
    build: |params| scrambling(params.count("seed") as u64),
};

/// The bases 29 and 31 are the tenth and the eleventh prime.
const DIMENSIONS: [usize; 2] = [9, 10];

fn projection(kind: Scrambling, n: usize, seed: u64) -> Result<Vec<[f64; 2]>> {
    let points: Vec<[f64; 11]> = Halton::new(n)?.scrambled(kind).points(seed);
    Ok(points.into_iter().map(|p| DIMENSIONS.map(|d| p[d])).collect())
}

/// The correlation of the two coordinates.
fn correlation(points: &[[f64; 2]]) -> f64 {
    let n = points.len() as f64;
    let mean = [0, 1].map(|d| points.iter().map(|p| p[d]).sum::<f64>() / n);
    let sum = |a: usize, b: usize| points.iter().map(|p| (p[a] - mean[a]) * (p[b] - mean[b])).sum::<f64>();
    sum(0, 1) / (sum(0, 0) * sum(1, 1)).sqrt()
}

fn scrambling(seed: u64) -> Result<Figure> {
    const N: usize = 256;
    const REACH: usize = 32;
    const TRIALS: u32 = 50;
    let kinds = [
        ("plain", "plain-power", text!("plain", "как есть"), Scrambling::None),
        ("permuted", "permuted-power", text!("permuted digits", "перестановка цифр"), Scrambling::Digits),
        ("owen", "owen-power", text!("Owen's scrambling", "перемешивание Оуэна"), Scrambling::Owen),
    ];
    let mut figure = Figure::new(3);
    let mut peaks = Vec::new();
    for (name, _, title, kind) in &kinds {
        let points = projection(*kind, N, pattern_seed(seed, 0))?;
        figure = figure.with(points_panel(name, title.clone(), &points));
    }
    for (_, name, _, kind) in &kinds {
        let found = Periodogram::of(&projection(*kind, N, pattern_seed(seed, 0))?, REACH)?;
        peaks.push(found.half().map(|(_, power)| power).fold(0.0, f64::max) / N as f64);
        let panel = power_panel(name, text!("its power", "его мощность"), &found, 1.0, (0.0, 4.0));
        figure = figure.with(if *name == "owen-power" { panel.bar(Bar::values(Text::EMPTY)) } else { panel });
    }
    let line = projection(Scrambling::None, 29, seed)?;
    let off = line.iter().map(|[x, y]| (31.0 * y - 29.0 * x).abs()).fold(0.0, f64::max);
    let of_owen = (0..TRIALS).map(|t| Ok(correlation(&projection(Scrambling::Owen, 29, pattern_seed(seed, t))?)));
    let of_owen = of_owen.collect::<Result<Vec<_>>>()?;
    let mean = of_owen.iter().sum::<f64>() / of_owen.len() as f64;
    // two independent orders of n strata are correlated with the variance 1/(n − 1)
    let deviation = (1.0 / (28.0 * f64::from(TRIALS))).sqrt();
    Ok(figure
        .claim(
            text!(
                "the first 29 points lie on one line: 31·Φ₃₁(i) = 29·Φ₂₉(i) = i",
                "первые 29 точек лежат на одной прямой: 31·Φ₃₁(i) = 29·Φ₂₉(i) = i"
            ),
            // each quotient i/b is rounded to ε/2 of itself, and so is its product with b
            Residual::at_most("31·Φ₃₁(i) = 29·Φ₂₉(i)", off, 2.0 * 29.0 * f64::EPSILON),
        )
        .claim(
            text!(
                "their correlation is {}; scrambled by Owen's method, on average over {TRIALS} seeds it is none",
                "их корреляция {}; после перемешивания Оуэна в среднем по {TRIALS} попыткам её нет",
                number(correlation(&line), 3)
            ),
            Residual::at_most(
                "mean correlation after scrambling, in standard deviations",
                mean.abs() / deviation,
                for_all_seeds(1),
            ),
        )
        .claim(
            text!(
                "the highest spike has {} of N; scrambled, {} and {}",
                "самый высокий пик — {} от N; после перемешивания {} и {}",
                number(peaks[0], 2),
                number(peaks[1], 2),
                number(peaks[2], 2)
            ),
            // white noise in M bins exceeds x means with a probability below M·e^{−x}: x = ln M + ln(1000·seeds)
            Residual::at_most(
                "highest spike of scrambled points, as white noise has it",
                peaks[2] * N as f64,
                ((2 * REACH * (REACH + 1)) as f64 * 1e3 * SEEDS as f64).ln(),
            ),
        ))
}
