//! How much of the plane of frequencies a picture fills.

use crate::error::Result;
use crate::image::radial::radial_mean;
use crate::inspect::picture::power::PowerSpectrum;
use crate::sampled::occupied::band_of;

/// The band that holds a part of the energy of a picture without its mean, in cycles a pixel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Band {
    /// What part.
    pub fraction: f64,
    /// `|u|` is below this for that part.
    pub across: f64,
    /// `|v|` is.
    pub down: f64,
    /// `√(u² + v²)` is.
    pub radial: f64,
    /// `max(|u|, |v|)` is: the square that holds it, half as wide as the scale to which the picture can be shrunk.
    pub square: f64,
}

impl Band {
    /// The parts of the energy that are usually stated.
    pub const FRACTIONS: [f64; 3] = [0.99, 0.999, 0.9999];

    /// The band that holds at least `fraction` of the energy, to one bin. Zero of an even picture.
    ///
    /// ```
    /// use nyquist::prelude::*;
    /// use nyquist::inspect::picture::band::Band;
    /// use nyquist::inspect::picture::power::PowerSpectrum;
    /// let image = Image::of(&Grating::new([0.25, 0.125])?, Grid::pixels(64, 64)?);
    /// let band = Band::of(&PowerSpectrum::of(&image, "none".parse()?), 0.999)?;
    /// assert_eq!((band.across, band.down, band.radial), (0.25, 0.125, 0.25f64.hypot(0.125)));
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    /// A fraction that is not strictly between zero and one.
    pub fn of(spectrum: &PowerSpectrum, fraction: f64) -> Result<Self> {
        let by = |size: fn([f64; 2]) -> f64| {
            let energies = spectrum.energies().map(|(at, e)| [size(at), e]).collect();
            band_of(energies, fraction)
        };
        Ok(Self {
            fraction,
            across: by(|[u, _]| u.abs())?,
            down: by(|[_, v]| v.abs())?,
            radial: by(|[u, v]| u.hypot(v))?,
            square: by(|[u, v]| u.abs().max(v.abs()))?,
        })
    }
}

/// How a spectrum falls along one direction: means over pieces of it, and what can be read from them.
#[derive(Debug, Clone, PartialEq)]
pub struct Fall {
    /// Frequencies, rising, and mean powers.
    pub levels: Vec<[f64; 2]>,
}

/// How many pieces between zero and the Nyquist frequency.
const PIECES: usize = 64;

impl Fall {
    /// Over rings around zero, to the lower of the two Nyquist frequencies.
    pub fn radial(spectrum: &PowerSpectrum) -> Self {
        let rings = radial_mean(spectrum.power(), PIECES).unwrap_or_default();
        Self { levels: rings.into_iter().map(|ring| [ring.frequency, ring.power]).collect() }
    }

    /// Across (`axis` 0) or down (1), over all frequencies of the other direction.
    pub fn along(spectrum: &PowerSpectrum, axis: usize) -> Self {
        let mut sums = [[0.0; 3]; PIECES];
        let power = spectrum.power();
        for (at, power) in power.grid().iter().zip(power.values()) {
            let nu = at[axis].abs();
            let piece = ((2.0 * nu * PIECES as f64) as usize).min(PIECES - 1);
            sums[piece] = [sums[piece][0] + nu, sums[piece][1] + power, sums[piece][2] + 1.0];
        }
        let filled = sums.into_iter().filter(|sum| sum[2] > 0.0);
        Self { levels: filled.map(|[nu, power, count]| [nu / count, power / count]).collect() }
    }

    /// The same with geometric means: what is typical across the other direction, whatever lines stand out of it.
    pub fn typical(spectrum: &PowerSpectrum, axis: usize) -> Self {
        let power = spectrum.power();
        let mut sums = [[0.0; 3]; PIECES];
        for (at, power) in power.grid().iter().zip(power.values()) {
            let nu = at[axis].abs();
            let sum = &mut sums[((2.0 * nu * PIECES as f64) as usize).min(PIECES - 1)];
            *sum = [sum[0] + nu, sum[1] + power.max(f64::MIN_POSITIVE).ln(), sum[2] + 1.0];
        }
        let filled = sums.into_iter().filter(|sum| sum[2] > 0.0);
        Self { levels: filled.map(|[nu, log, count]| [nu / count, (log / count).exp()]).collect() }
    }

    /// The floor: the least level of three neighbouring pieces together; and the highest frequency that stands more than
    /// twice above it (3 dB), zero if none does.
    ///
    /// A spectrum that still falls at the end has its last level for a floor.
    pub fn floor(&self) -> [f64; 2] {
        let threes = self.levels.windows(3).map(|three| three.iter().map(|l| l[1]).sum::<f64>() / 3.0);
        let floor = threes.fold(f64::INFINITY, f64::min);
        let least = if floor.is_finite() { floor } else { self.levels.iter().map(|l| l[1]).fold(0.0, f64::max) };
        let above = self.levels.iter().rev().find(|[_, level]| *level > 2.0 * least);
        [least, above.map_or(0.0, |l| l[0])]
    }

    /// Where the spectrum falls off a cliff, best of [typical](Self::typical) levels: the lowest frequency around which its
    /// level sinks by at least 15 dB within a factor of 1.5 and does not rise again by more than 6 dB. That is what enlarging
    /// leaves behind, and sharp scenes do not: theirs fall as `1/ν²` (Field 1987), 3.5 dB in that stretch, and blur by a lens
    /// falls steadily.
    pub fn cliff(&self) -> Option<f64> {
        if self.levels.len() < PIECES / 4 {
            return None; // a picture of so few pixels has no shape of a spectrum
        }
        let level = |nu: f64| self.levels.iter().min_by(|a, b| (a[0] - nu).abs().total_cmp(&(b[0] - nu).abs()));
        let falls = |nu: f64| -> Option<bool> {
            let (before, after) = (level(nu / 1.5f64.sqrt())?[1], level(nu * 1.5f64.sqrt())?[1]);
            let rises = self.levels.iter().filter(|l| l[0] > nu * 1.5f64.sqrt()).any(|l| l[1] > 4.0 * after);
            Some(!rises && before > after * 10f64.powf(1.5))
        };
        let places = self.levels.iter().map(|l| l[0]).filter(|nu| (0.04..=0.4).contains(nu));
        places.into_iter().find(|nu| falls(*nu) == Some(true))
    }
}
