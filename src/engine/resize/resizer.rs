//! The plan: two axes, and the order in which they are summed.

use crate::engine::real::Real;
use crate::engine::resize::code::Code;
use crate::engine::resize::job::{Job, ROWS};
use crate::engine::resize::light::Light;
use crate::engine::resize::room::Rooms;
use crate::engine::resize::strips::{Meaning, Themselves};
use crate::engine::resize::taps::{Blocks, Taps};
use crate::engine::resize::view::{Layout, View, ViewMut};
use crate::engine::simd::Arithmetic;
use crate::error::{Error, Result};
use crate::parallel;

/// Old rows, finished across, that stay in the second cache.
const LINES: usize = ROWS;

/// A resizing of images of one size to another one, planned once and used by any number of threads.
///
/// ```
/// use nyquist::axis::Edge;
/// use nyquist::engine::Arithmetic;
/// use nyquist::engine::resize::{Resizer, Taps, View, ViewMut};
/// // two by two pixels become one, their mean
/// let mean = || Taps::new(2, Edge::Clamp, [(0, &[0.5, 0.5][..])]);
/// let resizer = Resizer::<f32>::new(mean()?, mean()?, Arithmetic::Plain);
/// let mut pixel = [0u16];
/// resizer.run(View::new(&[1, 2, 3, 4], [2, 2], 1, 2)?, ViewMut::new(&mut pixel, [1, 1], 1, 1)?)?;
/// assert_eq!(pixel, [2]); // 2.5, rounded once, to the even code
/// # Ok::<(), nyquist::error::Error>(())
/// ```
#[derive(Debug)]
pub struct Resizer<T> {
    across: Blocks<T>,
    down: Blocks<T>,
    /// Whether fewer products are needed when rows are summed before columns.
    down_first: bool,
    fused: bool,
    rooms: Rooms<T>,
}

impl<T: Real> Resizer<T> {
    /// By the sums along both axes.
    pub fn new(across: Taps, down: Taps, arithmetic: Arithmetic) -> Self {
        let [width, height, new_width, new_height] =
            [across.old(), down.old(), across.len(), down.len()].map(|n| n as f64);
        let (taps_across, taps_down) = (across.mean(), down.mean());
        let rows_first = new_height * (taps_down * width + taps_across * new_width);
        let columns_first = new_width * (taps_across * height + taps_down * new_height);
        Self {
            down_first: rows_first <= columns_first,
            across: Blocks::new(across),
            down: Blocks::new(down),
            fused: arithmetic == Arithmetic::Fused,
            rooms: Rooms::new(),
        }
    }

    /// The size of the images that are read.
    pub fn old(&self) -> [usize; 2] {
        [self.across.taps.old(), self.down.taps.old()]
    }

    /// The size of those that are written.
    pub fn new_size(&self) -> [usize; 2] {
        [self.across.taps.len(), self.down.taps.len()]
    }

    /// Resizes an image.
    ///
    /// # Errors
    /// Images of other sizes than planned, or of different numbers of channels.
    pub fn run<C: Code<Sum = T>>(&self, source: View<'_, C>, target: ViewMut<'_, C>) -> Result<()> {
        self.resize(&Themselves, source, target)
    }

    fn resize<C: Copy + Send + Sync, M: Meaning<C, Sum = T>>(
        &self,
        meaning: &M,
        source: View<'_, C>,
        target: ViewMut<'_, C>,
    ) -> Result<()> {
        self.check(source.layout, target.layout)?;
        let (stride, band) = (target.layout.stride, ROWS * self.groups());
        parallel::chunks(target.values, band * stride, |i, target| {
            let rows = i * band..((i + 1) * band).min(self.down.taps.len());
            self.rooms.lend(|room| {
                let (across, down, fused) = (&self.across, &self.down, self.fused);
                let job = Job { across, down, fused, meaning, source, rows, stride };
                if self.down_first { job.down_first(target, room) } else { job.across_first(target, room) }
            });
        });
        Ok(())
    }

    fn check(&self, source: Layout, target: Layout) -> Result<()> {
        let ([width, height], [new_width, new_height]) = (self.old(), self.new_size());
        let pairs = [
            ("the width of the image to resize", width, source.width),
            ("the height of the image to resize", height, source.height),
            ("the width of the resized image", new_width, target.width),
            ("the height of the resized image", new_height, target.height),
            ("the channels of the resized image", source.channels, target.channels),
        ];
        match pairs.into_iter().find(|(_, expected, got)| expected != got) {
            Some((what, expected, got)) => Err(Error::Length { what, expected, got }),
            None => Ok(()),
        }
    }

    /// How many times [`ROWS`] new rows are a piece of work: the rows that two pieces read are read twice, so they are not
    /// small; but a few pieces there are for any number of threads.
    fn groups(&self) -> usize {
        let n = self.down.taps.len();
        let most = (n / (8 * ROWS)).max(1);
        let fits = |groups: &usize| self.down.reads(&(0..(groups * ROWS).min(n))).len() <= LINES;
        if self.down_first { most.min(4) } else { (1..=most).take_while(fits).last().unwrap_or(1) }
    }
}

impl Resizer<f32> {
    /// Resizes an image of bytes by the light that they stand for.
    ///
    /// # Errors
    /// Images of other sizes than planned, or of different numbers of channels.
    pub fn run_in_light(&self, light: &Light, source: View<'_, u8>, target: ViewMut<'_, u8>) -> Result<()> {
        self.resize(light, source, target)
    }
}
