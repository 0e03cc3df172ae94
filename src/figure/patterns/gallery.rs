//! The gallery of patterns: points, spectra and measures (slide «Другие методы сэмплирования»).

use crate::error::Result;
use crate::figure::labels::labels;
use crate::figure::params::{Param, Params};
use crate::figure::patterns::square::{SEED, SEEDS, for_all_seeds, mean, points_panel, power_panel};
use crate::figure::{Bar, Entry, Figure, Layer, Legend, Meaning, Panel, Scale};
use crate::laws::discrepancy::{elementary_intervals, grid_discrepancy, halton_boxes, hammersley_discrepancy};
use crate::laws::point_spectra::{PLATEAU, in_band};
use crate::laws::spacing::packing;
use crate::num::sinc;
use crate::pattern::catalog::by_name;
use crate::pattern::cells::Cells;
use crate::pattern::measure::discrepancy::star_discrepancy;
use crate::pattern::measure::distance::{min_distance_torus, most_distance};
use crate::pattern::measure::elementary::unfairness;
use crate::pattern::measure::periodogram::{Periodogram, pattern_seed};
use crate::pattern::measure::whiteness::white_peak;
use crate::pattern::poisson_disk::PoissonDisk;
use crate::residual::Residual;
use crate::text;
use crate::text::{Text, number};

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[POINTS, SPECTRA, MEASURES];

static COUNT: Text = Text::fixed("number of points", "число точек");

/// Catalogue names with what a reader calls them.
static SHOWN: [(&str, Text); 8] = [
    ("halton", Text::fixed("Halton", "Холтон")),
    ("hammersley", Text::fixed("Hammersley", "Хаммерсли")),
    ("zero-two", Text::fixed("(0,2)-sequence", "(0,2)-послед.")),
    ("sobol-owen", Text::fixed("Sobol', Owen", "Соболь, Оуэн")),
    ("best-candidate", Text::fixed("best candidate", "лучший кандидат")),
    ("poisson-disk", Text::fixed("Poisson disk", "диски Пуассона")),
    ("n-rooks", Text::fixed("N rooks", "N ладей")),
    ("multi-jittered", Text::fixed("multi-jitter", "мультиджиттер")),
];

const POINTS: Entry = Entry {
    id: "f54-patterns",
    inventory: &["F54"],
    errata: &[],
    title: &Text::fixed("Other patterns of 256 points", "Другие узоры из 256 точек"),
    caption: &Text::fixed(
        "Above: digital sequences, which put one point into every box of many divisions at once. Below: patterns that keep \
         points apart (best candidate, Poisson disk), or put one point into every row and column (N rooks), and into every \
         cell of a grid, too (multi-jitter).",
        "Вверху — цифровые последовательности: по точке в каждом ящике сразу многих разбиений. Внизу — узоры, которые держат \
         точки на расстоянии (лучший кандидат, диски Пуассона), ставят по точке в каждую строку и столбец (N ладей) и ещё в \
         каждую ячейку сетки (мультиджиттер).",
    ),
    params: &[Param::count("seed", &SEED, 1, 1, SEEDS)],
    build: |params| patterns(params.count("seed") as u64),
};

/// How many points the patterns have.
const N: usize = 256;

