//! Where a prefilter exists in image synthesis (slide «Применение к синтезу изображений»).

use crate::antialias::supersample::supersample;
use crate::axis::Axis;
use crate::error::Result;
use crate::field::checks::Checks;
use crate::field::perspective::{Camera, Perspective};
use crate::field::star::SiemensStar;
use crate::field::zone_plate::ZonePlate;
use crate::field::{ExactMean, Field, from_fn};
use crate::figure::params::Param;
use crate::figure::picture::{circles, picture};
use crate::figure::remedy::stochastic::SEED;
use crate::figure::{Entry, Figure, Meaning};
use crate::grid::Grid;
use crate::image::Image;
use crate::kernel::box_kernel::BoxKernel;
use crate::pattern::jittered::Jittered;
use crate::residual::Residual;
use crate::text;
use crate::text::{Text, number};

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[APPLICATION];

const APPLICATION: Entry = Entry {
    id: "f42-application",
    inventory: &["F42"],
    errata: &["E14"],
    title: &Text::fixed("Where a scene can be filtered first", "Где сцену можно отфильтровать заранее"),
    caption: &Text::fixed(
        "Above one sample a pixel, below what can be done about it. Polygons have an exact area in the pixel, textures a \
         table of means, formulas a known frequency that can be faded out (blue the true centre of the rings, red the false \
         ones): in these cases a prefilter exists. For L in \
         general, here a ball that mirrors a floor, nothing is known but its values at points: more samples are all there is.",
        "Сверху один отсчёт на пиксель, снизу — что с этим можно сделать. У многоугольников есть точная площадь в пикселе, у \
         текстур — таблица средних, у формул — известная частота, которую можно погасить (синий — истинный центр колец, красные \
         — ложные): здесь префильтр существует. Для \
         L общего вида (зеркальный шар над полом) известны только значения в точках: остаётся брать больше отсчётов.",
    ),
    params: &[Param::count("seed", &SEED, 1, 1, 100)],
    build: |params| application(params.count("seed") as u64),
};

const SIDE: usize = 84;
/// The period of the rings: their frequency reaches the sampling rate so far from the corner.
const RINGS: f64 = 48.0;
/// Below this frequency (in cycles per pixel) rings are kept as they are; at ½ nothing is left of them.
const KEPT: f64 = 0.35;

/// A floor of squares.
fn floor() -> Result<Perspective<Checks>> {
    let half = 0.5 * SIDE as f64;
    Perspective::new(Camera::new(half, 3.0, [half, 0.0])?, Checks::new(1.0)?, 0.5)
}

/// The mean of the texture over the box that surrounds what the pixel sees of the floor: what a table of sums over
/// rectangles gives in four look-ups (F. Crow, *Summed-area tables for texture mapping*, 1984).
struct ByTable(Perspective<Checks>);

impl Field for ByTable {
    fn at(&self, x: f64, y: f64) -> f64 {
        self.0.at(x, y)
    }
}

impl ExactMean for ByTable {
    fn mean(&self, [x0, x1]: [f64; 2], [y0, y1]: [f64; 2]) -> f64 {
        let corners = [[x0, y0], [x1, y0], [x0, y1], [x1, y1]].map(|[x, y]| self.0.camera().floor(x, y));
        let ends = |axis: usize| {
            let seen = || corners.iter().flatten().map(|p| p[axis]);
            [seen().fold(f64::INFINITY, f64::min), seen().fold(f64::NEG_INFINITY, f64::max)]
        };
        // a pixel at the horizon sees endlessly much
        if corners.contains(&None) { self.0.sky() } else { self.0.field().mean(ends(0), ends(1)) }
    }
}

