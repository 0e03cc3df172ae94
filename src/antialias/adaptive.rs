//! More samples where they differ (slide «Адаптивное сэмплирование»).

use crate::antialias::supersample::pixel_seed;
use crate::error::{Error, Result, finite, positive};
use crate::field::Field;
use crate::grid::Grid;
use crate::image::Image;
use crate::num::random::uniform;
use crate::parallel;
use std::cmp::Ordering;
use std::collections::BinaryHeap;
use std::ops::Range;

/// When to stop.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Budget {
    /// A cell is left alone once it can change its pixel by no more than this.
    pub contrast: f64,
    /// The most samples a pixel on average, at least 4.
    pub per_pixel: f64,
}

/// A picture by adaptive sampling, and what it took.
#[derive(Debug, Clone, PartialEq)]
pub struct Adapted {
    /// The picture.
    pub image: Image,
    /// How many samples every pixel took.
    pub samples: Image,
    /// How many there were in all.
    pub taken: usize,
    /// Whether the budget ended before every cell was below the contrast.
    pub exhausted: bool,
}

/// A cell is not divided further than this many times; its samples would hardly differ in their positions.
const DEEPEST: u8 = 20;

/// A square part of a pixel with one sample in each of its quarters.
struct Cell {
    pixel: u32,
    level: u8,
    /// Which of the `4^level` squares of its pixel.
    at: [u32; 2],
    /// `(u, v)` in the pixel and the value, quarter by quarter, along x first.
    samples: [[f64; 3]; 4],
    /// The first of its four parts, if it is divided.
    parts: Option<u32>,
}

/// A cell in the queue: the one that can change its pixel most comes first, and of equals the earlier.
#[derive(PartialEq)]
struct Next {
    contrast: f64,
    cell: u32,
}

impl Eq for Next {}

impl Ord for Next {
    fn cmp(&self, other: &Self) -> Ordering {
        self.contrast.total_cmp(&other.contrast).then(other.cell.cmp(&self.cell))
    }
}

impl PartialOrd for Next {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

/// A picture of a field with more samples where they differ: every pixel starts with four jittered ones, and the cells that
/// can change their pixels most are divided into four, until all are below the contrast or the budget is spent.
///
/// A cell's four samples stand one in each quarter; dividing it keeps each and adds three beside it, in the other quarters
/// of that quarter. So the leaves are a nested jitter, and a pixel is the mean of its samples weighted by their areas.
/// What a cell can change is how far its samples and the ring of twelve around it lie apart, times the share of the pixel
/// that it covers: without the ring an edge near a border would be seen from one side only. Cells that can change more than
/// half of what the first can are divided together, on all threads: a part has a quarter of the area, and would hardly
/// have come before them.
///
/// Not exact, and biased: the samples that decide where to look are also those that count (Kirk and Arvo 1991), and what
/// lies between the first samples is never found (PBRT's warning). The same bits in every run, for any number of threads.
///
/// ```
/// use nyquist::prelude::*;
/// use nyquist::antialias::adaptive::{Budget, adaptive};
/// let (disc, grid) = (Disc::new([8.0, 8.0], 5.3)?, Grid::pixels(16, 16)?);
/// let found = adaptive(&disc, grid, Budget { contrast: 0.02, per_pixel: 64.0 }, 1)?;
/// assert_eq!(found.samples.at(8, 8), 4.0); // inside, where all samples agree
/// assert!(found.samples.at(13, 8) > 40.0); // on the edge
/// let same = supersample(&disc, grid, &Jittered::<2>::nearest(found.taken / 256)?, &BoxKernel, 1)?;
/// let exact = Image::averaged(&disc, grid);
/// assert!(found.image.rmse(&exact)? < 0.2 * same.rmse(&exact)?); // for as many samples
/// # Ok::<(), Error>(())
/// ```
///
/// # Errors
/// A contrast that is negative or not finite, fewer than 4 samples a pixel, a budget of more than 2³⁰ samples.
pub fn adaptive(field: &(impl Field + Sync), grid: Grid, budget: Budget, seed: u64) -> Result<Adapted> {
    finite("the contrast of adaptive sampling", budget.contrast)?;
    positive("the samples a pixel of adaptive sampling", budget.per_pixel)?;
    let (most, pixels) = ((1u32 << 30) as f64, grid.len());
    if budget.contrast < 0.0 {
        let what = "the contrast of adaptive sampling";
        return Err(Error::OutOfRange { what, value: budget.contrast, low: 0.0, high: f64::MAX });
    }
    if budget.per_pixel < 4.0 {
        let what = "the samples a pixel of adaptive sampling";
        return Err(Error::OutOfRange { what, value: budget.per_pixel, low: 4.0, high: most / pixels as f64 });
    }
    let allowed = budget.per_pixel * pixels as f64;
    if allowed > most {
        return Err(Error::Overflow { what: "the number of adaptive samples", value: allowed, most });
    }
    let mut tree = Tree { field, grid, seed, cells: Vec::new() };
    tree.cells = parallel::map(pixels, |pixel| tree.cell(pixel as u32, 0, [0, 0], None));
    let mut taken = 4 * pixels;
    let mut queue: BinaryHeap<Next> = parallel::map(pixels, |cell| tree.next(cell as u32)).into();
    let mut exhausted = false;
    while let Some(first) = queue.peek().filter(|first| first.contrast > budget.contrast && !exhausted) {
        let least = budget.contrast.max(0.5 * first.contrast);
        let mut together = Vec::new();
        while let Some(next) = queue.peek().filter(|next| next.contrast > least) {
            if tree.cells[next.cell as usize].level < DEEPEST {
                together.push(next.cell);
            }
            queue.pop();
        }
        let room = ((allowed - taken as f64) / 12.0) as usize;
        exhausted = together.len() > room;
        together.truncate(room);
        taken += 12 * together.len();
        let parts = tree.divide(&together);
        queue.extend(parallel::map(parts.len(), |i| tree.next(parts.start + i as u32)));
    }
    let (mut values, mut counts) = (Vec::with_capacity(pixels), Vec::with_capacity(pixels));
    for pixel in 0..pixels as u32 {
        let (mean, count) = tree.mean(pixel);
        values.push(mean);
        counts.push(count);
    }
    Ok(Adapted { image: Image::new(grid, values)?, samples: Image::new(grid, counts)?, taken, exhausted })
}

/// All cells, those of whole pixels first.
struct Tree<'a, F> {
    field: &'a F,
    grid: Grid,
    seed: u64,
    cells: Vec<Cell>,
}

