//! The value of a pixel from the samples around it (slide «Получение значения пикселя по набору сэмплов»).

use crate::antialias::supersample::pixel_seed;
use crate::error::Result;
use crate::figure::common::unmarked;
use crate::figure::params::{Param, Params};
use crate::figure::picture::{frame, tones};
use crate::figure::{Bar, Entry, Figure, Layer, Legend, Meaning, Panel, Scale, Tones};
use crate::film::{Film, Sample};
use crate::grid::Grid;
use crate::image::Image;
use crate::kernel::Kernel;
use crate::kernel::catalog::by_name;
use crate::kernel::tent::TentKernel;
use crate::laws::film::{Moments, mean_pixel};
use crate::laws::jitter::deviations;
use crate::num::{cos_pi, sin_pi};
use crate::pattern::Pattern;
use crate::pattern::jittered::Jittered;
use crate::residual::Residual;
use crate::text;
use crate::text::{Text, number};
use std::ops::Range;

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[WEIGHTS];

pub(super) static KERNEL: Text = Text::fixed("the filter of the pixel", "фильтр пикселя");
pub(super) static SEED: Text = Text::fixed("seed of the random numbers", "начальное число генератора");
pub(super) const KERNELS: &[&str] = &["mitchell", "gaussian-pbrt2", "tent", "box", "lanczos-3"];

const WEIGHTS: Entry = Entry {
    id: "f56-weights",
    inventory: &["F56"],
    errata: &[],
    title: &Text::fixed("A pixel from the samples around it", "Пиксель по отсчётам вокруг него"),
    caption: &Text::fixed(
        "I = Σ f·L / Σ f: every sample within the filter's box counts by the filter's value where it stands (size of the \
         circles; diamonds: negative). Σ f differs from pixel to pixel, so that only the division keeps a constant. \
         Its price is a bias, for a quotient of random sums; it falls as 1/K with K samples.",
        "I = Σ f·L / Σ f: каждый отсчёт внутри рамки фильтра входит с весом, равным значению фильтра в его месте (размер \
         кружков; ромбы — отрицательный вес). Σ f от пикселя к пикселю разная, и константу сохраняет только деление. Его \
         цена — смещение, ведь это отношение случайных сумм; с числом отсчётов K оно убывает как 1/K.",
    ),
    params: &[Param::choice("kernel", &KERNEL, KERNELS), Param::count("seed", &SEED, 1, 1, 100)],
    build: |params| weights(params),
};

/// The samples of the pixels in those columns and rows, `n × n` jittered ones in each.
pub(super) fn samples(
    columns: Range<i64>,
    rows: Range<i64>,
    n: usize,
    seed: u64,
    light: impl Fn(f64, f64) -> f64,
) -> Result<Vec<Sample<1>>> {
    let pattern = Jittered::new([n, n])?;
    let pixels = rows.flat_map(|j| columns.clone().map(move |i| (i, j)));
    let of = |(i, j): (i64, i64)| {
        let points = pattern.points(pixel_seed(seed, i, j)).into_iter();
        points.map(move |[u, v]| [i as f64 + u, j as f64 + v])
    };
    Ok(pixels.flat_map(of).map(|at| Sample { at, light: [light(at[0], at[1])] }).collect())
}

/// Regular polygons around places, each of its own radius: circles, if they have many corners.
fn circles(corners: u32, of: impl IntoIterator<Item = ([f64; 2], f64)>) -> Vec<[f64; 2]> {
    let circle = |([x, y], r): ([f64; 2], f64)| {
        let around = (0..=corners).map(|k| 2.0 * f64::from(k) / f64::from(corners));
        around.map(|t| [x + r * cos_pi(t), y + r * sin_pi(t)]).chain([[f64::NAN; 2]]).collect::<Vec<_>>()
    };
    of.into_iter().flat_map(circle).collect()
}

