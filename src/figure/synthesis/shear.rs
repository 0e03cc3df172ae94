//! Motion and defocus are one thing: shears of the scene function, in space and in frequency (Durand and others 2005).

use crate::axis::Axis;
use crate::error::Result;
use crate::figure::params::{Param, Params};
use crate::figure::{Entry, Figure, Layer, Meaning, Panel, Scale, Tones};
use crate::grid::Grid;
use crate::image::dft::forward;
use crate::image::{Image, ImageBins};
use crate::laws::hold::uniform_transfer;
use crate::residual::Residual;
use crate::sampled::{Samples, dft};
use crate::scene::lens::ThinLens;
use crate::signal::gaussian::Gaussian;
use crate::signal::theorem::{Modulated, Scaled, Sum};
use crate::signal::{FourierPair, Signal};
use crate::text;
use crate::text::{Text, number};
use ndarray::Array2;
use std::f64::consts::PI;
use std::ops::Range;

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[SHEAR];

static SPEED: Text = Text::fixed("way of the bars in the shutter's time", "путь полос за время затвора");
static APERTURE: Text = Text::fixed("diameter of the lens", "диаметр линзы");

const SHEAR: Entry = Entry {
    id: "x-shear",
    inventory: &["F47"],
    errata: &[],
    title: &Text::fixed("Motion and defocus are shears", "Движение и расфокусировка — сдвиги"),
    caption: &Text::fixed(
        "Above: bars on the film, over the time or over the lens. What moves is slanted, v per time; what is out of focus \
         is slanted too, by the circle of confusion per lens. Below: a shear in space shears the spectrum the other way. \
         The mean over t or u keeps the row ν = 0 alone: the more slanted, the fewer frequencies are left in it.",
        "Вверху: полосы на плёнке в зависимости от времени или точки линзы. Движущееся наклонено на v за время затвора, \
         нерезкое — на кружок нерезкости за линзу. Внизу: спектр сдвинут в другую сторону. Среднее по t или u оставляет \
         лишь строку ν = 0: чем сильнее наклон, тем меньше в ней частот.",
    ),
    params: &[Param::real("v", &SPEED, 0.7, -0.8, 0.8, ""), Param::real("A", &APERTURE, 0.6, 0.1, 0.8, "")],
    build: |params| shear(params),
};

/// Cells of a slice, across and over the open shutter or the whole lens.
const CELLS: usize = 128;
/// The width of the bars' envelope, and their frequency.
const WIDTH: f64 = 0.2;
const BARS: f64 = 9.0;
/// Frequencies shown on either axis.
const SHOWN: f64 = 16.0;

/// A few bars: `½(1 + cos 2πkx)` under a Gaussian.
fn bars() -> Result<impl FourierPair> {
    let envelope = Gaussian::new(WIDTH)?;
    Scaled::new(0.5, Sum(envelope, Modulated::new(BARS, envelope)?))
}

/// A slice of the scene function: `x` on the film over `−1 … 1` and the other coordinate, `−½ … ½` of a shutter's time or
/// a lens; zero beyond, where the shutter is closed and the lens at its end.
struct Slice {
    image: Image,
    bins: ImageBins,
    slope: f64,
}

impl Slice {
    /// Of what `seen(x, s)` says; `slope` is what the shear should be.
    fn of(slope: f64, seen: impl Fn(f64, f64) -> f64) -> Result<Self> {
        let grid = Grid::cells(-1.0..1.0, CELLS, -1.0..1.0, 2 * CELLS)?;
        let open = |x: f64, s: f64| if s.abs() < 0.5 { seen(x, s) } else { 0.0 };
        let image = Image::new(grid, grid.iter().map(|[x, s]| open(x, s)).collect())?;
        Ok(Self { bins: forward(&image), image, slope })
    }

    fn open(&self) -> Array2<f64> {
        part_of(&self.image, 0..CELLS, CELLS / 2..CELLS / 2 + CELLS)
    }

