//! Samples in a pixel, their weights, and the pixel (slide «Однородный супер-сэмплинг», the sum Σ w_s·Sample_s).

use crate::antialias::supersample::{Tap, weighted};
use crate::error::Result;
use crate::field::Field;
use crate::field::flat::Flat;
use crate::field::star::SiemensStar;
use crate::figure::common::unmarked;
use crate::figure::params::{Param, Params};
use crate::figure::picture::{frame, picture};
use crate::figure::{Entry, Figure, Layer, Meaning, Panel, Tones};
use crate::grid::Grid;
use crate::image::Image;
use crate::kernel::catalog::by_name;
use crate::residual::Residual;
use crate::text;
use crate::text::{Text, number};
use ndarray::Array2;

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[PIXEL];

static COUNT: Text = Text::fixed("samples per pixel, n × n", "отсчётов на пиксель, n × n");
static WEIGHTS: Text = Text::fixed("the kernel that the weights are taken from", "ядро, из которого берутся веса");
static SUM: Text = Text::fixed("what the weights add up to on the right", "сумма весов справа");

const PIXEL: Entry = Entry {
    id: "f33-pixel",
    inventory: &["F33", "F34"],
    errata: &[],
    title: &Text::fixed("A grid of samples makes one pixel", "Из сетки отсчётов — один пиксель"),
    caption: &Text::fixed(
        "Pixel = Σ w_{s}·Sample_{s}: the samples of one pixel (framed on the right), their weights, and the picture. The slide does not say that the weights must add up to one: where they do not, every constant changes \
         its brightness, and with it the picture.",
        "Пиксель = Σ w_{s}·Отсчёт_{s}: отсчёты одного пикселя (справа он в рамке), их веса и картинка. На слайде не \
         сказано, что сумма весов должна быть равна единице: иначе меняется яркость любой константы, а с ней и всей картинки.",
    ),
    params: &[
        Param::count("n", &COUNT, 4, 2, 8),
        Param::choice("w", &WEIGHTS, &["tent", "box", "gaussian"]),
        Param::real("sum", &SUM, 0.5, 0.25, 1.5, ""),
    ],
    build: |params| pixel(params),
};

/// Pixels across and down.
const SIZE: [usize; 2] = [72, 36];
/// The pixel that is looked into.
const CHOSEN: [usize; 2] = [44, 6];
/// How far around it is shown, in pixels.
const MARGIN: f64 = 0.25;

fn pixel(params: &Params) -> Result<Figure> {
    let (n, kernel, sum) = (params.count("n"), by_name(params.choice("w"))?, params.real("sum"));
    let scene = SiemensStar::new(SIZE.map(|n| 0.5 * n as f64), 12)?;
    let grid = Grid::pixels(SIZE[0], SIZE[1])?;
    let place = |k: usize| (k as f64 + 0.5) / n as f64;
    // the whole kernel within the pixel
    let along: Vec<f64> = (0..n).map(|k| kernel.at(2.0 * kernel.radius() * (place(k) - 0.5))).collect();
    let total: f64 = along.iter().sum();
    let weight = |i: usize, j: usize| along[i] * along[j] / (total * total);
    let taps: Vec<Tap> =
        (0..n * n).map(|k| Tap { at: [place(k % n), place(k / n)], weight: weight(k % n, k / n) }).collect();
    let image = weighted(&scene, grid, &taps)?;
    let changed = image.map(|v| sum * v);

    let [[x0, x1], [y0, y1]] = grid.cell(CHOSEN[0] as i64, CHOSEN[1] as i64);
    let (x, y) = ((x0 - MARGIN, x1 + MARGIN), (y0 - MARGIN, y1 + MARGIN));
    const FINE: usize = 162;
    let seen = Image::of(&scene, Grid::cells(x.0..x.1, FINE, y.0..y.1, FINE)?);
    let places: Vec<[f64; 2]> = taps.iter().map(|t| [x0 + t.at[0], y0 + t.at[1]]).collect();
    let outline = || frame("pixel", Meaning::Error, [x0, x1], [y0, y1]);
    let samples = picture("samples", text!("samples", "отсчёты"), &seen).with(outline()).with(Layer::dots(
        "samples",
        Meaning::Samples,
        places.iter().copied(),
    ));
    let cells = Array2::from_shape_fn((n, n), |(j, i)| weight(i, j));
    let most = cells.iter().copied().fold(0.0, f64::max);
    let side = (0.0, n as f64);
    let mut weights =
        Panel::new("weights", text!("weights w_{{s}}", "веса w_{{s}}"), unmarked(0.0, side.1), unmarked(side.1, 0.0))
            .square()
            // light tones, so that numbers can be read on them
            .with(Layer::raster("weights", side, side, cells.clone(), (-1.2 * most, 1.2 * most), Tones::Grey));
    if n <= 4 {
        let says = |((j, i), w): ((usize, usize), &f64)| {
            ([i as f64 + 0.5, j as f64 + 0.5], text!("{}", "{}", format!("{w:.3}")))
        };
        weights = weights.with(Layer::notes("values", Meaning::Kernel, cells.indexed_iter().map(says)));
    }

    // a sum of n² products, each rounded
    let rounding = 4.0 * f64::EPSILON * (n * n) as f64;
    let own: f64 = places.iter().zip(&taps).map(|([x, y], tap)| tap.weight * scene.at(*x, *y)).sum();
    let constant = weighted(&Flat::new(0.7)?, Grid::pixels(1, 1)?, &taps)?.at(0, 0);
    let dimmed: Vec<Tap> = taps.iter().map(|t| Tap { weight: sum * t.weight, ..*t }).collect();
    let refused = weighted(&scene, grid, &dimmed).is_err() == ((sum - 1.0).abs() > rounding);
    Ok(Figure::new(3)
        .with(samples)
        .with(picture("one", text!("Σw = 1", "Σw = 1"), &image).with(outline()).span(2))
        .with(weights)
        .with(picture("other", text!("Σw = {}", "Σw = {}", number(sum, 3)), &changed).span(2))
        .claim(
            text!(
                "the framed pixel is Σ w·sample = {} of the {} samples on the left",
                "пиксель в рамке равен Σ w·отсчёт = {} по отсчётам слева (их {})",
                number(own, 3),
                n * n
            ),
            Residual::near("pixel = Σ w·sample", image.at(CHOSEN[0], CHOSEN[1]), own, rounding),
        )
        .claim(
            text!("Σw = 1: a constant 0.7 stays 0.7", "Σw = 1: константа 0.7 остаётся 0.7"),
            Residual::near("a constant by weights that add up to one", constant, 0.7, rounding),
        )
        .claim(
            text!(
                "Σw = {0}: every brightness is multiplied by {0}",
                "Σw = {0}: любая яркость умножается на {0}",
                number(sum, 3)
            ),
            Residual::near("mean of the picture", changed.mean() / image.mean(), sum, rounding * grid.len() as f64),
        )
        .claim(
            text!(
                "weights that do not add up to one are refused by the library",
                "веса, сумма которых не равна единице, библиотека отвергает"
            ),
            Residual::at_most("accepted although Σw ≠ 1", f64::from(u8::from(!refused)), 0.0),
        ))
}
