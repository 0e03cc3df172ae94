//! Image, time and lens stratified in groups (slide «Стратификация в многомерном случае»).

use crate::error::Result;
use crate::figure::common::unmarked;
use crate::figure::params::Param;
use crate::figure::patterns::square::{SEED, SEEDS, for_all_seeds};
use crate::figure::{Bar, Entry, Figure, Layer, Legend, Meaning, Panel, Scale, Tones};
use crate::pattern::Pattern;
use crate::pattern::jittered::Jittered;
use crate::pattern::measure::periodogram::pattern_seed;
use crate::pattern::padded::{Association, Padded};
use crate::residual::Residual;
use crate::text;
use crate::text::{Text, number};
use ndarray::Array2;

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[GROUPS];

const GROUPS: Entry = Entry {
    id: "f52-groups",
    inventory: &["F52"],
    errata: &["E17"],
    title: &Text::fixed("Five dimensions with four samples", "Пять измерений — четыре отсчёта"),
    caption: &Text::fixed(
        "Four strata of the pixel, four of the time, four of the lens: each group is stratified by itself, and a random \
         shuffle says which goes with which (one colour is one sample). Four strata in every one of the five dimensions would \
         need 4⁵ = 1024 samples; groups need four. Unshuffled, every pixel would see the same time and lens at the same corner.",
        "Четыре страты пикселя, четыре времени, четыре линзы: каждая группа стратифицирована сама по себе, а случайное \
         перемешивание решает, что с чем связать (один цвет — один отсчёт). Четыре страты в каждом из пяти измерений \
         потребовали бы 4⁵ = 1024 отсчёта, группам хватает четырёх. Без перемешивания углу пикселя всегда достаются одни и те \
         же время и место на линзе.",
    ),
    params: &[Param::count("seed", &SEED, 1, 1, SEEDS)],
    build: |params| groups(params.count("seed") as u64),
};

/// How many random associations are counted.
const DRAWS: u32 = 100_000;

/// Strata of the sample's image, time and lens places, 0 to 3 each.
fn strata(sample: &[f64; 5]) -> [usize; 3] {
    let quarter = |x: f64, y: f64| (2.0 * x) as usize + 2 * ((2.0 * y) as usize);
    [quarter(sample[0], sample[1]), (4.0 * sample[2]) as usize, quarter(sample[3], sample[4])]
}

/// The number of a permutation of four among all 24, in the order of the dictionary.
fn rank(order: [usize; 4]) -> usize {
    let smaller = |i: usize| order[i + 1..].iter().filter(|&&later| later < order[i]).count();
    6 * smaller(0) + 2 * smaller(1) + smaller(2)
}

/// The correlation of the indices `0..4` with their partners.
fn correlation(order: [usize; 4]) -> f64 {
    order.iter().zip(0..).map(|(&partner, i)| (f64::from(i) - 1.5) * (partner as f64 - 1.5)).sum::<f64>() / 5.0
}

/// Everything that is counted over many draws.
struct Counted {
    pairings: Array2<f64>,
    unfair: usize,
    correlation: f64,
}

fn count(pattern: &Padded, seed: u64, draws: u32) -> Counted {
    let mut counted = Counted { pairings: Array2::zeros((24, 24)), unfair: 0, correlation: 0.0 };
    for draw in 0..draws {
        let (mut times, mut lenses, mut seen) = ([0; 4], [0; 4], [0u8; 3]);
        for sample in pattern.points(pattern_seed(seed, draw)) {
            let [image, time, lens] = strata(&sample);
            (times[image], lenses[image]) = (time, lens);
            seen.iter_mut().zip([image, time, lens]).for_each(|(seen, stratum)| *seen |= 1 << stratum);
        }
        counted.unfair += usize::from(seen != [0b1111; 3]);
        counted.pairings[[rank(times), rank(lenses)]] += 1.0;
        counted.correlation += 0.5 * (correlation(times) + correlation(lenses)) / f64::from(draws);
    }
    counted
}

/// Where the three groups stand in the drawing.
const TIME: f64 = 1.5;
const LENS: f64 = 2.1;

/// The pixel, the time and the lens with their strata, and four samples through all of them.
fn drawing(name: &'static str, title: Text, samples: &[[f64; 5]]) -> Panel {
    let square = |x: f64| {
        let edges = [[x, 0.0], [x + 1.0, 0.0], [x + 1.0, 1.0], [x, 1.0], [x, 0.0], [f64::NAN; 2]];
        let cuts = [[x + 0.5, 0.0], [x + 0.5, 1.0], [f64::NAN; 2], [x, 0.5], [x + 1.0, 0.5], [f64::NAN; 2]];
        [edges, cuts].concat()
    };
    let marks = (0..=4).flat_map(|i| {
        let y = 0.25 * f64::from(i);
        [[TIME - 0.06, y], [TIME + 0.06, y], [f64::NAN; 2]]
    });
    let line = [[TIME, 0.0], [TIME, 1.0], [f64::NAN; 2]];
    let strata = square(0.0).into_iter().chain(square(LENS)).chain(marks).chain(line);
    let names = [
        ([0.5, 1.12], text!("pixel (x, y)", "пиксель (x, y)")),
        ([TIME, 1.12], text!("time t", "время t")),
        ([LENS + 0.5, 1.12], text!("lens (u, v)", "линза (u, v)")),
    ];
    let panel = Panel::new(name, title, unmarked(-0.1, LENS + 1.1), unmarked(-0.1, 1.25))
        .square()
        .with(Layer::line("strata", Meaning::Guide, strata))
        .with(Layer::notes("names", Meaning::Guide, names));
    samples.iter().zip(0..).fold(panel, |panel, (&[x, y, t, u, v], i)| {
        let places = [[x, y], [TIME, t], [LENS + u, v]];
        let links = [[places[0], places[1]], [places[1], places[2]]];
        panel.with(Layer::pointers("association", Meaning::Series(i), links)).with(Layer::dots(
            "sample",
            Meaning::Series(i),
            places,
        ))
    })
}

