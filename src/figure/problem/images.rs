//! Antialiasing of images (slide «Анти-алиасинг», the reading in two dimensions): an image sampled again and again.

use crate::axis::Axis;
use crate::error::Result;
use crate::field::line::ThinLine;
use crate::field::zone_plate::ZonePlate;
use crate::figure::params::{Param, Params};
use crate::figure::picture::{circles, picture};
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

    let [found, found_again] = [ghost(&plain, far), ghost(&plain_again, near)];
    let [left, left_again] = [ghost(&filtered, far), ghost(&filtered_again, near)];
    let leak = |filter: Filter, distance: f64| {
        let local = distance / SIDE as f64;
        let split = |z: f64| filter.response((local - z * SPREAD).max(0.0), 0.0) + (-0.5 * z * z).exp();
        (1..=60).map(|z| split(0.1 * f64::from(z))).fold(f64::INFINITY, f64::min)
    };
    let [allowed, allowed_again] = [leak(low(&source)?, far), leak(low(&filtered)?, near)];
    Ok(figure
        .claim(
            text!(
                "without a filter the nearest ghosts have the contrast {} and {} of true rings",
                "без фильтра контраст ближайших ложных центров — {} и {} от истинного",
                number(found, 3),
                number(found_again, 3)
            ),
            Residual::at_most(
                "contrast of ghosts = that of rings",
                (found - 1.0).abs().max((found_again - 1.0).abs()),
                STRAYS,
            ),
        )
        .claim(
            text!(
                "behind the filter {} of the first ghost is left",
                "после фильтра от первого ложного центра остаётся {}",
                number(left, 1)
            ),
            Residual::at_most("contrast of the first ghost behind the filter", left, allowed + 2.0 * STRAYS),
        )
        .claim(
            text!(
                "and {} of the second, whose rings are as fine against the new pixels but half as many",
                "а от второго — {}: его кольца так же часты для новых пикселей, но их вдвое меньше",
                number(left_again, 1)
            ),
            Residual::at_most(
                "contrast of the second ghost behind the filter",
                left_again,
                allowed_again + 2.0 * STRAYS,
            ),
        ))
}

/// The deviation of the window in which a ghost is looked for, √(SIDE/2π): with it the window and the rings' own change of
/// frequency within it blur the local frequency least, together by `1/√(πSIDE)`.
const WINDOW: f64 = 5.046;
const SPREAD: f64 = 0.0446;
/// What the lines change: they stay 19.5 pixels away from every ghost, 3.86 deviations of the window, beyond which there are
/// 5.7·10⁻⁵ of it; whole rings come to a mean of 0.31 in it, and a line differs from them by one at most.
const STRAYS: f64 = 5.7e-5 / 0.31;

/// The contrast of the ghost at `[distance, 0]` in a picture as it is shown, in parts of that of rings around that place: what
/// their pattern finds of itself in a Gaussian window, `|Σ w·(f − ½)·e^{iπr²/M}|`. The rings themselves, whose local
/// frequency is `distance/M` there, are not heard in it.
///
/// Behind a filter there is its response to that frequency, which is uncertain by [`SPREAD`]: no more than the response `z`
/// deviations below, and what lies beyond these, `e^{−z²/2}`.
fn ghost(image: &Image, distance: f64) -> f64 {
    let (mut seen, mut whole) = (Complex::new(0.0, 0.0), Complex::new(0.0, 0.0));
    for ([x, y], value) in image.grid().iter().zip(image.values()) {
        let squared = (x - distance).powi(2) + y * y;
        let ring = Complex::cis(PI * (squared / SIDE as f64 % 2.0)) * (-0.5 * squared / (WINDOW * WINDOW)).exp();
        seen += (value - 0.5) * ring;
        whole += 0.5 * (PI * (squared / SIDE as f64 % 2.0)).cos() * ring;
    }
    seen.norm() / whole.norm()
}
