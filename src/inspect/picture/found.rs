//! Predictions held against what is done.

use crate::axis::{Axis, Edge};
use crate::error::Result;
use crate::field::from_fn;
use crate::grid::Grid;
use crate::image::Image;
use crate::image::dft::inverse;
use crate::image::periodic::periodic_forward;
use crate::image::resize::{nearest, over, resample};
use crate::inspect::picture::patch::Patch;
use crate::inspect::picture::sampler::Moire;
use crate::inspect::picture::wave::{DARKEST, Wave};
use crate::inspect::picture::waves::EVEN;
use crate::kernel::catalog::by_name;
use crate::num::{cos_pi, sin_pi};
use num_complex::Complex;

/// The picture shrunk in the way of that name: `none`, or a kernel's.
///
/// # Errors
/// An unknown name; a width or height of zero, or too many pixels.
pub fn shrunk(image: &Image, size: [usize; 2], way: &str, edge: Edge) -> Result<Image> {
    onto(image, over(image.grid(), size[0], size[1])?, way, edge)
}

fn onto(image: &Image, grid: Grid, way: &str, edge: Edge) -> Result<Image> {
    if way == "none" { Ok(nearest(image, grid, edge)) } else { resample(image, grid, &by_name(way)?, edge) }
}

/// What a shrunk picture has where a grating was predicted to land.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Found {
    /// The contrast there, of the grating and of whatever else lands there.
    pub contrast: f64,
    /// That of the grating alone, had it the same amplitude everywhere: shrunk in the same way, seen through the same window.
    pub alone: f64,
    /// Whether both ratios of the sizes are whole: then all images of the grating are one.
    pub whole: bool,
}

/// Why a contrast that was found is not the predicted one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Cause {
    /// Something else that is too fine lands there as well, and adds to it.
    Added,
    /// Something else lands there and takes from it.
    Taken,
    /// Other images of the grating itself, which a ratio that is not whole leaves, lie within a bin of the place.
    Images,
}

impl Found {
    /// Why it is not what was predicted, if it is off by more than `least`.
    ///
    /// A grating counts as one where its amplitude is even to a fifth ([`waves`](crate::inspect::picture::waves::waves)): in
    /// the part that is looked at it may differ by as much from the grating alone, which is even; what differs by more is not
    /// of the grating. Between the grating alone and what was predicted nothing but images stand, and where the ratio of the
    /// sizes is whole they are one.
    ///
    /// ```
    /// use nyquist::inspect::picture::found::{Cause, Found};
    /// let cause = |contrast, alone| Found { contrast, alone, whole: false }.cause(0.010, 0.001);
    /// assert_eq!(cause(0.031, 0.010), Some(Cause::Added));
    /// assert_eq!(cause(0.004, 0.010), Some(Cause::Taken));
    /// assert_eq!(cause(0.008, 0.008), Some(Cause::Images));
    /// assert_eq!(cause(0.0105, 0.010), None);
    /// assert_eq!(Found { contrast: 0.008, alone: 0.008, whole: true }.cause(0.010, 0.001), None);
    /// ```
    pub fn cause(&self, predicted: f64, least: f64) -> Option<Cause> {
        let Self { contrast, alone, whole } = *self;
        let differs = (contrast - alone).abs() > least;
        if differs && EVEN * contrast > alone {
            Some(Cause::Added)
        } else if differs && contrast < EVEN * alone {
            Some(Cause::Taken)
        } else if !whole && (alone - predicted).abs() > least {
            Some(Cause::Images)
        } else {
            None
        }
    }
}

/// How much of a picture is looked at around a grating, at most, along a side.
const SIDE: usize = 512;

