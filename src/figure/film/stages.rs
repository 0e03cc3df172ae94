//! From samples to pixels: the three stages (slide «Реконструкция изображения»).

use crate::axis::Axis;
use crate::error::Result;
use crate::figure::common::{signal_curve, space, values};
use crate::figure::params::{Param, Params};
use crate::figure::{Entry, Figure, Layer, Legend, Meaning, Panel};
use crate::kernel::Kernel;
use crate::kernel::catalog::by_name;
use crate::num::quadrature::even_breaks;
use crate::reconstruct::reconstruct;
use crate::residual::Residual;
use crate::sampled::Samples;
use crate::signal::boxcar::Boxcar;
use crate::signal::gaussian::Gaussian;
use crate::signal::theorem::{Convolution, Scaled, Shifted, Sum};
use crate::signal::{Signal, from_fn};
use crate::text;
use crate::text::Text;

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[STAGES];

static PER_PIXEL: Text = Text::fixed("samples per pixel", "отсчётов на пиксель");
static FIRST: Text = Text::fixed("the filter r that reconstructs", "фильтр реконструкции r");
static SECOND: Text = Text::fixed("the filter p of the pixel", "фильтр пикселя p");

const STAGES: Entry = Entry {
    id: "f55-stages",
    inventory: &["F55"],
    errata: &[],
    title: &Text::fixed(
        "From samples to pixels: three stages, one filter",
        "От отсчётов к пикселям: три этапа, один фильтр",
    ),
    caption: &Text::fixed(
        "Reconstruct a function from the samples, remove what pixels cannot show, sample it at the centres. Only the \
         centres are asked for, and convolution is associative: (S ⊗ r) ⊗ p = S ⊗ (r ⊗ p). So one filter (right) gives the \
         same pixels, and the function in between need never be built.",
        "Построить функцию по отсчётам, убрать то, что не покажут пиксели, взять значения в центрах. Нужны только центры, а \
         свёртка ассоциативна: (S ⊗ r) ⊗ p = S ⊗ (r ⊗ p). Поэтому один фильтр (справа) даёт те же пиксели, и \
         промежуточную функцию строить незачем.",
    ),
    params: &[
        Param::count("n", &PER_PIXEL, 4, 1, 8),
        Param::choice("r", &FIRST, &["tent", "box", "catmull-rom"]),
        Param::choice("p", &SECOND, &["box", "tent", "mitchell", "gaussian"]),
    ],
    build: |params| stages(params),
};

/// How many pixels are shown; samples go on for `MARGIN` more to either side, as far as both filters reach.
const PIXELS: usize = 8;
const MARGIN: f64 = 5.0;

/// A bright field with sharp edges, and a soft light beside it.
fn scene() -> Result<impl Signal> {
    let field = Scaled::new(0.7, Shifted::new(2.55, Boxcar::new(2.3)?)?)?;
    let light = Scaled::new(0.9, Shifted::new(5.9, Gaussian::new(1.4)?)?)?;
    Ok(Sum(field, light))
}

/// Breaks at all kinks of a kernel of the library, `step` wide a step: they stand at halves of it.
fn kinks(kernel: &dyn Kernel, step: f64) -> Vec<f64> {
    let radius = kernel.radius() * step;
    even_breaks(-radius, radius, 0.5 * step)
}