fn patterns(seed: u64) -> Result<Figure> {
    let points = |name| Ok(by_name(name, N)?.points(pattern_seed(seed, 0)));
    let mut figure = Figure::new(4);
    for (name, title) in &SHOWN {
        figure = figure.with(points_panel(name, title.clone(), &points(name)?));
    }
    let rows = |name| {
        let points = points(name)?;
        Ok(unfairness(&points, Cells::new([N, 1])?)?.max(unfairness(&points, Cells::new([1, N])?)?))
    };
    let cells = unfairness(&points("multi-jittered")?, Cells::new([16, 16])?)?;
    let radius = PoissonDisk::with_about(N)?.radius();
    let distance = min_distance_torus(&points("poisson-disk")?)?;
    let nets = ["hammersley", "zero-two", "sobol-owen"].map(|name| elementary_intervals(&points(name)?));
    let nets = nets.into_iter().collect::<Result<Vec<_>>>()?;
    let worst = nets.iter().map(|r| r.measured).fold(0.0, f64::max);
    Ok(figure
        .claim(
            text!(
                "Hammersley, (0,2) and Sobol': one point in every box 2^{{−a}} × 2^{{−b}}, a + b = 8",
                "Хаммерсли, (0,2) и Соболь: по точке в каждом ящике 2^{{−a}} × 2^{{−b}}, a + b = 8"
            ),
            Residual::at_most("one point in every elementary interval", worst, 0.0),
        )
        .claim(
            text!(
                "Halton: the first 144 points, one in each of 16 × 9 boxes",
                "Холтон: первые 144 точки — по одной в каждом из 16 × 9 ящиков"
            ),
            halton_boxes(&points("halton")?[..144], [4, 2])?,
        )
        .claim(
            text!(
                "N rooks and multi-jitter: one point in each of {N} columns and rows; multi-jitter in each of 16 × 16 cells, too",
                "N ладей и мультиджиттер: по точке в каждом из {N} столбцов и строк; мультиджиттер — и в каждой из 16 × 16 ячеек"
            ),
            Residual::at_most(
                "one point in every row, column and cell",
                rows("n-rooks")?.max(rows("multi-jittered")?).max(cells),
                0.0,
            ),
        )
        .claim(
            text!(
                "Poisson disk: no two points nearer than {}, with opposite edges joined",
                "диски Пуассона: расстояния не меньше {}, если склеить противоположные стороны",
                number(radius, 3)
            ),
            Residual::at_most("no two points nearer than the radius", radius - distance, 4.0 * f64::EPSILON),
        ))
}

const SPECTRA: Entry = Entry {
    id: "f54-spectra",
    inventory: &["F54"],
    errata: &["E11"],
    title: &Text::fixed("Their power spectra", "Их спектры мощности"),
    caption: &Text::fixed(
        "Frequencies in units of √N; random patterns are averaged. Dark is no noise, 1 is white noise. Halton, \
         Hammersley and (0,2) have spikes: aliases stay copies; Owen's scrambling makes noise of them. N rooks is dark on \
         the axes only, multi-jitter around zero, too. Best candidate and Poisson disk are dark in a disk around zero with a bright \
         ring about it, the same in all directions.",
        "Частоты в единицах √N, случайные узоры усреднены. Тёмное — шума нет, 1 — белый шум. У Холтона, Хаммерсли и \
         (0,2) пики: алиасы остаются копиями; перемешивание Оуэна превращает их в шум. N ладей темны лишь на осях, \
         мультиджиттер — и вокруг нуля. Лучший кандидат и диски Пуассона темны в круге вокруг нуля, обведённом ярким \
         кольцом, одинаково во всех направлениях.",
    ),
    params: &[Param::count("seed", &SEED, 1, 1, SEEDS)],
    build: |params| spectra(params.count("seed") as u64),
};

/// How many patterns are averaged.
const PATTERNS: u32 = 30;
/// The largest frequency, a little beyond twice √N.
const REACH: usize = 32;

