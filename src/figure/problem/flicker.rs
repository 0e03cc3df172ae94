//! Small objects flicker (slide «Проблемы сэмплирования в компьютерной графике»).

use crate::error::Result;
use crate::field::Field;
use crate::field::disc::Disc;
use crate::field::flat::Flat;
use crate::figure::common::unmarked;
use crate::figure::params::{Param, Params};
use crate::figure::picture::{circles, picture};
use crate::figure::{Entry, Figure, Layer, Legend, Meaning, Panel, Scale, Tones};
use crate::grid::Grid;
use crate::image::Image;
use crate::num::{cos_pi, sin_pi};
use crate::residual::Residual;
use crate::text;
use crate::text::{Text, number};
use std::f64::consts::PI;

static RADIUS: Text = Text::fixed("radius r of the disc", "радиус r диска");

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[SMALL_OBJECTS];

const SMALL_OBJECTS: Entry = Entry {
    id: "f03-small-objects",
    inventory: &["F03"],
    errata: &[],
    title: &Text::fixed("Sampling problems: small objects flicker", "Проблемы сэмплирования: мерцание малых объектов"),
    caption: &Text::fixed(
        "A disc smaller than a pixel moves slowly: twelve frames. One sample a pixel hits it or misses it, with \
         probability πr², and it blinks between full brightness and nothing. The mean over the pixel's area spreads the \
         same light over the pixels that it touches, and the total never changes.",
        "Диск меньше пикселя медленно движется: двенадцать кадров. Единственный отсчёт пикселя попадает в него с \
         вероятностью πr², и диск мигает: полная яркость или ничего. Среднее по площади распределяет тот же свет по \
         задетым пикселям, и сумма не меняется.",
    ),
    params: &[Param::real("r", &RADIUS, 0.3, 0.15, 0.5, "px")],
    build: |params: &Params| small_objects(params.real("r")),
};

/// Frames of the strip, and the pixels of one, across and down.
const FRAMES: usize = 12;
const SIZE: [usize; 2] = [5, 4];
/// How many frames stand in a row of the strip.
const ROW: usize = 4;
/// How far the disc moves in a frame.
const STEP: [f64; 2] = [0.26, 0.06];
const START: [f64; 2] = [0.95, 1.25];

/// The disc in the frame of that number.
fn place(frame: usize) -> [f64; 2] {
    [0, 1].map(|axis| START[axis] + STEP[axis] * frame as f64)
}

fn total(image: &Image) -> f64 {
    image.values().iter().sum()
}

fn small_objects(radius: f64) -> Result<Figure> {
    let grid = Grid::pixels(SIZE[0], SIZE[1])?;
    let mut frames = Vec::with_capacity(FRAMES);
    for frame in 0..FRAMES {
        let disc = Disc::new(place(frame), radius)?;
        frames.push([Image::of(&disc, grid), Image::averaged(&disc, grid)]);
    }
    let totals = |way: usize| frames.iter().enumerate().map(move |(k, f)| [k as f64 + 1.0, total(&f[way])]);
    let along = Scale::linear(text!("frame", "кадр"), 0.5, FRAMES as f64 + 0.5);
    let area = PI * radius * radius;
    let level = text!("πr² = {}", "πr² = {}", number(area, 3));
    let light = Panel::new("light", text!("light of the frame", "свет кадра"), along, unmarked(0.0, 1.3))
        .span(2)
        .legend(Legend::Above)
        .with(Layer::stems("point", Meaning::Leaked, totals(0)).label(text!("1 sample a pixel", "1 отсчёт на пиксель")))
        .with(
            Layer::line("area", Meaning::Reconstructed, totals(1))
                .thick()
                .label(text!("mean over the area", "среднее по площади")),
        )
        .with(Layer::notes("level", Meaning::Reconstructed, [([FRAMES as f64 - 0.5, area + 0.25], level)]));

    // every place of the disc in its pixel, on a fine grid
    const PLACES: usize = 1000;
    let places = Grid::cells(-0.5..0.5, PLACES, -0.5..0.5, PLACES)?;
    let disc = Disc::new([0.0, 0.0], radius)?;
    let hits = places.iter().filter(|[x, y]| disc.at(*x, *y) > 0.5).count() as f64 / places.len() as f64;
    let blinks = totals(0).filter(|t| t[1] > 0.5).count();
    let apart = totals(1).map(|t| (t[1] - area).abs()).fold(0.0, f64::max);
    Ok(Figure::new(2)
        .heights([2.2, 1.0])
        .with(strip("point-frames", text!("1 sample a pixel", "1 отсчёт на пиксель"), &frames, 0, radius))
        .with(strip(
            "area-frames",
            text!("mean over the pixel's area", "среднее по площади пикселя"),
            &frames,
            1,
            radius,
        ))
        .with(light)
        .claim(
            text!(
                "a sample hits the disc with probability πr² = {}; here in {} frames of {}",
                "отсчёт попадает в диск с вероятностью πr² = {}; здесь в {} кадрах из {}",
                number(area, 4),
                blinks,
                FRAMES
            ),
            // cells on the boundary count wholly or not at all: a circle crosses at most 8rn + 4 of n² cells
            Residual::near(
                "hit probability = πr²",
                hits,
                area,
                (8.0 * radius * PLACES as f64 + 4.0) / (PLACES * PLACES) as f64,
            ),
        )
        .claim(
            text!(
                "averaged over areas every frame has the same light, {}",
                "при усреднении по площади свет всех кадров одинаков: {}",
                number(area, 4)
            ),
            // the pixels that the disc touches, each 16ε(1 + r) off
            Residual::at_most("total of area means = πr²", apart, 9.0 * 16.0 * f64::EPSILON * (1.0 + radius)),
        )
        .moving(motion(radius)?, 10))
}

