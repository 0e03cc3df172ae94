//! The three stages in the plane, and the one filter that does the same (slide «Реконструкция изображения. Этапы»).

use crate::axis::Axis;
use crate::error::Result;
use crate::field::from_fn;
use crate::figure::params::{Param, Params};
use crate::figure::picture::picture;
use crate::figure::{Entry, Figure, Panel};
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

/// Pixels across and down.
const PIXELS: [usize; 2] = [24, 12];
/// Samples go on for so many pixels beyond the frame: as far as both filters reach.
const MARGIN: f64 = 4.0;
/// How many points a pixel is drawn with.
const FINE: usize = 7;

/// A tilted edge, and rings beside it.
fn scene(x: f64, y: f64) -> f64 {
    let [u, v] = [x - 14.2, y - 7.1];
    if x + 0.37 * y < 8.3 { 0.9 } else { 0.45 + 0.4 * cos_pi(0.11 * (u * u + v * v)) }
}

/// `Σ_ij down[·][j]·across[·][i]·s_ij`: a separable sum over values, at the crossings of rows and columns.
fn spread(values: &Array2<f64>, [across, down]: &[Array2<f64>; 2]) -> Array2<f64> {
    down.dot(values).dot(&across.t())
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
    let (lengths, step) = (PIXELS.map(|n| n as f64), 1.0 / n as f64);
    let along = |axis: usize| {
        let margin = 2 * MARGIN as usize;
        Axis::cells(-MARGIN..lengths[axis] + MARGIN, (PIXELS[axis] + margin) * n)
    };
    let axes = [along(0)?, along(1)?];
    let samples = Image::of(&from_fn(scene), Grid::new(axes[0], axes[1])?);
    // one filter's values at places, from every sample, along each axis
    let tables = |places: [&[f64]; 2], value: &dyn Fn(f64, f64) -> f64| {
        [0, 1].map(|axis| {
            let (places, along) = (places[axis], axes[axis]);
            Array2::from_shape_fn((places.len(), along.len()), |(q, i)| value(places[q], along.at(i as i64)))
        })
    };
    let first = |x: f64, at: f64| r.at((x - at) / step);

    // stage by stage: the reconstructed picture at the nodes of a quadrature, each kink of both filters between two of them
    let reach = p.radius();
    let rules = lengths.map(|length| nodes(-reach, length + reach, 0.5 * step));
    let places = rules.each_ref().map(|rule| rule.iter().map(|q| q[0]).collect::<Vec<f64>>());
    let rebuilt = spread(samples.pixels(), &tables([&places[0], &places[1]], &first));
    let [centres, fine] = [1, FINE].map(|parts| {
        [0, 1].map(|axis| (0..PIXELS[axis] * parts).map(|k| (k as f64 + 0.5) / parts as f64).collect::<Vec<f64>>())
    });
    let second = [0, 1].map(|axis| {
        let (rule, centres) = (&rules[axis], &centres[axis]);
        Array2::from_shape_fn((centres.len(), rule.len()), |(k, q)| rule[q][1] * p.at(centres[k] - rule[q][0]))
    });
    let staged = spread(&rebuilt, &second);

    // at once
    let breaks = |kernel: &dyn Kernel, step: f64| {
        let radius = kernel.radius() * step;
        even_breaks(-radius, radius, 0.5 * step)
    };
    let narrow = signal_from_fn(|x| r.at(x / step) / step);
    let both = Convolution::new(&*p, &breaks(&*p, 1.0), &narrow, &breaks(&*r, step))?;
    let once = |x: f64, at: f64| step * both.at(x - at);
    let of_pixels = tables([&centres[0], &centres[1]], &once);
    let pixels = spread(samples.pixels(), &of_pixels);

    let in_frame = |parts: usize| {
        let [nx, ny] = PIXELS.map(|pixels| pixels * parts);
        Grid::cells(0.0..lengths[0], nx, 0.0..lengths[1], ny)
    };
    let view = |name, title, parts: usize, values: Array2<f64>| -> Result<Panel> {
        Ok(picture(name, title, &Image::trusted(in_frame(parts)?, values)))
    };
    let seen = Image::of(&from_fn(scene), in_frame(n)?);
    let on_fine = |value: &dyn Fn(f64, f64) -> f64| spread(samples.pixels(), &tables([&fine[0], &fine[1]], value));
    let apart = |a: &Array2<f64>, b: &Array2<f64>| a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    let ones = Array2::ones(samples.pixels().dim());
    let defect = spread(&ones, &of_pixels).iter().map(|v| (v - 1.0).abs()).fold(0.0, f64::max);
    // the rounding of sums over all nodes of both axes, of which the amounts of the weights add up to less than two; the
    // convolution is a quadrature to 1e-14
    let terms: usize = (0..2).map(|axis| rules[axis].len() + axes[axis].len()).sum();
    let rounding = 2.0 * (f64::EPSILON * terms as f64 + 2e-14);
    Ok(Figure::new(2)
        .with(view("samples", text!("samples", "отсчёты"), n, seen.pixels().clone())?)
        .with(view("first", text!("1. reconstructed", "1. построено"), FINE, on_fine(&first))?)
        .with(view("second", text!("2. low-passed", "2. сглажено"), FINE, on_fine(&once))?)
        .with(view("third", text!("3. pixels", "3. пиксели"), 1, staged.clone())?)
        .claim(
            text!(
                "one filter gives the same {} × {} pixels as all three stages",
                "один фильтр даёт те же {} × {} пикселей, что и три этапа",
                PIXELS[0],
                PIXELS[1]
            ),
            Residual::at_most("(S ⊗ r) ⊗ p = S ⊗ (r ⊗ p) in the plane", apart(&staged, &pixels), rounding),
        )
        .claim(
            text!("its weights add up to 1 in every pixel", "сумма его весов в каждом пикселе равна 1"),
            Residual::at_most("sum of the weights of r ⊗ p", defect, rounding),
        ))
}
