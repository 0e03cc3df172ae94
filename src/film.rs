//! From scattered samples to pixels: `I = Σ f(x − x_i, y − y_i)·L_i / Σ f(x − x_i, y − y_i)` (Φ14, slide «Получение
//! значения пикселя по набору сэмплов»).
//!
//! Reconstructing from the samples, removing what the pixels cannot show and reading at the pixels' centres is one
//! convolution with one kernel `f` (F55), and only its values at the centres are needed: a sum over the samples within
//! the kernel's reach. Dividing by the sum of the weights keeps a constant constant however the samples are scattered.
//!
//! The price: a quotient of two estimates is biased. For `K` independent samples the bias is about
//! `(I·E[w²] − E[w²L])/(K·E[w]²)` ([`laws::film`](crate::laws::film), V13), and a kernel with negative lobes can bring
//! the sum of the weights near zero; [`Exposure::weights`] shows where.

use crate::error::{Error, Result};
use crate::grid::Grid;
use crate::image::{Image, Rgb};
use crate::kernel::{Kernel, MOST_RADIUS};
use crate::parallel;
use ndarray::Array2;

/// Light that arrived at a place: one value for each of `C` colours.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sample<const C: usize> {
    /// Where `(x, y)`, in the units of the film's grid.
    pub at: [f64; 2],
    /// How much.
    pub light: [f64; C],
}

/// A grid of pixels that weigh the samples around them by a kernel, `f(x, y) = k(x/T_x)·k(y/T_y)`.
///
/// ```
/// use nyquist::prelude::*;
/// // three samples of the same light at odd places: every pixel they reach has that light, whatever the kernel
/// let film = Film::new(Grid::pixels(3, 1)?, Cubic::mitchell())?;
/// let samples = [[0.2, 0.9], [1.7, 0.4], [2.1, 0.3]].map(|at| Sample { at, light: [0.25] });
/// let exposure = film.develop(&samples)?;
/// assert!(exposure.image().values().iter().all(|v| (v - 0.25).abs() < 1e-15));
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy)]
pub struct Film<K> {
    grid: Grid,
    kernel: K,
}

/// Rows that are developed together. A sample near a border is weighed for both sides, so higher bands weigh fewer
/// twice; 32 keeps that below a sixth for a radius of two.
const BAND: usize = 32;

impl<K: Kernel> Film<K> {
    /// A film on that grid.
    ///
    /// # Errors
    /// A kernel of infinite radius: every pixel would need every sample, and what is beyond the frame as well.
    pub fn new(grid: Grid, kernel: K) -> Result<Self> {
        let radius = kernel.radius();
        if radius.is_infinite() {
            let what = "a film with a kernel of infinite radius: every pixel would need samples from everywhere";
            return Err(Error::Unsupported(what));
        }
        if !(radius > 0.0 && radius <= MOST_RADIUS) {
            let what = "the radius of a film's kernel, in pixels,";
            return Err(Error::OutOfRange { what, value: radius, low: 0.0, high: MOST_RADIUS });
        }
        Ok(Self { grid, kernel })
    }

    /// Where the pixels are.
    pub fn grid(&self) -> Grid {
        self.grid
    }

    /// How many pixels beyond the frame a sample can lie and still reach a pixel inside: `⌊radius + ½⌋`; one for the box,
    /// for the sake of samples exactly on the border, which count one half on either side.
    pub fn reach(&self) -> usize {
        (self.kernel.radius() + 0.5).floor() as usize
    }

    /// The weight `f(x, y)` of a sample that is that far from a pixel's centre.
    pub fn weight(&self, x: f64, y: f64) -> f64 {
        self.kernel.at(x / self.grid.x().step()) * self.kernel.at(y / self.grid.y().step())
    }

    /// The pixels that these samples make.
    ///
    /// Samples in another order give the same pixels up to the rounding of their sums; the same samples give the same
    /// bits for any number of threads. Samples out of reach count for nothing.
    ///
    /// # Errors
    /// A place or a light that is not finite: which sample.
    pub fn develop<const C: usize>(&self, samples: &[Sample<C>]) -> Result<Exposure<C>> {
        for (index, sample) in samples.iter().enumerate() {
            let parts = [("places of samples", &sample.at[..]), ("lights of samples", &sample.light[..])];
            for (what, values) in parts {
                if let Some(&value) = values.iter().find(|v| !v.is_finite()) {
                    return Err(Error::NotFiniteAt { what, index, value });
                }
            }
        }
        // a counting sort by rows, the order within a row being the given one
        let reach = self.reach() as i64;
        let rows = self.grid.height() + 2 * self.reach();
        let row = |s: &Sample<C>| {
            let row = (self.grid.y().index_of(s.at[1]) + 0.5).floor() + reach as f64;
            (row >= 0.0 && row < rows as f64).then_some(row as usize)
        };
        let mut ends = vec![0usize; rows + 1];
        samples.iter().filter_map(row).for_each(|r| ends[r + 1] += 1);
        (0..rows).for_each(|r| ends[r + 1] += ends[r]);
        let mut sorted = vec![Sample { at: [0.0; 2], light: [0.0; C] }; ends[rows]];
        let mut next = ends.clone();
        for sample in samples {
            if let Some(r) = row(sample) {
                sorted[next[r]] = *sample;
                next[r] += 1;
            }
        }
        Ok(self.expose(|row| {
            let r = (row + reach) as usize;
            &sorted[ends[r]..ends[r + 1]]
        }))
    }

