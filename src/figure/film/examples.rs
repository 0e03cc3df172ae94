//! What filters do to a picture: the same samples, weighed differently (slide «Примеры работы фильтров»).

use crate::antialias::supersample::supersample;
use crate::error::Result;
use crate::field::half_plane::HalfPlane;
use crate::figure::common::{frequency, values};
use crate::figure::film::trial::{Found, RANGE, developed, one_set};
use crate::figure::params::{Param, Params};
use crate::figure::picture::{frame, part, picture};
use crate::figure::{Entry, Figure, Layer, Legend, Meaning, Panel};
use crate::grid::Grid;
use crate::image::Image;
use crate::kernel::Kernel;
use crate::kernel::catalog::by_name;
use crate::kernel::metrics::Metrics;
use crate::laws::metrics::{TABLE, agrees};
use crate::num::quadrature::{even_breaks, integrate_pieces};
use crate::pattern::regular::Regular;
use crate::residual::Residual;
use crate::text;
use crate::text::{Lang, Text, number};
use std::ops::Range;

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[FILTERS, CROPS];

static COUNT: Text = Text::fixed("jittered samples per pixel, n × n", "отсчётов с джиттером на пиксель, n × n");
static SEED: Text = Text::fixed("seed of the random numbers", "начальное число генератора");

const PARAMS: &[Param] = &[Param::count("n", &COUNT, 2, 1, 4), Param::count("seed", &SEED, 1, 1, 100)];

const FILTERS: Entry = Entry {
    id: "f58-filters",
    inventory: &["F58"],
    errata: &[],
    title: &Text::fixed("Three filters on the same samples", "Три фильтра на одних и тех же отсчётах"),
    caption: &Text::fixed(
        "The same four jittered samples a pixel, weighed by the box, by the Gaussian and by Mitchell's filter. The box is \
         crisp and rough: its images are strongest (P). The Gaussian is the smoothest and blurs edges most. Mitchell's is \
         sharper again, for a faint halo beside edges.",
        "Одни и те же четыре отсчёта с джиттером на пиксель с весами box, Гаусса и Митчелла. Box резок и груб: он сильнее \
         всех пропускает копии спектра (P). Гауссиан самый гладкий, но и края размывает сильнее всех. Фильтр Митчелла \
         резче него, ценой слабого ореола у края.",
    ),
    params: PARAMS,
    build: |params| filters(params),
};

const CROPS: Entry = Entry {
    id: "x-filter-crops",
    inventory: &["F58"],
    errata: &[],
    title: &Text::fixed("Eight filters, one detail", "Восемь фильтров, одна деталь"),
    caption: &Text::fixed(
        "The same samples through eight filters: bricks, rings beyond Nyquist and letters. From upper left to lower right \
         from rough over blurred to sharp with halos. Filters without negative weights never leave the range of the \
         samples; the others do, and what is darker than black is cut off.",
        "Одни и те же отсчёты через восемь фильтров: кирпичи, кольца за Найквистом и буквы. Слева сверху направо вниз: от \
         грубых через размытые к резким с ореолом. Фильтры без отрицательных весов не выходят за пределы значений \
         отсчётов, остальные выходят, и то, что чернее чёрного, обрезается.",
    ),
    params: PARAMS,
    build: |params| crops(params),
};

/// The part of three pictures that is shown enlarged, and that of eight: columns and rows.
const DETAIL: [Range<usize>; 2] = [34..82, 30..70];
const SQUARE: [Range<usize>; 2] = [34..76, 29..71];

/// A part of a picture enlarged.
fn detail(name: &'static str, title: Text, image: &Image, [columns, rows]: [Range<usize>; 2]) -> Result<Panel> {
    Ok(picture(name, title, &part(image, columns, rows)?))
}

/// An edge at zero behind the filter: `∫_{−∞}^x k/∫k`.
fn edge(kernel: &dyn Kernel, x: f64) -> f64 {
    let radius = kernel.radius();
    let end = x.clamp(-radius, radius);
    let mut breaks = even_breaks(-radius, radius, 0.5);
    breaks.retain(|b| *b < end);
    breaks.push(end);
    if breaks.len() < 2 {
        return 0.0;
    }
    integrate_pieces(|t| kernel.at(t), &breaks, 1e-14).value / kernel.response(0.0)
}

