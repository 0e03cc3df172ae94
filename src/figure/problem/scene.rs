//! What images have to do with it (slide «А какое отношение это имеет к синтезу изображений?»).

use crate::error::Result;
use crate::field::disc::Disc;
use crate::field::half_plane::HalfPlane;
use crate::field::polygon::ConvexPolygon;
use crate::field::{Field, from_fn};
use crate::figure::params::{Param, Params};
use crate::figure::picture::{frame, picture};
use crate::figure::{Entry, Figure, Layer, Meaning, Panel};
use crate::grid::Grid;
use crate::image::Image;
use crate::num::{cos_pi, sin_pi};
use crate::residual::Residual;
use crate::text;
use crate::text::{Text, number};

static DEPTH: Text =
    Text::fixed("how far the wavy glass shifts the picture", "насколько волнистое стекло сдвигает картину");

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[SYNTHESIS];

const SYNTHESIS: Entry = Entry {
    id: "f05-synthesis",
    inventory: &["F05"],
    errata: &["E18"],
    title: &Text::fixed("Why image synthesis needs it", "Какое отношение это имеет к синтезу изображений"),
    caption: &Text::fixed(
        "A renderer can compute the scene's light L(x, y) at any point, asks at finitely many, and makes pixels of the \
         answers. Below: the same scene behind wavy glass that is still at exactly those points. It looks different \
         everywhere else, its samples are the same to the last bit: what lies between the samples is lost for good.",
        "Рендерер может вычислить свет сцены L(x, y) в любой точке, спрашивает в конечном их числе и делает из ответов \
         пиксели. Внизу та же сцена за волнистым стеклом, неподвижным ровно в этих точках. Всюду между ними она другая, а \
         отсчёты совпадают до последнего бита: то, что между отсчётами, потеряно навсегда.",
    ),
    params: &[Param::real("depth", &DEPTH, 0.25, 0.1, 0.5, "px")],
    build: |params: &Params| synthesis(params.real("depth")),
};

/// Pixels along a side, and points in one along each axis where the scene is drawn finely.
const SIDE: usize = 28;
const FINE: usize = 12;
/// The part that is shown enlarged.
const PART: [[f64; 2]; 2] = [[10.0, 17.0], [11.0, 18.0]];

/// A house in front of a low sun.
fn scene() -> Result<impl Field> {
    let sun = Disc::new([20.4, 8.7], 4.1)?;
    let house = ConvexPolygon::new(&[[6.2, 14.2], [14.4, 14.2], [14.4, 23.6], [6.2, 23.6]])?;
    let roof = ConvexPolygon::new(&[[4.6, 14.7], [15.9, 14.7], [10.2, 7.3]])?;
    let window = ConvexPolygon::new(&[[8.4, 16.4], [12.1, 16.4], [12.1, 20.3], [8.4, 20.3]])?;
    let sky = HalfPlane::through([0.0, 21.9], -0.05)?;
    Ok(from_fn(move |x, y| {
        let over = |below: f64, shape: f64, light: f64| below + shape * (light - below);
        let field = 0.12 + 0.08 * cos_pi(1.3 * y + 0.2 * x);
        let air = over(0.28 + 0.012 * y, sun.at(x, y), 1.0);
        let land = over(field, sky.at(x, y), air);
        let walls = over(land, house.at(x, y), 0.45);
        over(over(walls, window.at(x, y), 0.9), roof.at(x, y), 0.03)
    }))
}

fn synthesis(depth: f64) -> Result<Figure> {
    let scene = scene()?;
    // sin 2πx is zero at the middles of the pixels
    let glass = from_fn(|x, y| scene.at(x + depth * sin_pi(2.0 * x), y + depth * sin_pi(2.0 * y)));
    let (true_row, true_images) = row(["scene", "part", "pixels"], text!("scene L", "сцена L"), &scene)?;
    let (other_row, other_images) =
        row(["glass", "glass-part", "glass-pixels"], text!("behind wavy glass", "за волнистым стеклом"), &glass)?;
    let [fine, sampled] = true_images;
    let [other, resampled] = other_images;
    let apart = sampled.with(&resampled, |a, b| (a - b).abs())?.values().iter().copied().fold(0.0, f64::max);
    let figure = true_row.into_iter().chain(other_row).fold(Figure::new(3), Figure::with);
    let differs = fine.rmse(&other)?;
    Ok(figure
        .claim(
            text!(
                "all {} samples of the two scenes are equal, bit for bit",
                "отсчёты двух сцен (их {}) равны бит в бит",
                SIDE * SIDE
            ),
            Residual::at_most("samples of one scene − samples of the other", apart, 0.0),
        )
        .claim(
            text!(
                "the scenes differ by {} (RMSE, of white)",
                "сцены отличаются на {} (СКО, от белого)",
                number(differs, 2)
            ),
            // what eight bits can show
            Residual::at_least("scenes differ visibly", differs, 1.0 / 255.0),
        ))
}

/// The scene, a part of it with the sampled points, and the pixels; the fine picture and the samples.
fn row(names: [&'static str; 3], title: Text, scene: &impl Field) -> Result<([Panel; 3], [Image; 2])> {
    let whole = 0.0..SIDE as f64;
    let fine = Image::of(scene, Grid::cells(whole.clone(), SIDE * FINE, whole, SIDE * FINE)?);
    let sampled = Image::of(scene, Grid::pixels(SIDE, SIDE)?);
    let [[x0, x1], [y0, y1]] = PART;
    let cells = |low: f64, high: f64| (FINE as f64 * SIDE as f64 / 7.0 * (high - low)) as usize;
    let near = Image::of(scene, Grid::cells(x0..x1, cells(x0, x1), y0..y1, cells(y0, y1))?);
    let inside = |[x, y]: &[f64; 2]| (x0..x1).contains(x) && (y0..y1).contains(y);
    let points = sampled.grid().iter().filter(inside);
    let marked = |panel: Panel| panel.with(frame("part", Meaning::Leaked, PART[0], PART[1]).thick());
    let panels = [
        marked(picture(names[0], title, &fine)),
        picture(names[1], text!("where it is sampled", "где берутся отсчёты"), &near).with(Layer::dots(
            "points",
            Meaning::Samples,
            points,
        )),
        marked(picture(names[2], text!("pixels", "пиксели"), &sampled)),
    ];
    Ok((panels, [fine, sampled]))
}
