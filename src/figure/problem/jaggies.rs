//! Staircases at edges (slide «Проблемы сэмплирования в компьютерной графике»).

use crate::error::Result;
use crate::field::Field;
use crate::field::half_plane::HalfPlane;
use crate::figure::common::values;
use crate::figure::params::{Param, Params};
use crate::figure::picture::picture;
use crate::figure::{Entry, Figure, Layer, Legend, Meaning, Panel, Scale};
use crate::grid::Grid;
use crate::image::Image;
use crate::residual::Residual;
use crate::text;
use crate::text::{Text, number};

static FLAT: Text = Text::fixed("slope of the flat edge", "наклон пологой границы");
static STEEP: Text = Text::fixed("slope of the steep edge", "наклон крутой границы");

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[JAGGIES];

const JAGGIES: Entry = Entry {
    id: "f03-jaggies",
    inventory: &["F03"],
    errata: &["E14"],
    title: &Text::fixed("Sampling problems: staircases", "Проблемы сэмплирования: «лестница»"),
    caption: &Text::fixed(
        "A straight edge, one sample a pixel: rows of pixels are equal for cot θ columns, then jump by one, and the \
         flatter the edge the longer and plainer the stairs. The mean over the pixel's area, which is known exactly for \
         a straight edge, puts the fractions back.",
        "Прямая граница, один отсчёт на пиксель: строки не меняются на протяжении cot θ столбцов и прыгают на пиксель; чем \
         положе граница, тем длиннее и заметнее ступени. Среднее по площади пикселя, для прямой границы известное точно, \
         возвращает дробные части.",
    ),
    params: &[Param::real("flat", &FLAT, 2.0, 1.0, 10.0, "°"), Param::real("steep", &STEEP, 20.0, 10.0, 40.0, "°")],
    build: jaggies,
};

/// The size of the pictures.
const SIZE: (usize, usize) = (96, 32);
/// Columns of the edge that is measured: far more than are shown.
const LONG: usize = 30_000;
/// How many runs are drawn.
const RUNS: usize = 24;

/// What was measured of one edge.
struct Edge {
    point: Image,
    area: Image,
    /// The lengths of the runs, from the first whole one on.
    runs: Vec<f64>,
    cot: f64,
    /// How far the light of a column is from that under the straight line, at most: by points, by areas.
    off: [f64; 2],
}

fn measured(degrees: f64) -> Result<Edge> {
    let angle = degrees.to_radians();
    let middle = [0.5 * SIZE.0 as f64 + 0.3, 0.5 * SIZE.1 as f64 + 0.2];
    let edge = HalfPlane::through(middle, angle)?;
    let grid = Grid::pixels(SIZE.0, SIZE.1)?;
    let (point, area) = (Image::of(&edge, grid), Image::averaged(&edge, grid));
    // the edge falls by less than a row from column to column
    let (mut height, mut steps) = (0.0f64, Vec::new());
    for column in 0..LONG {
        let x = column as f64 + 0.5;
        let before = height;
        while edge.at(x, height + 0.5) > 0.5 {
            height += 1.0;
        }
        if height > before && column > 0 {
            steps.push(column as f64);
        }
    }
    let runs = steps.windows(2).map(|w| w[1] - w[0]).collect();
    let line = |x: f64| middle[1] + angle.tan() * (x - middle[0]);
    // columns that the edge crosses from side to side within the picture
    let inside = |i: &usize| line(*i as f64) > 0.0 && line(*i as f64 + 1.0) < SIZE.1 as f64;
    let light = |image: &Image, i: usize| (0..SIZE.1).map(|j| image.at(i, j)).sum::<f64>();
    let off = [&point, &area].map(|image| {
        let columns = (0..SIZE.0).filter(inside);
        columns.map(|i| (light(image, i) - line(i as f64 + 0.5)).abs()).fold(0.0, f64::max)
    });
    Ok(Edge { point, area, runs, cot: 1.0 / angle.tan(), off })
}

impl Edge {
    fn mean(&self) -> f64 {
        self.runs.iter().sum::<f64>() / self.runs.len() as f64
    }

    fn stairs(&self, name: &'static str, degrees: f64) -> Panel {
        let shown = self.runs.iter().take(RUNS).enumerate().map(|(i, &run)| [i as f64 + 1.0, run]);
        let title = text!(
            "mean run {} px = cot {}°",
            "средняя ступень {} пкс = cot {}°",
            number(self.mean(), 4),
            number(degrees, 3)
        );
        let step = Scale::linear(text!("step", "ступень"), 0.0, RUNS as f64 + 1.0);
        Panel::new(name, title, step, values("", 0.0, 1.25 * self.cot.ceil()))
            .legend(Legend::Above)
            .with(Layer::bars("runs", Meaning::Leaked, 0.7, shown))
            .with(Layer::horizontals("cot", Meaning::Theory, [self.cot]).dashed())
    }
}

fn jaggies(params: &Params) -> Result<Figure> {
    let degrees = [params.real("flat"), params.real("steep")];
    let [flat, steep] = [measured(degrees[0])?, measured(degrees[1])?];
    let title = |degrees: f64| text!("{}°, 1 sample a pixel", "{}°, 1 отсчёт на пиксель", number(degrees, 3));
    let area = || text!("mean over the pixel's area", "среднее по площади пикселя");
    let figure = Figure::new(2)
        .heights([1.0, 1.0, 0.9])
        .with(picture("flat-point", title(degrees[0]), &flat.point))
        .with(picture("steep-point", title(degrees[1]), &steep.point))
        .with(picture("flat-area", area(), &flat.area))
        .with(picture("steep-area", area(), &steep.area))
        .with(flat.stairs("flat-runs", degrees[0]))
        .with(steep.stairs("steep-runs", degrees[1]));
    let figure = [&flat, &steep].into_iter().zip(degrees).fold(figure, |figure, (edge, degrees)| {
        let others = edge.runs.iter().filter(|run| (**run - edge.cot).abs() >= 1.0).count();
        figure
            .claim(
                text!(
                    "at {}° the mean step is {} pixels long, cot θ",
                    "при {}° средняя длина ступени в пикселях {}, cot θ",
                    number(degrees, 3),
                    number(edge.mean(), 4)
                ),
                // n whole runs reach from one crossing, rounded up to a column, to another
                Residual::near("mean run length = cot θ", edge.mean(), edge.cot, 1.0 / edge.runs.len() as f64),
            )
            .claim(
                text!(
                    "at {}° every step is {} or {} pixels long",
                    "при {}° длина каждой ступени в пикселях {} или {}",
                    number(degrees, 3),
                    number(edge.cot.floor(), 3),
                    number(edge.cot.ceil(), 3)
                ),
                Residual::at_most("steps of other lengths", others as f64, 0.0),
            )
    });
    let [point, area] = [0, 1].map(|i| flat.off[i].max(steep.off[i]));
    Ok(figure
        .claim(
            text!(
                "point samples put the edge up to {} pixels beside its place",
                "по точечным отсчётам граница стоит до {} пикселя в стороне",
                number(point, 2)
            ),
            Residual::at_most("edge by point samples − straight edge", point, 0.5),
        )
        .claim(
            text!(
                "means over areas add up to the straight edge in every column",
                "средние по площади в каждом столбце складываются в прямую границу"
            ),
            // a column of 32 means, each off by 4ε(1 + offset)
            Residual::at_most(
                "edge by areas − straight edge",
                area,
                4.0 * f64::EPSILON * SIZE.1 as f64 * (1.0 + SIZE.0 as f64),
            ),
        ))
}
