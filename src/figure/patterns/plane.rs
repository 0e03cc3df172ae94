//! Regular and jittered points in the plane, and their spectra (slides «Равномерное сэмплирование», «Jittered Sampling»).

use crate::error::Result;
use crate::figure::common::unmarked;
use crate::figure::params::{Param, Params};
use crate::figure::patterns::square::{SEED, SEEDS, cell_lines, points_panel, power_panel, tones_panel};
use crate::figure::{Bar, Entry, Figure, Layer, Legend, Meaning, Panel, Scale};
use crate::laws::point_spectra::{Model, follows};
use crate::num::sinc;
use crate::pattern::Pattern;
use crate::pattern::jittered::Jittered;
use crate::pattern::measure::periodogram::{Periodogram, pattern_seed};
use crate::pattern::regular::Regular;
use crate::residual::Residual;
use crate::text;
use crate::text::{Text, number};
use ndarray::Array2;

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[REGULAR, JITTERED];

static SIDE: Text = Text::fixed("points along a side", "точек вдоль стороны");
static AMOUNT: Text = Text::fixed("amount of jitter, in cells", "величина джиттера, в ячейках");

const REGULAR: Entry = Entry {
    id: "f37-plane",
    inventory: &["F37"],
    errata: &["E10"],
    title: &Text::fixed("A regular grid and its spectrum", "Регулярная сетка и её спектр"),
    caption: &Text::fixed(
        "The power spectrum of an n × n grid is again a grid: N = n² at the multiples of n, and nothing at all other whole \
         frequencies. On every one of these spikes sampling puts a copy of the image's spectrum, as strong as the first.",
        "Спектр мощности сетки n × n — снова сетка: N = n² на кратных n и ноль на остальных целых частотах. На каждый из \
         этих пиков дискретизация ставит копию спектра изображения, такую же сильную, как первая.",
    ),
    params: &[Param::count("n", &SIDE, 16, 6, 20)],
    build: |params| regular(params.count("n")),
};

fn regular(side: usize) -> Result<Figure> {
    let pattern = Regular::new([side, side])?;
    let points = pattern.points(0);
    let reach = 5 * side / 2;
    let found = Periodogram::of(&points, reach)?;
    let (n, far) = (points.len() as f64, reach as i64);
    let lines =
        (-far..=far).flat_map(|v| (-far..=far).map(move |u| [u, v])).filter(|[u, v]| found.at(*u, *v) > 0.5 * n);
    let lines: Vec<[f64; 2]> = lines.map(|f| f.map(|f| f as f64)).collect();
    let edge = reach as f64 + 0.5;
    let ticks =
        || [-2, -1, 0, 1, 2].map(|k| k * side as i64).map(|f| (f as f64, Text::of(f.to_string(), f.to_string())));
    let scale = || Scale::linear(Text::EMPTY, -edge, edge).ticks(ticks());
    let others = found.half().filter(|(f, _)| f.iter().any(|f| f % side as i64 != 0));
    let rest = others.map(|(_, power)| power).fold(0.0, f64::max);
    let row = Panel::new(
        "row",
        text!("along v = 0", "вдоль v = 0"),
        Scale::linear(Text::same("u"), -edge, edge).ticks(ticks()),
        Scale::linear(text!("power", "мощность"), 0.0, 1.15 * n),
    )
    .span(2)
    .with(Layer::stems("row", Meaning::Samples, (-far..=far).map(|u| [u as f64, found.at(u, 0)])));
    Ok(Figure::new(2)
        .heights([1.7, 1.0])
        .with(points_panel("points", text!("{side} × {side} points", "{side} × {side} точек"), &points))
        .with(
            Panel::new("spectrum", text!("where there is power", "где есть мощность"), scale(), scale())
                .square()
                .with(Layer::dots("lines", Meaning::Replica, lines.iter().copied())),
        )
        .with(row)
        .claim(
            text!(
                "{} spikes of {n}, one at each multiple of {side}; nothing elsewhere",
                "{} пиков высоты {n}, по одному на кратных {side}; больше ничего",
                lines.len()
            ),
            follows(&found, Model::Jittered([side, side], 0.0), 1),
        )
        .claim(
            text!("nothing: at no other whole frequency any power", "ничего: на других целых частотах мощности нет"),
            // each of N phasors is off by 4ε·reach, so their sum by N times that, and P is its square over N
            Residual::at_most(
                "power of a grid off its lines",
                rest,
                n * (4.0 * f64::EPSILON * (reach + 1) as f64).powi(2),
            ),
        ))
}

const JITTERED: Entry = Entry {
    id: "f39-plane",
    inventory: &["F39"],
    errata: &["E11", "E32"],
    title: &Text::fixed("Jitter in the plane", "Джиттер на плоскости"),
    caption: &Text::fixed(
        "Every point is moved at random within its cell. The mean power spectrum of such patterns is 1 − sinc²u·sinc²v, with \
         frequencies in cycles per cell: with jitter over whole cells all spikes of the grid but the one at zero are gone, and \
         their power has become noise, little of it near zero and all of it beyond.",
        "Каждая точка случайно сдвинута в пределах своей ячейки. Средний спектр мощности таких узоров равен \
         1 − sinc²u·sinc²v, частоты — в периодах на ячейку: при сдвигах по всей ячейке исчезли все пики сетки, кроме \
         нулевого. Их мощность стала шумом: вблизи нуля его мало, вдали он достигает единицы.",
    ),
    params: &[Param::real("a", &AMOUNT, 1.0, 0.05, 1.0, ""), Param::count("seed", &SEED, 1, 1, SEEDS)],
    build: |params| jittered(params),
};