/// From where an edge behind the filter is one tenth up for the last time, to nine tenths for the first: by symmetry twice
/// the way from the middle. By bisection, the edge rising from the middle on.
fn width(kernel: &dyn Kernel) -> f64 {
    let (mut low, mut high) = (0.0, kernel.radius());
    // where the filter turns negative the edge has its maximum, beyond nine tenths
    let rising = |x: f64| edge(kernel, x) < 0.9;
    for _ in 0..50 {
        let middle = 0.5 * (low + high);
        if rising(middle) { low = middle } else { high = middle }
    }
    low + high
}

/// How far an edge behind the filter goes beyond its ends, drawn in steps of 1/64.
fn halo(kernel: &dyn Kernel) -> f64 {
    let places = (0..=(64.0 * kernel.radius()) as u32).map(|k| f64::from(k) / 64.0);
    places.map(|x| edge(kernel, x) - 1.0).fold(0.0, f64::max)
}

fn filters(params: &Params) -> Result<Figure> {
    let samples = one_set(params.count("n"), params.count("seed") as u64)?;
    let names = ["box", "gaussian-pbrt2", "mitchell"];
    let shown = [text!("box", "box"), text!("Gaussian", "гауссиан"), text!("Mitchell", "Митчелл")];
    let kernels = names.map(by_name).into_iter().collect::<Result<Vec<_>>>()?;
    let images = kernels.iter().map(|k| developed(&**k, &samples)).collect::<Result<Vec<_>>>()?;
    let metrics: Vec<Metrics> = kernels.iter().map(|k| Metrics::of(&**k)).collect();

    // an edge through the middle of a pixel's row, at a few places in it: regular samples as fine as a step is drawn
    const FINE: usize = 32;
    const PLACES: usize = 2;
    let measured = |kernel: &dyn Kernel| -> Result<Vec<[f64; 2]>> {
        let mut found = Vec::new();
        for place in 0..PLACES {
            let at = 8.0 + place as f64 / PLACES as f64;
            let scene = HalfPlane::new([-1.0, 0.0], -at)?;
            let row = supersample(&scene, Grid::pixels(16, 1)?, &Regular::new([FINE, 1])?, kernel, 0)?;
            found.extend((0..16).map(|i| [i as f64 + 0.5 - at, row.at(i, 0)]).filter(|p| p[0].abs() <= 1.75));
        }
        Ok(found)
    };
    let edges = kernels.iter().map(|k| measured(&**k)).collect::<Result<Vec<_>>>()?;
    let widths: Vec<f64> = kernels.iter().map(|k| width(&**k)).collect();
    let mut profile = Panel::new("edge", text!("an edge", "край"), values("x", -1.8, 1.8), values("", -0.1, 1.1))
        .legend(Legend::LowerRight);
    let mut response =
        Panel::new("response", text!("what passes", "что проходит"), frequency(0.0, 2.0), values("|K|", 0.0, 1.05))
            .with(Layer::verticals("nyquist", Meaning::Guide, [0.5]).dashed());
    let names = ["box", "gaussian", "mitchell"];
    for (i, (kernel, name)) in kernels.iter().zip(names).enumerate() {
        let meaning = Meaning::Series(i as u8);
        let curve = Layer::curve(name, meaning, -1.8, 1.8, 144, |x| edge(&**kernel, x)).thick();
        profile = profile.with(curve.label(shown[i].clone()));
        let gain = kernel.response(0.0);
        let curve = Layer::curve(name, meaning, 0.0, 2.0, 300, |nu| (kernel.response(nu) / gain).abs()).thick();
        response = response.with(curve);
    }
    for ((points, name), i) in edges.iter().zip(["box-edge", "gaussian-edge", "mitchell-edge"]).zip(0..) {
        profile = profile.with(Layer::dots(name, Meaning::Series(i), points.iter().copied()));
    }

    let [x, y] = DETAIL.map(|range| [range.start as f64, range.end as f64]);
    let mut figure = Figure::new(3).heights([1.32, 1.0]);
    for (i, (image, name)) in images.iter().zip(names).enumerate() {
        let [en, ru] = Lang::ALL.map(|lang| shown[i].get(lang).to_owned());
        let p = number(metrics[i].postaliasing, 3);
        figure = figure.with(detail(name, text!("{en}: P = {}", "{ru}: P = {}", p), image, DETAIL)?);
    }
    let figure = figure
        .with(picture("whole", text!("all of it, box", "целиком, box"), &images[0]).with(frame(
            "detail",
            Meaning::Error,
            x,
            y,
        )))
        .with(profile)
        .with(response);
    let [of_box, of_gaussian, of_mitchell] = [0, 1, 2].map(|i| Found::of(&images[i]));

    let rows = kernels.iter().zip(["box", "gaussian-pbrt2", "mitchell"]);
    let rows =
        rows.flat_map(|(kernel, name)| TABLE.iter().filter(move |r| r.name == name).flat_map(|r| agrees(&**kernel, r)));
    let worst = rows.map(|r| r.measured / r.bound).fold(0.0, f64::max);
    // the samples of an edge stand 1/32 apart: an edge between two of them is misplaced by half of that at most, where
    // the filter is k(0) ≤ 1.13 high
    let off = kernels
        .iter()
        .zip(&edges)
        .flat_map(|(kernel, points)| points.iter().map(|p| (p[1] - edge(&**kernel, p[0])).abs()).collect::<Vec<_>>());
    let off = off.fold(0.0, f64::max);
    let steepest = kernels.iter().map(|k| k.at(0.0)).fold(0.0, f64::max);
    Ok(figure
        .claim(
            text!(
                "images let through: P = {} (box), {} (Gaussian), {} (Mitchell)",
                "копии спектра: P = {} (box), {} (гауссиан), {} (Митчелл)",
                number(metrics[0].postaliasing, 4),
                number(metrics[1].postaliasing, 3),
                number(metrics[2].postaliasing, 3)
            ),
            Residual::at_most("the metrics, in half units of the table's last digit", worst, 1.0),
        )
        .claim(
            text!(
                "in the pictures the post's side is as blurred as a ramp of {} (box), {} (Mitchell), {} pixels (Gaussian)",
                "на картинках край столба размыт, как скат шириной {} (box), {} (Митчелл), {} пикселя (гауссиан)",
                number(of_box.ramp, 2),
                number(of_mitchell.ramp, 2),
                number(of_gaussian.ramp, 3)
            ),
            Residual::at_least(
                "ramp of the Gaussian / the wider of the others",
                of_gaussian.ramp / of_mitchell.ramp.max(of_box.ramp),
                1.0,
            ),
        )
        .claim(
            text!(
                "beyond Nyquist they keep {} (box), {} (Mitchell), {} (Gaussian) of the rings' power: all of it false",
                "за Найквистом от мощности колец остаётся {} (box), {} (Митчелл), {} (гауссиан) — и вся она ложная",
                number(of_box.alias, 2),
                number(of_mitchell.alias, 2),
                number(of_gaussian.alias, 2)
            ),
            Residual::at_least(
                "false power: the lesser of box/Mitchell and Mitchell/Gaussian",
                (of_box.alias / of_mitchell.alias).min(of_mitchell.alias / of_gaussian.alias),
                1.0,
            ),
        )
        .claim(
            text!(
                "beside the post Mitchell's plate is brighter than white by {} % of the step; box and Gaussian do not overshoot",
                "рядом со столбом табличка у Митчелла светлее белого на {} % перепада; box и гауссиан выброса не дают",
                number(100.0 * of_mitchell.halo, 1)
            ),
            Residual::at_least(
                "Mitchell's halo over what box and Gaussian have",
                of_mitchell.halo,
                // means of samples that are nowhere brighter than the plate, each to rounding
                of_box.halo.max(of_gaussian.halo).max(64.0 * f64::EPSILON),
            ),
        )
        .claim(
            text!(
                "an edge rises from 10 to 90 % within {} (box), {} (Gaussian), {} pixels (Mitchell)",
                "край поднимается от 10 до 90 % за {} (box), {} (гауссиан), {} пикселя (Митчелл)",
                number(widths[0], 3),
                number(widths[1], 3),
                number(widths[2], 3)
            ),
            Residual::at_least("width of an edge, Gaussian − Mitchell", widths[1] - widths[2], 0.0),
        )
        .claim(
            text!(
                "pixels across an edge lie on the integral of the filter",
                "пиксели поперёк края лежат на интеграле фильтра"
            ),
            Residual::at_most("pixels of an edge = ∫k", off, 0.5 * steepest / FINE as f64),
        )
        .claim(
            text!(
                "Mitchell overshoots by {} % of an edge with many samples, and by {} % with one sample a pixel",
                "выброс у Митчелла — {} % края при многих отсчётах и {} % при одном отсчёте на пиксель",
                number(100.0 * halo(&*kernels[2]), 3),
                number(100.0 * metrics[2].overshoot, 3)
            ),
            // with one sample it is the depth of the negative lobe, with many its area: one lobe is less than a pixel wide
            Residual::at_most("overshoot with many samples / with one", halo(&*kernels[2]) / metrics[2].overshoot, 1.0),
        ))
}

