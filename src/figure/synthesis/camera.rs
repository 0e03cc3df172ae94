//! The camera as a chain of means: radiance, lens, shutter, sensor.

use crate::axis::Edge;
use crate::error::Result;
use crate::figure::params::{Param, Params};
use crate::figure::picture::{grey, tones};
use crate::figure::synthesis::rendered::sampled;
use crate::figure::{Entry, Figure, Panel, Tones};
use crate::image::Image;
use crate::image::dft::forward;
use crate::image::resize::resize;
use crate::kernel::box_kernel::BoxKernel;
use crate::pattern::Pattern;
use crate::pattern::padded::Padded;
use crate::pattern::regular::Regular;
use crate::residual::Residual;
use crate::scene::camera::LensCamera;
use crate::scene::sphere::Sphere;
use crate::scene::sun::Sun;
use crate::scene::surface::Surface;
use crate::scene::world::{Sky, World};
use crate::scene::{Scene, ScenePoint};
use crate::text;
use crate::text::{Text, number};

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[CAMERA];

static APERTURE: Text = Text::fixed("diameter of the lens", "диаметр линзы");
static SEED: Text = Text::fixed("seed", "зерно");

const CAMERA: Entry = Entry {
    id: "x-camera",
    inventory: &["F01", "F47"],
    errata: &["E18"],
    title: &Text::fixed("A camera is a chain of means", "Камера — цепочка усреднений"),
    caption: &Text::fixed(
        "A pinhole that is open for a moment sees the radiance itself. The lens takes its mean over (u, v): what is out of \
         focus softens. The shutter takes it over t: what moves smears. The sensor takes it over each pixel's area, and \
         only then samples. Every step is a prefilter; a renderer that shoots one ray a pixel has none of them.",
        "Точечное отверстие, открытое на миг, видит саму яркость. Линза усредняет её по (u, v): смягчается то, что не в \
         фокусе. Затвор — по t: смазывается то, что движется. Сенсор — по площади пикселя, и лишь потом дискретизует. Каждый \
         шаг — префильтр; у рендера с одним лучом на пиксель нет ни одного.",
    ),
    params: &[Param::real("A", &APERTURE, 0.3, 0.1, 0.5, ""), Param::count("seed", &SEED, 1, 1, 100)],
    build: |params| camera(params),
};

/// Pixels of the fine pictures, in a row and rows.
const SIZE: usize = 84;
/// The darkest tone of a spectrum, in decibels.
const FLOOR: f64 = -80.0;
/// Fine pixels in a pixel of the sensor, across and down.
const COARSE: usize = 4;

/// A still sphere in focus, one far behind, and one that passes in front.
fn scene(aperture: f64) -> Result<World> {
    let camera = LensCamera::new([0.0, 1.0, -5.0], [0.0, 0.62, 0.0], 27.0)?.with_lens(aperture, 5.0)?;
    let sun = Sun::new([-0.4, 0.8, -0.6], 2.0, [1.0; 3])?;
    let sky = Sky::new([0.35; 3], [0.2; 3])?;
    let floor = Surface::checkered([[0.1; 3], [0.5; 3]], 0.4)?;
    let surface = |grey: f64| Surface::plain([grey; 3])?.with_highlight(0.6, 80.0);
    Ok(World::new(camera, sun, sky)
        .with_floor(floor)
        .with_sphere(Sphere::new([0.45, 0.45, 0.0], 0.45, surface(0.8)?)?)
        .with_sphere(Sphere::new([-1.5, 0.9, 5.5], 0.9, surface(0.6)?)?)
        .with_sphere(Sphere::new([-0.95, 0.25, -0.5], 0.25, surface(0.9)?)?.moving([0.75, 0.0, 0.0])?))
}

/// A scene whose time or lens stands still, each at its middle.
struct Held<'a> {
    world: &'a World,
    lens: bool,
    time: bool,
}

impl Scene for Held<'_> {
    fn radiance(&self, at: ScenePoint) -> [f64; 3] {
        let still = ScenePoint::still(at.film);
        let lens = if self.lens { still.lens } else { at.lens };
        let time = if self.time { still.time } else { at.time };
        self.world.radiance(ScenePoint { lens, time, ..at })
    }
}

/// How much a picture changes from pixel to pixel: the mean square of its differences across and down.
fn sharpness(image: &Image) -> f64 {
    let n = image.width();
    let across = (0..n).flat_map(|j| (1..n).map(move |i| image.at(i, j) - image.at(i - 1, j)));
    let down = (1..n).flat_map(|j| (0..n).map(move |i| image.at(i, j) - image.at(i, j - 1)));
    across.chain(down).map(|d| d * d).sum::<f64>() / (2 * n * (n - 1)) as f64
}

fn camera(params: &Params) -> Result<Figure> {
    let (aperture, seed) = (params.real("A"), params.count("seed") as u64);
    let world = scene(aperture)?;
    let pinhole = Regular::new([4, 4, 1, 1, 1])?;
    let strata = Padded::with_count(100)?;
    let picture = |lens: bool, time: bool, pattern: &dyn Pattern<5>| {
        sampled(&Held { world: &world, lens, time }, SIZE, pattern, seed)
    };
    let radiance = picture(true, true, &pinhole)?;
    let lens = picture(false, true, &strata)?;
    let shutter = picture(false, false, &strata)?;
    let coarse = SIZE / COARSE;
    let sensor = resize(&shutter, coarse, coarse, &BoxKernel, Edge::Clamp)?;

    let steps = [&radiance, &lens, &shutter].map(sharpness);
    let range = (0.0, 0.9);
    let spectrum = |name, picture: &Image| -> Result<Panel> {
        let decibels = forward(picture).log_magnitude(FLOOR)?.map(|v| (FLOOR * (1.0 - v)).round());
        let title = text!("spectrum, {FLOOR} to 0 dB", "спектр, от {FLOOR} до 0 дБ");
        Ok(tones(name, title, &decibels, (FLOOR, 0.0), Tones::Data))
    };
    Ok(Figure::new(4)
        .with(grey("radiance", text!("radiance", "яркость сцены"), &radiance, range))
        .with(grey("lens", text!("through the lens", "через линзу"), &lens, range))
        .with(grey("shutter", text!("and the shutter", "и затвор"), &shutter, range))
        .with(grey("sensor", text!("on the sensor", "на сенсоре"), &sensor, range))
        .with(spectrum("radiance-spectrum", &radiance)?)
        .with(spectrum("lens-spectrum", &lens)?)
        .with(spectrum("shutter-spectrum", &shutter)?)
        .with(spectrum("sensor-spectrum", &sensor)?)
        .claim(
            text!(
                "lens and shutter each leave less to alias: differences of neighbours {}, {}, {}",
                "линза и затвор оставляют всё меньше для алиасинга: разности соседей {}, {}, {}",
                number(steps[0].sqrt(), 2),
                number(steps[1].sqrt(), 2),
                number(steps[2].sqrt(), 2)
            ),
            Residual::at_least(
                "least drop of the neighbours' differences",
                (steps[0] / steps[1]).min(steps[1] / steps[2]),
                1.0,
            ),
        )
        .claim(
            text!(
                "the sensor keeps all of the light: the mean is {} before and after",
                "сенсор сохраняет весь свет: среднее {} до и после",
                number(sensor.mean(), 3)
            ),
            // two sums of as many values as there are fine pixels
            Residual::near(
                "mean before and after the sensor",
                sensor.mean(),
                shutter.mean(),
                2.0 * f64::EPSILON * (SIZE * SIZE) as f64,
            ),
        ))
}
