//! Spheres on a floor under a sky, seen by a camera: a ray tracer in one file.

use crate::error::{Result, positive};
use crate::scene::camera::{LensCamera, Ray};
use crate::scene::sphere::Sphere;
use crate::scene::sun::Sun;
use crate::scene::surface::{Surface, light};
use crate::scene::vector::{Vector, mix};
use crate::scene::{Scene, ScenePoint};

/// How often a mirror may show a mirror.
const BOUNCES: u32 = 3;

/// What is above, and how far one sees.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sky {
    horizon: [f64; 3],
    zenith: [f64; 3],
    haze: f64,
}

impl Sky {
    /// The light of the sky at the horizon and overhead.
    ///
    /// # Errors
    /// Light that is negative or not finite.
    pub fn new(horizon: [f64; 3], zenith: [f64; 3]) -> Result<Self> {
        let what = "the light of a sky";
        Ok(Self { horizon: light(what, horizon)?, zenith: light(what, zenith)?, haze: f64::INFINITY })
    }

    /// With haze: at the distance `sight` only `1/e` is left of a thing's own light, the rest is the horizon's.
    ///
    /// # Errors
    /// A distance that is not positive and finite.
    pub fn with_haze(self, sight: f64) -> Result<Self> {
        Ok(Self { haze: positive("the distance that haze lets one see", sight)?, ..self })
    }

    fn light(&self, direction: Vector) -> [f64; 3] {
        mix(self.horizon, self.zenith, direction.0[1].max(0.0).sqrt())
    }

    /// What surfaces get from all of it.
    fn ambient(&self) -> [f64; 3] {
        mix(self.horizon, self.zenith, 0.5)
    }
}

/// A floor at `y = 0`, spheres, one light, a sky, and the camera that looks at them: a [`Scene`].
///
/// ```
/// use nyquist::prelude::*;
/// let camera = LensCamera::new([0.0, 1.0, 0.0], [0.0, 1.0, 5.0], 40.0)?;
/// let sun = Sun::new([0.0, 1.0, -1.0], 2.0, [0.8; 3])?;
/// let sky = Sky::new([0.25; 3], [0.25; 3])?;
/// let sphere = Sphere::new([0.0, 1.0, 5.0], 1.0, Surface::plain([0.5; 3])?)?;
/// let world = World::new(camera, sun, sky).with_sphere(sphere);
/// // in the middle the sphere faces the camera, and the light at 45°: ½·(0.25 + 0.8·cos 45°)
/// let [grey, ..] = world.radiance(ScenePoint::still([0.0, 0.0]));
/// assert!((grey - 0.5 * (0.25 + 0.8 * 0.5f64.sqrt())).abs() < 1e-12);
/// assert_eq!(world.radiance(ScenePoint::still([0.4, 0.0])), [0.25; 3]); // beside it, the sky
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct World {
    camera: LensCamera,
    sun: Sun,
    sky: Sky,
    floor: Option<Surface>,
    spheres: Vec<Sphere>,
}

/// What a ray met: how far, where, the normal, the surface, and which sphere if one.
struct Hit {
    distance: f64,
    place: Vector,
    normal: Vector,
    surface: Surface,
    sphere: Option<usize>,
}

impl World {
    /// An empty world.
    pub fn new(camera: LensCamera, sun: Sun, sky: Sky) -> Self {
        Self { camera, sun, sky, floor: None, spheres: Vec::new() }
    }

    /// With a floor at `y = 0`.
    #[must_use]
    pub fn with_floor(self, surface: Surface) -> Self {
        Self { floor: Some(surface), ..self }
    }

    /// With one more sphere.
    #[must_use]
    pub fn with_sphere(mut self, sphere: Sphere) -> Self {
        self.spheres.push(sphere);
        self
    }

    /// The same seen by another camera.
    #[must_use]
    pub fn seen_by(self, camera: LensCamera) -> Self {
        Self { camera, ..self }
    }

    /// The same under another light.
    #[must_use]
    pub fn lit_by(self, sun: Sun) -> Self {
        Self { sun, ..self }
    }

    /// The camera.
    pub fn camera(&self) -> LensCamera {
        self.camera
    }

    fn meets(&self, ray: &Ray, time: f64, from: Option<usize>) -> Option<Hit> {
        let spheres = self.spheres.iter().enumerate().filter(|(i, _)| from != Some(*i));
        let met = spheres.filter_map(|(i, sphere)| Some((sphere.meets(ray, time)?, i)));
        let nearest = met.min_by(|a, b| a.0.total_cmp(&b.0));
        let drop = ray.direction.0[1];
        let below = -ray.origin.0[1] / drop;
        let floor = self.floor.filter(|_| drop < 0.0 && below > 0.0 && below < f64::INFINITY);
        match (nearest, floor) {
            (Some((distance, i)), floor) if floor.is_none() || distance <= below => {
                let (place, sphere) = (ray.at(distance), &self.spheres[i]);
                let normal = (place - sphere.center(time)) * sphere.radius.recip();
                Some(Hit { distance, place, normal, surface: sphere.surface, sphere: Some(i) })
            }
            (_, Some(surface)) => {
                let Vector([x, _, z]) = ray.at(below);
                let (place, normal) = (Vector([x, 0.0, z]), Vector([0.0, 1.0, 0.0]));
                Some(Hit { distance: below, place, normal, surface, sphere: None })
            }
            _ => None,
        }
    }

    /// The share of the sun that a point sees. Several spheres hide independent parts of it.
    fn sunlight(&self, hit: &Hit, time: f64) -> f64 {
        let others = self.spheres.iter().enumerate().filter(|(i, _)| hit.sphere != Some(*i));
        others.map(|(_, sphere)| self.sun.share(hit.place, sphere, time)).product()
    }

    fn trace(&self, ray: &Ray, time: f64, from: Option<usize>, bounces: u32) -> [f64; 3] {
        let Some(hit) = self.meets(ray, time, from) else { return self.sky.light(ray.direction) };
        let surface = hit.surface;
        let color = surface.color(hit.place.0[0], hit.place.0[2]);
        let facing = hit.normal.dot(self.sun.direction);
        let (mut lit, mut shine) = (0.0, 0.0);
        if facing > 0.0 {
            let sunlight = self.sunlight(&hit, time);
            lit = facing * sunlight;
            if surface.highlight > 0.0 {
                let half = (self.sun.direction - ray.direction).unit();
                shine = surface.highlight * sunlight * hit.normal.dot(half).max(0.0).powf(surface.exponent);
            }
        }
        let ambient = self.sky.ambient();
        let mut seen = [0, 1, 2].map(|i| color[i] * (ambient[i] + lit * self.sun.light[i]));
        if surface.mirror > 0.0 && bounces > 0 {
            let turned = ray.direction - hit.normal * (2.0 * hit.normal.dot(ray.direction));
            let mirrored = self.trace(&Ray { origin: hit.place, direction: turned }, time, hit.sphere, bounces - 1);
            seen = mix(seen, mirrored, surface.mirror);
        }
        let seen = [0, 1, 2].map(|i| seen[i] + shine * self.sun.light[i]);
        match self.sky.haze {
            haze if haze.is_finite() => mix(self.sky.horizon, seen, (-hit.distance / haze).exp()),
            _ => seen,
        }
    }
}

impl Scene for World {
    fn radiance(&self, at: ScenePoint) -> [f64; 3] {
        self.trace(&self.camera.ray(at.film, at.lens), at.time, None, BOUNCES)
    }
}
