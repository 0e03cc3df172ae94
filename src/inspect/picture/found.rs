//! Predictions held against what is done.

use crate::axis::{Axis, Edge};
use crate::error::Result;
use crate::grid::Grid;
use crate::image::Image;
use crate::image::dft::inverse;
use crate::image::periodic::periodic_forward;
use crate::image::resize::{nearest, over, resample};
use crate::inspect::picture::sampler::Moire;
use crate::inspect::picture::wave::{DARKEST, Wave};
use crate::kernel::catalog::by_name;

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

/// How much of a picture is looked at around a grating, at most, along a side.
const SIDE: usize = 512;

/// The contrast that a shrunk picture has where a grating was predicted to land, found by doing it: what is too fine for the
/// new size is cut out of the picture around the grating, shrunk alone, and looked at there. (With the rest, the contrast
/// would be that of what belongs there as well.)
///
/// Nothing where there are fewer than 8 new pixels, or fewer than two periods: then it cannot be told from a change of the
/// mean. Whatever else is too fine and lands within a bin of the place counts as well.
///
/// ```
/// use nyquist::prelude::*;
/// use nyquist::inspect::picture::found::found;
/// use nyquist::inspect::picture::shrinking::{Shrinking, Tolerance};
/// let image = Image::of(&Grating::new([0.4, 0.3])?, Grid::pixels(300, 200)?).map(|v| 0.4 + 0.2 * v);
/// let predicted = Shrinking::of(&image, [100, 66], Tolerance::default(), None)?;
/// let (wave, moire) = (&predicted.waves.strongest[0], &predicted.ways[0].moires[0]);
/// let there = found(&image, wave, moire, [100, 66], "none")?.unwrap();
/// assert!((there / moire.contrast - 1.0).abs() < 0.02);
/// # Ok::<(), Error>(())
/// ```
///
/// # Errors
/// An unknown way; a width or height of zero, or too many pixels.
pub fn found(image: &Image, wave: &Wave, moire: &Moire, size: [usize; 2], way: &str) -> Result<Option<f64>> {
    let (old, new) = (image.grid(), over(image.grid(), size[0], size[1])?);
    let (across, down) = (Look::of(old.x(), new.x(), wave, 0), Look::of(old.y(), new.y(), wave, 1));
    let periods = (moire.frequency[0] * across.count as f64).abs().max((moire.frequency[1] * down.count as f64).abs());
    if across.few() || down.few() || periods < 2.0 {
        return Ok(None);
    }
    let part = image.part([across.first, down.first], [across.length, down.length])?;
    let limit = [new.x().nyquist(), new.y().nyquist()];
    let beyond = |u: f64, v: f64| if u.abs() > limit[0] || v.abs() > limit[1] { 1.0 } else { 0.0 };
    let fine = inverse(&periodic_forward(&part).times(|u, v| beyond(u, v).into()));
    let small = onto(&fine, Grid::new(across.grid()?, down.grid()?)?, way, Edge::Mirror)?;
    let there = Wave::at(&small, moire.frequency, [0, 0], [small.width(), small.height()]);
    Ok(Some(there.amplitude / wave.mean.max(DARKEST)))
}

/// What is looked at along one axis: old pixels with a margin, and the new ones inside.
struct Look {
    new: Axis,
    first: usize,
    length: usize,
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
        Self { new, first: from, length: to - from, start, count, single: n == 1 }
    }

    fn few(&self) -> bool {
        self.count < if self.single { 1 } else { 8 }
    }

    fn grid(&self) -> Result<Axis> {
        Axis::new(self.new.at(self.start), self.new.step(), self.count)
    }
}