    /// The pixels that samples make which are given row by row, as they are asked for: no more of them are kept than a
    /// few rows.
    ///
    /// `light(j)` has the samples whose place is in pixel row `j`, for `−reach ≤ j < height + reach`; it is asked for a
    /// row once or twice, in any order, from any thread, and must give the same each time. Places and lights are trusted
    /// to be finite.
    pub fn expose<const C: usize, S: AsRef<[Sample<C>]>>(&self, light: impl Fn(i64) -> S + Sync + Send) -> Exposure<C> {
        let (width, height) = (self.grid.width(), self.grid.height());
        let bands = parallel::map(height.div_ceil(BAND), |band| {
            let first = band * BAND;
            self.band(first, (first + BAND).min(height), &light)
        });
        let mut weights = Vec::with_capacity(width * height);
        let mut colours: [Vec<f64>; C] = std::array::from_fn(|_| Vec::with_capacity(width * height));
        for (sums, lights) in bands {
            for (sum, light) in sums.iter().zip(&lights) {
                for (plane, l) in colours.iter_mut().zip(light) {
                    plane.push(if *sum == 0.0 { 0.0 } else { l / sum });
                }
            }
            weights.extend(sums);
        }
        let image = |values: Vec<f64>| {
            let pixels = Array2::from_shape_vec((height, width), values).expect("every band has its rows");
            Image::trusted(self.grid, pixels)
        };
        Exposure { planes: colours.map(image), weights: image(weights) }
    }

    /// `Σf` and `Σf·L` for the rows `first..last`.
    fn band<const C: usize, S: AsRef<[Sample<C>]>>(
        &self,
        first: usize,
        last: usize,
        light: &impl Fn(i64) -> S,
    ) -> (Vec<f64>, Vec<[f64; C]>) {
        let width = self.grid.width();
        let mut sums = vec![0.0; width * (last - first)];
        let mut lights = vec![[0.0; C]; width * (last - first)];
        let (mut across, mut down) = (Vec::new(), Vec::new());
        let reach = self.reach() as i64;
        for row in first as i64 - reach..last as i64 + reach {
            for sample in light(row).as_ref() {
                let at = [self.grid.x().index_of(sample.at[0]), self.grid.y().index_of(sample.at[1])];
                let left = self.weights(at[0], 0, width, &mut across);
                let top = self.weights(at[1], first, last, &mut down);
                for (j, wy) in down.iter().enumerate() {
                    let start = (top + j - first) * width + left;
                    let targets = sums[start..].iter_mut().zip(&mut lights[start..]);
                    for (wx, (sum, light)) in across.iter().zip(targets) {
                        let weight = wx * wy;
                        *sum += weight;
                        for (l, given) in light.iter_mut().zip(sample.light) {
                            *l += weight * given;
                        }
                    }
                }
            }
        }
        (sums, lights)
    }

    /// The kernel's values at the pixels `first..last` of one axis around the position `at`, counted in pixels; the first
    /// pixel that has one.
    fn weights(&self, at: f64, first: usize, last: usize, into: &mut Vec<f64>) -> usize {
        into.clear();
        let radius = self.kernel.radius();
        let low = (at - radius).ceil().max(first as f64);
        let high = (at + radius).floor().min(last as f64 - 1.0);
        if low > high {
            return first;
        }
        let low = low as usize;
        into.extend((low..=high as usize).map(|i| self.kernel.at(at - i as f64)));
        low
    }
}

/// A developed film: the pixels of `C` colours, and the sums of the weights behind them.
///
/// A pixel that no sample reached (`Σf = 0`) is black and counted by [`unlit`](Self::unlit).
#[derive(Debug, Clone, PartialEq)]
pub struct Exposure<const C: usize> {
    planes: [Image; C],
    weights: Image,
}

impl<const C: usize> Exposure<C> {
    /// `Σ f·L / Σ f`, colour by colour.
    pub fn planes(&self) -> &[Image; C] {
        &self.planes
    }

    /// `Σ f`: how much every pixel has seen.
    pub fn weights(&self) -> &Image {
        &self.weights
    }

    /// How many pixels no sample reached.
    pub fn unlit(&self) -> usize {
        self.weights.values().iter().filter(|w| **w == 0.0).count()
    }
}

impl Exposure<1> {
    /// The picture.
    pub fn image(&self) -> &Image {
        &self.planes[0]
    }
}

impl Exposure<3> {
    /// The picture in colour.
    pub fn rgb(&self) -> Rgb {
        Rgb::new(self.planes.clone()).expect("the planes share the film's grid")
    }
}
