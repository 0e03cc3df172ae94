//! Exact area is a box prefilter: what it leaves of the ghosts (E13).

use crate::axis::{Axis, Edge};
use crate::error::Result;
use crate::field::zone_plate::ZonePlate;
use crate::figure::images::view::picture;
use crate::figure::params::Param;
use crate::figure::{Entry, Figure, Layer, Legend, Meaning, Panel, Scale};
use crate::grid::Grid;
use crate::image::Image;
use crate::image::resize::resample;
use crate::kernel::Kernel;
use crate::kernel::lanczos::Lanczos;
use crate::laws::coverage::dimmed_ghosts;
use crate::num::quadrature::{even_breaks, integrate_pieces};
use crate::num::{cos_pi, sinc};
use crate::residual::Residual;
use crate::signal::Signal;
use crate::text;
use crate::text::{Text, number};
use std::f64::consts::PI;

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[AREA];

static PERIOD: Text = Text::fixed("where the ghost stands, in pixels", "где стоит ложный центр, в пикселях");

const AREA: Entry = Entry {
    id: "x-area-ghosts",
    inventory: &[],
    errata: &["E13"],
    title: &Text::fixed(
        "Exact area dims ghosts and leaves them",
        "Точная площадь ослабляет ложные центры, но не убирает",
    ),
    caption: &Text::fixed(
        "A zone plate with its centre on the left; where its rings pass half a period per pixel a perfect picture is grey. \
         One point per pixel shows the ghost as strong as the true centre. The exact area of every pixel is a box \
         prefilter: sinc ν of the contrast is left, 0.64 at ν = ½, 0.11 at 0.9, 0.22 again at 1.43. A Lanczos prefilter \
         leaves next to nothing.",
        "Зонная пластинка с центром слева; где её кольца чаще половины периода на пиксель, идеальная картинка серая. Одна \
         точка на пиксель даёт ложный центр той же силы, что настоящий. Точная площадь пикселя есть предфильтр box: от \
         контраста остаётся sinc ν — 0,64 при ν = ½, 0,11 при 0,9 и снова 0,22 при 1,43. Предфильтр Ланцоша не оставляет \
         почти ничего.",
    ),
    params: &[Param::count("M", &PERIOD, 64, 48, 72)],
    build: |params| area(params.count("M")),
};

/// Pixels along a side, and how many of them stand left of the true centre.
const SIDE: usize = 128;
const LEFT: usize = 32;
/// How many points a pixel has each way for the Lanczos prefilter, and how many pixels it needs beyond the border.
const FINER: usize = 4;
const BORDER: usize = 8;
/// The half height and the width of the blocks in which contrast is measured.
const BLOCK: (i64, usize) = (4, 6);

/// The wave of the zone plate at a pixel: cos(πr²/M).
fn wave(period: f64, [x, y]: [f64; 2]) -> f64 {
    cos_pi((x * x + y * y) / period)
}

/// Pixels with their places, that a test of the place lets in.
fn within(image: &Image, inside: impl Fn([f64; 2]) -> bool) -> impl Iterator<Item = ([f64; 2], f64)> {
    image.grid().iter().zip(image.values()).filter(move |(p, _)| inside(*p)).map(|(p, v)| (p, v - 0.5))
}

/// The blocks along the middle row: the first `x` of each.
fn blocks() -> impl Iterator<Item = f64> {
    (4..SIDE - LEFT - BLOCK.1).step_by(BLOCK.1).map(|x| x as f64)
}

fn in_block(first: f64, [x, y]: [f64; 2]) -> bool {
    (first..first + BLOCK.1 as f64).contains(&x) && y.abs() <= BLOCK.0 as f64
}

/// One way to a picture of the zone plate, and its gain for a wave.
struct Way<'a> {
    name: &'static str,
    title: Text,
    label: Text,
    image: &'a Image,
    gain: &'a dyn Fn(f64) -> f64,
}

impl Way<'_> {
    /// The contrast of the rings in a block: how much of `½cos` the pixels hold, by least squares. With it what the gain at
    /// the local frequency makes of it, and by how much it may err where every pixel errs by one.
    fn contrast(&self, period: f64, first: f64) -> [f64; 3] {
        let (mut held, mut known, mut norm, mut size) = (0.0, 0.0, 0.0, 0.0);
        for (place, v) in within(self.image, |p| in_block(first, p)) {
            let half = 0.5 * wave(period, place);
            held += v * half;
            known += (self.gain)(place[0] / period) * (self.gain)(place[1] / period) * half * half;
            norm += half * half;
            size += half.abs();
        }
        [held, known, size].map(|sum| sum / norm)
    }

    /// The largest difference of the contrast to the gain, in units of what pixels that err by `each` allow.
    fn worst(&self, period: f64, each: f64) -> f64 {
        let off = blocks().map(|first| {
            let [held, known, size] = self.contrast(period, first);
            (held - known).abs() / (size * (each + 16.0 * f64::EPSILON * period))
        });
        off.fold(0.0, f64::max)
    }

    /// What [`ghost`] finds if every pixel has the gain at its local frequency.
    fn ghost_expected(&self, period: f64) -> Result<f64> {
        let grid = self.image.grid();
        let gains = |axis: Axis| axis.iter().map(|x| (self.gain)(x / period)).collect::<Vec<_>>();
        let (across, up) = (gains(grid.x()), gains(grid.y()));
        let products = up.iter().flat_map(|v| across.iter().map(move |u| u * v));
        let modelled = grid.iter().zip(products).map(|(place, gain)| 0.5 + 0.5 * gain * wave(period, place));
        Ok(ghost(&Image::new(grid, modelled.collect())?, period))
    }
}

