//! The thin lens: why what is out of focus is blurred, and by how much.

use crate::error::{Error, Result, finite, positive};
use crate::num::{cos_pi, sin_pi};

/// The unit square onto the unit disc with equal areas and little distortion: squares around the middle become circles
/// (Shirley, Chiu, *A low distortion map between disk and square*, 1997). Strata of the square stay compact on the lens.
///
/// ```
/// use nyquist::scene::lens::concentric;
/// assert_eq!(concentric([0.5, 0.5]), [0.0, 0.0]);
/// assert_eq!(concentric([1.0, 0.5]), [1.0, 0.0]);
/// let [a, b] = concentric([0.75, 0.75]); // half way out to the corner: radius one half
/// assert!((a.hypot(b) - 0.5).abs() < 1e-15);
/// ```
pub fn concentric([u, v]: [f64; 2]) -> [f64; 2] {
    let (a, b) = (2.0 * u - 1.0, 2.0 * v - 1.0);
    // radius, and the angle in half turns
    let (radius, turn) = match () {
        () if a == 0.0 && b == 0.0 => (0.0, 0.0),
        () if a.abs() > b.abs() => (a, 0.25 * b / a),
        () => (b, 0.5 - 0.25 * a / b),
    };
    [radius * cos_pi(turn), radius * sin_pi(turn)]
}

/// A thin lens and a film behind it, in the lens's own coordinates: the lens in the plane `z = 0` with the optical axis
/// through its middle, the scene at `z > 0`, the film at the distance `d′` behind.
///
/// A point at the distance `z` has its image at `z′` with `1/z + 1/z′ = 1/f`; the film is in focus for the one distance
/// `z_f` with `z′ = d′`. Every other point becomes a circle of confusion of the diameter `c = |(d′ − z′)/z′|·A`, `A` the
/// lens's: in terms of distances in the scene, `c = A·d′·|1/z_f − 1/z|`.
///
/// Film positions are those of the upright picture: the picture on a real film is upside down and mirrored.
///
/// ```
/// use nyquist::prelude::*;
/// let lens = ThinLens::new(0.05, 2.0, 0.025)?; // film 5 cm behind, focus at 2 m, f/1.95
/// assert!((lens.focal_length() - 0.1 / 2.05).abs() < 1e-17);
/// assert!((lens.image_distance(2.0) - 0.05).abs() < 1e-17);
/// assert_eq!(lens.circle_of_confusion(2.0), 0.0);
/// // at infinity the circle is A·d′/z_f
/// assert!((lens.circle_of_confusion(f64::INFINITY) - 0.025 * 0.025).abs() < 1e-18);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ThinLens {
    film: f64,
    focus: f64,
    aperture: f64,
}

impl ThinLens {
    /// The film's distance `d′` behind the lens, the distance `z_f` in focus, and the diameter `A` of the lens; zero for a
    /// pinhole.
    ///
    /// # Errors
    /// Distances that are not positive and finite, a diameter that is negative or not finite.
    pub fn new(film: f64, focus: f64, aperture: f64) -> Result<Self> {
        positive("the distance from the lens to the film", film)?;
        positive("the distance in focus", focus)?;
        let what = "the diameter of a lens";
        if finite(what, aperture)? < 0.0 {
            return Err(Error::OutOfRange { what, value: aperture, low: 0.0, high: f64::MAX });
        }
        Ok(Self { film, focus, aperture })
    }

    /// The same lens and film with another distance in focus: what turning the ring does, up to the film's small shift.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn focused(self, focus: f64) -> Result<Self> {
        Self::new(self.film, focus, self.aperture)
    }

    /// `d′`.
    pub fn film(&self) -> f64 {
        self.film
    }

    /// `z_f`.
    pub fn focus(&self) -> f64 {
        self.focus
    }

    /// `A`.
    pub fn aperture(&self) -> f64 {
        self.aperture
    }

    /// `f = 1/(1/z_f + 1/d′)`.
    pub fn focal_length(&self) -> f64 {
        self.focus * self.film / (self.focus + self.film)
    }

    /// `z′ = 1/(1/f − 1/z)`: where the image of a point at the distance `z` is; infinite at the focal length, negative
    /// (in front of the lens, seen through it) nearer than that.
    pub fn image_distance(&self, z: f64) -> f64 {
        (self.focal_length().recip() - z.recip()).recip()
    }

    /// The diameter of the circle that a point at the distance `z` becomes on the film.
    pub fn circle_of_confusion(&self, z: f64) -> f64 {
        (self.aperture * self.shear(z)).abs()
    }

    /// How far the image of a point at the distance `z` moves on the film for a step of one on the lens:
    /// `d′·(1/z_f − 1/z)`, zero in focus. The slope of the light field in `(x, u)` (Durand and others, *A frequency
    /// analysis of light transport*, 2005); times `A` it is the circle of confusion, with a sign.
    pub fn shear(&self, z: f64) -> f64 {
        self.film * (self.focus.recip() - z.recip())
    }

    /// The point of the lens that belongs to `(u, v)` of the unit square.
    pub fn point(&self, uv: [f64; 2]) -> [f64; 2] {
        concentric(uv).map(|part| 0.5 * self.aperture * part)
    }

    /// Light from a `point` of the scene through a place on the `lens`: where it meets the film.
    ///
    /// Traced as the lens bends it: straight to the lens, there by `−h/f` in slope, straight to the film.
    pub fn to_film(&self, point: [f64; 3], lens: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|i| {
            let arriving = (lens[i] - point[i]) / point[2];
            let leaving = arriving - lens[i] / self.focal_length();
            -(lens[i] + self.film * leaving)
        })
    }

    /// The ray that a place on the `film` receives through a place on the `lens`, as its origin and a point on it: all
    /// rays of one place on the film meet in the plane in focus, there where the one through the middle goes.
    pub fn from_film(&self, film: [f64; 2], lens: [f64; 2]) -> [[f64; 3]; 2] {
        let scale = self.focus / self.film;
        [[lens[0], lens[1], 0.0], [film[0] * scale, film[1] * scale, self.focus]]
    }
}
