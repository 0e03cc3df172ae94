//! A photograph and what is left of it behind a low-, a band- and a high-pass.

use crate::axis::Edge;
use crate::door::{Limits, read_picture};
use crate::error::Result;
use crate::figure::images::view::{in_decibels, spectrum_over, worse};
use crate::figure::params::{Param, Params};
use crate::figure::picture::{grey, part, picture};
use crate::figure::{Entry, Figure};
use crate::grid::Grid;
use crate::image::dft::forward;
use crate::image::filter::{Filter, Shape};
use crate::image::resize::resize;
use crate::image::{Image, ImageBins};
use crate::kernel::lanczos::Lanczos;
use crate::laws::plane::{parseval_of_image, transform_rounding};
use crate::residual::Residual;
use crate::text;
use crate::text::{Text, number};

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[PASSES];

static LOW: Text = Text::fixed("lower cut-off, periods across the picture", "нижняя граница, периодов на картинку");
static HIGH: Text = Text::fixed("higher cut-off, periods across the picture", "верхняя граница, периодов на картинку");
static SHAPE: Text = Text::fixed("shape of the filters", "форма фильтров");

const PASSES: Entry = Entry {
    id: "x-frequency-filters",
    inventory: &["F43"],
    errata: &[],
    title: &Text::fixed("A photograph in three bands", "Фотография в трёх полосах частот"),
    caption: &Text::fixed(
        "Low frequencies are masses of light, high ones edges and grass; most of the energy is low, most of what we recognise \
         is not. The three bands add up to the photograph. The ideal filter rings along every edge. In band and high the \
         grey of the ground is zero. (Photograph: Lav Varshney, CC0.)",
        "Низкие частоты — пятна света, высокие — контуры и трава; почти вся энергия внизу, а узнаём мы в основном остальное. \
         Три полосы в сумме дают фотографию. Идеальный фильтр звенит вдоль каждого контура. На полосовой и высокочастотной \
         картинках серый фон — это нуль. (Фото: Lav Varshney, CC0.)",
    ),
    params: &[
        Param::count("low", &LOW, 8, 2, 20),
        Param::count("high", &HIGH, 24, 21, 40),
        Param::choice("shape", &SHAPE, &["ideal", "gaussian", "butterworth"]),
    ],
    build: |params| passes(params),
};

/// The photograph, unchanged, and the size at which it is shown.
const CAMERA: &[u8] = include_bytes!("../../../data/camera.png");
const SIDE: usize = 128;
/// The columns and rows that are shown: all but a narrow border, for the sake of larger pixels.
const SHOWN: std::ops::Range<usize> = 4..124;
/// The darkest tone of a spectrum, in decibels.
const FLOOR: f64 = -80.0;
/// How many bins to every side of zero are shown.
const REACH: usize = 42;

/// The photograph in linear light, made smaller with Lanczos' kernel, around the origin.
fn photo() -> Result<Image> {
    let picture = read_picture("camera.png", CAMERA, Limits::default())?;
    let small = resize(&picture.luminance(), SIDE, SIDE, &Lanczos::new(3.0)?, Edge::Mirror)?;
    small.on(Grid::centered(1.0, SIDE, SIDE)?)
}

/// `Σ|F|²` without the mean.
fn energy(bins: &ImageBins) -> f64 {
    bins.values().iter().map(|f| f.norm_sqr()).sum::<f64>() - bins.bin(0, 0).norm_sqr()
}

