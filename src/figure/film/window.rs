//! A part of the film, and the samples that it needs.

use crate::error::Result;
use crate::figure::film::weights::{KERNEL, KERNELS, SEED, samples, terms};
use crate::figure::params::{Param, Params};
use crate::figure::picture::{frame, part, picture, tones};
use crate::figure::{Bar, Entry, Figure, Legend, Meaning, Tones};
use crate::film::Film;
use crate::grid::Grid;
use crate::image::Image;
use crate::kernel::Kernel;
use crate::kernel::catalog::by_name;
use crate::num::cos_pi;
use crate::residual::Residual;
use crate::text;
use crate::text::{Text, number};
use std::ops::Range;

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[WINDOW];

const WINDOW: Entry = Entry {
    id: "x-film-window",
    inventory: &["F56"],
    errata: &[],
    title: &Text::fixed("A window of the film, and the samples it needs", "Окно плёнки и нужные ему отсчёты"),
    caption: &Text::fixed(
        "To render a part of a picture one needs samples from farther out: as far as the filter of its border pixels \
         reaches. With that margin the window is the same as in the whole picture. Without it the pixels at its border are \
         made of half of their samples, and tiles show seams.",
        "Чтобы посчитать часть картинки, нужны отсчёты и за её краем: насколько достаёт фильтр крайних пикселей. С таким \
         запасом окно совпадает с тем же местом целой картинки. Без него крайние пиксели собраны из половины своих \
         отсчётов, и между плитками видны швы.",
    ),
    params: &[Param::choice("kernel", &KERNEL, KERNELS), Param::count("seed", &SEED, 1, 1, 100)],
    build: |params| window(params),
};

fn window(params: &Params) -> Result<Figure> {
    let (kernel, seed) = (by_name(params.choice("kernel"))?, params.count("seed") as u64);
    let (width, height) = (24usize, 16usize);
    let (columns, rows) = (8i64..16, 5i64..11);
    let light = |x: f64, y: f64| 0.5 + 0.45 * cos_pi(0.02 * ((x - 4.0).powi(2) + (y - 3.0).powi(2)));
    let film = Film::new(Grid::pixels(width, height)?, &*kernel)?;
    let reach = film.reach() as i64;
    let whole = film.develop(&samples(-reach..width as i64 + reach, -reach..height as i64 + reach, 2, seed, light)?)?;
    let size = [columns.end - columns.start, rows.end - rows.start].map(|n| n as usize);
    let grid =
        Grid::cells(columns.start as f64..columns.end as f64, size[0], rows.start as f64..rows.end as f64, size[1])?;
    let small = Film::new(grid, &*kernel)?;
    let developed = |margin: i64| {
        let columns = columns.start - margin..columns.end + margin;
        small.develop(&samples(columns, rows.start - margin..rows.end + margin, 2, seed, light)?)
    };
    let (with, without) = (developed(reach)?, developed(0)?);
    let counted = |range: &Range<i64>| range.start as usize..range.end as usize;
    let same = part(whole.image(), counted(&columns), counted(&rows))?;
    let apart =
        |image: &Image| image.values().iter().zip(same.values()).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    let seam = without.image().with(&same, |a, b| a - b)?;

    let [x, y] = [&columns, &rows].map(|r| [r.start as f64, r.end as f64]);
    let margin = |[a, b]: [f64; 2], m: f64| [a - m, b + m];
    let radius = kernel.radius();
    // the filter stands on the centres of pixels
    let footprint = radius - 0.5;
    let all = picture("film", text!("film, window, margin", "плёнка, окно, запас"), whole.image());
    let all = all
        .legend(Legend::Above)
        .with(frame("window", Meaning::Samples, x, y).thick().label(text!("window", "окно")))
        .with(
            frame("margin", Meaning::Error, margin(x, footprint), margin(y, footprint))
                .thick()
                .dashed()
                .label(text!("its samples", "его отсчёты")),
        );
    let rounding = 2.0 * f64::EPSILON * terms(&*kernel, 2);
    let worst = apart(without.image());
    let inner = footprint <= 0.0;
    Ok(Figure::new(2)
        .heights([1.13, 1.0])
        .with(all)
        .with(picture("with", text!("with the margin", "с запасом"), with.image()))
        .with(picture("without", text!("without it", "без запаса"), without.image()))
        .with(
            tones(
                "seam",
                text!("what is wrong without it", "ошибка без запаса"),
                &seam.map(f64::abs),
                (0.0, 0.1),
                Tones::Data,
            )
            .bar(Bar::values(Text::EMPTY)),
        )
        .claim(
            text!(
                "with a margin of {} the window has the pixels of the whole picture",
                "с запасом {} пиксели окна те же, что в целой картинке",
                number(footprint.max(0.0), 3)
            ),
            // the sums are taken in the same order, from another first pixel
            Residual::at_most("window with margin − whole picture", apart(with.image()), 2.0 * rounding),
        )
        .claim(
            match inner {
                true => text!(
                    "this filter is no wider than a pixel: no margin is needed",
                    "этот фильтр не шире пикселя: запас не нужен"
                ),
                false => text!(
                    "without it pixels at the border are off by up to {}",
                    "без него пиксели у края ошибаются до {}",
                    number(worst, 2)
                ),
            },
            match inner {
                true => Residual::at_most("window without margin − whole picture", worst, 2.0 * rounding),
                // far more than rounding, or it would be no error
                false => Residual::at_least("error at the border, in roundings", worst / rounding, 1e6),
            },
        ))
}
