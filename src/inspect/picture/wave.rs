//! A grating that was found in a picture.

use crate::image::Image;
use crate::inspect::picture::angle;
use crate::inspect::picture::patch::Patch;

/// A grating: stripes of one frequency in a part of a picture, `m + a·cos(2π(ux + vy) + φ)`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wave {
    /// `(u, v)` in cycles a pixel, one of the two opposite ones: the one whose [`angle`] is below 180°.
    pub frequency: [f64; 2],
    /// `a`, in linear light.
    pub amplitude: f64,
    /// `m`, the mean around.
    pub mean: f64,
    /// The corner of the part where it was found, in pixels.
    pub corner: [usize; 2],
    /// The width and height of this part; the grating is weighed by a window that is highest in its middle.
    pub size: [usize; 2],
}

/// Contrast is counted against no less than this: in a lit room no screen is darker than 1 % of its white.
pub const DARKEST: f64 = 0.01;

impl Wave {
    /// The wave of about that frequency in a part of a picture: its frequency, and amplitude, to what the part resolves.
    ///
    /// A wave that fills the part has its frequency to about 10⁻⁶ of a bin; others, noise and gradients move it.
    ///
    /// ```
    /// use nyquist::prelude::*;
    /// use nyquist::inspect::picture::wave::Wave;
    /// let stripes = Grating::new([0.3127, -0.21])?;
    /// let image = Image::of(&stripes, Grid::pixels(64, 64)?).map(|v| 0.5 + 0.1 * v);
    /// let wave = Wave::near(&image, [0.31, -0.2], [0, 0], [64, 64]);
    /// assert!((wave.frequency[0] - 0.3127).abs() < 1e-6 && (wave.frequency[1] + 0.21).abs() < 1e-6);
    /// assert!((wave.contrast() - 0.2).abs() < 1e-5);
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Panics
    /// A part that does not lie inside the picture.
    pub fn near(image: &Image, frequency: [f64; 2], corner: [usize; 2], size: [usize; 2]) -> Self {
        let patch = Patch::of(image, corner, size);
        let frequency = patch.refined(frequency);
        let amplitude = patch.amplitude(frequency);
        Self { frequency: upward(frequency), amplitude, mean: patch.mean, corner, size }
    }

    /// `a` of exactly that frequency in a part of a picture: what is there of a predicted wave.
    ///
    /// # Panics
    /// A part that does not lie inside the picture.
    pub fn at(image: &Image, frequency: [f64; 2], corner: [usize; 2], size: [usize; 2]) -> Self {
        let patch = Patch::of(image, corner, size);
        let amplitude = patch.amplitude(frequency);
        Self { frequency: upward(frequency), amplitude, mean: patch.mean, corner, size }
    }

    /// Michelson's contrast `(max − min)/(max + min) = a/m`; in the dark against [`DARKEST`].
    pub fn contrast(&self) -> f64 {
        self.amplitude / self.mean.max(DARKEST)
    }

    /// The period across its stripes, in pixels.
    pub fn period(&self) -> f64 {
        1.0 / self.frequency[0].hypot(self.frequency[1])
    }

    /// Its [direction](angle), in degrees.
    pub fn angle(&self) -> f64 {
        angle(self.frequency)
    }

    /// The middle of the part where it was found, in pixels.
    pub fn middle(&self) -> [f64; 2] {
        [0, 1].map(|i| self.corner[i] as f64 + 0.5 * self.size[i] as f64)
    }
}

/// Of a frequency and its opposite the one that points right, or up; between −½ and ½, where samples tell it apart.
pub(super) fn upward(frequency: [f64; 2]) -> [f64; 2] {
    let [u, v] = frequency.map(|nu| nu - nu.round());
    let turned = v > 0.0 || v == 0.0 && u < 0.0;
    let [u, v] = if turned { [-u, -v] } else { [u, v] };
    // ½ and −½ are one frequency
    if v == -0.5 && u < 0.0 { [-u, v] } else { [u, v] }
}