impl<F: Field + Sync> Tree<'_, F> {
    /// What a cell can change its pixel by: how far its four samples and the twelve around it lie apart, times its area.
    fn next(&self, index: u32) -> Next {
        let cell = &self.cells[index as usize];
        let (side, width) = (2i64 << cell.level, self.grid.width() as i64);
        let pixel = [i64::from(cell.pixel) % width, i64::from(cell.pixel) / width];
        let corner: [i64; 2] = std::array::from_fn(|d| pixel[d] * side + 2 * i64::from(cell.at[d]));
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for (i, j) in (-1..3).flat_map(|j| (-1..3).map(move |i| (i, j))) {
            if let Some(value) = self.around(corner[0] + i, corner[1] + j, cell.level) {
                (low, high) = (low.min(value), high.max(value));
            }
        }
        Next { contrast: (high - low) * 0.25f64.powi(i32::from(cell.level)), cell: index }
    }

    /// The sample in that quarter of a cell of that level, counted over the whole picture, or the one that stands for it
    /// where the cells are larger; nothing beyond the frame.
    fn around(&self, i: i64, j: i64, level: u8) -> Option<f64> {
        let side = 2i64 << level;
        let (column, row) = (i.div_euclid(side), j.div_euclid(side));
        let (width, height) = (self.grid.width() as i64, self.grid.height() as i64);
        if !(0..width).contains(&column) || !(0..height).contains(&row) {
            return None;
        }
        let (i, j) = (i - column * side, j - row * side);
        let quarter = |level: u8, depth: u8| (((i >> (level - depth)) & 1) + 2 * ((j >> (level - depth)) & 1)) as usize;
        let (mut cell, mut depth) = (&self.cells[(row * width + column) as usize], 0);
        while depth < level
            && let Some(first) = cell.parts
        {
            cell = &self.cells[first as usize + quarter(level, depth)];
            depth += 1;
        }
        Some(cell.samples[quarter(level, depth)][2])
    }

    /// A cell with a sample in every quarter, one of which may be known.
    fn cell(&self, pixel: u32, level: u8, at: [u32; 2], known: Option<[f64; 3]>) -> Cell {
        let width = self.grid.width();
        let (column, row) = ((pixel as usize % width) as i64, (pixel as usize / width) as i64);
        let seed = pixel_seed(self.seed, column, row);
        // a quarter has an address in its pixel: its numbers do not depend on the order in which cells are divided
        let side = f64::from(2u32 << level);
        let quarter_of = |s: [f64; 3]| [(s[0] * side) as u32, (s[1] * side) as u32];
        let samples = std::array::from_fn(|quarter| {
            let [i, j] = [2 * at[0] + quarter as u32 % 2, 2 * at[1] + quarter as u32 / 2];
            if let Some(sample) = known.filter(|s| quarter_of(*s) == [i, j]) {
                return sample;
            }
            let (index, dimension) = ((u64::from(i) << 32) | u64::from(j), 2 * u32::from(level));
            let u = (f64::from(i) + uniform(seed, index, dimension)) / side;
            let v = (f64::from(j) + uniform(seed, index, dimension + 1)) / side;
            let [middle_x, middle_y] = self.grid.at(column, row);
            let (x, y) = (middle_x + (u - 0.5) * self.grid.x().step(), middle_y + (v - 0.5) * self.grid.y().step());
            [u, v, self.field.at(x, y)]
        });
        Cell { pixel, level, at, samples, parts: None }
    }

    /// Divides cells into four each; where the parts are, one cell's after the other's.
    fn divide(&mut self, cells: &[u32]) -> Range<u32> {
        let parts = parallel::map(cells.len(), |i| {
            let Cell { pixel, level, at, samples, .. } = self.cells[cells[i] as usize];
            [0u32, 1, 2, 3].map(|quarter| {
                let at = [2 * at[0] + quarter % 2, 2 * at[1] + quarter / 2];
                self.cell(pixel, level + 1, at, Some(samples[quarter as usize]))
            })
        });
        let first = self.cells.len() as u32;
        for (cell, place) in cells.iter().zip((first..).step_by(4)) {
            self.cells[*cell as usize].parts = Some(place);
        }
        self.cells.extend(parts.into_iter().flatten());
        first..self.cells.len() as u32
    }

    /// The mean over a cell, and how many samples it has.
    fn mean(&self, cell: u32) -> (f64, f64) {
        let cell = &self.cells[cell as usize];
        let (sum, count) = match cell.parts {
            None => (cell.samples.iter().map(|s| s[2]).sum::<f64>(), 4.0),
            Some(first) => {
                (first..first + 4).map(|part| self.mean(part)).fold((0.0, 0.0), |a, b| (a.0 + b.0, a.1 + b.1))
            }
        };
        (0.25 * sum, count)
    }
}
