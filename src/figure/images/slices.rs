//! Projections and slices (V31; Bracewell 1956): how tomographs see.

use crate::axis::Axis;
use crate::error::Result;
use crate::field::added::Added;
use crate::field::moved::Moved;
use crate::field::spot::GaussianSpot;
use crate::field::{FourierField, from_fn};
use crate::figure::common::PIECES;
use crate::figure::images::view::picture;
use crate::figure::params::Param;
use crate::figure::{Bar, Entry, Figure, Layer, Legend, Meaning, Panel, Scale, Tones};
use crate::grid::Grid;
use crate::image::Image;
use crate::image::projection::line_integral;
use crate::laws::plane::projection_slice;
use crate::laws::poisson::sum_rounding;
use crate::residual::Residual;
use crate::sampled::dft;
use crate::sampled::{Bins, Samples};
use crate::text;
use crate::text::{Text, number};
use std::f64::consts::PI;

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[SLICE];

static ANGLE: Text =
    Text::fixed("direction θ of the projection's axis, in degrees", "направление θ оси проекции, в градусах");

const SLICE: Entry = Entry {
    id: "x-projection-slice",
    inventory: &[],
    errata: &[],
    title: &Text::fixed("A projection's spectrum is a slice", "Спектр проекции есть сечение спектра"),
    caption: &Text::fixed(
        "The picture is summed along parallel lines; what is left is a function of the position s across them. Its \
         one-dimensional spectrum is the slice of the picture's spectrum through zero in the direction of s. Projections from \
         all sides therefore know the whole spectrum, and with it the picture: that is tomography.",
        "Картинку просуммировали вдоль параллельных прямых; осталась функция положения s поперёк них. Её одномерный спектр — \
         сечение спектра картинки через нуль в направлении s. Поэтому проекции со всех сторон знают весь спектр, а с ним и \
         картинку: это томография.",
    ),
    params: &[Param::real("angle", &ANGLE, 30.0, -90.0, 90.0, "°")],
    build: |params| slice(params.real("angle")),
};

/// Places of the projection, a quarter of a unit apart: ±16, outside which the spots are below 10⁻¹⁰.
const SIDE: usize = 128;
/// Pixels along a side of the picture: ±11.25.
const PICTURE: usize = 90;
const STEP: f64 = 0.25;
/// The highest frequency shown.
const SHOWN: f64 = 0.6;

/// Three spots of different sizes, shapes and directions.
fn spots() -> Result<impl FourierField> {
    let spot = |at: [f64; 2], radii: [f64; 2], angle: f64| Moved::new(at, GaussianSpot::turned(radii, angle)?);
    Ok(Added(
        Added(spot([-3.5, 2.5], [1.2, 2.2], 0.4)?, spot([3.0, 3.0], [1.0, 1.0], 0.0)?),
        spot([1.0, -3.5], [2.4, 1.1], 0.3)?,
    ))
}