fn spectra(seed: u64) -> Result<Figure> {
    const COLUMNS: usize = 4;
    let mut figure = Figure::new(COLUMNS);
    let mut found = Vec::new();
    for (i, (name, title)) in SHOWN.iter().enumerate() {
        let pattern = by_name(name, N)?;
        // without chance one is as good as many
        let patterns = if matches!(*name, "halton" | "hammersley") { 1 } else { PATTERNS };
        let power = Periodogram::mean(&*pattern, seed, patterns, REACH)?;
        let mut panel = power_panel(name, title.clone(), &power, (N as f64).sqrt(), (0.0, 2.0));
        // all have the same scales: numbers stand at the start of a row, and what tones mean at its end
        if i % COLUMNS > 0 {
            panel.y = panel.y.bare();
        }
        figure = figure.with(if i % COLUMNS == COLUMNS - 1 { panel.bar(Bar::values(Text::EMPTY)) } else { panel });
        found.push((*name, power));
    }
    let of = |name| found.iter().find(|(known, _)| *known == name).map(|(_, power)| power);
    let band = |name| of(name).map_or([f64::NAN; 2], |power| in_band(power, [0.02, 0.35]));
    let ([disks, disks_error], [best, _]) = (band("poisson-disk"), band("best-candidate"));
    let ([rooks, _], [multi, _]) = (band("n-rooks"), band("multi-jittered"));
    // on an axis both are jitter of N cells: 1 − sinc²(u/N)
    let axis = |name| {
        let ratio = |power: &Periodogram| {
            let at = |u: i64| {
                let theory = 1.0 - sinc(u as f64 / N as f64).powi(2);
                0.5 * (power.at(u, 0) + power.at(0, u)) / theory
            };
            (1..=REACH as i64).map(at).sum::<f64>() / REACH as f64
        };
        of(name).map_or(f64::NAN, ratio)
    };
    // √(2P² + 4P/N) for one periodogram at one frequency; P ≥ 5·10⁻⁵, so the second term is at most (17P)²: it is taken
    // at each frequency as it is
    let spread = |u: i64| {
        let theory = 1.0 - sinc(u as f64 / N as f64).powi(2);
        2.0 + 4.0 / (N as f64 * theory)
    };
    let variance: f64 = (1..=REACH as i64).map(spread).sum::<f64>() / (REACH * REACH) as f64;
    let deviation = (variance / f64::from(2 * PATTERNS)).sqrt();
    let worst = [axis("n-rooks"), axis("multi-jittered")].map(|r| (r - 1.0).abs()).into_iter().fold(0.0, f64::max);
    let peak = |name| of(name).map_or(f64::NAN, |power| power.half().map(|(_, p)| p).fold(0.0, f64::max));
    let z = for_all_seeds(2);
    // one pattern without chance: the peak that noise stays below in all but one of 10⁵ cases
    let half = 2 * REACH * (REACH + 1);
    let spike = white_peak(half, 1.0 - 1e-5)?;
    Ok(figure
        .claim(
            text!(
                "N rooks and multi-jitter follow 1 − sinc²(u/N) on the axes: {} of it",
                "N ладей и мультиджиттер на осях следуют 1 − sinc²(u/N): {} от неё",
                number(axis("n-rooks"), 2)
            ),
            Residual::at_most("power on the axes relative to 1 − sinc²(u/N), less one", worst, z * deviation),
        )
        .claim(
            text!(
                "noise below 0.35√N: Poisson disk {}, best candidate {}, multi-jitter {}, N rooks {}",
                "шум ниже 0,35√N: диски Пуассона {}, лучший кандидат {}, мультиджиттер {}, N ладей {}",
                number(disks, 2),
                number(best, 2),
                number(multi, 2),
                number(rooks, 2)
            ),
            // the plateau rises a little towards 0.35√N: 0.066 in the last band (V21), an eighth
            Residual::near(
                "plateau of a Poisson disk pattern",
                disks,
                PLATEAU[0],
                z * (disks_error + PLATEAU[1]) + PLATEAU[0] / 8.0,
            ),
        )
        .claim(
            text!(
                "highest spikes: Halton {}, Hammersley {}, (0,2) on average {}; no noise reaches {}",
                "самые высокие пики: Холтон {}, Хаммерсли {}, (0,2) в среднем {}; шум не достигает {}",
                number(peak("halton"), 2),
                number(peak("hammersley"), 2),
                number(peak("zero-two"), 2),
                number(spike, 2)
            ),
            Residual::at_least(
                "the lowest of the three highest spikes, in powers of noise",
                ["halton", "hammersley", "zero-two"].map(peak).into_iter().fold(f64::INFINITY, f64::min),
                spike,
            ),
        )
        .claim(
            text!(
                "Owen's scrambling makes noise of them: the highest power is {}",
                "перемешивание Оуэна превращает их в шум: наибольшая мощность {}",
                number(peak("sobol-owen"), 2)
            ),
            // the variance of a scrambled (0,2)-net in base 2 is at most twice that of independent points, for every
            // function (A. Owen, *Scrambled net variance*, 1997): so is the mean power at every frequency
            Residual::at_most("highest mean power of Owen's points", peak("sobol-owen"), 2.0 * loudest(half * SEEDS)),
        ))
}

