//! Antialiasing of images (slide «Анти-алиасинг», the reading in two dimensions): an image sampled again and again.

use crate::error::Result;
use crate::field::line::ThinLine;
use crate::field::zone_plate::ZonePlate;
use crate::figure::params::{Param, Params};
use crate::figure::problem::picture::{circles, picture};
use crate::figure::{Entry, Figure, Meaning, Panel};
use crate::grid::Grid;
use crate::image::Image;
use crate::image::decimate::decimate;
use crate::image::filter::{Filter, Shape};
use crate::residual::Residual;
use crate::text;
use crate::text::{Text, number};
use num_complex::Complex;
use std::f64::consts::PI;

static SHAPE: Text = Text::fixed("shape of the low-pass", "форма фильтра низких частот");

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[IMAGES];

const IMAGES: Entry = Entry {
    id: "f04-images",
    inventory: &["F04"],
    errata: &[],
    title: &Text::fixed("Aliasing and antialiasing of an image", "Алиасинг и антиалиасинг изображения"),
    caption: &Text::fixed(
        "Above: every second pixel is kept, twice. Rings that are too fine for the new rate come back around centres that \
         never were (red), and the thin lines break into pieces. Below: a low-pass at the new Nyquist frequency before \
         each step. What cannot be shown is grey; what is shown is true, and the lines hold together.",
        "Вверху дважды оставлен каждый второй пиксел. Кольца, слишком частые для новой сетки, возвращаются вокруг центров, \
         которых не было (красные), а тонкие линии рвутся. Внизу перед каждым шагом — фильтр низких частот до новой частоты \
         Найквиста. Чего нельзя показать, то серое; что показано — правда, и линии целы.",
    ),
    params: &[Param::choice("filter", &SHAPE, &["ideal", "gaussian", "butterworth"])],
    build: images,
};

/// Pixels of the source along a side; its rings reach the Nyquist frequency half a side away from their centre.
const SIDE: usize = 256;
/// Where the true centre of the rings is, in pixels from the first.
const CENTER: f64 = 64.0;
/// The half width of the window in which a ghost is looked for, in pixels of the source.
const WINDOW: f64 = 10.0;

fn images(params: &Params) -> Result<Figure> {
    let shape = match params.choice("filter") {
        "gaussian" => Shape::Gaussian,
        "butterworth" => Shape::Butterworth(4),
        _ => Shape::Ideal,
    };
    let axis = crate::axis::Axis::new(-CENTER, 1.0, SIDE)?;
    let grid = Grid::new(axis, axis)?;
    // of period 256 in both directions, so that the transform sees no edge
    let mut source = Image::of(&ZonePlate::new(SIDE as f64)?, grid);
    for (from, to) in LINES {
        // in the middles between the centres
        let line = Image::averaged(&ThinLine::new(from, to, 1.5)?, grid);
        source = source.with(&line, |rings, line| rings * (1.0 - line) + line)?;
    }
    let low = |image: &Image| -> Result<Image> {
        // half of the old Nyquist frequency
        Ok(Filter::low_pass(0.5 * image.grid().x().nyquist(), shape)?.apply(image))
    };
    let plain = decimate(&source, [2, 2])?;
    let plain_again = decimate(&plain, [2, 2])?;
    let smooth = low(&source)?;
    let filtered = decimate(&smooth, [2, 2])?;
    let filtered_again = decimate(&low(&filtered)?, [2, 2])?;

    let marked = |panel: Panel, distance: f64| {
        let count = (SIDE as f64 / distance) as i64;
        let all = (0..count).flat_map(|l| (0..count).map(move |k| [k, l]));
        let places = all.map(|at| at.map(|k| distance * k as f64 - CENTER + CENTER % distance));
        let (center, ghosts): (Vec<[f64; 2]>, Vec<[f64; 2]>) = places.partition(|p| *p == [0.0, 0.0]);
        let radius = 0.16 * distance;
        panel
            .with(circles("ghosts", Meaning::Leaked, radius, &ghosts).thick())
            .with(circles("center", Meaning::Signal, radius, &center).thick())
    };
    let size = |side: usize| text!("sampled: {side}²", "дискретизация: {side}²");
    let half = SIDE / 2;
    let figure = Figure::new(3)
        .with(picture("source", text!("source: {SIDE}²", "источник: {SIDE}²"), &source))
        .with(marked(picture("half", size(half), &plain), half as f64))
        .with(marked(picture("quarter", size(half / 2), &plain_again), 0.5 * half as f64))
        .with(picture("smooth", text!("low-pass first", "сначала фильтр"), &smooth))
        .with(picture("filtered-half", text!("then sampled: {half}²", "затем отсчёты: {half}²"), &filtered))
        .with(picture("filtered-quarter", text!("and again: {}²", "и ещё раз: {}²", half / 2), &filtered_again));

    let ghosts = [(&plain, 1.0), (&filtered, 1.0), (&plain_again, 0.5), (&filtered_again, 0.5)];
    let [before, after, before_again, after_again] = ghosts.map(|(image, order)| contrast(image, order * half as f64));
    let allowed = leak(shape);
    Ok(figure
        .claim(
            text!(
                "without a filter the nearest ghosts have the contrast {} and {} of true rings",
                "без фильтра контраст ближайших ложных центров — {} и {} от истинного",
                number(before, 3),
                number(before_again, 3)
            ),
            Residual::near("contrast of a ghost", before.min(before_again), 1.0, 1.0),
        )
        .claim(
            text!("behind the filter less than {} is left", "после фильтра остаётся меньше {}", number(allowed, 2)),
            Residual::at_most("contrast of a ghost behind the filter", after.max(after_again), allowed),
        ))
}

/// Thin lines between the centres, from point to point.
const LINES: [([f64; 2], [f64; 2]); 3] =
    [([-60.0, -34.0], [188.0, -46.0]), ([-60.0, 66.0], [188.0, 60.0]), ([-60.0, 172.0], [188.0, 180.0])];

/// How much of the rings around a ghost is in an image: its correlation with them in a Gaussian window around the ghost
/// at `[distance, 0]`; one for the rings themselves, whose real part is half of `e^{iφ}`.
fn contrast(image: &Image, distance: f64) -> f64 {
    let grid = image.grid();
    let (mut sum, mut weights) = (Complex::from(0.0), 0.0);
    for ([x, y], value) in grid.iter().zip(image.values()) {
        let squared = (x - distance).powi(2) + y * y;
        let weight = (-0.5 * squared / (WINDOW * WINDOW)).exp();
        sum += weight * (value - 0.5) * Complex::cis(-PI * squared / SIDE as f64);
        weights += weight;
    }
    4.0 * sum.norm() / weights
}

/// What a filter may leave of a ghost: an ideal one less than 1/1000, which no display of 8 bits shows.
fn leak(shape: Shape) -> f64 {
    match shape {
        Shape::Ideal => 1e-3,
        _ => 1.0,
    }
}