fn groups(seed: u64) -> Result<Figure> {
    let shuffled = Padded::new(2)?;
    let ordered = shuffled.associated(Association::InOrder);
    let counted = count(&shuffled, seed, DRAWS);
    let kept = count(&ordered, seed, 1000);
    let draws = f64::from(DRAWS);
    let expected = draws / 576.0;
    let chi: f64 = counted.pairings.iter().map(|n| (n - expected).powi(2) / expected).sum();

    let all = (0.0, 24.0);
    let pairings = Panel::new(
        "pairings",
        text!("576 pairings, equally often", "576 связей, одинаково часто"),
        Scale::linear(text!("association with the lens", "связь с линзой"), 0.0, 24.0),
        Scale::linear(text!("with the time", "со временем"), 0.0, 24.0),
    )
    .square()
    .with(Layer::raster("pairings", all, all, &counted.pairings / expected, (0.5, 1.5), Tones::Data))
    .bar(Bar::values(text!("of their mean", "от среднего")));
    let cost = Panel::new(
        "cost",
        text!("samples needed", "сколько нужно отсчётов"),
        Scale::linear(text!("strata", "страт"), 1.0, 16.0),
        Scale::log(text!("samples", "отсчётов"), 0.7, 3e6),
    )
    .legend(Legend::Above)
    .with(
        Layer::line("each", Meaning::Error, (1..=16).map(|n| [f64::from(n), f64::from(n).powi(5)]))
            .thick()
            .label(text!("in each dimension: n⁵", "в каждом измерении: n⁵")),
    )
    .with(
        Layer::line("groups", Meaning::Signal, (1..=16).map(|n| [f64::from(n), f64::from(n)]))
            .thick()
            .label(text!("in groups: n", "по группам: n")),
    )
    .with(Layer::dots("four", Meaning::Samples, [[4.0, 1024.0], [4.0, 4.0]]));

    // Laurent, Massart 2000: a χ² of d degrees is off by more than 2√(dx) + 2x with a probability below e^{−x}
    let degrees = 575.0f64;
    let tail = (1e3 * 2.0 * SEEDS as f64).ln();
    let spread = 2.0 * (degrees * tail).sqrt() + 2.0 * tail;
    // the correlation of a random permutation of four has the variance ⅓; two of them are averaged
    let deviation = (1.0 / (6.0 * draws)).sqrt();
    let each = Pattern::<5>::count(&Jittered::new([4; 5])?).unwrap_or_default();
    Ok(Figure::new(2)
        .heights([0.8, 1.0])
        .with(drawing("shuffled", text!("shuffled", "перемешано"), &shuffled.points(pattern_seed(seed, 0))))
        .with(drawing("in-order", text!("in order", "по порядку"), &ordered.points(pattern_seed(seed, 0))))
        .with(pairings)
        .with(cost)
        .claim(
            text!(
                "in every draw each of (x, y), t and (u, v) has one sample in each of its four strata",
                "при каждой попытке у (x, y), t и (u, v) по одному отсчёту в каждой из четырёх страт"
            ),
            Residual::at_most("draws with an empty stratum", (counted.unfair + kept.unfair) as f64, 0.0),
        )
        .claim(
            text!(
                "all 4!·4! = 576 associations are equally likely: χ² = {} for 575 degrees of freedom",
                "все 4!·4! = 576 связей равновероятны: χ² = {} при 575 степенях свободы",
                number(chi, 3)
            ),
            Residual::near("χ² of the associations", chi, degrees, spread),
        )
        .claim(
            text!(
                "in order, partners are fully correlated; shuffled, not at all",
                "по порядку связанные номера полностью коррелированы, после перемешивания — совсем нет"
            ),
            Residual::at_most(
                "correlation of partners: 1 in order, 0 shuffled, in standard deviations",
                (counted.correlation / deviation).abs()
                    + (kept.correlation - 1.0).abs() / (8.0 * 1000.0 * f64::EPSILON),
                for_all_seeds(1),
            ),
        )
        .claim(
            text!(
                "four strata in each dimension take {each} samples, in groups {}",
                "четыре страты в каждом измерении — это {each} отсчёта, по группам — {}",
                shuffled.points(seed).len()
            ),
            Residual::near("4⁵ = 1024 samples", each as f64, 1024.0, 0.0),
        ))
}
