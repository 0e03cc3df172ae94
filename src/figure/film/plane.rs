//! The three stages in the plane, and the one filter that does the same (slide «Реконструкция изображения. Этапы»).

use crate::axis::Axis;
use crate::error::Result;
use crate::field::from_fn;
use crate::figure::common::unmarked;
use crate::figure::params::{Param, Params};
use crate::figure::{Entry, Figure, Layer, Panel, Tones};
use crate::grid::Grid;
use crate::image::Image;
use crate::kernel::Kernel;
use crate::kernel::catalog::by_name;
use crate::num::cos_pi;
use crate::num::quadrature::even_breaks;
use crate::residual::Residual;
use crate::signal::theorem::Convolution;
use crate::signal::{Signal, from_fn as signal_from_fn};
use crate::text;
use crate::text::Text;
use ndarray::Array2;

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[PLANE];

static PER_PIXEL: Text = Text::fixed("samples per pixel, n × n", "отсчётов на пиксель, n × n");
static FIRST: Text = Text::fixed("the filter r that reconstructs", "фильтр реконструкции r");
static SECOND: Text = Text::fixed("the filter p of the pixel", "фильтр пикселя p");

const PLANE: Entry = Entry {
    id: "f55-plane",
    inventory: &["F55"],
    errata: &[],
    title: &Text::fixed("From samples to pixels in the plane", "От отсчётов к пикселям на плоскости"),
    caption: &Text::fixed(
        "Samples, the picture reconstructed from them, the picture after the pixel's filter, and its values at the centres. \
         Renderers leave out both pictures in the middle: one filter, r ⊗ p along each axis, makes the same pixels from the \
         samples.",
        "Отсчёты, построенное по ним изображение, оно же после фильтра пикселя и его значения в центрах. Рендереры обходятся \
         без двух изображений в середине: один фильтр, r ⊗ p по каждой оси, даёт из отсчётов те же пиксели.",
    ),
    params: &[
        Param::count("n", &PER_PIXEL, 2, 1, 4),
        Param::choice("r", &FIRST, &["tent", "box", "catmull-rom"]),
        Param::choice("p", &SECOND, &["mitchell", "box", "tent"]),
    ],
    build: |params| plane(params),
};

const PIXELS: usize = 12;
/// Samples go on for so many pixels beyond the frame: as far as both filters reach.
const MARGIN: f64 = 4.0;
/// How many points a pixel is drawn with.
const FINE: usize = 10;

/// A tilted edge, and rings beside it.
fn scene(x: f64, y: f64) -> f64 {
    let [u, v] = [x - 8.2, y - 7.1];
    if x + 0.37 * y < 5.3 { 0.9 } else { 0.45 + 0.4 * cos_pi(0.11 * (u * u + v * v)) }
}

/// `Σ_ij across[·][i]·down[·][j]·s_ij`: a separable sum over the samples, at the crossings of rows and columns.
fn spread(samples: &Image, weights: &Array2<f64>) -> Array2<f64> {
    weights.dot(samples.pixels()).dot(&weights.t())
}

/// The nodes and weights of Gauss's rule with four points in every piece of length `piece`: exact for the products of two
/// cubics, of degree six.
fn nodes(low: f64, high: f64, piece: f64) -> Vec<[f64; 2]> {
    const RULE: [[f64; 2]; 2] =
        [[0.339_981_043_584_856_26, 0.652_145_154_862_546_1], [0.861_136_311_594_052_6, 0.347_854_845_137_453_9]];
    let ends = even_breaks(low, high, piece);
    let of = |ends: &[f64]| {
        let (middle, half) = (0.5 * (ends[0] + ends[1]), 0.5 * (ends[1] - ends[0]));
        RULE.into_iter().flat_map(move |[t, w]| [[middle - half * t, half * w], [middle + half * t, half * w]])
    };
    ends.windows(2).flat_map(of).collect()
}

