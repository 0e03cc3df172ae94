//! What is too fine for a scale and is no grating: edges, grass, hair, cloth with folds.

use crate::inspect::picture::angle;
use crate::inspect::picture::power::PowerSpectrum;
use crate::inspect::picture::wave::{DARKEST, Wave, upward};

/// A region of the plane of frequencies, and what a picture has there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Texture {
    /// The middle of its energy, in cycles a pixel; pointing upward.
    pub frequency: [f64; 2],
    /// Its root mean square over the whole picture, against the picture's mean.
    pub contrast: f64,
}

/// The width of a region in cycles a pixel.
pub const WIDTH: f64 = 1.0 / 16.0;

impl Texture {
    /// Its [direction](angle), in degrees.
    pub fn angle(&self) -> f64 {
        angle(self.frequency)
    }
}

/// The strongest regions beyond `limit = [U, V]`: squares of [`WIDTH`], of which only what is beyond counts, without those in
/// which gratings are listed already.
///
/// ```
/// use nyquist::prelude::*;
/// use nyquist::inspect::picture::power::{Border, PowerSpectrum};
/// use nyquist::inspect::picture::texture::textures;
/// // white noise has the same everywhere: (1/16)² of its variance in a square and as much in the opposite one
/// let noise = |i: u64| 1.0 + 0.1 * nyquist::num::random::normal(5, i, 0);
/// let image = Image::new(Grid::pixels(128, 128)?, (0..1 << 14).map(noise).collect())?;
/// let found = textures(&PowerSpectrum::of(&image, Border::Periodic), [0.25, 0.25], &[], 3);
/// let each = 0.1 * (2.0f64 / 256.0).sqrt();
/// assert!(found.len() == 3 && found.iter().all(|t| (t.contrast / each - 1.0).abs() < 0.35));
/// # Ok::<(), Error>(())
/// ```
pub fn textures(spectrum: &PowerSpectrum, limit: [f64; 2], waves: &[Wave], most: usize) -> Vec<Texture> {
    const CELLS: i64 = (0.5 / WIDTH) as i64;
    let across = 2 * CELLS + 1;
    let cell = |[u, v]: [f64; 2]| {
        let index = |nu: f64| ((nu / WIDTH).floor() as i64).clamp(-CELLS, CELLS) + CELLS;
        (index(v) * across + index(u)) as usize
    };
    let mut sums = vec![[0.0; 3]; (across * across) as usize];
    for ([u, v], energy) in spectrum.energies() {
        if u.abs() > limit[0] || v.abs() > limit[1] {
            let at = upward([u, v]);
            let sum = &mut sums[cell(at)];
            *sum = [sum[0] + energy, sum[1] + energy * at[0], sum[2] + energy * at[1]];
        }
    }
    for wave in waves {
        // and what a window has spread of it
        for (i, j) in [(-0.5, -0.5), (-0.5, 0.5), (0.5, -0.5), (0.5, 0.5)] {
            let [u, v] = wave.frequency;
            sums[cell(upward([u + i * WIDTH, v + j * WIDTH]))][0] = 0.0;
        }
    }
    let mean = spectrum.mean().abs().max(DARKEST);
    let mut found: Vec<Texture> = sums
        .into_iter()
        .filter(|sum| sum[0] > 0.0)
        .map(|[energy, u, v]| Texture { frequency: [u / energy, v / energy], contrast: energy.sqrt() / mean })
        .collect();
    found.sort_by(|a, b| b.contrast.total_cmp(&a.contrast));
    found.truncate(most);
    found
}
