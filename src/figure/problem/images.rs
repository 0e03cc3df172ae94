//! Antialiasing of images (slide «Анти-алиасинг», the reading in two dimensions): an image sampled again and again.

use crate::axis::Axis;
use crate::error::Result;
use crate::field::line::ThinLine;
use crate::field::zone_plate::ZonePlate;
use crate::figure::params::{Param, Params};
use crate::figure::problem::picture::{circles, picture};
use crate::figure::{Entry, Figure, Meaning, Panel};
use crate::grid::Grid;
use crate::image::Image;
use crate::image::decimate::decimate;
use crate::image::dft::{forward, inverse};
use crate::image::filter::{Filter, Shape};
use crate::residual::Residual;
use crate::text;
use crate::text::{Text, number};
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
        "Вверху дважды оставлен каждый второй пиксель. Кольца, слишком частые для новой сетки, возвращаются вокруг центров, \
         которых не было (красные), а тонкие линии рвутся. Внизу перед каждым шагом — фильтр низких частот до новой частоты \
         Найквиста. Чего нельзя показать, то серое; что показано — правда, и линии целы.",
    ),
    params: &[Param::choice("filter", &SHAPE, &["ideal", "gaussian", "butterworth"])],
    build: images,
};

/// Pixels of the source along a side; its rings reach the Nyquist frequency half a side away from their centre.
const SIDE: usize = 160;
/// Where the true centre of the rings is, in pixels from the first.
const CENTER: f64 = 40.0;
/// Thin lines between the centres, from point to point.
const LINES: [([f64; 2], [f64; 2]); 3] =
    [([-36.0, -19.0], [116.0, -27.0]), ([-36.0, 43.0], [116.0, 38.0]), ([-36.0, 106.0], [116.0, 112.0])];

/// Rings of period [`SIDE`] in both directions, so that the transform sees no edge, and lines across them.
fn source() -> Result<Image> {
    let axis = Axis::new(-CENTER, 1.0, SIDE)?;
    let grid = Grid::new(axis, axis)?;
    let mut source = Image::of(&ZonePlate::new(SIDE as f64)?, grid);
    for (from, to) in LINES {
        let over = |width: f64, light: f64, below: &Image| -> Result<Image> {
            let line = Image::averaged(&ThinLine::new(from, to, width)?, grid);
            below.with(&line, |below, covered| below + covered * (light - below))
        };
        source = over(1.2, 1.0, &over(7.0, 0.0, &source)?)?;
    }
    Ok(source)
}

fn images(params: &Params) -> Result<Figure> {
    let shape = match params.choice("filter") {
        "gaussian" => Shape::Gaussian,
        "butterworth" => Shape::Butterworth(4),
        _ => Shape::Ideal,
    };
    // half of the Nyquist frequency: what every second pixel can show
    let low = |image: &Image| -> Result<Filter> { Filter::low_pass(0.5 * image.grid().x().nyquist(), shape) };
    let source = source()?;
    let plain = decimate(&source, [2, 2])?;
    let plain_again = decimate(&plain, [2, 2])?;
    let smooth = low(&source)?.apply(&source);
    let filtered = decimate(&smooth, [2, 2])?;
    let smooth_again = low(&filtered)?.apply(&filtered);
    let filtered_again = decimate(&smooth_again, [2, 2])?;

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
    let [half, quarter] = [SIDE / 2, SIDE / 4];
    let [far, near] = [half, quarter].map(|side| side as f64);
    let every = |side: usize| text!("every 2nd: {side}²", "через один: {side}²");
    let again = |side: usize| text!("and again: {side}²", "и ещё раз: {side}²");
    let figure = Figure::new(3)
        .with(picture("source", text!("source: {SIDE}²", "источник: {SIDE}²"), &source))
        .with(marked(picture("half", every(half), &plain), far))
        .with(marked(picture("quarter", again(quarter), &plain_again), near))
        .with(picture("smooth", text!("low-pass first", "сначала фильтр"), &smooth))
        .with(picture("filtered-half", every(half), &filtered))
        .with(picture("filtered-quarter", again(quarter), &filtered_again));

    let [before, before_again] = [contrast(&source, far)?, contrast(&plain, near)?];
    let [after, after_again] = [contrast(&smooth, far)?, contrast(&smooth_again, near)?];
    let leak = |image: &Image, distance: f64| -> Result<f64> {
        let edge = (1.0 - 4.0 * WINDOW) * distance / SIDE as f64;
        Ok(low(image)?.response(edge, 0.0) + TAIL)
    };
    let allowed = leak(&source, far)?.max(leak(&filtered, near)?);
    let [of_far, of_near] = [far, near].map(expected);
    Ok(figure
        .claim(
            text!(
                "without a filter the nearest ghosts have the contrast {} and {} of true rings",
                "без фильтра контраст ближайших ложных центров — {} и {} от истинного",
                number(before, 2),
                number(before_again, 2)
            ),
            Residual::at_most(
                "contrast of ghosts = that of rings",
                (before - of_far).abs().max((before_again - of_near).abs()),
                STRAYS,
            ),
        )
        .claim(
            text!("behind the filter less than {} is left", "после фильтра остаётся меньше {}", number(allowed, 1)),
            Residual::at_most("contrast of a ghost behind the filter", after.max(after_again), allowed),
        ))
}

/// The deviation of the window in which a ghost is looked for, in distances of ghosts, and its weight four of them away.
const WINDOW: f64 = 0.1;
const TAIL: f64 = 3.4e-4; // e^{−½·4²}
/// What the lines change: they stay 2½ deviations of the window away from every ghost, e^{−½·2.5²}.
const STRAYS: f64 = 0.044;

/// The contrast of the ghost at `[distance, 0]` that appears when only every second pixel of an image is kept: of what is
/// above the new Nyquist frequency, and folds, the amplitude in a Gaussian window around the ghost, in parts of the ½ that
/// the rings themselves have.
fn contrast(image: &Image, distance: f64) -> Result<f64> {
    let limit = 0.5 * image.grid().x().nyquist();
    let folds = |u: f64, v: f64| if u.abs().max(v.abs()) > limit { 1.0 } else { 0.0 };
    let folded = decimate(&inverse(&forward(image).times(|u, v| folds(u, v).into())), [2, 2])?;
    let (mut power, mut weights) = (0.0, 0.0);
    for ([x, y], value) in folded.grid().iter().zip(folded.values()) {
        let squared = (x - distance).powi(2) + y * y;
        let weight = (-0.5 * squared / (WINDOW * distance).powi(2)).exp();
        power += weight * value * value;
        weights += weight;
    }
    // the mean square of ½cos φ is ⅛
    Ok((8.0 * power / weights).sqrt())
}

/// What the contrast of whole rings is in that window: cos² has the mean ½ + ½Re⟨e^{2πir²/M}⟩.
fn expected(distance: f64) -> f64 {
    let turn = 4.0 * PI * (WINDOW * distance).powi(2) / SIDE as f64;
    (1.0 + 1.0 / (1.0 + turn * turn)).sqrt()
}