fn plane(params: &Params) -> Result<Figure> {
    let n = params.count("n");
    let (r, p) = (by_name(params.choice("r"))?, by_name(params.choice("p"))?);
    let (length, step) = (PIXELS as f64, 1.0 / n as f64);
    let along = Axis::cells(-MARGIN..length + MARGIN, (PIXELS + 2 * MARGIN as usize) * n)?;
    let samples = Image::of(&from_fn(scene), Grid::new(along, along)?);
    let table = |places: &[f64], value: &dyn Fn(f64, f64) -> f64| {
        Array2::from_shape_fn((places.len(), along.len()), |(q, i)| value(places[q], along.at(i as i64)))
    };
    let first = |x: f64, at: f64| r.at((x - at) / step);

    // stage by stage: the reconstructed picture at the nodes of a quadrature, each kink of both filters between two of them
    let reach = p.radius();
    let rule = nodes(-reach, length + reach, 0.5 * step);
    let places: Vec<f64> = rule.iter().map(|q| q[0]).collect();
    let rebuilt = spread(&samples, &table(&places, &first));
    let centres: Vec<f64> = Axis::cells(0.0..length, PIXELS)?.iter().collect();
    let second = Array2::from_shape_fn((PIXELS, rule.len()), |(k, q)| rule[q][1] * p.at(centres[k] - rule[q][0]));
    let staged = second.dot(&rebuilt).dot(&second.t());

    // at once
    let breaks = |kernel: &dyn Kernel, step: f64| {
        let radius = kernel.radius() * step;
        even_breaks(-radius, radius, 0.5 * step)
    };
    let narrow = signal_from_fn(|x| r.at(x / step) / step);
    let both = Convolution::new(&*p, &breaks(&*p, 1.0), &narrow, &breaks(&*r, step))?;
    let once = |x: f64, at: f64| step * both.at(x - at);
    let pixels = spread(&samples, &table(&centres, &once));

    let fine: Vec<f64> = Axis::cells(0.0..length, PIXELS * FINE)?.iter().collect();
    let shown: Vec<f64> = along.iter().filter(|x| (0.0..length).contains(x)).collect();
    let seen = Image::of(
        &from_fn(scene),
        Grid::new(Axis::cells(0.0..length, shown.len())?, Axis::cells(0.0..length, shown.len())?)?,
    );
    let view = |name, title, values: Array2<f64>| {
        let side = (0.0, length);
        Panel::new(name, title, unmarked(0.0, length), unmarked(length, 0.0)).square().with(Layer::raster(
            "values",
            side,
            side,
            values,
            (0.0, 1.0),
            Tones::Grey,
        ))
    };
    let apart = |a: &Array2<f64>, b: &Array2<f64>| a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    let ones = Image::new(samples.grid(), vec![1.0; samples.grid().len()])?;
    let defect = spread(&ones, &table(&centres, &once)).iter().map(|v| (v - 1.0).abs()).fold(0.0, f64::max);
    // the rounding of sums over all nodes of both axes, of which the amounts of the weights add up to less than two; the
    // convolution is a quadrature to 1e-14
    let rounding = 4.0 * (f64::EPSILON * (rule.len() + along.len()) as f64 + 1e-14);
    Ok(Figure::new(4)
        .with(view("samples", text!("samples", "отсчёты"), seen.pixels().clone()))
        .with(view("first", text!("1. reconstructed", "1. построено"), spread(&samples, &table(&fine, &first))))
        .with(view("second", text!("2. low-passed", "2. сглажено"), spread(&samples, &table(&fine, &once))))
        .with(view("third", text!("3. pixels", "3. пиксели"), staged.clone()))
        .claim(
            text!(
                "one filter gives the same {0} × {0} pixels as all three stages",
                "один фильтр даёт те же {0} × {0} пикселей, что и три этапа",
                PIXELS
            ),
            Residual::at_most("(S ⊗ r) ⊗ p = S ⊗ (r ⊗ p) in the plane", apart(&staged, &pixels), rounding),
        )
        .claim(
            text!("its weights add up to 1 in every pixel", "сумма его весов в каждом пикселе равна 1"),
            Residual::at_most("sum of the weights of r ⊗ p", defect, rounding),
        ))
}
