//! All scenes by name.

use crate::error::{Result, unknown};
use crate::field::bricks::BrickWall;
use crate::field::checkerboard::Checkerboard;
use crate::field::checks::Checks;
use crate::field::glyphs::Glyphs;
use crate::field::perspective::Camera;
use crate::field::star::SiemensStar;
use crate::field::zone_plate::ZonePlate;
use crate::field::{Field, from_fn};
use crate::scene::Scene;
use crate::scene::camera::LensCamera;
use crate::scene::chart::Chart;
use crate::scene::sphere::Sphere;
use crate::scene::sun::Sun;
use crate::scene::surface::Surface;
use crate::scene::world::{Sky, World};
use crate::text::Text;

/// A scene with a name.
#[derive(Debug, Clone, Copy)]
pub struct Entry {
    /// Its name, as the command line takes it.
    pub name: &'static str,
    /// What is to be seen in it.
    pub about: &'static Text,
    make: fn() -> Result<Box<dyn Scene>>,
}

impl Entry {
    /// The scene.
    pub fn scene(&self) -> Box<dyn Scene> {
        (self.make)().expect("the named scenes are within their ranges")
    }
}

/// The scenes, the lecture's own first.
static ENTRIES: &[Entry] = &[
    Entry {
        name: "checkerboard",
        about: &Text::fixed("the lecture's checkerboard, up to the horizon", "шахматная доска из лекции, до горизонта"),
        make: || Ok(Box::new(Chart::new(checkerboard()?))),
    },
    Entry {
        name: "spheres",
        about: &Text::fixed(
            "spheres on a checkered floor: depth of field, soft shadows",
            "шары на клетчатом полу: глубина резкости, мягкие тени",
        ),
        make: || Ok(Box::new(spheres()?)),
    },
    Entry {
        name: "defocus",
        about: &Text::fixed("one sphere out of focus", "один шар не в фокусе"),
        make: || Ok(Box::new(defocus()?)),
    },
    Entry {
        name: "motion",
        about: &Text::fixed("moving spheres", "движущиеся шары"),
        make: || Ok(Box::new(motion()?)),
    },
    Entry {
        name: "highlights",
        about: &Text::fixed("many small spheres with narrow highlights", "много мелких шаров с узкими бликами"),
        make: || Ok(Box::new(highlights()?)),
    },
    Entry {
        name: "zone-plate",
        about: &Text::fixed(
            "all frequencies in all directions: with one regular sample a pixel there are false rings at the sides",
            "все частоты во всех направлениях: при одном регулярном отсчёте на пиксель по бокам видны ложные кольца",
        ),
        // with 320 rows the true rings reach Nyquist at 0.37, and the false ones stand at ±0.74, just inside a picture 3 : 2
        make: || Ok(Box::new(Chart::new(ZonePlate::new(1.0 / 432.0)?))),
    },
    Entry {
        name: "bricks",
        about: &Text::fixed("a wall of bricks", "кирпичная стена"),
        make: || Ok(Box::new(Chart::new(bricks()?).in_colors([0.52, 0.5, 0.46], [0.42, 0.13, 0.08])?)),
    },
    Entry {
        name: "text",
        about: &Text::fixed("black letters, ever smaller", "чёрные буквы, всё мельче"),
        make: || Ok(Box::new(Chart::new(text()?))),
    },
    Entry {
        name: "star",
        about: &Text::fixed("a Siemens star", "звезда Сименса"),
        make: || Ok(Box::new(Chart::new(SiemensStar::new([0.0, 0.0], 72)?))),
    },
];

/// All scenes, in order.
pub fn all() -> &'static [Entry] {
    ENTRIES
}

/// The scene of that name.
///
/// ```
/// use nyquist::scene::catalog::by_name;
/// assert_eq!(by_name("defocus")?.name, "defocus");
/// let error = by_name("sphere").unwrap_err();
/// assert!(error.to_string().starts_with("no scene is called \"sphere\"; known: spheres"));
/// # Ok::<(), nyquist::error::Error>(())
/// ```
///
/// # Errors
/// An unknown name; the known ones stand in the error, nearest first.
pub fn by_name(name: &str) -> Result<&'static Entry> {
    let found = ENTRIES.iter().find(|entry| entry.name == name);
    found.ok_or_else(|| unknown("scene", name, ENTRIES.iter().map(|entry| entry.name)))
}

/// The lecture's checkerboard: a field of view of 90°, the horizon at the upper edge.
fn checkerboard() -> Result<Checkerboard> {
    Checkerboard::new(Camera::new(0.5, 1.0, [0.0, -0.5])?, Checks::new(1.0)?, 0.5)
}

/// Afternoon light from the left behind the camera, and a soft shadow.
fn afternoon(degrees: f64) -> Result<Sun> {
    Sun::new([-0.6, 0.75, -0.5], degrees, [0.95, 0.85, 0.68])
}

fn daylight() -> Result<Sky> {
    Sky::new([0.5, 0.6, 0.74], [0.1, 0.22, 0.5])?.with_haze(120.0)
}

fn tiles() -> Result<Surface> {
    Surface::checkered([[0.08, 0.09, 0.11], [0.78, 0.76, 0.7]], 0.5)
}

fn glossy(color: [f64; 3]) -> Result<Surface> {
    Surface::plain(color)?.with_highlight(0.9, 250.0)?.with_mirror(0.12)
}