/// How much of a frequency is kept: all below [`KEPT`], nothing from ½ on.
fn fade(nu: f64) -> f64 {
    let t = ((0.5 - nu.abs()) / (0.5 - KEPT)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// A ball that mirrors an endless floor of squares, seen from straight ahead.
fn ball(x: f64, y: f64) -> f64 {
    let radius = 0.5 * SIDE as f64;
    let [nx, ny] = [x / radius - 1.0, y / radius - 1.0];
    let square = 1.0 - nx * nx - ny * ny;
    if square <= 0.0 {
        return 0.8;
    }
    // the direction (0, 0, −1) reflected about the normal (nx, ny, nz): −v + 2(n·v)n with v towards the eye
    let nz = square.sqrt();
    let ray = [2.0 * nz * nx, 2.0 * nz * ny, 2.0 * nz * nz - 1.0];
    if ray[1] <= 0.0 {
        return 0.8 + 0.2 * ray[1]; // the sky
    }
    let far = (1.5 - ny) / ray[1];
    let [u, w] = [nx + far * ray[0], nz + far * ray[2]].map(|v| (2.0 * v).floor());
    if (u + w).rem_euclid(2.0) == 0.0 { 0.05 } else { 0.95 }
}

fn application(seed: u64) -> Result<Figure> {
    let grid = Grid::pixels(SIDE, SIDE)?;
    let star = SiemensStar::new([0.5 * SIDE as f64, 0.5 * SIDE as f64], 24)?;
    let floor = floor()?;
    let rings = ZonePlate::new(RINGS)?;
    let axis = Axis::new(0.0, 1.0, SIDE)?;
    let from_corner = Grid::new(axis, axis)?;
    let faded = from_fn(|x: f64, y: f64| 0.5 + (rings.at(x, y) - 0.5) * fade(x / RINGS) * fade(y / RINGS));
    let mirror = from_fn(ball);
    let mean_of = |n: usize, seed: u64| supersample(&mirror, grid, &Jittered::new([n, n])?, &BoxKernel, seed);

    let points =
        [Image::of(&star, grid), Image::of(&floor, grid), Image::of(&rings, from_corner), Image::of(&mirror, grid)];
    let better = [
        Image::averaged(&star, grid),
        Image::averaged(&ByTable(floor), grid),
        Image::of(&faded, from_corner),
        mean_of(4, seed)?,
    ];
    let reference = mean_of(16, seed + 1000)?;
    let errors = [mean_of(1, seed)?.rmse(&reference)?, better[3].rmse(&reference)?];
    // below the horizon's row, of which no table knows the mean
    let exact = Image::averaged(&floor, Grid::cells(0.0..SIDE as f64, SIDE, 1.0..SIDE as f64, SIDE - 1)?);
    let below =
        |image: &Image| -> Result<f64> { Image::new(exact.grid(), image.values()[SIDE..].to_vec())?.rmse(&exact) };
    let on_floor = [below(&points[1])?, below(&better[1])?];

    let titles = [
        text!("polygons", "многоугольники"),
        text!("a texture", "текстура"),
        text!("a formula", "формула"),
        text!("any L", "любая L"),
    ];
    let below_titles = [
        text!("exact area", "точная площадь"),
        text!("table of means", "таблица средних"),
        text!("faded out", "частоты погашены"),
        text!("16 jittered", "16 с джиттером"),
    ];
    let mut figure = Figure::new(4);
    let names =
        ["polygon-point", "texture-point", "formula-point", "any-point", "polygon", "texture", "formula", "any"];
    let panels = points.iter().chain(&better).zip(titles.into_iter().chain(below_titles)).zip(names);
    // where rings seem to be: a period apart, one of them true
    let ghosts = [[RINGS, 0.0], [0.0, RINGS], [RINGS, RINGS]];
    for ((image, title), name) in panels {
        let panel = picture(name, title, image);
        figure = figure.with(match name {
            "formula-point" | "formula" => panel
                .with(circles("ghosts", Meaning::Leaked, 0.2 * RINGS, &ghosts).thick())
                .with(circles("center", Meaning::Signal, 0.2 * RINGS, &[[0.0, 0.0]]).thick()),
            _ => panel,
        });
    }
    let side = SIDE as f64;
    let area = star.mean([0.0, side], [0.0, side]);
    let beyond = |x: f64, y: f64| x.max(y) >= 0.5 * RINGS;
    let left = from_corner.iter().zip(better[2].values()).filter(|([x, y], _)| beyond(*x, *y));
    let left = left.map(|(_, v)| (v - 0.5).abs()).fold(0.0, f64::max);
    let ghost = points[2].at(RINGS as usize, 0);
    Ok(figure
        .claim(
            text!(
                "polygons: the pixels add up to the area, {} of the picture",
                "многоугольники: пиксели в сумме дают площадь, {} картинки",
                number(area, 4)
            ),
            // 24 wedges clipped in each pixel, each to 16ε of the picture's side
            Residual::near("mean of the exact pixels = area", better[0].mean(), area, 24.0 * 16.0 * f64::EPSILON * side),
        )
        .claim(
            text!(
                "texture: the table errs by {}, one sample by {}: it takes a box around what the pixel sees",
                "текстура: таблица ошибается на {}, один отсчёт — на {}: она берёт прямоугольник вокруг видимого в пикселе",
                number(on_floor[1], 2),
                number(on_floor[0], 2)
            ),
            Residual::at_most("error of the table / of one sample", on_floor[1] / on_floor[0], 1.0),
        )
        .claim(
            text!(
                "formula: one sample sees a ghost of brightness {0} at the distance {1}; faded out, all is grey from {2} on",
                "формула: один отсчёт видит на расстоянии {1} ложный центр яркости {0}; после гашения с {2} всё серое",
                number(ghost, 2),
                RINGS,
                0.5 * RINGS
            ),
            Residual::at_most("what is left beyond Nyquist", left, 0.0),
        )
        .claim(
            text!(
                "any L: sixteen jittered samples err by {}, one by {}",
                "любая L: шестнадцать отсчётов с джиттером ошибаются на {}, один — на {}",
                number(errors[1], 2),
                number(errors[0], 2)
            ),
            // strata never hurt: at most a quarter in the mean, and edges gain more than that
            Residual::at_most("error of 16 jittered samples / of one", errors[1] / errors[0], 0.25),
        ))
}
