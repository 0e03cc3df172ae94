//! A flat picture as a scene.

use crate::error::Result;
use crate::field::Field;
use crate::scene::surface::light;
use crate::scene::vector::mix;
use crate::scene::{Scene, ScenePoint};

/// A [`Field`] in place of a world: the same through every point of the lens and at all times.
///
/// The field is laid out in heights of the picture, with its origin in the middle and `y` downwards.
///
/// ```
/// use nyquist::prelude::*;
/// let chart = Chart::new(ZonePlate::new(1.0 / 512.0)?);
/// assert_eq!(chart.radiance(ScenePoint::still([0.0, 0.0])), [1.0; 3]);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Chart<F> {
    field: F,
    colors: [[f64; 3]; 2],
}

impl<F> Chart<F> {
    /// `field` as a grey scene.
    pub fn new(field: F) -> Self {
        Self { field, colors: [[0.0; 3], [1.0; 3]] }
    }

    /// The same with a colour for the value zero and one for the value one.
    ///
    /// # Errors
    /// Light that is negative or not finite.
    pub fn in_colors(self, zero: [f64; 3], one: [f64; 3]) -> Result<Self> {
        let what = "the light of a chart";
        Ok(Self { colors: [light(what, zero)?, light(what, one)?], ..self })
    }
}

impl<F: Field + Send + Sync> Scene for Chart<F> {
    fn radiance(&self, at: ScenePoint) -> [f64; 3] {
        let [zero, one] = self.colors;
        mix(zero, one, self.field.at(at.film[0], at.film[1]))
    }
}
