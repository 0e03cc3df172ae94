//! The scene that filters are tried on, and what they did to it, measured in its pictures.

use crate::error::Result;
use crate::field::Field;
use crate::field::bricks::BrickWall;
use crate::field::glyphs::Glyphs;
use crate::field::zone_plate::ZonePlate;
use crate::figure::film::weights::samples;
use crate::film::{Film, Sample};
use crate::grid::Grid;
use crate::image::Image;
use crate::kernel::Kernel;

/// Pixels along a side.
const SIDE: usize = 96;

/// A wall of bricks on the left with a dark post before it, rings that grow too fine on the right, letters on a plate below
/// them.
struct Scene {
    wall: BrickWall,
    rings: ZonePlate,
    letters: Glyphs,
}

/// Brightness of the darkest and the brightest parts.
pub(super) const RANGE: [f64; 2] = [0.06, 0.92];
/// Where the rings end, and the plate begins.
const PLATE: f64 = 50.7;
/// The middle of the rings, from which their frequency grows as `r/95`.
const RINGS: ([f64; 2], f64) = ([96.0, 0.0], 95.0);

/// The right side of the post at a height: slanted, so that it meets pixels in every way.
fn side_of_post(y: f64) -> f64 {
    46.3 + 0.05 * (y - 72.0)
}

impl Scene {
    fn new() -> Result<Self> {
        Ok(Self {
            wall: BrickWall::new([13.7, 6.3], 1.1, [0.38, RANGE[1]])?,
            rings: ZonePlate::new(RINGS.1)?,
            letters: Glyphs::new("ШAV", [51.0, 56.0], 14.3)?,
        })
    }
}

impl Field for Scene {
    fn at(&self, x: f64, y: f64) -> f64 {
        let [dark, bright] = RANGE;
        let beside = x - side_of_post(y);
        if beside < -5.0 {
            self.wall.at(x, y + 0.04 * x)
        } else if beside < 0.0 {
            dark
        } else if y < PLATE {
            dark + (bright - dark) * self.rings.at(x - RINGS.0[0], y - RINGS.0[1])
        } else {
            bright - (bright - dark) * self.letters.at(x, y)
        }
    }
}

/// One set of samples for all filters, as far beyond the frame as the widest of them reaches.
pub(super) fn one_set(n: usize, seed: u64) -> Result<Vec<Sample<1>>> {
    const REACH: i64 = 4;
    let (scene, side) = (Scene::new()?, -REACH..SIDE as i64 + REACH);
    samples(side.clone(), side, n, seed, |x, y| scene.at(x, y))
}

pub(super) fn developed(kernel: &dyn Kernel, samples: &[Sample<1>]) -> Result<Image> {
    Ok(Film::new(Grid::pixels(SIDE, SIDE)?, kernel)?.develop(samples)?.image().clone())
}

/// What a filter did, measured in its picture.
pub(super) struct Found {
    /// How wide a ramp from dark to bright would be that is as far from the post's sharp side as the pixels are, in pixels.
    pub(super) ramp: f64,
    /// How much brighter than the plate it is on average between one and two pixels beside the post, in parts of the step.
    pub(super) halo: f64,
    /// The power of the pixels where all rings are beyond Nyquist, in parts of the power that the rings have.
    pub(super) alias: f64,
}

impl Found {
    pub(super) fn of(image: &Image) -> Self {
        let [dark, bright] = RANGE;
        let pixels = || image.grid().iter().zip(image.values());
        // rows of the plate, as far from its end as filters reach
        let across = || {
            let rows = pixels().filter(|([_, y], _)| *y > PLATE + 3.0 && *y < SIDE as f64 - 2.0);
            rows.map(|([x, y], v)| (x - side_of_post(y), (v - dark) / (bright - dark)))
        };
        // of a ramp from −w/2 to w/2 the distance to a step is w/4 in every row
        let near = || across().filter(|(beside, _)| beside.abs() < 2.5);
        let rows = near().count() as f64 / 5.0;
        let off: f64 = near().map(|(beside, v)| (v - f64::from(u8::from(beside > 0.0))).abs()).sum();
        let next: Vec<f64> = across().filter(|(beside, _)| (1.0..2.0).contains(beside)).map(|(_, v)| v - 1.0).collect();
        let fine = pixels().filter(|([x, y], _)| {
            let [u, v] = [x - RINGS.0[0], y - RINGS.0[1]];
            u.hypot(v) > 0.55 * RINGS.1 && *y < PLATE - 3.0 && x - side_of_post(*y) > 3.0
        });
        let fine: Vec<f64> = fine.map(|(_, v)| *v).collect();
        let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
        let middle = 0.5 * (dark + bright);
        let squares: Vec<f64> = fine.iter().map(|v| (v - middle).powi(2)).collect();
        // rings are waves from dark to bright: half of the square of their amplitude
        Self { ramp: 4.0 * off / rows, halo: mean(&next), alias: mean(&squares) / (0.5 * (bright - middle).powi(2)) }
    }
}
