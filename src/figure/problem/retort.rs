//! A silhouette with edges in all directions, after Don Mitchell's retort.

use crate::error::Result;
use crate::field::outline::Outline;
use crate::figure::params::{Param, Params};
use crate::figure::picture::{frame, picture};
use crate::figure::{Entry, Figure, Meaning, Panel};
use crate::grid::Grid;
use crate::image::Image;
use crate::residual::Residual;
use crate::text;
use crate::text::{Text, number};

static SHIFT: Text = Text::fixed("how far the retort is moved across", "сдвиг реторты по горизонтали");

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[RETORT];

const RETORT: Entry = Entry {
    id: "x-retort",
    inventory: &["F03"],
    errata: &["E14"],
    title: &Text::fixed("The retort: edges in all directions", "Реторта: границы всех направлений"),
    caption: &Text::fixed(
        "A silhouette like the retort with which Don Mitchell showed staircases. One sample a pixel is right inside and \
         outside and wrong wherever the outline runs; the stairs change their length along the neck, and the eye sees \
         that first. The mean over the pixel's area is exact for any polygon.",
        "Силуэт, подобный реторте, на которой Дон Митчелл показывал «лестницу». Один отсчёт на пиксель верен внутри и \
         снаружи и неверен всюду, где проходит контур; длина ступеней вдоль горла меняется, и глаз замечает это прежде \
         всего. Среднее по площади пикселя точно для любого многоугольника.",
    ),
    params: &[Param::real("shift", &SHIFT, 0.0, 0.0, 1.0, "px")],
    build: |params: &Params| retort(params.real("shift")),
};

/// Pixels of the picture, and the part that is enlarged.
const SIZE: (usize, usize) = (124, 84);
const PART: [[usize; 2]; 2] = [[76, 116], [22, 42]];

/// The outline: most of a circle, and a neck between two cubic curves.
fn silhouette(shift: f64) -> Result<Outline> {
    let (middle, radius) = ([35.0 + shift, 54.0], 25.0);
    let (from, to) = ((-32.0f64).to_radians(), 258.0f64.to_radians());
    let on = |t: f64| [middle[0] + radius * t.cos(), middle[1] + radius * t.sin()];
    let bulb = (0..=80).map(|i| on(from + (to - from) * f64::from(i) / 80.0));
    let bend = |p: [[f64; 2]; 4]| {
        (1..40).map(move |i| {
            let t = f64::from(i) / 40.0;
            let weights = [(1.0 - t).powi(3), 3.0 * t * (1.0 - t).powi(2), 3.0 * t * t * (1.0 - t), t.powi(3)];
            [0, 1].map(|axis| p.iter().zip(weights).map(|(p, w)| w * p[axis]).sum::<f64>())
        })
    };
    let tip = [[118.0 + shift, 58.2], [114.6 + shift, 60.6]];
    let upper = bend([on(to), [44.0 + shift, 2.0], [76.0 + shift, 8.0], tip[0]]);
    let lower = bend([tip[1], [78.0 + shift, 23.0], [63.0 + shift, 26.0], on(from)]);
    let vertices: Vec<[f64; 2]> = bulb.chain(upper).chain(tip).chain(lower).collect();
    Outline::new(&vertices)
}

fn retort(shift: f64) -> Result<Figure> {
    let outline = silhouette(shift)?;
    let grid = Grid::pixels(SIZE.0, SIZE.1)?;
    let (point, area) = (Image::of(&outline, grid), Image::averaged(&outline, grid));
    let [[x0, x1], [y0, y1]] = PART;
    let part = Grid::cells(x0 as f64..x1 as f64, x1 - x0, y0 as f64..y1 as f64, y1 - y0)?;
    // dark glass before a white wall
    let shown = |image: &Image| image.map(|v| 1.0 - v);
    let corners = PART.map(|side| side.map(|v| v as f64));
    let marked = |panel: Panel| panel.with(frame("part", Meaning::Leaked, corners[0], corners[1]).thick());
    let total = |image: &Image| image.values().iter().sum::<f64>();

    let crossed = area.values().iter().filter(|v| **v > 0.0 && **v < 1.0).count();
    let pairs = point.values().iter().zip(area.values());
    let elsewhere = pairs.filter(|(_, v)| **v == 0.0 || **v == 1.0).map(|(p, v)| (p - v).abs()).fold(0.0, f64::max);
    let error = point.rmse(&area)?;
    // a picture of means, each off by 4nε(1 + extent)
    let rounding = 4.0 * f64::EPSILON * outline.vertices().len() as f64 * (1.0 + SIZE.0 as f64) * crossed as f64;
    Ok(Figure::new(2)
        .heights([1.35, 1.0])
        .with(marked(picture("point", text!("1 sample a pixel", "1 отсчёт на пиксель"), &shown(&point))))
        .with(marked(picture("area", text!("mean over the pixel's area", "среднее по площади пикселя"), &shown(&area))))
        .with(picture("point-part", text!("its neck", "горло"), &shown(&Image::of(&outline, part))))
        .with(picture("area-part", text!("its neck", "горло"), &shown(&Image::averaged(&outline, part))))
        .claim(
            text!(
                "means over areas add up to the area inside, {} pixels",
                "средние по площади складываются в площадь силуэта, {} пикселя",
                number(outline.area(), 6)
            ),
            Residual::near("Σ means = area", total(&area), outline.area(), rounding),
        )
        .claim(
            text!(
                "point samples count {} pixels: off by less than the outline's length",
                "точечные отсчёты насчитывают {} пикселя: ошибка меньше длины контура",
                number(total(&point), 6)
            ),
            // Steinhaus 1947: |lattice points inside − area| < length, for a closed curve at least one long
            Residual::near("lattice points inside ≈ area", total(&point), outline.area(), outline.length()),
        )
        .claim(
            text!(
                "they err only in the {} pixels that the outline crosses, RMSE {} over the picture",
                "они ошибаются только в {} пикселях, через которые идёт контур; СКО по всей картинке {}",
                crossed,
                number(error, 3)
            ),
            Residual::at_most("error away from the outline", elsewhere, 0.0),
        ))
}
