//! The generalised scene function `L(x, y, u, v, t)`: what a camera's film receives (slide «Обобщение функции сцены»).
//!
//! A picture of a real camera is an integral over five dimensions: over a pixel's place `(x, y)` on the film, over the
//! points `(u, v)` of the lens, and over the time `t` that the shutter is open. A renderer samples all five. Depth of field
//! and motion blur are nothing but averages over `(u, v)` and `t`, and the noise of a picture is that of their sampling.
//!
//! [`World`](world::World) traces rays through a thin [`lens`] for real, [`Chart`](chart::Chart) makes a scene of any field
//! of the plane, [`catalog`] has scenes by name.

pub mod camera;
pub mod catalog;
pub mod chart;
pub mod lens;
pub mod render;
pub mod sphere;
pub mod sun;
pub mod surface;
mod vector;
pub mod world;

/// The farthest that a thing may be from the origin: beyond it squares of distances lose what they are about.
pub const FARTHEST: f64 = 1e9;

/// A place in the domain of the scene function.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ScenePoint {
    /// `(x, y)` on the film, in heights of the picture from its middle, x to the right and y downwards.
    pub film: [f64; 2],
    /// `(u, v)` on the lens, as a point of the unit square; the middle of the lens is `(½, ½)`.
    pub lens: [f64; 2],
    /// `t` in the time that the shutter is open, from 0 to 1.
    pub time: f64,
}

impl ScenePoint {
    /// Through the middle of the lens, half way through the shutter's time: what a pinhole camera sees at once.
    pub fn still(film: [f64; 2]) -> Self {
        Self { film, lens: [0.5; 2], time: 0.5 }
    }
}

/// A scene: the light that arrives at every place of the film, through every point of the lens, at every time.
///
/// Total and pure: every finite point has a finite value, and the same in every run. Light is linear: red, green, blue.
///
/// ```
/// use nyquist::prelude::*;
/// // a scene of one's own: a dot that crosses the picture while the shutter is open
/// struct Passing;
/// impl Scene for Passing {
///     fn radiance(&self, at: ScenePoint) -> [f64; 3] {
///         [if (at.film[0] - (at.time - 0.5)).abs() < 0.01 { 1.0 } else { 0.0 }; 3]
///     }
/// }
/// let at = |time| Passing.radiance(ScenePoint { time, ..ScenePoint::still([0.25, 0.0]) });
/// assert_eq!([at(0.5), at(0.75)], [[0.0; 3], [1.0; 3]]);
/// ```
pub trait Scene: Send + Sync {
    /// `L(x, y, u, v, t)`.
    fn radiance(&self, at: ScenePoint) -> [f64; 3];
}

impl<S: Scene + ?Sized> Scene for &S {
    fn radiance(&self, at: ScenePoint) -> [f64; 3] {
        (**self).radiance(at)
    }
}

impl<S: Scene + ?Sized> Scene for Box<S> {
    fn radiance(&self, at: ScenePoint) -> [f64; 3] {
        (**self).radiance(at)
    }
}
