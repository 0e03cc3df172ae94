//! From a scene to a picture.

use crate::antialias::supersample::pixel_seed;
use crate::error::{Error, Result};
use crate::film::{Film, Sample};
use crate::grid::Grid;
use crate::image::Rgb;
use crate::kernel::Kernel;
use crate::pattern::Pattern;
use crate::scene::{Scene, ScenePoint};

/// The most pixels of a rendered picture: 2²⁵, two gigabytes while it is made.
pub const MOST_PIXELS: usize = 1 << 25;

/// The most samples that one row of pixels may have: 2²⁴.
pub const MOST_IN_A_ROW: usize = 1 << 24;

/// The largest radius of a kernel, in pixels: with it every sample is weighed for more than four thousand pixels.
pub const MOST_FILTER_RADIUS: f64 = 32.0;

fn most(what: &'static str, factors: [usize; 2], most: usize) -> Result<()> {
    match factors[0].checked_mul(factors[1]) {
        Some(n) if n <= most => Ok(()),
        _ => Err(Error::Overflow { what, value: factors[0] as f64 * factors[1] as f64, most: most as f64 }),
    }
}

/// A picture of a scene: in every pixel a pattern of samples in all five dimensions, weighed by a kernel.
///
/// Every pixel has the pattern of its own seed; samples of pixels just beyond the frame are taken too, as far as the
/// kernel reaches. A pure function of its arguments: the same bits for any number of threads.
///
/// ```
/// use nyquist::prelude::*;
/// use nyquist::scene::catalog::by_name;
/// let scene = by_name("defocus")?.scene();
/// let picture = |n| render(&*scene, 24, 16, &Padded::with_count(n)?, &BoxKernel, 1).map(|rgb| rgb.luminance());
/// let [reference, few, many] = [picture(1024)?, picture(4)?, picture(64)?];
/// assert!(many.rmse(&reference)? < 0.3 * few.rmse(&reference)?); // sixteen times the rays: a quarter, were they random
/// # Ok::<(), Error>(())
/// ```
///
/// # Errors
/// A picture without pixels or with more than [`MOST_PIXELS`], more samples a row than [`MOST_IN_A_ROW`], a kernel of a
/// radius beyond [`MOST_FILTER_RADIUS`].
pub fn render(
    scene: &(impl Scene + ?Sized),
    width: usize,
    height: usize,
    pattern: &dyn Pattern<5>,
    kernel: &dyn Kernel,
    seed: u64,
) -> Result<Rgb> {
    render_watched(scene, [width, height], pattern, kernel, seed, || ())
}

/// [`render`], telling `watch` of every row of samples that is done: one for every row of pixels, and some that a kernel needs twice.
///
/// # Errors
/// As [`render`].
pub fn render_watched(
    scene: &(impl Scene + ?Sized),
    [width, height]: [usize; 2],
    pattern: &dyn Pattern<5>,
    kernel: &dyn Kernel,
    seed: u64,
    watch: impl Fn() + Sync + Send,
) -> Result<Rgb> {
    most("the number of pixels of a picture", [width, height], MOST_PIXELS)?;
    if kernel.radius().is_finite() && kernel.radius() > MOST_FILTER_RADIUS {
        let what =
            "the radius of a rendered picture's kernel, in pixels (wider ones take a sample into thousands of pixels),";
        return Err(Error::OutOfRange { what, value: kernel.radius(), low: 0.0, high: MOST_FILTER_RADIUS });
    }
    let film = Film::new(Grid::pixels(width, height)?, kernel)?;
    let wide = width + 2 * film.reach();
    most(
        "the number of samples in a row of pixels and beside it",
        [wide, pattern.count().unwrap_or(1)],
        MOST_IN_A_ROW,
    )?;
    let reach = film.reach() as i64;
    // a pixel in heights of the picture, and where the picture's middle is
    let (pixel, middle) = ((height as f64).recip(), [0.5 * width as f64, 0.5 * height as f64]);
    let exposure = film.expose(|row| {
        let mut samples = Vec::new();
        for column in -reach..width as i64 + reach {
            for [x, y, time, u, v] in pattern.points(pixel_seed(seed, column, row)) {
                let at = [column as f64 + x, row as f64 + y];
                let film = [0, 1].map(|i| (at[i] - middle[i]) * pixel);
                samples.push(Sample { at, light: scene.radiance(ScenePoint { film, lens: [u, v], time }) });
            }
        }
        watch();
        samples
    });
    Ok(exposure.rgb())
}
