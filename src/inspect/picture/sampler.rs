//! A way to shrink a picture, and what it makes of gratings and spectra before it is done.

use crate::axis::Axis;
use crate::error::Result;
use crate::grid::Grid;
use crate::image::weights::Weights;
use crate::inspect::picture::angle;
use crate::inspect::picture::blur::Blur;
use crate::inspect::picture::power::PowerSpectrum;
use crate::inspect::picture::wave::{DARKEST, Wave};
use crate::kernel::Kernel;
use crate::nyquist::Alias;

/// A grating where it lands on a new raster.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Moire {
    /// In cycles a new pixel, between −½ and ½, with the sign that continues the grating's phase.
    pub frequency: [f64; 2],
    /// Michelson's contrast of its stripes.
    pub contrast: f64,
    /// Whether less than half a period of it is left in the part where the grating is: that part becomes brighter or darker
    /// as a whole, and no pattern is seen.
    pub even: bool,
}

impl Moire {
    /// The period across its stripes in new pixels; infinite at zero frequency.
    pub fn period(&self) -> f64 {
        1.0 / self.frequency[0].hypot(self.frequency[1])
    }

    /// Its [direction](angle), in degrees.
    pub fn angle(&self) -> f64 {
        angle(self.frequency)
    }
}

/// What of a picture's energy stays where it is, and what goes astray: as parts of the variance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Passed {
    /// Of frequencies within the new Nyquist box, at their own places.
    pub kept: f64,
    /// What folds from beyond it, and images of what is inside.
    pub folded: f64,
}

impl Passed {
    /// The contrast of a grating that would have the energy of what folds, on a mean.
    pub fn contrast(&self, mean: f64) -> f64 {
        (2.0 * self.folded).sqrt() / mean.max(DARKEST)
    }

    /// `10·log₁₀(kept/folded)` in dB; infinite if nothing folds.
    pub fn ratio(&self) -> f64 {
        if self.folded > 0.0 { 10.0 * (self.kept / self.folded).log10() } else { f64::INFINITY }
    }
}

/// Weights for both axes, and what stands before them: a way to shrink pictures of one size to another.
#[derive(Debug, Clone, PartialEq)]
pub struct Sampler {
    name: String,
    blur: Option<Blur>,
    across: Weights,
    down: Weights,
    /// The same for positions of all phases, or of many, which are enough for energies.
    few: [Weights; 2],
}

/// How many phases stand for all of them in sums over a spectrum.
const FEW: usize = 128;

impl Sampler {
    /// Every new pixel takes the nearest old one: plain decimation.
    pub fn none(old: Grid, new: Grid) -> Self {
        let [across, down] = [Weights::nearest(old.x(), new.x()), Weights::nearest(old.y(), new.y())];
        let few = [(old.x(), new.x()), (old.y(), new.y())].map(|(old, new)| Weights::nearest(old, phases(old, new)));
        Self { name: "none".into(), blur: None, across, down, few }
    }

    /// A kernel, widened with the step and divided by the sum of its weights, as
    /// [`resample`](crate::image::resize::resample) does.
    ///
    /// # Errors
    /// A kernel of infinite radius; too many weights.
    pub fn kernel(old: Grid, new: Grid, kernel: &dyn Kernel) -> Result<Self> {
        let few = |old, new| Weights::of(old, phases(old, new), kernel);
        let few = [few(old.x(), new.x())?, few(old.y(), new.y())?];
        let (across, down) = (Weights::of(old.x(), new.x(), kernel)?, Weights::of(old.y(), new.y(), kernel)?);
        Ok(Self { name: kernel.name(), blur: None, across, down, few })
    }

    /// The same behind a blur.
    #[must_use]
    pub fn behind(self, blur: Blur) -> Self {
        Self { blur: Some(blur), ..self }
    }

    /// The kernel's name, or `none`.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The new Nyquist frequencies, in cycles an old pixel.
    pub fn limit(&self) -> [f64; 2] {
        [&self.across, &self.down].map(|weights| weights.new_axis().nyquist() * weights.old().step())
    }

    fn blurred(&self, [u, v]: [f64; 2]) -> f64 {
        self.blur.as_ref().map_or(1.0, |blur| blur.gain(u) * blur.gain(v))
    }