fn crops(params: &Params) -> Result<Figure> {
    let samples = one_set(params.count("n"), params.count("seed") as u64)?;
    const FILTERS: [(&str, Text); 8] = [
        ("box", Text::same("box")),
        ("tent", Text::fixed("tent", "tent")),
        ("gaussian-pbrt2", Text::fixed("Gaussian", "гауссиан")),
        ("b-spline", Text::fixed("B-spline", "B-сплайн")),
        ("mitchell", Text::fixed("Mitchell", "Митчелл")),
        ("sinc-pbrt2", Text::fixed("pbrt-2's sinc", "sinc из pbrt-2")),
        ("catmull-rom", Text::fixed("Catmull–Rom", "Катмулл–Ром")),
        ("lanczos-3", Text::fixed("Lanczos-3", "Ланцош-3")),
    ];
    let mut figure = Figure::new(4);
    let (mut calm, mut wild) = (0.0f64, f64::INFINITY);
    let mut blur = Vec::new();
    for (name, title) in FILTERS {
        let kernel = by_name(name)?;
        let image = developed(&*kernel, &samples)?;
        figure = figure.with(detail(name, title, &image, SQUARE)?);
        let beyond = image.values().iter().map(|v| (v - RANGE[1]).max(RANGE[0] - v)).fold(f64::NEG_INFINITY, f64::max);
        if kernel.claims().nonnegative {
            calm = calm.max(beyond);
        } else {
            wild = wild.min(beyond);
        }
        blur.push((name, Metrics::of(&*kernel)));
    }
    let of = |name: &str| blur.iter().find(|(n, _)| *n == name).map_or(f64::NAN, |(_, m)| m.smoothing);
    let worst = blur.iter().filter_map(|(name, _)| {
        let row = TABLE.iter().find(|row| row.name == *name)?;
        let kernel = by_name(name).ok()?;
        agrees(&*kernel, row).into_iter().map(|r| r.measured / r.bound).reduce(f64::max)
    });
    Ok(figure
        .claim(
            text!(
                "without negative weights no pixel leaves the range of the scene",
                "без отрицательных весов ни один пиксель не выходит за пределы яркостей сцены"
            ),
            // a weighted mean of values below one, to rounding
            Residual::at_most("beyond the range, nonnegative filters", calm, 64.0 * f64::EPSILON),
        )
        .claim(
            text!(
                "with negative weights every filter leaves it, by {} and more",
                "с отрицательными весами за них выходит каждый, на {} и больше",
                number(wild, 1)
            ),
            Residual::at_least("beyond the range, filters with negative weights", wild, 0.0),
        )
        .claim(
            text!(
                "blur S: {} (B-spline), {} (Mitchell), {} (Catmull–Rom), {} (Lanczos-3)",
                "размытие S: {} (B-сплайн), {} (Митчелл), {} (Катмулл–Ром), {} (Ланцош-3)",
                number(of("b-spline"), 4),
                number(of("mitchell"), 4),
                number(of("catmull-rom"), 4),
                number(of("lanczos-3"), 4)
            ),
            Residual::at_most("the metrics, in half units of the table's last digit", worst.fold(0.0, f64::max), 1.0),
        ))
}