fn slice(angle: f64) -> Result<Figure> {
    let field = spots()?;
    let spectrum = field.spectrum();
    let (sin, cos) = angle.to_radians().sin_cos();
    let degrees = number(angle, 3);
    let image = Image::of(&field, Grid::centered(STEP, PICTURE, PICTURE)?);

    let axis = Axis::centered(STEP, SIDE)?;
    let lines: Vec<_> = axis.iter().map(|s| line_integral(&field, angle.to_radians(), s, 16.0, 1.0)).collect();
    let missed = axis.step() * lines.iter().map(|line| line.error).sum::<f64>();
    let projection = Samples::new(axis, lines.iter().map(|line| line.value).collect())?;
    let bins: Bins = dft::forward(&projection);

    // two of the lines that are summed along, and the axis across them
    let end = 9.5;
    let place = |s: f64, t: f64| [s * cos - t * sin, s * sin + t * cos];
    let along = [-6.0, -3.0, 0.0, 3.0, 6.0].into_iter().flat_map(|s| [place(s, -end), place(s, end), [f64::NAN; 2]]);
    let space = picture("picture", text!("the picture", "картинка"), &image, (0.0, 1.1))
        .with(Layer::line("lines", Meaning::Series(3), along).thin())
        .with(Layer::pointers("axis", Meaning::Reconstructed, [[place(-end, 0.0), place(end, 0.0)]]).thick());
    let top = 1.12 * projection.values().iter().copied().fold(0.0, f64::max);
    let summed = Panel::new(
        "projection",
        text!("its projection at {degrees}°", "её проекция под {degrees}°"),
        Scale::linear(Text::same("s"), -10.0, 10.0),
        Scale::linear(Text::EMPTY, 0.0, top),
    )
    .with(Layer::line("projection", Meaning::Reconstructed, projection.points()).thick());

    let peak = spectrum.density(0.0, 0.0).norm();
    let view = Image::of(
        &from_fn(|u, v| spectrum.density(u, v).norm() / peak),
        Grid::cells(-SHOWN..SHOWN, 90, -SHOWN..SHOWN, 90)?,
    );
    let scale = || Scale::linear(Text::EMPTY, -SHOWN, SHOWN);
    let frequency = Panel::new("spectrum", text!("its spectrum |F|", "её спектр |F|"), scale(), scale())
        .square()
        .with(Layer::raster(
            "spectrum",
            (-SHOWN, SHOWN),
            (-SHOWN, SHOWN),
            view.pixels().clone(),
            (0.0, 1.0),
            Tones::Data,
        ))
        .bar(Bar::values(Text::EMPTY))
        .with(
            Layer::pointers(
                "axis",
                Meaning::Reconstructed,
                [[[-0.95 * SHOWN * cos, -0.95 * SHOWN * sin], [0.95 * SHOWN * cos, 0.95 * SHOWN * sin]]],
            )
            .thick(),
        );
    let of_line = bins.axis().iter().zip(bins.values()).filter(|(nu, _)| nu.abs() <= SHOWN);
    let cut = |nu: f64| spectrum.density(nu * cos, nu * sin);
    let same = Panel::new(
        "slice",
        text!("the slice, and the projection's", "сечение и спектр проекции"),
        Scale::linear(Text::same("ν"), -SHOWN, SHOWN),
        Scale::linear(Text::EMPTY, 0.0, 1.12),
    )
    .legend(Legend::UpperRight)
    .with(
        Layer::curve("slice", Meaning::Theory, -SHOWN, SHOWN, PIECES, |nu| cut(nu).norm() / peak)
            .label(text!("slice", "сечение")),
    )
    .with(
        Layer::dots("transform", Meaning::Reconstructed, of_line.map(|(nu, f)| [nu, f.norm() / peak]))
            .label(text!("of the projection", "от проекции")),
    );

    let worst = bins.axis().iter().zip(bins.values()).map(|(nu, f)| (f - cut(nu)).norm()).fold(0.0, f64::max);
    let size = axis.step() * projection.values().iter().map(|v| v.abs()).sum::<f64>();
    // every spot is at least 11.7 from the ends and at most 2.4 wide; beyond the ends, and beyond the Nyquist frequency 2,
    // there is less than this of its volume
    let tail = 3.0 * PI * 2.4 * 2.4 * ((-(11.7f64 / 2.4).powi(2)).exp() + (-4.0 * PI * PI).exp());
    Ok(Figure::new(2)
        .with(space)
        .with(summed)
        .with(frequency)
        .with(same)
        .claim(
            text!(
                "the spectrum of the projection at {degrees}° is the slice of the spectrum at {degrees}°",
                "спектр проекции под {degrees}° есть сечение спектра под {degrees}°"
            ),
            Residual::at_most(
                "transform of the line integrals = slice at their angle",
                worst,
                missed + sum_rounding(SIDE, size) + tail,
            ),
        )
        .claim(
            text!(
                "summing the pixels of every column gives the row v = 0, exactly",
                "суммы пикселей по столбцам дают в точности строку v = 0"
            ),
            projection_slice(&image, 0),
        ))
}
