//! Light from far away that is not a point: the source of soft shadows.

use crate::error::{Error, Result, all_finite, within};
use crate::scene::sphere::Sphere;
use crate::scene::surface::light;
use crate::scene::vector::Vector;
use std::f64::consts::PI;

/// A round light at infinity, seen under an angular radius: zero for a point with hard shadows, 0.27° for the real sun.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sun {
    pub(in crate::scene) direction: Vector,
    radius: f64,
    sin: f64,
    cos: f64,
    pub(in crate::scene) light: [f64; 3],
}

impl Sun {
    /// The direction towards the light, its angular radius in degrees, and what it gives to a surface that faces it.
    ///
    /// # Errors
    /// A direction that is zero or not finite, a radius outside `0° … 30°`, light that is negative or not finite.
    pub fn new(direction: [f64; 3], degrees: f64, given: [f64; 3]) -> Result<Self> {
        all_finite("the direction of a light", &direction)?;
        let direction = Vector(direction).unit();
        if !direction.length().is_finite() {
            return Err(Error::Unsupported("a light needs a direction"));
        }
        within("the angular radius of a light, in degrees,", degrees, 0.0, 30.0)?;
        let radius = degrees.to_radians();
        let light = light("the light of a sun", given)?;
        Ok(Self { direction, radius, sin: radius.sin(), cos: radius.cos(), light })
    }

    /// The share of the light that a sphere leaves to a point at a time: one minus the overlap of two discs.
    ///
    /// Seen from the point, light and sphere are discs of known angular radii at a known angle. What the sphere hides is
    /// their [`overlap`] in closed form: a soft shadow without noise. (Discs in a plane stand for caps of the sphere of
    /// directions: equal up to the square of the light's radius.)
    pub(in crate::scene) fn share(&self, point: Vector, sphere: &Sphere, time: f64) -> f64 {
        let to = sphere.center(time) - point;
        let along = to.dot(self.direction);
        let aside = self.direction.cross(to).length();
        // clear of the cone of the light: most spheres, most of the time
        let clear = aside * self.cos - along * self.sin >= sphere.radius;
        let distance = to.length();
        if clear || along <= -sphere.radius || distance <= sphere.radius {
            return 1.0;
        }
        let between = aside.atan2(along);
        1.0 - overlap(self.radius, (sphere.radius / distance).asin(), between)
    }
}

/// The share of a disc of radius `own` that a disc of radius `other` hides, its centre at the distance `between`.
///
/// Two circular segments over the common chord; a disc without an area is hidden or not.
///
/// ```
/// use nyquist::scene::sun::overlap;
/// assert_eq!([overlap(1.0, 2.0, 0.5), overlap(1.0, 2.0, 3.5)], [1.0, 0.0]);
/// assert_eq!(overlap(2.0, 1.0, 0.5), 0.25); // wholly inside
/// // two equal discs through each other's middle: 2π/3 − √3/2 of π
/// let lens = 2.0 / 3.0 - 3f64.sqrt() / (2.0 * std::f64::consts::PI);
/// assert!((overlap(1.0, 1.0, 1.0) - lens).abs() < 1e-15);
/// ```
pub fn overlap(own: f64, other: f64, between: f64) -> f64 {
    if between >= own + other {
        return 0.0;
    }
    if between <= (other - own).abs() {
        return if other >= own { 1.0 } else { (other / own).powi(2) };
    }
    // the chord's distance from each centre
    let from_own = 0.5 * (between + (own - other) * (own + other) / between);
    let segment = |radius: f64, distance: f64| {
        let cosine = (distance / radius).clamp(-1.0, 1.0);
        radius * radius * (cosine.acos() - cosine * (1.0 - cosine * cosine).sqrt())
    };
    (segment(own, from_own) + segment(other, between - from_own)) / (PI * own * own)
}
