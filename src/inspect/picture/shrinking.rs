//! What would happen to a picture at another scale, for every way to get there.

use crate::error::{Result, within};
use crate::image::Image;
use crate::image::resize::over;
use crate::inspect::picture::blur::Blur;
use crate::inspect::picture::power::PowerSpectrum;
use crate::inspect::picture::sampler::{Moire, Passed, Sampler};
use crate::inspect::picture::texture::{Texture, textures};
use crate::inspect::picture::wave::Wave;
use crate::inspect::picture::waves::{Waves, waves};
use crate::kernel::{Kernel, catalog};

/// How far below what is there aliases must stay.
///
/// A moiré is a pattern of its own: its contrast must be below `10^{−dB/20}`; 40 dB are 1 %, about what an eye just sees on
/// an even surface. What folds of edges and texture hides among them (Legge & Foley, *Contrast masking in human vision*,
/// J. Opt. Soc. Am. 70, 1980): of that all together must be as many dB less [`MASKED`](Self::MASKED) below what is kept, or
/// have no more energy than such a moiré.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tolerance(f64);

impl Tolerance {
    /// How many dB more of aliases a texture hides.
    pub const MASKED: f64 = 10.0;

    /// In dB.
    ///
    /// # Errors
    /// A number that is not finite or outside `0..=200`.
    pub fn new(decibels: f64) -> Result<Self> {
        Ok(Self(within("the tolerance in dB", decibels, 0.0, 200.0)?))
    }

    /// In dB.
    pub fn decibels(self) -> f64 {
        self.0
    }

    /// The highest contrast of a moiré.
    pub fn contrast(self) -> f64 {
        10f64.powf(-self.0 / 20.0)
    }

    /// The contrast that is worth a word: a tenth of the highest.
    pub fn noticeable(self) -> f64 {
        0.1 * self.contrast()
    }

    /// The lowest ratio of what is kept to what folds, in dB.
    pub fn ratio(self) -> f64 {
        self.0 - Self::MASKED
    }
}

impl Default for Tolerance {
    /// 40 dB.
    fn default() -> Self {
        Self(40.0)
    }
}

/// One way to shrink, and what comes of it.
#[derive(Debug, Clone, PartialEq)]
pub struct Way {
    /// The filter's name; `none` for plain decimation.
    pub name: String,
    /// The moiré of each grating, in the same order.
    pub moires: Vec<Moire>,
    /// What of the whole picture's energy stays and folds.
    pub passed: Passed,
    /// Whether both are within the tolerance.
    pub fine: bool,
}

impl Way {
    fn of(sampler: &Sampler, waves: &[Wave], spectrum: &PowerSpectrum, tolerance: Tolerance) -> Self {
        let moires: Vec<Moire> = waves.iter().map(|wave| sampler.moire(wave)).collect();
        let passed = sampler.passed(spectrum);
        let name = sampler.name().to_owned();
        let mut way = Self { name, moires, passed, fine: false };
        let unseen = passed.contrast(spectrum.mean()) <= tolerance.contrast();
        let worst = way.contrast().max(way.brightness());
        way.fine = worst <= tolerance.contrast() && (unseen || passed.ratio() >= tolerance.ratio());
        way
    }

    /// The grating whose moiré has the highest contrast, and that moiré; what becomes an even change of brightness is none.
    pub fn worst(&self) -> Option<(usize, Moire)> {
        let numbered = self.moires.iter().copied().enumerate().filter(|(_, moire)| !moire.even);
        numbered.max_by(|a, b| a.1.contrast.total_cmp(&b.1.contrast))
    }

    /// The highest contrast of a moiré; zero if there is none.
    pub fn contrast(&self) -> f64 {
        self.worst().map_or(0.0, |(_, moire)| moire.contrast)
    }

    /// The highest change of brightness, against the mean, that a grating becomes; zero if none does. Which way it goes, and
    /// how far, hangs on where the new pixels meet the grating: this is the most.
    pub fn brightness(&self) -> f64 {
        self.moires.iter().filter(|moire| moire.even).map(|moire| moire.contrast).fold(0.0, f64::max)
    }
}

/// What shrinking a picture to a size makes of it.
#[derive(Debug, Clone, PartialEq)]
pub struct Shrinking {
    /// The new width and height.
    pub size: [usize; 2],
    /// The new Nyquist frequencies, in cycles an old pixel.
    pub limit: [f64; 2],
    /// What was asked for.
    pub tolerance: Tolerance,
    /// The gratings beyond the limit, and how many more.
    pub waves: Waves,
    /// The strongest regions of texture beyond it.
    pub textures: Vec<Texture>,
    /// Plain decimation, and then every filter.
    pub ways: Vec<Way>,
    /// The least blur after which plain decimation is fine, unless it is so without, or with none.
    pub blur: Option<f64>,
}

