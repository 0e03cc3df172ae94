//! Spheres that move.

use crate::error::{Result, positive, within};
use crate::scene::FARTHEST;
use crate::scene::camera::Ray;
use crate::scene::surface::Surface;
use crate::scene::vector::Vector;

/// A sphere on a straight way: its centre is `center + t·velocity` while the shutter is open, `t` from 0 to 1.
///
/// ```
/// use nyquist::prelude::*;
/// let white = Surface::plain([1.0; 3])?;
/// assert!(Sphere::new([0.0, 1.0, 5.0], 1.0, white)?.moving([0.5, 0.0, 0.0]).is_ok());
/// assert!(Sphere::new([0.0, 1.0, 5.0], -1.0, white).is_err());
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sphere {
    center: Vector,
    velocity: Vector,
    pub(in crate::scene) radius: f64,
    pub(in crate::scene) surface: Surface,
}

impl Sphere {
    /// A sphere at rest.
    ///
    /// # Errors
    /// A centre or a radius that is not finite or beyond [`FARTHEST`], a radius that is not positive.
    pub fn new(center: [f64; 3], radius: f64, surface: Surface) -> Result<Self> {
        for part in center {
            within("the centre of a sphere", part, -FARTHEST, FARTHEST)?;
        }
        let what = "the radius of a sphere";
        within(what, positive(what, radius)?, FARTHEST.recip(), FARTHEST)?;
        Ok(Self { center: Vector(center), velocity: Vector([0.0; 3]), radius, surface })
    }

    /// The same on its way, so far in the time that the shutter is open.
    ///
    /// # Errors
    /// A way that is not finite or beyond [`FARTHEST`].
    pub fn moving(self, velocity: [f64; 3]) -> Result<Self> {
        for part in velocity {
            within("the way of a sphere", part, -FARTHEST, FARTHEST)?;
        }
        Ok(Self { velocity: Vector(velocity), ..self })
    }

    /// Its centre at a time.
    pub(in crate::scene) fn center(&self, time: f64) -> Vector {
        self.center + self.velocity * time
    }

    /// How far along the ray its outside is first met.
    pub(in crate::scene) fn meets(&self, ray: &Ray, time: f64) -> Option<f64> {
        let to = self.center(time) - ray.origin;
        let along = to.dot(ray.direction);
        // the distance of the ray from the centre, and not a difference of two large squares
        let aside = to - ray.direction * along;
        let chord = self.radius * self.radius - aside.dot(aside);
        if chord < 0.0 {
            return None;
        }
        let distance = along - chord.sqrt();
        (distance > 0.0).then_some(distance)
    }
}