    /// Decibels of the spectrum around zero.
    fn spectrum(&self) -> Result<Array2<f64>> {
        let view = self.bins.log_magnitude(-40.0)?;
        let part = |axis: Axis| {
            let half = (SHOWN / axis.step()) as usize;
            axis.len() / 2 - half..axis.len() / 2 + half + 1
        };
        let (x, y) = (part(self.bins.grid().x()), part(self.bins.grid().y()));
        Ok(part_of(&view, x, y))
    }

    /// The law of the shear: `G(ν_x)` on the line `ν_s = −slope·ν_x`, spread by the end of the shutter to `D(ν_s + slope·ν_x)`,
    /// the transfer of the slice's rows.
    fn sheared(&self, bars: &impl FourierPair, name: &'static str) -> Residual {
        let spectrum = bars.spectrum();
        let transfer = |w: f64| uniform_transfer(CELLS as u32, w);
        let theory = |nu: [f64; 2]| spectrum.density(nu[0]) * transfer(nu[1] + self.slope * nu[0]);
        let shown = self.bins.grid().iter().zip(self.bins.values()).filter(|(nu, _)| nu[0].abs() <= SHOWN);
        let worst = shown.map(|(nu, value)| (value - theory(nu)).norm()).fold(0.0, f64::max);
        // what the envelope leaves beyond the ends of the slice, twice; what it leaves beyond the first copy in frequency; and
        // the rounding of a transform of that many values of a sum of one hundredth and less
        let clear = 1.0 - 0.5 * self.slope.abs();
        let rate = 0.5 * CELLS as f64;
        let tail = 2.0 * (-PI * (clear / WIDTH).powi(2)).exp();
        let copy = (-PI * (WIDTH * (rate - SHOWN - BARS)).powi(2)).exp();
        let rounding = 16.0 * f64::EPSILON * (2.0 * (CELLS * CELLS) as f64).log2() * 2.0;
        Residual::at_most(name, worst, tail + copy + rounding)
    }
}

/// Some columns and rows of an image.
fn part_of(image: &Image, x: Range<usize>, y: Range<usize>) -> Array2<f64> {
    Array2::from_shape_fn((y.len(), x.len()), |(j, i)| image.at(x.start + i, y.start + j))
}

