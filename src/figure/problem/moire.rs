//! Moiré: the zone plate and its ghosts (slide «Проблемы сэмплирования в компьютерной графике»).

use crate::error::Result;
use crate::field::zone_plate::ZonePlate;
use crate::figure::common::values;
use crate::figure::params::{Param, Params};
use crate::figure::picture::{circles, picture};
use crate::figure::{Entry, Figure, Layer, Legend, Meaning, Panel, Scale};
use crate::grid::Grid;
use crate::image::Image;
use crate::num::sinc;
use crate::nyquist::fold;
use crate::residual::Residual;
use crate::text;
use crate::text::{Text, number};
use num_complex::Complex;
use std::f64::consts::PI;

static PERIOD: Text =
    Text::fixed("distance M of the ghosts, in pixels", "расстояние M между ложными центрами, пиксели");

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[MOIRE];

const MOIRE: Entry = Entry {
    id: "f03-moire",
    inventory: &["F03"],
    errata: &["E13"],
    title: &Text::fixed("Sampling problems: moiré", "Проблемы сэмплирования: муар"),
    caption: &Text::fixed(
        "Rings whose frequency grows as r/M. Sampled once a pixel they repeat exactly with the period M: of the nine \
         centres only the one in the middle exists. The mean over the pixel's area weakens the ghosts, by sinc of the \
         frequency, but does not remove them: it is a box filter, not an ideal one.",
        "Кольца, частота которых растёт как r/M. При одном отсчёте на пиксель картинка в точности повторяется с периодом M: из \
         девяти центров существует только средний. Среднее по площади пикселя ослабляет ложные центры в sinc раз, но не \
         убирает: это прямоугольный фильтр, а не идеальный.",
    ),
    params: &[Param::choice("M", &PERIOD, &["64", "48", "80", "96"])],
    build: moire,
};

/// Pixels across and down.
const SIDE: usize = 192;

fn moire(params: &Params) -> Result<Figure> {
    let name = params.choice("M");
    let period: u32 = name.parse().map_err(|_| crate::error::Error::Unreadable {
        what: "the period of a zone plate".into(),
        given: name.into(),
        wanted: "a whole number",
    })?;
    let m = f64::from(period);
    let plate = ZonePlate::new(m)?;
    let grid = Grid::centered(1.0, SIDE, SIDE)?;
    let (point, area) = (Image::of(&plate, grid), Image::averaged(&plate, grid));
    let half = 0.5 * SIDE as f64;

    let order = (half / m) as i64;
    let around = (-order..=order).flat_map(|l| (-order..=order).map(move |k| [k, l]));
    let ghosts: Vec<[f64; 2]> = around.filter(|c| *c != [0, 0]).map(|c| c.map(|k| m * k as f64)).collect();
    let marked = |panel: Panel| {
        panel
            .with(circles("ghosts", Meaning::Leaked, 0.2 * m, &ghosts).thick())
            .with(circles("center", Meaning::Signal, 0.2 * m, &[[0.0, 0.0]]).thick())
    };
    let along = Scale::linear(text!("distance from the centre, r/M", "расстояние от центра, r/M"), 0.0, 1.6);
    let frequencies = Panel::new(
        "frequencies",
        text!("frequency along a radius", "частота вдоль радиуса"),
        along,
        values("", 0.0, 1.6),
    )
    .span(2)
    .legend(Legend::Above)
    .with(Layer::curve("true", Meaning::Signal, 0.0, 1.6, 2, |r| r).label(text!("true, r/M", "истинная, r/M")))
    .with(
        Layer::curve("seen", Meaning::Leaked, 0.0, 1.6, 320, |r| fold(r, 1.0)).thick().label(text!("seen", "видимая")),
    )
    .with(
        Layer::curve("gain", Meaning::Kernel, 0.0, 1.6, 320, |r| sinc(r).abs())
            .dashed()
            .label(text!("area keeps |sinc|", "площадь: |sinc|")),
    );

    let shifted = period as usize;
    let repeats = |i: usize, j: usize| {
        let across = (point.at(i + shifted, j) - point.at(i, j)).abs();
        across.max((point.at(j, i + shifted) - point.at(j, i)).abs())
    };
    let apart = (0..SIDE).flat_map(|j| (0..SIDE - shifted).map(move |i| (i, j))).map(|(i, j)| repeats(i, j));
    let apart = apart.fold(0.0, f64::max);
    // beside e^{iπr²/M} itself, the mean over a pixel has its amplitude times sinc(x/M)·sinc(y/M)
    let predicted = |[x, y]: [f64; 2]| {
        let ring = Complex::cis(PI * ((x * x + y * y) / m % 2.0));
        0.5 + 0.5 * ring.re * sinc(x / m) * sinc(y / m)
    };
    let off = grid.iter().zip(area.values()).map(|(at, v)| (v - predicted(at)).abs()).fold(0.0, f64::max);
    // π·r²/M with r² ≤ 2·half², rounded three times
    let rounding = 4.0 * f64::EPSILON * (1.0 + PI * 2.0 * half * half / m);
    Ok(Figure::new(2)
        .heights([1.27, 1.0])
        .with(marked(picture("point", text!("1 sample a pixel", "1 отсчёт на пиксель"), &point)))
        .with(marked(picture("area", text!("mean over the area", "среднее по площади"), &area)))
        .with(frequencies)
        .claim(
            text!(
                "the samples repeat exactly after {} pixels across and down: {} ghosts are in the picture",
                "отсчёты в точности повторяются с периодом M = {} по обеим осям; ложных центров на картинке: {}",
                number(m, 3),
                ghosts.len()
            ),
            Residual::at_most("samples of the zone plate have the period M", apart, rounding),
        )
        .claim(
            text!(
                "the mean over a pixel multiplies the rings by sinc(x/M)·sinc(y/M): {} is left at 0.9 of the rate",
                "среднее по пикселю умножает кольца на sinc(x/M)·sinc(y/M): на 0,9 частоты дискретизации остаётся {}",
                number(sinc(0.9), 4)
            ),
            // within a pixel the rings are not quite a grating: the mean of |e^{iπt²/M} − 1| ≤ πt²/M over −½ … ½ is
            // π/(12M) along each axis, and the rings have the amplitude ½
            Residual::at_most("area mean = sinc·sinc of the local frequency", off, PI / (12.0 * m) + rounding),
        ))
}
