//! The generalised scene function (slide «Обобщение функции сцены»): a lens traced for real, and what its axes are.

use crate::error::Result;
use crate::figure::params::{Param, Params};
use crate::figure::{Entry, Figure, Layer, Legend, Meaning, Panel, Scale};
use crate::laws::scene::{by_similar_triangles, rays_meet, slope_is_confusion};
use crate::scene::lens::ThinLens;
use crate::text;
use crate::text::{Text, number};

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[SCENE_FUNCTION];

static FOCUS: Text = Text::fixed("distance in focus", "расстояние в фокусе");
static APERTURE: Text = Text::fixed("diameter of the lens", "диаметр линзы");

const SCENE_FUNCTION: Entry = Entry {
    id: "f47-scene-function",
    inventory: &["F47"],
    errata: &[],
    title: &Text::fixed("The generalised scene function L(x, y, u, v, t)", "Обобщённая функция сцены L(x, y, u, v, t)"),
    caption: &Text::fixed(
        "Light reaches a place (x, y) of the film through every point (u, v) of the lens, as long as the shutter is open, t. \
         The rays of a point in focus meet on the film; those of a point before or behind it miss each other, by a \
         distance that grows in proportion to the step on the lens. A pixel is the mean over all five coordinates.",
        "Свет приходит в точку плёнки (x, y) через каждую точку линзы (u, v) всё время t, пока открыт затвор. Лучи точки в \
         фокусе сходятся на плёнке, а лучи точек ближе и дальше расходятся тем больше, чем больше шаг по линзе. Пиксель — \
         среднее по всем пяти координатам.",
    ),
    params: &[Param::real("focus", &FOCUS, 5.0, 3.5, 7.0, ""), Param::real("A", &APERTURE, 1.6, 0.4, 2.0, "")],
    build: |params| scene_function(params),
};

/// The distance from the lens to the film.
const FILM: f64 = 2.0;
/// Rays drawn of every point.
const RAYS: u32 = 7;

/// A point of the scene that is followed through the lens.
struct Followed {
    name: &'static str,
    label: Text,
    meaning: Meaning,
    point: [f64; 3],
}

fn followed(focus: f64) -> [Followed; 3] {
    let point = |x: f64, z: f64| [x, 0.0, z];
    [
        Followed {
            name: "near",
            label: text!("too near", "слишком близко"),
            meaning: Meaning::Leaked,
            point: point(-0.75, 0.55 * focus),
        },
        Followed {
            name: "focused",
            label: text!("in focus", "в фокусе"),
            meaning: Meaning::Reconstructed,
            point: point(0.0, focus),
        },
        Followed {
            name: "far",
            label: text!("too far", "слишком далеко"),
            meaning: Meaning::Signal,
            point: point(2.2, 2.0 * focus),
        },
    ]
}

/// Places from edge to edge of the lens.
fn across(lens: &ThinLens) -> impl Iterator<Item = f64> + use<> {
    let aperture = lens.aperture();
    (0..RAYS).map(move |i| aperture * (f64::from(i) / f64::from(RAYS - 1) - 0.5))
}

/// Where the ray of a point through `a` meets the film: upside down, as it really is.
fn on_film(lens: &ThinLens, point: [f64; 3], a: f64) -> f64 {
    -lens.to_film(point, [a, 0.0])[0]
}

fn rays_panel(lens: &ThinLens, points: &[Followed]) -> Panel {
    let (far, half) = (2.0 * lens.focus(), 0.5 * lens.aperture());
    let low = [[-far - 0.6, 0.0], [FILM + 0.7, 0.0]];
    let mut panel = Panel::new(
        "rays",
        text!("rays of three points", "лучи трёх точек"),
        Scale::linear(text!("distance from the lens", "расстояние от линзы"), low[0][0], low[1][0]),
        Scale::linear(Text::same("x"), -1.9, 2.6),
    )
    .span(2)
    .legend(Legend::Above)
    .with(Layer::line("axis", Meaning::Guide, low).thin())
    .with(Layer::verticals("plane in focus", Meaning::Guide, [-lens.focus()]).dashed());
    for Followed { name, label, meaning, point } in points {
        let path = |a: f64| [[-point[2], point[0]], [0.0, a], [FILM, on_film(lens, *point, a)], [f64::NAN, f64::NAN]];
        let paths = across(lens).flat_map(path);
        panel = panel.with(Layer::line(name, *meaning, paths).thin().label(label.clone()));
    }
    let dots = points.iter().map(|f| [-f.point[2], f.point[0]]);
    panel
        .with(Layer::dots("points", Meaning::Samples, dots))
        .with(Layer::line("lens", Meaning::Kernel, [[0.0, -half], [0.0, half]]).thick())
        .with(Layer::line("film", Meaning::Theory, [[FILM, -1.7], [FILM, 1.7]]).thick())
        .with(Layer::notes(
            "names",
            Meaning::Guide,
            [
                ([-lens.focus(), 2.35], text!("plane in focus", "плоскость фокуса")),
                ([0.0, 2.35], text!("lens (u, v)", "линза (u, v)")),
                ([0.9, -1.55], text!("film (x, y)", "плёнка (x, y)")),
            ],
        ))
}