/// What distinguishes one column of the figure.
struct Column {
    names: [&'static str; 2],
    title: Text,
    other: [&'static str; 2],
    slice: Slice,
}

impl Column {
    fn slice_panel(&self) -> Panel {
        let label = |name: &'static str| Text::same(name);
        Panel::new(
            self.names[0],
            self.title.clone(),
            Scale::linear(label("x"), -1.0, 1.0),
            Scale::linear(label(self.other[0]), -0.5, 0.5),
        )
        .with(Layer::raster("slice", (-1.0, 1.0), (-0.5, 0.5), self.slice.open(), (0.0, 1.0), Tones::Grey))
    }

    fn spectrum_panel(&self) -> Result<Panel> {
        let edge = SHOWN + 0.25;
        let slope = self.slice.slope;
        let reach = (SHOWN / slope.abs().max(1.0)).min(SHOWN);
        let line = [[-reach, slope * reach], [reach, -slope * reach]];
        Ok(Panel::new(
            self.names[1],
            text!("its spectrum", "его спектр"),
            Scale::linear(Text::same("ν_{x}"), -edge, edge),
            Scale::linear(Text::same(self.other[1]), -edge, edge),
        )
        .with(Layer::raster("spectrum", (-edge, edge), (-edge, edge), self.slice.spectrum()?, (0.0, 1.0), Tones::Data))
        .with(Layer::line("sheared", Meaning::Leaked, line).dashed()))
    }
}

fn shear(params: &Params) -> Result<Figure> {
    let (speed, aperture) = (params.real("v"), params.real("A"));
    let bars = bars()?;
    // the film at the distance one, in focus at three; a thing in front, one there, and one far behind
    let lens = ThinLens::new(1.0, 3.0, aperture)?;
    let [near, far] = [1.0, 1e6];
    let seen = |z: f64, x: f64, s: f64| {
        let [from, to] = lens.from_film([x, 0.0], [aperture * s, 0.0]);
        // where the ray meets the plane at z, in units of the picture of that plane
        let place = from[0] + (to[0] - from[0]) * z / to[2];
        bars.at(place * lens.film() / z)
    };
    let out_of_focus = |z: f64| Slice::of(aperture * lens.shear(z), |x, s| seen(z, x, s));
    let columns = [
        Column {
            names: ["motion", "motion-spectrum"],
            title: text!("moving: (x, t)", "движение: (x, t)"),
            other: ["t", "ν_{t}"],
            slice: Slice::of(speed, |x, t| bars.at(x - speed * t))?,
        },
        Column {
            names: ["focus", "focus-spectrum"],
            title: text!("in focus: (x, u)", "в фокусе: (x, u)"),
            other: ["u", "ν_{u}"],
            slice: out_of_focus(lens.focus())?,
        },
        Column {
            names: ["near", "near-spectrum"],
            title: text!("too near: (x, u)", "близко: (x, u)"),
            other: ["u", "ν_{u}"],
            slice: out_of_focus(near)?,
        },
        Column {
            names: ["far", "far-spectrum"],
            title: text!("too far: (x, u)", "далеко: (x, u)"),
            other: ["u", "ν_{u}"],
            slice: out_of_focus(far)?,
        },
    ];
    let mut figure = columns.iter().fold(Figure::new(4), |figure, column| figure.with(column.slice_panel()));
    for column in &columns {
        figure = figure.with(column.spectrum_panel()?);
    }
    let [motion, focus, near_slice, far_slice] = columns.each_ref().map(|column| &column.slice);
    Ok(figure
        .claim(
            text!(
                "moving by {}: the spectrum lies on ν_{{t}} = −{}·ν_{{x}}",
                "движение на {}: спектр лежит на ν_{{t}} = −{}·ν_{{x}}",
                number(speed, 3),
                number(speed, 3)
            ),
            motion.sheared(&bars, "spectrum of the moving bars, sheared by their way"),
        )
        .claim(
            text!("in focus nothing is slanted", "в фокусе наклона нет"),
            focus.sheared(&bars, "spectrum of the bars in focus, not sheared"),
        )
        .claim(
            text!(
                "too near: slanted by the circle of confusion, {}",
                "слишком близко: наклон равен кружку нерезкости, {}",
                number(lens.circle_of_confusion(near), 3)
            ),
            near_slice.sheared(&bars, "spectrum of the bars too near, sheared by their circle of confusion"),
        )
        .claim(
            text!(
                "too far: by {}, the other way",
                "слишком далеко: на {}, в другую сторону",
                number(lens.circle_of_confusion(far), 3)
            ),
            far_slice.sheared(&bars, "spectrum of the bars too far, sheared by their circle of confusion"),
        )
        .claim(
            text!(
                "the mean over t is the row ν_{{t}} = 0 of the spectrum",
                "среднее по t — это строка ν_{{t}} = 0 спектра"
            ),
            blurred(motion)?,
        ))
}

/// The mean over the shutter, transformed, against the row of the slice's spectrum at zero.
fn blurred(slice: &Slice) -> Result<Residual> {
    let open = slice.open();
    let mean = open
        .rows()
        .into_iter()
        .fold(vec![0.0; CELLS], |sum: Vec<f64>, row| sum.iter().zip(row).map(|(a, b)| a + b / CELLS as f64).collect());
    let record = Samples::new(Axis::cells(-1.0..1.0, CELLS)?, mean)?;
    let bins = dft::forward(&record);
    let row = slice.bins.values().row(CELLS);
    let worst = bins.values().iter().zip(row).map(|(a, b)| (a - b).norm()).fold(0.0, f64::max);
    let bound = 16.0 * f64::EPSILON * (2.0 * (CELLS * CELLS) as f64).log2();
    Ok(Residual::at_most("spectrum of the mean over t = the row at zero", worst, bound))
}