    /// Where a grating lands, and with what contrast: of itself and its nearest images (see [`Weights::gain`]) the strongest.
    ///
    /// ```
    /// use nyquist::prelude::*;
    /// use nyquist::image::resize::over;
    /// use nyquist::inspect::picture::sampler::Sampler;
    /// use nyquist::inspect::picture::wave::Wave;
    /// let grid = Grid::pixels(300, 300)?;
    /// let image = Image::of(&Grating::new([0.35, 0.0])?, grid).map(|v| 0.5 + 0.25 * v);
    /// let wave = Wave::near(&image, [0.35, 0.0], [0, 0], [300, 300]);
    /// // every third pixel: 0.35 is 1.05 of the new rate, stripes of 20 new pixels and of the old contrast
    /// let moire = Sampler::none(grid, over(grid, 100, 100)?).moire(&wave);
    /// assert!((moire.period() - 20.0).abs() < 1e-3 && (moire.contrast - 0.5).abs() < 1e-4);
    /// // the box before it leaves (1 + 2cos 2π·0.35)/3
    /// let boxed = Sampler::kernel(grid, over(grid, 100, 100)?, &BoxKernel)?.moire(&wave);
    /// assert!((boxed.contrast - 0.5 * (1.0 + 2.0 * (0.7 * std::f64::consts::PI).cos()).abs() / 3.0).abs() < 1e-4);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn moire(&self, wave: &Wave) -> Moire {
        // a few images suffice: kernels weaken the others more
        let along = |weights: &Weights, nu: f64| {
            let (old, new) = (weights.old().step(), weights.new_axis().step());
            let gains = [0i64, 1, -1].map(|m| (weights.gain(nu / old, m).norm(), nu + m as f64));
            // at a whole factor all images are one: the first counts
            let (gain, landing) = gains
                .into_iter()
                .fold((0.0, nu), |best, other| if other.0 > best.0 * (1.0 + 1e-9) { other } else { best });
            let alias = Alias::of(landing / old * new, 1.0).map_or(f64::NAN, |alias| alias.signed());
            (gain, alias)
        };
        let ((gx, u), (gy, v)) = (along(&self.across, wave.frequency[0]), along(&self.down, wave.frequency[1]));
        // what is its own opposite, at zero or the Nyquist frequency, is two waves in one, which an alias elsewhere is not
        let own = |at: [f64; 2]| at.iter().all(|nu| (2.0 * nu - (2.0 * nu).round()).abs() < 1e-6);
        let both = if own(wave.frequency) && !own([u, v]) { 2.0 } else { 1.0 };
        let contrast = both * wave.contrast() * gx * gy * self.blurred(wave.frequency).abs();
        let [rx, ry] = self.limit().map(|limit| 2.0 * limit);
        let periods = [u * rx * wave.size[0] as f64, v * ry * wave.size[1] as f64];
        let even = periods.iter().all(|periods| periods.abs() < 0.5);
        Moire { frequency: [u, v], contrast, even }
    }

    /// What of a picture's energy stays and what folds.
    ///
    /// `kept = Σ P·|G(u)G(v)|²` over the new Nyquist box, `folded` what is left of all the energy that comes through. Along an
    /// axis that does not shrink nothing folds, and images are not counted: blocks are no aliases.
    pub fn passed(&self, spectrum: &PowerSpectrum) -> Passed {
        let grid = spectrum.power().grid();
        let gains = |weights: &Weights, axis: Axis| -> Vec<[f64; 2]> {
            let step = weights.old().step();
            let shrinks = weights.new_axis().step() > step;
            let of = |nu: f64| {
                let gain = weights.gain(nu, 0).norm_sqr();
                [gain, if shrinks { weights.power(nu) } else { gain }]
            };
            axis.iter().map(|nu| of(nu / step)).collect()
        };
        let (across, down) = (gains(&self.few[0], grid.x()), gains(&self.few[1], grid.y()));
        let (limit, width) = (self.limit(), grid.width());
        let (mut kept, mut all) = (0.0, 0.0);
        for (i, ([u, v], energy)) in spectrum.energies().enumerate() {
            let ([gx, tx], [gy, ty]) = (across[i % width], down[i / width]);
            let energy = energy * self.blurred([u, v]).powi(2);
            all += energy * tx * ty;
            if u.abs() <= limit[0] && v.abs() <= limit[1] {
                kept += energy * gx * gy;
            }
        }
        Passed { kept, folded: (all - kept).max(0.0) }
    }
}

/// The first of the new positions, until their phases on the old axis repeat; no more than [`FEW`].
fn phases(old: Axis, new: Axis) -> Axis {
    let phase = |k: usize| {
        let at = old.index_of(new.at(k as i64)) - old.index_of(new.at(0));
        (at - at.round()).abs()
    };
    // rounding of both axes
    let least = 8.0 * f64::EPSILON * old.len() as f64;
    let repeats = (1..new.len().min(FEW)).find(|&k| phase(k) <= least);
    let count = repeats.unwrap_or(new.len().min(FEW));
    Axis::new(new.start(), new.step(), count).expect("a part of an axis").in_unit(new.unit())
}