fn passes(params: &Params) -> Result<Figure> {
    let (low, high) = (params.count("low"), params.count("high"));
    let shape = match params.choice("shape") {
        "gaussian" => Shape::Gaussian,
        "butterworth" => Shape::Butterworth(2),
        _ => Shape::Ideal,
    };
    // between two bins, so that none stands on the edge
    let cutoff = |k: usize| (k as f64 + 0.5) / SIDE as f64;
    let filters = [
        Filter::low_pass(cutoff(low), shape)?,
        Filter::band_pass(cutoff(low), cutoff(high), shape)?,
        Filter::high_pass(cutoff(high), shape)?,
    ];
    let photo = photo()?;
    let whole = forward(&photo);
    let pieces = filters.map(|filter| filter.apply(&photo));
    let bins = pieces.each_ref().map(forward);
    let shares = bins.each_ref().map(|bins| energy(bins) / energy(&whole));
    let percent = shares.map(|share| number(100.0 * share, 3));

    // detail around zero, to the same scale in both pictures
    let detail = |name, title, piece: &Image| grey(name, title, piece, (-0.25, 0.25));
    let largest = whole.values().iter().map(|f| f.norm()).fold(0.0, f64::max);
    let below = |name, bins: &ImageBins, title: Text| spectrum_over(name, title, bins, largest, FLOOR, REACH);
    let share = |i: usize| text!("{} % of the energy", "{} % энергии", percent[i]);
    let inner = |image: &Image| part(image, SHOWN, SHOWN);
    let figure = Figure::new(4)
        .heights([1.14, 1.0])
        .with(picture("photo", text!("photograph", "фотография"), &inner(&photo)?))
        .with(picture("low", text!("low: to {low}", "низкие: до {low}"), &inner(&pieces[0])?))
        .with(detail("band", text!("band: {low} to {high}", "средние: {low}–{high}"), &inner(&pieces[1])?))
        .with(detail("high", text!("high: from {high}", "высокие: от {high}"), &inner(&pieces[2])?))
        .with(below("photo-spectrum", &whole, in_decibels(FLOOR))?)
        .with(below("low-spectrum", &bins[0], share(0))?)
        .with(below("band-spectrum", &bins[1], share(1))?)
        .with(below("high-spectrum", &bins[2], share(2))?);

    let sum = pieces[0].with(&pieces[1], |a, b| a + b)?.with(&pieces[2], |a, b| a + b)?;
    let worst = sum.values().iter().zip(photo.values()).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    let rounding = transform_rounding(SIDE * SIDE);
    let size = photo.values().iter().map(|v| v * v).sum::<f64>().sqrt();
    let passed = |i: usize| {
        let places = whole.grid();
        let each = places.iter().zip(whole.values()).zip(bins[i].values());
        each.map(|(([u, v], f), g)| (g - f * filters[i].response(u, v)).norm()).fold(0.0, f64::max)
    };
    let most = (0..3).map(passed).fold(0.0, f64::max);
    // what two pieces have in common counts twice
    let common = |a: usize, b: usize| {
        let products = bins[a].values().iter().zip(bins[b].values()).map(|(f, g)| (f * g.conj()).re);
        (products.sum::<f64>() - (bins[a].bin(0, 0) * bins[b].bin(0, 0).conj()).re) / energy(&whole)
    };
    let shared = 2.0 * (common(0, 1) + common(1, 2) + common(0, 2));
    let total: f64 = shares.iter().sum();
    let energies = match shape {
        Shape::Ideal => text!(
            "{} % + {} % + {} % of the energy are all of it",
            "{} % + {} % + {} % энергии — это вся энергия",
            percent[0],
            percent[1],
            percent[2]
        ),
        _ => text!(
            "{} % + {} % + {} % of the energy, and {} % that neighbours share",
            "{} % + {} % + {} % энергии и ещё {} % общих у соседних полос",
            percent[0],
            percent[1],
            percent[2],
            number(100.0 * shared, 3)
        ),
    };
    let parseval = pieces.iter().map(parseval_of_image).fold(parseval_of_image(&photo), worse);
    Ok(figure
        .claim(
            text!("low + band + high = the photograph", "низкие + средние + высокие = фотография"),
            // three round trips, each relative to the root of the sum of squares
            Residual::at_most("low + band + high = original", worst, 6.0 * rounding * size),
        )
        .claim(
            text!(
                "every bin is the photograph's times the filter: nothing outside its pass-band",
                "каждый отсчёт спектра умножен на фильтр: за полосой пропускания ничего нет"
            ),
            // a round trip and a transform, relative to the root of the sum of squares, in N² bins
            Residual::at_most("bins behind the filter = bins × response", most, 3.0 * rounding * size * SIDE as f64),
        )
        .claim(
            energies,
            Residual::near("energies of the bands and what they share = energy", total + shared, 1.0, 24.0 * rounding),
        )
        .claim(text!("Parseval: Σf² = Σ|F|²/N² for each of them", "Парсеваль: Σf² = Σ|F|²/N² для каждой"), parseval))
}