/// What the mean power of [`PATTERNS`] patterns of noise does not exceed at any of so many frequencies, in 999 of 1000
/// cases: of `n` exponential numbers the mean is beyond `x` with probability `e^{−n(x − 1 − ln x)}` at most (Chernoff).
fn loudest(frequencies: usize) -> f64 {
    let rare = (1e3 * frequencies as f64).ln() / f64::from(PATTERNS);
    // x ← 1 + rare + ln x contracts: its slope is 1/x
    (0..60).fold(2.0, |x: f64, _| 1.0 + rare + x.ln())
}

const MEASURES: Entry = Entry {
    id: "f54-measures",
    inventory: &["F54"],
    errata: &[],
    title: &Text::fixed("Even, or apart?", "Равномерно или врозь?"),
    caption: &Text::fixed(
        "Two virtues that are not one: star discrepancy says how evenly points fill boxes (left is better), the least distance \
         how far they keep from each other (up is better; 1 is the hexagonal lattice, the most there is). Nets and sequences \
         are even, Poisson disks are apart; random points are neither.",
        "Два разных достоинства: звёздное расхождение говорит, насколько равномерно точки заполняют ящики (левее — лучше), \
         наименьшее расстояние — насколько они держатся врозь (выше — лучше; 1 — шестиугольная решётка, больше не бывает). \
         Сети и последовательности равномерны, диски Пуассона держатся врозь, у случайных точек нет ни того, ни другого.",
    ),
    params: &[Param::choice("N", &COUNT, &["256", "64", "1024"]), Param::count("seed", &SEED, 1, 1, SEEDS)],
    build: |params| measures(params),
};

/// All that are compared.
static MEASURED: [(&str, Text); 12] = [
    ("random", Text::fixed("random", "случайные")),
    ("regular", Text::fixed("regular", "сетка")),
    ("jittered", Text::fixed("jitter", "джиттер")),
    ("n-rooks", Text::fixed("N rooks", "N ладей")),
    ("multi-jittered", Text::fixed("multi-jitter", "мультиджиттер")),
    ("halton", Text::fixed("Halton", "Холтон")),
    ("hammersley", Text::fixed("Hammersley", "Хаммерсли")),
    ("zero-two", Text::fixed("(0,2)", "(0,2)")),
    ("sobol-owen", Text::fixed("Sobol', Owen", "Соболь, Оуэн")),
    ("best-candidate", Text::fixed("best candidate", "лучший кандидат")),
    ("poisson-disk", Text::fixed("Poisson disk", "диски Пуассона")),
    ("blue-noise", Text::fixed("blue noise", "синий шум")),
];

