//! A floor seen in perspective.

use crate::error::{Result, finite, positive};
use crate::field::Field;

/// A pinhole camera over a floor that reaches to the horizon: `(x, y)` sees the point
/// `(u, v) = (h·(x − x₀)/(y − y₀), h·f/(y − y₀))` of the floor, with the horizon at `y = y₀` and the floor beyond it
/// (towards greater `y`, downwards in a picture).
///
/// The frequency of what lies on the floor grows without a bound towards the horizon: in the direction of `y` by
/// `h·f/(y − y₀)²` for a floor of frequency one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Camera {
    focal: f64,
    height: f64,
    horizon: [f64; 2],
}

impl Camera {
    /// Focal length `f` and the point of the picture straight ahead, `(x₀, y₀)`, in the picture's units; the camera's
    /// height `h` above the floor in the floor's.
    ///
    /// # Errors
    /// A focal length or height that is not positive and finite, a point that is not finite.
    pub fn new(focal: f64, height: f64, horizon: [f64; 2]) -> Result<Self> {
        positive("the focal length of a camera", focal)?;
        positive("the height of a camera", height)?;
        for part in horizon {
            finite("the place of the horizon", part)?;
        }
        Ok(Self { focal, height, horizon })
    }

    /// The focal length, in the picture's units.
    pub fn focal(&self) -> f64 {
        self.focal
    }

    /// The height above the floor, in the floor's units.
    pub fn height(&self) -> f64 {
        self.height
    }

    /// The point straight ahead.
    pub fn horizon(&self) -> [f64; 2] {
        self.horizon
    }

    /// The point of the floor that is seen at `(x, y)`, or `None` at the horizon and above.
    pub fn floor(&self, x: f64, y: f64) -> Option<[f64; 2]> {
        let (x, y) = (x - self.horizon[0], y - self.horizon[1]);
        (y > 0.0).then(|| [self.height * x / y, self.height * self.focal / y])
    }
}

/// A field laid out on the floor and seen by a [`Camera`]; `sky` at the horizon and above.
///
/// ```
/// use nyquist::prelude::*;
/// let camera = Camera::new(64.0, 1.0, [64.0, 0.0])?;
/// let seen = Perspective::new(camera, field_fn(|u, v| u + 100.0 * v), -1.0)?;
/// assert_eq!(seen.at(64.0 + 16.0, 32.0), 0.5 + 200.0);
/// assert_eq!(seen.at(10.0, -5.0), -1.0);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Perspective<F> {
    camera: Camera,
    field: F,
    sky: f64,
}

impl<F> Perspective<F> {
    /// `field` on the floor.
    ///
    /// # Errors
    /// A sky that is not finite.
    pub fn new(camera: Camera, field: F, sky: f64) -> Result<Self> {
        Ok(Self { camera, field, sky: finite("the value of the sky", sky)? })
    }

    /// The camera.
    pub fn camera(&self) -> Camera {
        self.camera
    }

    /// What lies on the floor.
    pub fn field(&self) -> &F {
        &self.field
    }

    /// The value above the horizon.
    pub fn sky(&self) -> f64 {
        self.sky
    }
}

impl<F: Field> Field for Perspective<F> {
    fn at(&self, x: f64, y: f64) -> f64 {
        match self.camera.floor(x, y) {
            Some([u, v]) => self.field.at(u, v),
            None => self.sky,
        }
    }
}
