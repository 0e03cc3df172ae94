//! Pictures that tests are made of.

use nyquist::prelude::*;

/// Stripes of a contrast around a mean: frequency in cycles a pixel.
pub(crate) struct Stripes {
    pub(crate) frequency: [f64; 2],
    pub(crate) contrast: f64,
    pub(crate) mean: f64,
}

impl Stripes {
    pub(crate) fn at(&self, x: f64, y: f64) -> f64 {
        let cycles = self.frequency[0] * x + self.frequency[1] * y;
        self.mean * (1.0 + self.contrast * (std::f64::consts::TAU * cycles.rem_euclid(1.0)).cos())
    }
}

pub(crate) fn image(width: usize, height: usize, f: impl Fn(f64, f64) -> f64) -> Image {
    Image::of(&field_fn(f), Grid::pixels(width, height).expect("a small picture"))
}

/// A photograph that comes with the project, in linear light.
#[cfg(feature = "files")]
pub(crate) fn photograph() -> Image {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("data/camera.png");
    nyquist::door::open_picture(&path, Limits::default()).expect("it is in the repository").luminance()
}

/// The amplitude of `cos 2π(ux + vy)` of any phase in a rectangle, by least squares: an oracle that knows no windows.
pub(crate) fn fitted(image: &Image, frequency: [f64; 2], corner: [usize; 2], size: [usize; 2]) -> f64 {
    let [cos, sin] = fit(image, frequency, corner, size, |_| 1.0);
    sin.hypot(cos)
}

/// `a` and `b` of `m + a·cos 2π(ux + vy) + b·sin 2π(ux + vy)` in a rectangle, by least squares with a weight along either
/// side, a function of the position from 0 to 1.
pub(crate) fn fit(
    image: &Image,
    frequency: [f64; 2],
    corner: [usize; 2],
    size: [usize; 2],
    weight: impl Fn(f64) -> f64,
) -> [f64; 2] {
    let mut normal = [[0.0; 3]; 3];
    let mut right = [0.0; 3];
    for (down, y) in (corner[1]..corner[1] + size[1]).enumerate() {
        for (across, x) in (corner[0]..corner[0] + size[0]).enumerate() {
            let cycles = frequency[0] * (x as f64 + 0.5) + frequency[1] * (y as f64 + 0.5);
            let (sin, cos) = (std::f64::consts::TAU * cycles.rem_euclid(1.0)).sin_cos();
            let place = |index: usize, n: usize| weight((index as f64 + 0.5) / n as f64);
            let (basis, w) = ([1.0, cos, sin], place(across, size[0]) * place(down, size[1]));
            for i in 0..3 {
                right[i] += w * basis[i] * image.at(x, y);
                (0..3).for_each(|j| normal[i][j] += w * basis[i] * basis[j]);
            }
        }
    }
    // elimination of a 3 × 3 system that is positive definite
    for i in 0..3 {
        for k in i + 1..3 {
            let factor = normal[k][i] / normal[i][i];
            (0..3).for_each(|j| normal[k][j] -= factor * normal[i][j]);
            right[k] -= factor * right[i];
        }
    }
    let sin = right[2] / normal[2][2];
    [(right[1] - normal[1][2] * sin) / normal[1][1], sin]
}