fn measures(params: &Params) -> Result<Figure> {
    let seed = params.count("seed") as u64;
    // fewer points deviate more
    let (n, trials): (usize, u32) = match params.choice("N") {
        "64" => (64, 60),
        "1024" => (1024, 12),
        _ => (256, 30),
    };
    let side = (n as f64).sqrt() as usize;
    let (mut places, mut errors, mut apart_errors, mut farthest) = (Vec::new(), Vec::new(), Vec::new(), 0.0f64);
    for (name, _) in &MEASURED {
        let pattern = by_name(name, n)?;
        let sets: Vec<_> = (0..trials).map(|trial| pattern.points(pattern_seed(seed, trial))).collect();
        let even = sets.iter().map(|p| star_discrepancy(p)).collect::<Result<Vec<_>>>()?;
        let apart =
            sets.iter().map(|p| Ok(min_distance_torus(p)? / most_distance(p.len()))).collect::<Result<Vec<_>>>()?;
        farthest = apart.iter().copied().fold(farthest, f64::max);
        let ([d, d_error], [r, r_error]) = (mean(&even), mean(&apart));
        apart_errors.push(r_error);
        places.push([d, r]);
        errors.push(d_error);
    }
    let index = |name| MEASURED.iter().position(|(known, _)| *known == name).unwrap_or_default();
    let discrepancy = |name| places[index(name)][0];
    let least = places.iter().map(|p| p[0]).fold(f64::INFINITY, f64::min);
    let most = places.iter().map(|p| p[0]).fold(0.0, f64::max);
    let panel = Panel::new(
        "plane",
        text!("{n} points, means of {trials}", "{n} точек, среднее из {trials}"),
        Scale::log(text!("star discrepancy D*", "звёздное расхождение D*"), 0.75 * least, 1.35 * most),
        Scale::linear(
            text!("least distance, of the greatest possible", "наименьшее расстояние, от возможного"),
            -0.06,
            1.12,
        ),
    )
    .legend(Legend::LowerRight);
    let names: Vec<Text> = MEASURED.iter().map(|entry| entry.1.clone()).collect();
    let filled = panel
        .clone()
        .with(Layer::horizontals("hexagonal", Meaning::Guide, [1.0]).dashed())
        .with(Layer::dots("patterns", Meaning::Samples, places.iter().copied()))
        .with(labels("names", &panel, 60.0, &places, &names));
    let of = |name| Ok(by_name(name, n)?.points(pattern_seed(seed, 0)));
    let z = for_all_seeds(1);
    let [random, jitter, net, disks] = ["random", "jittered", "sobol-owen", "poisson-disk"].map(index);
    let even = (places[net][0] + z * errors[net]) / (places[disks][0] - z * errors[disks]);
    let apart = (places[net][1] + z * apart_errors[net]) / (places[disks][1] - z * apart_errors[disks]);
    Ok(Figure::new(1)
        .with(filled)
        .claim(
            text!(
                "D* of the grid is 1/n − 1/(4n²) = {}",
                "D* сетки 1/n − 1/(4n²) = {}",
                number(discrepancy("regular"), 4)
            ),
            grid_discrepancy(&of("regular")?, side)?,
        )
        .claim(
            text!(
                "D* of Hammersley's points is that of Halton and Zaremba, {}",
                "D* точек Хаммерсли — по формуле Холтона и Зарембы, {}",
                number(discrepancy("hammersley"), 3)
            ),
            hammersley_discrepancy(&of("hammersley")?)?,
        )
        .claim(
            text!(
                "jitter is more even than random points: {} against {}",
                "джиттер равномернее случайных точек: {} против {}",
                number(places[jitter][0], 2),
                number(places[random][0], 2)
            ),
            Residual::at_most(
                "D* of jitter < D* of random points, with the statistical error",
                (places[jitter][0] + z * errors[jitter]) / (places[random][0] - z * errors[random]),
                1.0,
            ),
        )
        .claim(
            text!(
                "even or apart, not both: Owen's Sobol' points have D* = {}, disks {}; their distances are {} and {}",
                "либо равномерно, либо порознь: у точек Соболя с Оуэном D* = {}, у дисков {}; расстояния {} и {}",
                number(places[net][0], 2),
                number(places[disks][0], 2),
                number(places[net][1], 2),
                number(places[disks][1], 2)
            ),
            Residual::at_most(
                "the net more even, the disks farther apart, with the statistical error",
                even.max(apart),
                1.0,
            ),
        )
        .claim(
            text!(
                "none keeps its points farther apart than a hexagonal lattice: at most {} of it",
                "ни один не держит точки дальше, чем шестиугольная решётка: не более {} от неё",
                number(farthest, 3)
            ),
            packing(farthest * most_distance(n), n),
        ))
}