/// How many regions of texture are named.
const TEXTURES: usize = 3;

impl Shrinking {
    /// Of a picture to a new size, with every kernel of the catalogue that resizing can use, and one more if it is given.
    ///
    /// ```
    /// use nyquist::prelude::*;
    /// use nyquist::inspect::picture::shrinking::{Shrinking, Tolerance};
    /// let stripes = Grating::new([0.35, 0.0])?;
    /// let image = Image::of(&stripes, Grid::pixels(240, 240)?).map(|v| 0.5 + 0.25 * v);
    /// let small = Shrinking::of(&image, [80, 80], Tolerance::default(), None)?;
    /// let [plain, lanczos] = ["none", "lanczos-3"].map(|name| small.way(name).unwrap());
    /// assert!(!plain.fine && (plain.contrast() - 0.5).abs() < 1e-3);
    /// assert!(lanczos.fine);
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    /// A width or height of zero, or more pixels than a grid can have; a kernel of infinite radius.
    pub fn of(image: &Image, size: [usize; 2], tolerance: Tolerance, more: Option<&dyn Kernel>) -> Result<Self> {
        Self::with(image, &PowerSpectrum::welch(image), size, tolerance, more)
    }

    /// The same with a spectrum that is known already.
    ///
    /// # Errors
    /// As [`Shrinking::of`].
    pub fn with(
        image: &Image,
        spectrum: &PowerSpectrum,
        size: [usize; 2],
        tolerance: Tolerance,
        more: Option<&dyn Kernel>,
    ) -> Result<Self> {
        let old = image.grid();
        let new = over(old, size[0], size[1])?;
        let plain = Sampler::none(old, new);
        let limit = plain.limit();
        // half of what matters is worth knowing
        let waves = waves(image, limit, 0.5 * tolerance.contrast());
        let textures = textures(spectrum, limit, &waves.strongest, TEXTURES);
        let kernels = catalog::all();
        let known: Vec<&dyn Kernel> =
            kernels.iter().map(|k| &**k as &dyn Kernel).filter(|k| k.radius().is_finite()).collect();
        let more = more.filter(|more| known.iter().all(|kernel| kernel.name() != more.name()));
        let mut samplers = vec![plain.clone()];
        for kernel in known.iter().copied().chain(more) {
            samplers.push(Sampler::kernel(old, new, kernel)?);
        }
        let found = &waves.strongest;
        let ways: Vec<Way> =
            crate::parallel::map(samplers.len(), |i| Way::of(&samplers[i], found, spectrum, tolerance));
        let blur = if ways[0].fine { None } else { blur(&plain, found, spectrum, tolerance) };
        Ok(Self { size, limit, tolerance, waves, textures, ways, blur })
    }

    /// What a filter makes of it.
    pub fn way(&self, name: &str) -> Option<&Way> {
        self.ways.iter().find(|way| way.name == name)
    }

    /// Of the filters that are fine the one that keeps most of what the new raster can hold; plain decimation if that is.
    pub fn best(&self) -> Option<&Way> {
        if self.ways[0].fine {
            return self.ways.first();
        }
        let fine = self.ways.iter().filter(|way| way.fine);
        fine.max_by(|a, b| a.passed.kept.total_cmp(&b.passed.kept))
    }

    /// The filter whose aliases are weakest, if none is fine.
    pub fn cleanest(&self) -> &Way {
        let worst = |way: &Way| {
            let contrast = -20.0 * way.contrast().max(way.brightness()).max(1e-12).log10() - self.tolerance.decibels();
            contrast.min(way.passed.ratio() - self.tolerance.ratio())
        };
        self.ways.iter().max_by(|a, b| worst(a).total_cmp(&worst(b))).expect("plain decimation is always there")
    }
}

/// The least standard deviation, to 1 %, of a blur behind which plain decimation is within the tolerance; up to two new
/// pixels.
fn blur(plain: &Sampler, waves: &[Wave], spectrum: &PowerSpectrum, tolerance: Tolerance) -> Option<f64> {
    let fine = |sigma: f64| {
        let blur = Blur::new(sigma).ok()?;
        Way::of(&plain.clone().behind(blur), waves, spectrum, tolerance).fine.then_some(sigma)
    };
    let [u, v] = plain.limit();
    let (mut low, mut high) = (0.05, (1.0 / u.min(v)).min(Blur::MOST));
    let mut best = fine(high)?;
    while high > 1.01 * low {
        let middle = (low * high).sqrt();
        match fine(middle) {
            Some(sigma) => (best, high) = (sigma, middle),
            None => low = middle,
        }
    }
    Some(best)
}