/// The root mean square contrast around the ghost, where the local frequency is between 0.75 and 1.25.
fn ghost(image: &Image, period: f64) -> f64 {
    let near = |[x, y]: [f64; 2]| (0.75 * period..=1.25 * period).contains(&x) && y.abs() <= 0.25 * period;
    let (mut sum, mut norm) = (0.0, 0.0);
    for (place, v) in within(image, near) {
        sum += v * v;
        norm += (0.5 * wave(period, place)).powi(2);
    }
    (sum / norm).sqrt()
}

fn area(period: usize) -> Result<Figure> {
    let period = period as f64;
    let plate = ZonePlate::new(period)?;
    let kernel = Lanczos::new(3.0)?;
    let pixels = |first: f64, n: usize| Axis::new(first, 1.0, n);
    let (left, low) = (-(LEFT as f64), -0.5 * SIDE as f64);
    let grid = Grid::new(pixels(left, SIDE)?, pixels(low, SIDE)?)?;
    let fine = |first: f64| {
        let part = 1.0 / FINER as f64;
        Axis::new(first - 0.5 + 0.5 * part - BORDER as f64, part, FINER * (SIDE + 2 * BORDER))
    };
    let point = Image::of(&plate, grid);
    let exact = Image::averaged(&plate, grid);
    let filtered = resample(&Image::of(&plate, Grid::new(fine(left)?, fine(low)?)?), grid, &kernel, Edge::Clamp)?;

    let lanczos = |nu: f64| kernel.response(nu);
    let way = |name, title, label, image, gain| Way { name, title, label, image, gain };
    let ways = [
        way("point", text!("one point", "одна точка"), Text::same("1"), &point, &|_| 1.0),
        way("area", text!("exact area", "точная площадь"), Text::same("sinc ν"), &exact, &sinc),
        way(
            "lanczos",
            text!("Lanczos prefilter", "предфильтр Ланцоша"),
            text!("Lanczos-3", "Ланцош-3"),
            &filtered,
            &lanczos,
        ),
    ];
    let end = (SIDE - LEFT) as f64 / period;
    let mut plot = Panel::new(
        "contrast",
        text!("contrast of the rings to the right of the centre", "контраст колец справа от центра"),
        Scale::linear(
            text!("local frequency ν, periods per pixel", "местная частота ν, периодов на пиксель"),
            0.0,
            end,
        ),
        Scale::linear(Text::EMPTY, -0.3, 1.15),
    )
    .span(3)
    .legend(Legend::Above)
    .with(
        Layer::spans("false", Meaning::Leaked, [[0.5, end]])
            .label(text!("above ½: all that is left is false", "выше ½: всё, что осталось, ложно")),
    );
    let mut figure = Figure::new(3).heights([1.25, 1.0]);
    for (i, way) in (0u8..).zip(&ways) {
        figure = figure.with(picture(way.name, way.title.clone(), way.image, (0.0, 1.0)));
        let dots = blocks().map(|first| {
            let middle = first + 0.5 * (BLOCK.1 as f64 - 1.0);
            [middle / period, way.contrast(period, first)[0]]
        });
        plot = plot
            .with(Layer::curve("theory", Meaning::Series(i), 0.0, end, 240, way.gain).label(way.label.clone()))
            .with(Layer::dots(way.name, Meaning::Series(i), dots.collect::<Vec<_>>()));
    }

    // within its reach the phase of a chirp departs from a plane wave by πt²/M: a prefilter errs by no more than that times
    // its size, in both directions, of the amplitude ½
    let bend = |size: f64, moment: f64| PI / period * size * moment;
    let steps = even_breaks(0.0, 3.0, 0.25);
    let part = |f: &dyn Fn(f64) -> f64| 2.0 * integrate_pieces(f, &steps, 1e-12).value;
    let (size, moment) = (part(&|t| kernel.at(t).abs()), part(&|t| kernel.at(t).abs() * t * t));
    let [shown, dimmed, gone] = [ghost(&point, period), ghost(&exact, period), ghost(&filtered, period)];
    let known = ways[1].ghost_expected(period)?;
    let behind = ways[2].ghost_expected(period)?;
    Ok(figure
        .with(plot)
        .claim(
            text!(
                "by points the ghost is as strong as the true centre",
                "по точкам ложный центр столь же силён, как настоящий"
            ),
            Residual::near("contrast of the ghost by points = 1", shown, 1.0, 64.0 * f64::EPSILON * period),
        )
        .claim(
            text!(
                "by exact area every pixel is ½ + ½cos·sinc·sinc: {} of the ghost is left",
                "по точной площади каждый пиксель равен ½ + ½cos·sinc·sinc: от ложного центра остаётся {}",
                number(dimmed, 2)
            ),
            dimmed_ghosts(&exact, period)?,
        )
        .claim(
            text!(
                "measured in blocks its contrast follows sinc ν",
                "измеренный по блокам, его контраст следует sinc ν"
            ),
            Residual::at_most(
                "contrast in every block = sinc·sinc, in units of what is allowed",
                ways[1].worst(period, bend(1.0, 1.0 / 12.0)),
                1.0,
            ),
        )
        .claim(
            text!(
                "a Lanczos prefilter leaves {} of the ghost",
                "предфильтр Ланцоша оставляет от ложного центра {}",
                number(gone, 1)
            ),
            // of a whole amplitude, twice the error of a half; the points stand four a pixel and alias beyond 3.5
            Residual::near("ghost behind Lanczos-3", gone, behind, 2.0 * bend(size, moment)),
        )
        .claim(
            text!(
                "that is less than a fifth of what exact area leaves",
                "это менее пятой доли того, что оставляет площадь"
            ),
            Residual::at_most("ghost behind Lanczos-3 ≤ ghost behind the area / 5", gone, 0.2 * known),
        ))
}