/// Spheres near, in focus and far, on tiles up to the horizon.
///
/// # Errors
/// None: its numbers are within their ranges.
pub fn spheres() -> Result<World> {
    let camera = LensCamera::new([0.0, 1.25, -5.0], [0.0, 0.62, 0.5], 34.0)?.with_lens(0.22, 5.3)?;
    let world = World::new(camera, afternoon(4.0)?, daylight()?).with_floor(tiles()?);
    Ok(world
        .with_sphere(Sphere::new([0.1, 0.8, 0.6], 0.8, glossy([0.62, 0.05, 0.04])?)?)
        .with_sphere(Sphere::new([-1.15, 0.36, -2.2], 0.36, glossy([0.05, 0.25, 0.6])?)?)
        .with_sphere(Sphere::new(
            [1.35, 0.45, -0.7],
            0.45,
            Surface::plain([0.05; 3])?.with_highlight(1.0, 400.0)?.with_mirror(0.8)?,
        )?)
        .with_sphere(Sphere::new([-2.3, 1.0, 4.6], 1.0, glossy([0.75, 0.42, 0.04])?)?)
        .with_sphere(Sphere::new([2.9, 0.9, 6.5], 0.9, glossy([0.08, 0.38, 0.08])?)?))
}

/// A purple sphere far before the plane in focus, in front of the sky.
///
/// # Errors
/// None: its numbers are within their ranges.
pub fn defocus() -> Result<World> {
    let camera = LensCamera::new([0.0, 0.0, -4.0], [0.0, 0.0, 0.0], 40.0)?.with_lens(1.0, 12.0)?;
    let sky = Sky::new([0.36, 0.4, 0.48], [0.2, 0.25, 0.38])?;
    let sun = Sun::new([-0.6, 0.7, -0.7], 1.0, [1.1, 1.06, 1.0])?;
    let purple = Surface::plain([0.5, 0.16, 0.66])?.with_highlight(0.3, 20.0)?;
    Ok(World::new(camera, sun, sky).with_sphere(Sphere::new([0.0, 0.0, 0.0], 0.85, purple)?))
}

/// Spheres that pass by, fall, come nearer, and one that stands.
///
/// # Errors
/// None: its numbers are within their ranges.
pub fn motion() -> Result<World> {
    let camera = LensCamera::new([0.0, 1.2, -5.5], [0.0, 0.75, 0.0], 36.0)?;
    let world = World::new(camera, afternoon(3.0)?, daylight()?).with_floor(tiles()?);
    let sphere = |center, radius, color| Sphere::new(center, radius, glossy(color)?);
    Ok(world
        .with_sphere(sphere([-1.9, 0.45, -0.6], 0.45, [0.62, 0.05, 0.04])?.moving([0.7, 0.0, 0.0])?)
        .with_sphere(sphere([0.55, 1.75, 0.3], 0.4, [0.05, 0.25, 0.6])?.moving([0.0, -0.6, 0.0])?)
        .with_sphere(sphere([1.75, 0.5, 0.1], 0.5, [0.75, 0.42, 0.04])?)
        .with_sphere(sphere([-1.2, 0.6, 3.4], 0.6, [0.08, 0.38, 0.08])?.moving([0.25, 0.0, -1.6])?))
}

/// Rows of small shiny spheres whose highlights are narrower than a pixel.
///
/// # Errors
/// None: its numbers are within their ranges.
pub fn highlights() -> Result<World> {
    let camera = LensCamera::new([0.0, 1.6, -3.2], [0.0, 0.1, 0.6], 38.0)?;
    let sky = Sky::new([0.03, 0.04, 0.07], [0.02, 0.03, 0.06])?;
    let sun = Sun::new([0.4, 0.7, -0.3], 1.0, [1.0, 0.96, 0.9])?;
    let floor = Surface::plain([0.12, 0.11, 0.12])?;
    let mut world = World::new(camera, sun, sky).with_floor(floor);
    for row in 0..6 {
        for column in 0..9 {
            let (row, column) = (f64::from(row), f64::from(column) - 4.0);
            let color = [0.1 + 0.06 * row, 0.06, 0.35 - 0.05 * row];
            let pearl = Surface::plain(color)?.with_highlight(12.0, 3000.0)?;
            world = world.with_sphere(Sphere::new([0.4 * column, 0.16, 0.55 * row - 0.9], 0.16, pearl)?);
        }
    }
    Ok(world)
}

/// A wall in perspective would hide what filters do to its edges: it stands upright and still.
fn bricks() -> Result<BrickWall> {
    BrickWall::new([0.13, 0.057], 0.009, [1.0, 0.0])
}

/// Lines of ever smaller letters, black on white: of each as many whole words as there is room for.
fn text() -> Result<impl Field + Send + Sync + 'static> {
    const WIDE: f64 = 1.36;
    let mut lines = Vec::new();
    let mut top = -0.45;
    for height in [0.15, 0.11, 0.08, 0.055, 0.038, 0.026, 0.017, 0.011, 0.007] {
        let room = (WIDE / height) as usize;
        let words = "HALF A TILE ".repeat(room / 12 + 1);
        let fitting =
            words.match_indices(' ').map(|(end, _)| end).take_while(|end| *end <= room).last().unwrap_or(room);
        lines.push((top, height, Glyphs::new(&words[..fitting], [-0.5 * WIDE, top], height)?));
        top += 1.85 * height;
    }
    Ok(from_fn(move |x, y| {
        // only the line at that height has ink there
        let line = lines.iter().find(|(top, height, _)| (*top..=top + height).contains(&y));
        1.0 - line.map_or(0.0, |(_, _, line)| line.at(x, y).min(1.0))
    }))
}
