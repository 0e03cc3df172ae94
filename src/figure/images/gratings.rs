//! Waves in the plane and their spectra (slides «Spatial and Frequency Domain», «More Examples»).

use crate::error::Result;
use crate::field::FourierField;
use crate::field::flat::Flat;
use crate::field::grating::Grating;
use crate::field::plaid::Plaid;
use crate::figure::images::view::{decibels, in_decibels, picture, spectrum};
use crate::figure::params::{Param, Params};
use crate::figure::{Entry, Figure, Layer, Meaning, Panel, Scale};
use crate::grid::Grid;
use crate::image::Image;
use crate::image::dft::forward;
use crate::laws::plane::spectrum_by_transform;
use crate::residual::Residual;
use crate::text;
use crate::text::{Text, number};
use std::f64::consts::FRAC_PI_2;

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[CONSTANT, WAVES];

/// Pixels along a side.
const SIDE: usize = 128;
/// How many bins to every side of zero are shown.
const REACH: usize = 16;
/// The darkest tone of a spectrum, in decibels.
const FLOOR: f64 = -60.0;

static ACROSS: Text = Text::fixed("periods across the picture", "периодов на ширину картинки");
static UP: Text = Text::fixed("periods along the height", "периодов на высоту картинки");
static SLOW: Text = Text::fixed("periods of the slower wave across", "периодов медленной волны на ширину");

const CONSTANT: Entry = Entry {
    id: "f43-spatial-and-frequency",
    inventory: &["F43"],
    errata: &[],
    title: &Text::fixed("Space and frequency: constant and sine", "Пространство и частота: константа и синус"),
    caption: &Text::fixed(
        "A picture of 128 × 128 pixels, below it the middle of its spectrum with zero frequency in the centre, and the bins \
         of the row v = 0. A constant is a single bin. A sine is two, as far from zero as it has periods across the picture: 32 pixels \
         per period are 4. The scales of spectra count periods across the picture.",
        "Картинка 128 × 128, под ней середина её спектра с нулевой частотой в центре и отсчёты спектра в строке v = 0. Константа — \
         один отсчёт. Синус — два, на расстоянии от нуля, равном числу периодов на картинке: период в 32 пикселя даёт 4. \
         По осям спектров — число периодов на картинку.",
    ),
    params: &[Param::count("k", &ACROSS, 4, 1, 15)],
    build: |params| constant_and_sine(params.count("k")),
};

fn grid() -> Result<Grid> {
    Grid::centered(1.0, SIDE, SIDE)
}

/// `sin(2π(kx + ly)/N)`.
fn sine(k: usize, l: usize) -> Result<Grating> {
    Grating::with_phase([k, l].map(|n| n as f64 / SIDE as f64), -FRAC_PI_2)
}

/// `2πx/32`, or with the fraction where the period is not a whole number of pixels.
fn argument(of: char, periods: usize) -> String {
    match SIDE % periods {
        0 => format!("2π{of}/{}", SIDE / periods),
        _ => format!("2π·{periods}{of}/{SIDE}"),
    }
}

/// The sizes of the bins in the row of zero vertical frequency, in units of N².
fn row(name: &'static str, image: &Image) -> Panel {
    let bins = forward(image);
    let size = |k: i64| bins.bin(k, 0).norm() / bins.space().area();
    let reach = REACH as i64;
    let end = REACH as f64 + 0.5;
    let stems = (-reach..=reach).map(|k| [k as f64, size(k)]);
    Panel::new(
        name,
        text!("row v = 0", "строка v = 0"),
        Scale::linear(Text::EMPTY, -end, end),
        Scale::linear(Text::same("|F|/N²"), 0.0, 0.62),
    )
    .with(Layer::stems("bins", Meaning::Signal, stems))
}