fn stages(params: &Params) -> Result<Figure> {
    let n = params.count("n");
    let (r, p) = (by_name(params.choice("r"))?, by_name(params.choice("p"))?);
    let scene = scene()?;
    let (length, step) = (PIXELS as f64, 1.0 / n as f64);
    let count = (length + 2.0 * MARGIN) as usize * n;
    let samples = Samples::of(&scene, Axis::cells(-MARGIN..length + MARGIN, count)?);

    // three stages
    let built = reconstruct(&samples, &*r);
    let ends = even_breaks(-MARGIN, length + MARGIN, 0.5 * step);
    let low_passed = Convolution::new(&*p, &kinks(&*p, 1.0), built, &ends)?;
    let centres = Axis::cells(0.0..length, PIXELS)?;
    let pixels = Samples::of(&low_passed, centres);
    // one filter
    let narrow = from_fn(|x| r.at(x / step) / step);
    let both = Convolution::new(&*p, &kinks(&*p, 1.0), &narrow, &kinks(&*r, step))?;
    let weighed = |x: f64, value: &dyn Fn(f64) -> f64| -> f64 {
        samples.points().map(|[at, v]| step * value(v) * both.at(x - at)).sum()
    };
    let at_once: Vec<[f64; 2]> = centres.iter().map(|x| [x, weighed(x, &|v| v)]).collect();

    let plot =
        |name, title| Panel::new(name, title, space(0.0, length), values("f", -0.15, 1.15)).legend(Legend::Above);
    let inside = |p: &[f64; 2]| (0.0..=length).contains(&p[0]);
    let built_curve = || signal_curve("reconstructed", Meaning::Reconstructed, &built, 0.0, length);
    let low_passed_curve =
        || Layer::curve("low-passed", Meaning::Kernel, 0.0, length, 50 * PIXELS, |x| low_passed.at(x));
    let first = plot("first", text!("1. reconstruct: S ⊗ r", "1. построить: S ⊗ r"))
        .with(built_curve().label(text!("function", "функция")))
        .with(
            Layer::stems("samples", Meaning::Samples, samples.points().filter(inside))
                .label(text!("samples", "отсчёты")),
        );
    let second = plot("second", text!("2. low-pass: ⊗ p", "2. префильтровать: ⊗ p"))
        .with(built_curve().thin().label(text!("function", "функция")))
        .with(low_passed_curve().thick().label(text!("low-passed", "сглажена")));
    let third = plot("third", text!("3. sample at the centres", "3. взять в центрах"))
        .with(Layer::bars("pixels", Meaning::Replica, 0.9, pixels.points()).label(text!("pixels", "пиксели")))
        .with(low_passed_curve().thin())
        .with(
            Layer::dots("at-once", Meaning::Error, at_once.iter().copied())
                .label(text!("by one filter", "одним фильтром")),
        );
    let filter = |name, title, what, filter: &dyn Signal, top: f64| {
        Panel::new(name, title, space(-2.6, 2.6), values(what, -0.15 * top, 1.15 * top))
            .with(Layer::curve(name, Meaning::Kernel, -2.6, 2.6, 520, |x| filter.at(x)).thick())
    };
    let top_of_both = both.at(0.0);

    // both ways are quadratures to 1e-14 or 16ε of the integral of |f|, here of sums of weights below two
    let quadrature = 1e-14 + 32.0 * f64::EPSILON;
    let size: f64 = 1.0 + samples.values().iter().map(|v| step * v.abs()).sum::<f64>();
    let difference = pixels.values().iter().zip(&at_once).map(|(a, b)| (a - b[1]).abs()).fold(0.0, f64::max);
    let defect = centres.iter().map(|x| (weighed(x, &|_| 1.0) - 1.0).abs()).fold(0.0, f64::max);
    let reach = p.radius() + step * r.radius();
    let weighs = samples.points().filter(|s| (s[0] - centres.at(PIXELS as i64 / 2)).abs() < reach).count();
    Ok(Figure::new(3)
        .heights([1.0, 0.62])
        .with(first)
        .with(second)
        .with(third)
        .with(filter("r", text!("r, a sample wide", "r: в масштабе отсчётов"), "r(x)", &narrow, n as f64))
        .with(filter("p", text!("p, a pixel wide", "p: в масштабе пикселей"), "p(x)", &p, 1.0))
        .with(filter("both", text!("both at once: r ⊗ p", "сразу оба: r ⊗ p"), "r ⊗ p", &both, top_of_both))
        .claim(
            text!(
                "one filter (it weighs {weighs} samples for a pixel) gives the same {PIXELS} pixels as all three stages",
                "один фильтр (взвешивает на пиксель отсчётов: {weighs}) даёт те же {PIXELS} пикселей, что и три этапа"
            ),
            Residual::at_most("(S ⊗ r) ⊗ p = S ⊗ (r ⊗ p) at the centres", difference, quadrature * size),
        )
        .claim(
            text!(
                "the weights of a pixel add up to 1: a constant keeps its brightness",
                "сумма весов пикселя равна 1: постоянная яркость сохраняется"
            ),
            Residual::at_most("sum of the weights of r ⊗ p", defect, quadrature * (1.0 + count as f64 * step)),
        ))
}