/// The frames, row by row, the disc's true place drawn over each.
fn strip(name: &'static str, title: Text, frames: &[[Image; 2]], way: usize, radius: f64) -> Panel {
    // a pixel of paper between two frames
    let pitch = SIZE.map(|side| side + 1);
    let (width, height) = (ROW * pitch[0] - 1, FRAMES.div_ceil(ROW) * pitch[1] - 1);
    let corner = |k: usize| [(k % ROW * pitch[0]) as f64, (k / ROW * pitch[1]) as f64];
    let places: Vec<[f64; 2]> = (0..FRAMES).map(|k| [0, 1].map(|axis| place(k)[axis] + corner(k)[axis])).collect();
    let panel = Panel::new(name, title, unmarked(0.0, width as f64), unmarked(height as f64, 0.0)).square();
    let strip = frames.iter().enumerate().fold(panel, |panel, (k, frame)| {
        let ([x, y], [w, h]) = (corner(k), SIZE.map(|side| side as f64));
        let pixels = frame[way].pixels().clone();
        panel.with(Layer::raster("pixels", (x, x + w), (y, y + h), pixels, (0.0, 1.0), Tones::Grey))
    });
    strip.with(circles("disc", Meaning::Signal, radius, &places).thick())
}

/// Five discs on one slow circle, in as many pixels as fit: sampled beside averaged.
fn motion(radius: f64) -> Result<Vec<Figure>> {
    const LENGTH: usize = 30;
    const STARTS: [[f64; 2]; 5] = [[2.1, 2.3], [7.4, 1.9], [5.2, 4.7], [2.5, 7.6], [7.8, 7.1]];
    let grid = Grid::pixels(10, 10)?;
    let frame = |k: usize| {
        let turn = 2.0 * k as f64 / LENGTH as f64;
        let places = STARTS.map(|[x, y]| [x + 0.8 * cos_pi(turn), y + 0.8 * sin_pi(turn)]);
        let dark = Image::of(&Flat::new(0.0)?, grid);
        let mut images = [dark.clone(), dark];
        for place in places {
            let disc = Disc::new(place, radius)?;
            images = [
                images[0].with(&Image::of(&disc, grid), |a, b| a + b)?,
                images[1].with(&Image::averaged(&disc, grid), |a, b| a + b)?,
            ];
        }
        let [point, area] = images;
        let titles = [
            text!("1 sample a pixel: Σ = {:.2}", "1 отсчёт на пиксель: Σ = {:.2}", total(&point)),
            text!("pixel areas: Σ = {:.2}", "площадь пикселя: Σ = {:.2}", total(&area)),
        ];
        let [left, right] = titles;
        let over = |panel: Panel| panel.with(circles("discs", Meaning::Signal, radius, &places));
        Ok(Figure::new(2).with(over(picture("point", left, &point))).with(over(picture("area", right, &area))))
    };
    (0..LENGTH).map(frame).collect()
}