/// What a shrunk picture has where a grating was predicted to land, found by doing it: what is too fine for the new size is
/// cut out of the picture around the grating, shrunk alone, and looked at there. (With the rest, the contrast would be that
/// of what belongs there as well.) The grating alone goes the same way.
///
/// Nothing where there are fewer than 8 new pixels, or fewer than two periods: then it cannot be told from a change of the
/// mean.
///
/// ```
/// use nyquist::prelude::*;
/// use nyquist::inspect::picture::found::found;
/// use nyquist::inspect::picture::shrinking::{Shrinking, Tolerance};
/// let image = Image::of(&Grating::new([0.4, 0.3])?, Grid::pixels(300, 200)?).map(|v| 0.4 + 0.2 * v);
/// let predicted = Shrinking::of(&image, [100, 66], Tolerance::default(), None)?;
/// let (wave, moire) = (&predicted.waves.strongest[0], &predicted.ways[0].moires[0]);
/// let there = found(&image, wave, moire, [100, 66], "none")?.unwrap();
/// assert!((there.contrast / moire.contrast - 1.0).abs() < 0.02);
/// assert!((there.contrast / there.alone - 1.0).abs() < 1e-3); // nothing else is in the picture
/// # Ok::<(), Error>(())
/// ```
///
/// # Errors
/// An unknown way; a width or height of zero, or too many pixels.
pub fn found(image: &Image, wave: &Wave, moire: &Moire, size: [usize; 2], way: &str) -> Result<Option<Found>> {
    let (old, new) = (image.grid(), over(image.grid(), size[0], size[1])?);
    let (across, down) = (Look::of(old.x(), new.x(), wave, 0), Look::of(old.y(), new.y(), wave, 1));
    let periods = (moire.frequency[0] * across.count as f64).abs().max((moire.frequency[1] * down.count as f64).abs());
    if across.few() || down.few() || periods < 2.0 {
        return Ok(None);
    }
    let limit = [new.x().nyquist(), new.y().nyquist()];
    let beyond = |u: f64, v: f64| if u.abs() > limit[0] || v.abs() > limit[1] { 1.0 } else { 0.0 };
    let contrast = |part: &Image| -> Result<f64> {
        let fine = inverse(&periodic_forward(part).times(|u, v| beyond(u, v).into()));
        let small = onto(&fine, Grid::new(across.grid()?, down.grid()?)?, way, Edge::Mirror)?;
        let there = Wave::at(&small, moire.frequency, [0, 0], [small.width(), small.height()]);
        Ok(there.amplitude / wave.mean.max(DARKEST))
    };
    let part = image.part([across.first, down.first], [across.length, down.length])?;
    let (corner, size) = ([across.inner[0], down.inner[0]], [across.inner[1], down.inner[1]]);
    // of the wave's own amplitude: between it and what was predicted stand images alone
    let phase = Patch::of(image, corner, size).phasor(wave.frequency).arg();
    let phasor = Complex::from_polar(wave.amplitude, phase);
    // from the middle of the pixels, as the phase is
    let middle = [0, 1].map(|i| corner[i] as f64 + 0.5 * size[i] as f64);
    let [u, v] = wave.frequency;
    let grating = |x: f64, y: f64| {
        let cycles = 2.0 * (u * (x - middle[0]) + v * (y - middle[1]));
        phasor.re * cos_pi(cycles) - phasor.im * sin_pi(cycles)
    };
    let alone = Image::of(&from_fn(grating), part.grid());
    let whole = image.width().is_multiple_of(new.width()) && image.height().is_multiple_of(new.height());
    Ok(Some(Found { contrast: contrast(&part)?, alone: contrast(&alone)?, whole }))
}

/// What is looked at along one axis: old pixels with a margin, and the new ones inside.
struct Look {
    new: Axis,
    first: usize,
    length: usize,
    /// Where the old pixels without the margin begin, and how many they are.
    inner: [usize; 2],
    /// The first of the new pixels, and how many.
    start: i64,
    count: usize,
    /// Whether the picture has but one pixel that way.
    single: bool,
}

impl Look {
    fn of(old: Axis, new: Axis, wave: &Wave, axis: usize) -> Self {
        let (n, step) = (old.len(), new.step() / old.step());
        let length = wave.size[axis].min(SIDE);
        let first = wave.corner[axis] + (wave.size[axis] - length) / 2;
        let start = (first as f64 / step).ceil() as i64;
        let end = ((first + length) as f64 / step).floor() as i64;
        let margin = 32 + (8.0 * step) as usize;
        let (from, to) = (first.saturating_sub(margin), (first + length + margin).min(n));
        let count = usize::try_from(end - start).unwrap_or(0).min(new.len());
        Self { new, first: from, length: to - from, inner: [first, length], start, count, single: n == 1 }
    }

    fn few(&self) -> bool {
        self.count < if self.single { 1 } else { 8 }
    }

    fn grid(&self) -> Result<Axis> {
        Axis::new(self.new.at(self.start), self.new.step(), self.count)
    }
}
