//! A camera with a lens, somewhere in space.

use crate::error::{Error, Result, within};
use crate::scene::FARTHEST;
use crate::scene::lens::ThinLens;
use crate::scene::vector::Vector;

/// A [`ThinLens`] that stands somewhere and looks somewhere; upwards is `+y`.
///
/// Film positions are counted in heights of the picture from its middle, x to the right and y downwards: a picture is
/// `−½ … ½` high and as wide as it is.
///
/// ```
/// use nyquist::prelude::*;
/// let camera = LensCamera::new([0.0, 0.0, 0.0], [0.0, 0.0, 5.0], 90.0)?.with_lens(0.5, 5.0)?;
/// // 90° from top to bottom: at the distance 5 the picture is 10 high, and what is there is in focus
/// for lens in [[0.5, 0.5], [0.9, 0.2]] {
///     let [x, y] = camera.film_position([2.5, -5.0, 5.0], lens);
///     assert!((x - 0.25).abs() < 1e-15 && (y - 0.5).abs() < 1e-15);
/// }
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LensCamera {
    eye: Vector,
    right: Vector,
    down: Vector,
    forward: Vector,
    lens: ThinLens,
    height: f64,
}

impl LensCamera {
    /// A pinhole at `eye` that looks at a point, with a field of view of so many degrees from top to bottom.
    ///
    /// # Errors
    /// Places that are not finite or beyond [`FARTHEST`]; a direction of view that is zero or straight up or down; a field of view that is not
    /// between 0.01° and 179°.
    pub fn new(eye: [f64; 3], at: [f64; 3], degrees: f64) -> Result<Self> {
        for part in eye.into_iter().chain(at) {
            within("the place of a camera, and what it looks at,", part, -FARTHEST, FARTHEST)?;
        }
        within("the field of view of a camera, in degrees,", degrees, 0.01, 179.0)?;
        let forward = (Vector(at) - Vector(eye)).unit();
        let right = Vector([0.0, 1.0, 0.0]).cross(forward).unit();
        if !right.length().is_finite() {
            return Err(Error::Unsupported("a camera needs a direction of view, and not straight up or down"));
        }
        let down = right.cross(forward);
        let height = 2.0 * (0.5 * degrees.to_radians()).tan();
        Ok(Self { eye: Vector(eye), right, down, forward, lens: ThinLens::new(1.0, 1.0, 0.0)?, height })
    }

    /// The same with a lens of the diameter `aperture`, in focus at the distance `focus`.
    ///
    /// # Errors
    /// As [`ThinLens::new`].
    pub fn with_lens(self, aperture: f64, focus: f64) -> Result<Self> {
        Ok(Self { lens: ThinLens::new(self.lens.film(), focus, aperture)?, ..self })
    }

    /// Its lens, with the film at the distance one behind it.
    pub fn lens(&self) -> ThinLens {
        self.lens
    }

    /// The diameter, in heights of the picture, of the circle that a point at the distance `z` becomes.
    pub fn circle_of_confusion(&self, z: f64) -> f64 {
        self.lens.circle_of_confusion(z) / self.height
    }

    /// Where the light of a point of space that passes `(u, v)` of the lens meets the film.
    pub fn film_position(&self, point: [f64; 3], uv: [f64; 2]) -> [f64; 2] {
        let seen = Vector(point) - self.eye;
        let point = [self.right, self.down, self.forward].map(|axis| seen.dot(axis));
        self.lens.to_film(point, self.lens.point(uv)).map(|part| part / self.height)
    }

    /// The ray that a film position receives through `(u, v)` of the lens: its origin and its unit direction.
    pub(in crate::scene) fn ray(&self, film: [f64; 2], uv: [f64; 2]) -> Ray {
        let lens = self.lens.point(uv);
        let [from, to] = self.lens.from_film(film.map(|part| part * self.height), lens).map(Vector);
        let turned = |Vector([x, y, z]): Vector| self.right * x + self.down * y + self.forward * z;
        Ray { origin: self.eye + turned(from), direction: turned(to - from).unit() }
    }
}

/// A half line.
#[derive(Debug, Clone, Copy)]
pub(in crate::scene) struct Ray {
    pub(in crate::scene) origin: Vector,
    /// Of length one.
    pub(in crate::scene) direction: Vector,
}

impl Ray {
    pub(in crate::scene) fn at(&self, distance: f64) -> Vector {
        self.origin + self.direction * distance
    }
}