/// The lines between pixels.
fn pixel_lines(panel: Panel, width: usize, height: usize) -> Panel {
    let lines = |n: usize| (1..n).map(|k| k as f64);
    panel
        .with(Layer::verticals("columns", Meaning::Guide, lines(width)).thin())
        .with(Layer::horizontals("rows", Meaning::Guide, lines(height)).thin())
}

/// How many samples a pixel's sum has at most, and how far the amounts of its weights can exceed their sum: for the
/// bounds of rounding.
pub(super) fn terms(kernel: &dyn Kernel, n: usize) -> f64 {
    let pixels = (2.0 * kernel.radius() + 1.0).ceil();
    // of Lanczos-3, the worst, Σ|f|/Σf is (1.36)² on the whole; times four for uneven samples
    8.0 * pixels * pixels * (n * n) as f64
}

fn weights(params: &Params) -> Result<Figure> {
    let (kernel, seed) = (by_name(params.choice("kernel"))?, params.count("seed") as u64);
    let radius = kernel.radius();
    const CONSTANT: f64 = 0.6;

    // one pixel and its samples
    let (width, height) = (9, 7);
    let film = Film::new(Grid::pixels(width, height)?, &*kernel)?;
    let middle = film.grid().at(4, 3);
    let light = |x: f64, y: f64| 0.5 + 0.4 * sin_pi(0.3 * x) * cos_pi(0.23 * y);
    let around = samples(0..width as i64, 0..height as i64, 2, seed, light)?;
    let weighed: Vec<([f64; 2], f64)> =
        around.iter().map(|s| (s.at, film.weight(s.at[0] - middle[0], s.at[1] - middle[1]))).collect();
    let most = weighed.iter().map(|(_, w)| w.abs()).fold(0.0, f64::max);
    let sized = |corners: u32, keep: &dyn Fn(f64) -> bool| {
        let kept = weighed.iter().filter(|(_, w)| keep(*w));
        circles(corners, kept.map(|(at, w)| (*at, 0.05 + 0.23 * (w.abs() / most).sqrt())).collect::<Vec<_>>())
    };
    let diagram = Panel::new(
        "diagram",
        text!("weights of the samples", "веса отсчётов"),
        unmarked(0.0, width as f64),
        unmarked(height as f64, 0.0),
    )
    .square();
    let [[x0, x1], [y0, y1]] = middle.map(|m| [m - radius, m + radius]);
    let diagram = pixel_lines(diagram, width, height)
        .with(Layer::line("outside", Meaning::Guide, sized(8, &|w| w == 0.0)).thin())
        .with(Layer::line("positive", Meaning::Samples, sized(16, &|w| w > 0.0)))
        .with(Layer::line("negative", Meaning::Leaked, sized(4, &|w| w < 0.0)))
        .with(frame("extent", Meaning::Kernel, [x0, x1], [y0, y1]).thick())
        .with(Layer::dots("pixel", Meaning::Signal, [middle]));

    let filter = {
        const CELLS: usize = 60;
        let reach = radius + 0.25;
        let grid = Grid::cells(-reach..reach, CELLS, -reach..reach, CELLS)?;
        let values: Vec<f64> = grid.iter().map(|[x, y]| film.weight(x, y)).collect();
        let (low, top) = values.iter().fold((0.0f64, 0.0f64), |(l, t), &v| (l.min(v), t.max(v)));
        let image = Image::new(grid, values)?;
        let title = text!("filter f(x, y)", "фильтр f(x, y)");
        tones("filter", title, &image, (low, top), Tones::Data).bar(Bar::values(Text::EMPTY))
    };

    // a constant, on a larger film
    const SIDE: usize = 32;
    let large = Film::new(Grid::pixels(SIDE, SIDE)?, &*kernel)?;
    let reach = large.reach() as i64;
    let all = -reach..SIDE as i64 + reach;
    let flat = large.develop(&samples(all.clone(), all, 2, seed, |_, _| CONSTANT)?)?;
    let relative = flat.weights().map(|w| w / 4.0);
    let uneven = relative.values().iter().fold(0.0, |most: f64, w| most.max((w - 1.0).abs()));
    let title = text!("Σf over its mean, pixel by pixel", "Σf, делённая на среднее, по пикселям");
    let sums = tones("sums", title, &relative, (0.5, 1.5), Tones::Data).bar(Bar::values(Text::EMPTY));

    // the bias of a quotient of sums
    const TRIALS: u32 = 8000;
    let square = |x: f64| x * x;
    let moments = Moments::of(&TentKernel, square);
    let counts = [4, 8, 16, 32];
    let found = counts.map(|k| Ok([k as f64, mean_pixel(&TentKernel, square, k, TRIALS, seed, true)? - moments.pixel]));
    let found = found.into_iter().collect::<Result<Vec<_>>>()?;
    let bias = Panel::new(
        "bias",
        text!("bias: tent, L = x^{{2}}", "смещение: треугольник, L = x^{{2}}"),
        Scale::log(text!("samples K", "отсчётов K"), 3.0, 43.0).ticks(counts.map(|k| (k as f64, text!("{k}", "{k}")))),
        Scale::log(Text::EMPTY, 1.2e-3, 5e-2),
    )
    .legend(Legend::Above)
    .with(Layer::line("theory", Meaning::Theory, [3.0, 43.0].map(|k| [k, moments.bias(1) / k])).label(text!(
        "{}/K",
        "{}/K",
        number(moments.bias(1), 4)
    )))
    .with(Layer::dots("found", Meaning::Error, found.iter().copied()).label(text!("measured", "измерено")));
    // the standard error of the mean; and the next term of the expansion, smaller by E[w²]/(K·E[w]²)
    let off = counts.iter().zip(&found).map(|(&k, f)| {
        let next = moments.bias(k) * moments.square / (k as f64 * moments.weight * moments.weight);
        let bound = deviations(100 * counts.len()) * moments.deviation(k) / f64::from(TRIALS).sqrt() + next;
        (f[1] - moments.bias(k)).abs() / bound
    });
    let off = off.fold(0.0, f64::max);

    let pixel = film.develop(&around)?.image().at(4, 3);
    let (numerator, denominator) =
        weighed.iter().zip(&around).fold((0.0, 0.0), |(n, d), ((_, w), s)| (n + w * s.light[0], d + w));
    let kept = flat.image().values().iter().map(|v| (v - CONSTANT).abs()).fold(0.0, f64::max);
    let rounding = 2.0 * f64::EPSILON * terms(&*kernel, 2);
    let counted = weighed.iter().filter(|(_, w)| *w != 0.0).count();
    Ok(Figure::new(2)
        .with(diagram)
        .with(filter)
        .with(sums)
        .with(bias)
        .claim(
            text!(
                "the pixel is the quotient of the drawn weights' sums, {}, over {counted} samples",
                "пиксель — отношение сумм с нарисованными весами, {}, по отсчётам числом {counted}",
                number(numerator / denominator, 3)
            ),
            Residual::near("I = Σ f·L / Σ f", pixel, numerator / denominator, rounding),
        )
        .claim(
            text!(
                "Σf differs from its mean by up to {} %; a constant {CONSTANT} is {CONSTANT} in every pixel all the same",
                "Σf отличается от среднего до {} %, но константа {CONSTANT} в каждом пикселе остаётся {CONSTANT}",
                number(100.0 * uneven, 2)
            ),
            Residual::at_most("a constant after the division", kept, rounding),
        )
        .claim(
            text!(
                "the bias of the quotient is {}/K: {} at K = 32",
                "смещение отношения — {}/K: {} при K = 32",
                number(moments.bias(1), 4),
                number((1e4 * found[3][1]).round() / 1e4, 2)
            ),
            Residual::at_most("bias of the quotient, in bounds", off, 1.0),
        ))
}