fn constant_and_sine(k: usize) -> Result<Figure> {
    let (flat, wave) = (Flat::new(0.5)?, sine(k, 0)?);
    let images = [Image::of(&flat, grid()?), Image::of(&wave, grid()?)];
    let shown = |image: &Image, name| spectrum(name, in_decibels(FLOOR), &forward(image), FLOOR, REACH);
    let argument = argument('x', k);
    let half = number((SIDE * SIDE / 2) as f64, 4);
    Ok(Figure::new(4)
        .heights([1.24, 1.0])
        .with(picture("constant", text!("constant ½", "константа ½"), &images[0], (0.0, 1.0)).span(2))
        .with(picture("sine", text!("sin({argument})", "sin({argument})"), &images[1], (-1.0, 1.0)).span(2))
        .with(shown(&images[0], "constant-spectrum")?)
        .with(row("constant-row", &images[0]))
        .with(shown(&images[1], "sine-spectrum")?)
        .with(row("sine-row", &images[1]))
        .claim(
            text!(
                "the constant ½: one bin at zero, ½·N² = {half}, and nothing else",
                "константа ½: один отсчёт в нуле, ½·N² = {half}, и больше ничего"
            ),
            spectrum_by_transform(&images[0], &flat.spectrum(), 0.0),
        )
        .claim(
            text!(
                "sin({argument}): two bins, at (±{k}, 0), of the size N²/2 = {half}, and nothing else",
                "sin({argument}): два отсчёта, в (±{k}, 0), величины N²/2 = {half}, и больше ничего"
            ),
            spectrum_by_transform(&images[1], &wave.spectrum(), 0.0),
        ))
}

const WAVES: Entry = Entry {
    id: "f44-waves",
    inventory: &["F44"],
    errata: &[],
    title: &Text::fixed("More examples: waves and their products", "Ещё примеры: волны и их произведения"),
    caption: &Text::fixed(
        "The direction of a wave is the direction in which its two peaks lie, its number of periods their distance from zero. \
         A product of two waves is a sum of two others, at the sum and the difference of the frequencies: four peaks of half \
         the size, none of them where the factors have theirs.",
        "Направление волны — это направление, в котором лежат два её пика, число периодов — их расстояние от нуля. \
         Произведение двух волн есть сумма двух других, на сумме и разности частот: четыре пика вдвое меньшей величины, и \
         ни один не там, где пики сомножителей.",
    ),
    params: &[
        Param::count("k", &ACROSS, 8, 1, 15),
        Param::count("l", &UP, 8, 1, 15),
        Param::count("m", &SLOW, 4, 1, 15),
    ],
    build: |params| waves(params),
};

fn waves(params: &Params) -> Result<Figure> {
    let [k, l, m] = ["k", "l", "m"].map(|name| params.count(name));
    let (across, up, slow) = (sine(k, 0)?, sine(0, l)?, sine(m, 0)?);
    let product = Plaid::new(slow, up)?;
    let (half, quarter) = (number((SIDE * SIDE / 2) as f64, 4), number((SIDE * SIDE / 4) as f64, 4));
    let [x, y, z] = [argument('x', k), argument('y', l), argument('x', m)];
    let columns = [
        Column::of(
            &across,
            ["across", "across-spectrum"],
            text!("sin({x})", "sin({x})"),
            text!("sin({x}): peaks at (±{k}, 0), N²/2 = {half}", "sin({x}): пики в (±{k}, 0), N²/2 = {half}"),
        )?,
        Column::of(
            &up,
            ["up", "up-spectrum"],
            text!("sin({y})", "sin({y})"),
            text!("sin({y}): peaks at (0, ±{l}), N²/2 = {half}", "sin({y}): пики в (0, ±{l}), N²/2 = {half}"),
        )?,
        Column::of(
            &product,
            ["product", "product-spectrum"],
            text!("sin({z})·sin({y})", "sin({z})·sin({y})"),
            text!(
                "sin({z})·sin({y}): four peaks at (±{m}, ±{l}), N²/4 = {quarter}",
                "sin({z})·sin({y}): четыре пика в (±{m}, ±{l}), N²/4 = {quarter}"
            ),
        )?,
    ];
    let figure = Figure::new(3).heights([1.22, 1.0]);
    let figure = columns.iter().fold(figure, |figure, column| figure.with(column.above.clone()));
    let figure = columns.iter().fold(figure, |figure, column| figure.with(column.below.clone()));
    Ok(columns.into_iter().fold(figure, |figure, column| figure.claim(column.says, column.residual)))
}

/// A picture above its spectrum, and the claim that its peaks are those of the closed form.
struct Column {
    above: Panel,
    below: Panel,
    says: Text,
    residual: Residual,
}

impl Column {
    fn of(field: &impl FourierField, [above, below]: [&'static str; 2], title: Text, says: Text) -> Result<Self> {
        let image = Image::of(field, grid()?);
        Ok(Self {
            above: picture(above, title, &image, (-1.0, 1.0)),
            below: spectrum(below, Text::EMPTY, &forward(&image), FLOOR, REACH)?.bar(decibels()),
            says,
            residual: spectrum_by_transform(&image, &field.spectrum(), 0.0),
        })
    }
}