/// Places on the film over places on the lens: the slice `(x, u)` of the scene function.
fn slice_panel(lens: &ThinLens, points: &[Followed]) -> Panel {
    let half = 0.5 * lens.aperture();
    let most = points.iter().map(|f| 0.6 * lens.circle_of_confusion(f.point[2])).fold(0.0, f64::max);
    let panel = Panel::new(
        "slice",
        text!("the slice (x, u)", "сечение (x, u)"),
        Scale::linear(text!("x on the film", "x на плёнке"), -most, most),
        Scale::linear(text!("u on the lens", "u на линзе"), -1.15 * half, 1.15 * half),
    );
    points.iter().fold(panel, |panel, Followed { name, meaning, point, .. }| {
        let middle = lens.to_film(*point, [0.0, 0.0])[0];
        let traced: Vec<[f64; 2]> = across(lens).map(|a| [lens.to_film(*point, [a, 0.0])[0] - middle, a]).collect();
        panel.with(Layer::line(name, *meaning, traced.clone())).with(Layer::dots("traced", *meaning, traced))
    })
}

/// The circle of confusion over the distance, and the measured ones.
fn confusion_panel(lens: &ThinLens, points: &[Followed]) -> Panel {
    let focus = lens.focus();
    let (low, high) = (0.4 * focus, 2.4 * focus);
    let most = 1.15 * lens.circle_of_confusion(low);
    let panel = Panel::new(
        "confusion",
        text!("circle of confusion", "кружок нерезкости"),
        Scale::linear(text!("distance z", "расстояние z"), low, high),
        Scale::linear(Text::same("c"), 0.0, most),
    )
    .legend(Legend::Above)
    .with(
        Layer::curve("formula", Meaning::Theory, low, high, 200, |z| by_similar_triangles(lens, z))
            .label(Text::same("|(d′ − z′)/z′|·A")),
    );
    points.iter().fold(panel, |panel, f| {
        let ends = across(lens).map(|a| on_film(lens, f.point, a));
        let (low, high) = ends.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), x| (l.min(x), h.max(x)));
        panel.with(Layer::dots(f.name, f.meaning, [[f.point[2], high - low]]))
    })
}

/// What the five axes are, and what an average over each of them makes.
fn axes_panel() -> Panel {
    let rows: [[Text; 3]; 4] = [
        [text!("axes", "оси"), text!("what", "что это"), text!("their mean", "среднее по ним")],
        [Text::same("x, y"), text!("place on the film", "место на плёнке"), text!("smooth edges", "гладкие края")],
        [Text::same("u, v"), text!("point of the lens", "точка линзы"), text!("depth of field", "глубина резкости")],
        [Text::same("t"), text!("shutter time", "время затвора"), text!("motion blur", "смаз движения")],
    ];
    let columns = [0.1, 0.42, 0.8];
    let notes = rows.into_iter().enumerate().flat_map(|(row, texts)| {
        let y = 0.84 - 0.23 * row as f64;
        texts.into_iter().zip(columns).map(move |(text, x)| ([x, y], text))
    });
    let bare = || Scale::linear(Text::EMPTY, 0.0, 1.0).bare();
    Panel::new("axes", text!("the five axes", "пять осей"), bare(), bare())
        .span(2)
        .with(Layer::line("rule", Meaning::Guide, [[0.02, 0.73], [0.98, 0.73]]).thin())
        .with(Layer::notes("table", Meaning::Signal, notes))
}

fn scene_function(params: &Params) -> Result<Figure> {
    let lens = ThinLens::new(FILM, params.real("focus"), params.real("A"))?;
    let points = followed(lens.focus());
    let mut figure = Figure::new(3)
        .heights([1.0, 0.8])
        .with(rays_panel(&lens, &points))
        .with(slice_panel(&lens, &points))
        .with(axes_panel())
        .with(confusion_panel(&lens, &points));
    let [near, focused, far] = &points;
    figure = figure.claim(
        text!(
            "all rays of the point in focus (z = {}) meet on the film",
            "все лучи точки в фокусе (z = {}) сходятся на плёнке",
            number(focused.point[2], 3)
        ),
        rays_meet(&lens, focused.point, 0.0),
    );
    for Followed { point, .. } in [near, far] {
        let c = lens.circle_of_confusion(point[2]);
        figure = figure
            .claim(
                text!(
                    "those of the point at {} fill a circle of {}",
                    "лучи точки на расстоянии {} заполняют кружок {}",
                    number(point[2], 3),
                    number(c, 3)
                ),
                rays_meet(&lens, *point, c),
            )
            .claim(
                text!(
                    "in (x, u) its slope is {}: times A it is c = |(d′ − z′)/z′|·A",
                    "в (x, u) её наклон {}: умноженный на A, он равен c = |(d′ − z′)/z′|·A",
                    number(lens.shear(point[2]).abs(), 3)
                ),
                slope_is_confusion(&lens, point[2], by_similar_triangles),
            );
    }
    Ok(figure)
}