/// How many patterns the mean is taken over.
const PATTERNS: u32 = 1500;

fn jittered(params: &Params) -> Result<Figure> {
    const CELLS: usize = 8;
    const REACH: usize = 20;
    let (amount, seed) = (params.real("a"), params.count("seed") as u64);
    let pattern = Jittered::<2>::new([CELLS, CELLS])?.with_width(amount)?;
    let grid = Regular::<2>::new([CELLS, CELLS])?.points(0);
    let moved = pattern.points(pattern_seed(seed, 0));
    let found = Periodogram::mean(&pattern, seed, PATTERNS, REACH)?;
    let model = Model::Jittered([CELLS, CELLS], amount);
    let cells = CELLS as f64;
    let far = REACH as i64;
    let at = |u: i64, v: i64| {
        let [noise, line] = model.at([u, v]);
        noise + line * found.points()
    };
    let mut theory = Array2::from_shape_fn((2 * REACH + 1, 2 * REACH + 1), |(y, x)| at(x as i64 - far, y as i64 - far));
    theory[[REACH, REACH]] = 0.0;
    // a quarter of the square, so that the arrows can be seen
    let seen = || grid.iter().zip(&moved).filter(|(from, _)| from.iter().all(|&c| c < 0.5));
    let arrows = Panel::new(
        "moved",
        text!("moved within the cells", "сдвиги внутри ячеек"),
        unmarked(0.0, 0.5),
        unmarked(0.0, 0.5),
    )
    .square()
    .with(cell_lines(CELLS, CELLS))
    .with(Layer::dots("grid", Meaning::Replica, seen().map(|(&from, _)| from)))
    .with(Layer::dots("jittered", Meaning::Samples, seen().map(|(_, &to)| to)))
    .with(Layer::pointers("moves", Meaning::Guide, seen().map(|(&from, &to)| [from, to])));
    let floor = |nu: f64| 1.0 - sinc(amount * nu).powi(2);
    let edge = (REACH as f64 + 0.5) / cells;
    let axis = Panel::new(
        "axis",
        text!("along v = 0", "вдоль v = 0"),
        Scale::linear(text!("u, cycles per cell", "u, периодов на ячейку"), -edge, edge),
        Scale::linear(text!("power", "мощность"), 0.0, 1.3),
    )
    .span(3)
    .legend(Legend::Above)
    .with(
        Layer::dots(
            "measured",
            Meaning::Samples,
            (-far..=far).filter(|&u| u != 0).map(|u| [u as f64 / cells, found.at(u, 0)]),
        )
        .label(text!("mean of {PATTERNS} patterns", "среднее по {PATTERNS} узорам")),
    )
    .with(Layer::curve("theory", Meaning::Theory, -edge, edge, 400, floor).thick().label(Text::same("1 − sinc²(au)")));
    let line = sinc(amount).powi(2);
    let worst = [[8, 0], [0, 8], [8, 8]].map(|[u, v]| found.at(u, v)).into_iter().fold(0.0, f64::max);
    let allowed = at(8, 0) + at(0, 8) + at(8, 8); // with a = 1 each of them is noise alone
    let gone = if amount == 1.0 {
        text!(
            "all spikes but the one at zero are gone: nothing above {} where there were {}",
            "все пики, кроме нулевого, исчезли: не больше {} там, где было {}",
            number(worst, 2),
            found.points()
        )
    } else {
        text!(
            "of the spike at (1, 0) sinc²(a) = {} is left",
            "от пика в (1, 0) осталось sinc²(a) = {}",
            number(line, 3)
        )
    };
    Ok(Figure::new(3)
        .heights([1.35, 1.0])
        .with(arrows)
        .with(power_panel("power", text!("measured power", "измеренная мощность"), &found, cells, (0.0, 1.2)))
        .with(
            tones_panel("theory", Text::same("1 − sinc²(au)·sinc²(av)"), theory, cells, (0.0, 1.2))
                .bar(Bar::values(Text::EMPTY)),
        )
        .with(axis)
        .claim(
            text!(
                "the noise follows 1 − sinc²(au)·sinc²(av): on the axis {} at ¼, {} at ½ (theory {} and {})",
                "шум следует 1 − sinc²(au)·sinc²(av): на оси {} при ¼ и {} при ½ (теория {} и {})",
                number(found.at(2, 0), 2),
                number(found.at(4, 0), 2),
                number(floor(0.25), 4),
                number(floor(0.5), 4)
            ),
            follows(&found, model, SEEDS),
        )
        .claim(gone, Residual::at_most("spikes of the grid after jitter", worst, allowed)))
}
