//! The square in cells of one point each, and what of them disks cover.

use std::sync::LazyLock;

/// The square in cells of side at most `radius/√2`, which hold at most one point each, with a margin of two cells around
/// for the images of points across the edges: farther no disk reaches.
#[derive(Debug)]
pub(crate) struct Board {
    side: u32,
    /// Cells in a row, the margin included.
    width: usize,
    /// The square of the radius.
    squared: f64,
    torus: bool,
    points: Vec<[f64; 2]>,
    /// The point of each cell, infinitely far away if there is none.
    cells: Vec<[f64; 2]>,
    /// Which sixty-fourths of each cell some disk covers whole, a bit each, by rows.
    covered: Vec<u64>,
}

const MARGIN: u32 = 2;

/// Rows of cells that a disk reaches, and cells in them.
const AROUND: usize = 2 * MARGIN as usize + 1;

/// As many numbers as are read of a row: one more than there are cells around, to have pairs.
const READ: usize = AROUND + 1;

/// Parts along a side of a cell that are told apart in [`Board`]'s `covered`.
pub(crate) const PARTS: u32 = 8;

/// How many darts are looked at together, so that memory need not be waited for one after the other.
pub(crate) const BATCH: usize = 64;

impl Board {
    pub(crate) fn new(radius: f64, torus: bool) -> Self {
        let side = (2f64.sqrt() / radius).ceil() as u32;
        let width = (side + 2 * MARGIN) as usize;
        let cells = vec![[f64::INFINITY; 2]; width * width + READ - AROUND];
        let covered = vec![0; width * (width + AROUND)];
        Self { side, width, squared: radius * radius, torus, points: Vec::new(), cells, covered }
    }

    /// How many cells there are along a side.
    pub(crate) fn side(&self) -> u32 {
        self.side
    }

    pub(crate) fn into_points(self) -> Vec<[f64; 2]> {
        self.points
    }

    /// Where in the rows of points those around a cell begin.
    fn start(&self, [x, y]: [u32; 2]) -> usize {
        y as usize * self.width + x as usize
    }

    /// Where the point of a cell is. What it covers is as far behind that: so disks in the margin need no other rule.
    fn index(&self, cell: [u32; 2]) -> usize {
        self.start(cell.map(|c| c + MARGIN))
    }

    /// Where the covered parts of the cell stand whose point is `at`.
    fn mask(&self, at: usize) -> usize {
        at + MARGIN as usize * (self.width + 1)
    }

    /// Throws darts at places, in their order; those that hit no disk become points. `aim` says where those go whose numbers
    /// begin with the one given.
    ///
    /// A batch is looked at in passes of independent loads, none of which waits for another's.
    pub(crate) fn throw(&mut self, darts: u64, aim: impl Fn(u64, &mut [[f64; 2]])) {
        for first in (0..darts).step_by(BATCH) {
            let count = (darts - first).min(BATCH as u64) as usize;
            let mut places = [[0.0; 2]; BATCH];
            aim(first, &mut places[..count]);
            let mut open = 0;
            for dart in 0..count {
                let place = places[dart];
                places[open] = place;
                open += usize::from(place[0] < 1.0 && place[1] < 1.0 && !self.is_covered(self.part(place, PARTS)));
            }
            // the sum says nothing: it brings what is_free reads into the cache
            std::hint::black_box(places[..open].iter().map(|&place| self.ends_of_rows(place)).fold(0.0, |a, b| a + b));
            for &place in &places[..open] {
                if self.is_free(place) {
                    self.insert(place);
                }
            }
        }
    }

    /// The square that a place is in, if each cell is cut into so many along its side.
    fn part(&self, place: [f64; 2], parts: u32) -> [u32; 2] {
        let all = parts * self.side;
        place.map(|c| ((c * f64::from(all)) as u32).min(all - 1))
    }

    /// Whether a part of a cell, one of 64, is known to be covered whole.
    fn is_covered(&self, part: [u32; 2]) -> bool {
        let [x, y] = part.map(|c| c % PARTS);
        self.covered[self.mask(self.index(part.map(|c| c / PARTS)))] >> (PARTS * y + x) & 1 == 1
    }

    /// The points around a cell: five rows, the middle ones first, which tell most darts that miss.
    fn around(&self, cell: [u32; 2]) -> impl Iterator<Item = &[[f64; 2]; READ]> {
        let start = self.start(cell);
        let row = move |row| self.cells[start + row * self.width..].first_chunk();
        [2, 1, 3, 0, 4].into_iter().map(move |i| row(i).expect("there is a margin around every cell"))
    }

    /// The first and the last number of every row around a place, added.
    fn ends_of_rows(&self, place: [f64; 2]) -> f64 {
        self.around(self.part(place, 1)).map(|row| row[0][0] + row[READ - 1][0]).fold(0.0, |a, b| a + b)
    }

    /// Whether a place is at least the radius away from all points.
    fn is_free(&self, [x, y]: [f64; 2]) -> bool {
        self.around(self.part([x, y], 1)).all(|row| {
            let too_near = |[px, py]: &[f64; 2]| (px - x) * (px - x) + (py - y) * (py - y) < self.squared;
            !row.iter().fold(false, |any, point| any | too_near(point))
        })
    }

    /// Puts a point, and on the torus its images that fall into the margin.
    fn insert(&mut self, place: [f64; 2]) {
        self.points.push(place);
        let cell = self.part(place, 1);
        let step = self.part(place, STEPS as u32).map(|c| c as usize % STEPS);
        let (side, width) = (i64::from(self.side), self.width as i64);
        let inside = cell.iter().all(|&c| (MARGIN..self.side.saturating_sub(MARGIN)).contains(&c));
        let turns = if self.torus && !inside { -1..=1 } else { 0..=0 };
        for v in turns.clone() {
            for u in turns.clone() {
                let [x, y] = [(cell[0], u), (cell[1], v)].map(|(c, turn)| i64::from(c + MARGIN) + turn * side);
                if (0..width).contains(&x) && (0..width).contains(&y) {
                    let at = (y * width + x) as usize;
                    self.cells[at] = [place[0] + u as f64, place[1] + v as f64];
                    self.cover(at, step);
                }
            }
        }
    }

    /// Marks the parts that the disk of a cell covers.
    fn cover(&mut self, at: usize, [x, y]: [usize; 2]) {
        let last = AROUND - 1;
        for row in 0..AROUND {
            let masks = &COVERED[((last - row) * STEPS + y) * WINDOW + x..][..last * STEPS + 1];
            let cells = &mut self.covered[at + row * self.width..][..AROUND];
            cells.iter_mut().enumerate().for_each(|(i, cell)| *cell |= masks[(last - i) * STEPS]);
        }
        let own = self.mask(at);
        self.covered[own] = u64::MAX;
    }

    /// The sixty-fourths of cells that no disk covers whole, with some that one does by a narrow margin.
    pub(crate) fn open(&self) -> Vec<[u32; 2]> {
        let mut open = Vec::new();
        for y in 0..self.side {
            for x in 0..self.side {
                let mut rest = !self.covered[self.mask(self.index([x, y]))];
                while rest > 0 {
                    let bit = rest.trailing_zeros();
                    open.push([PARTS * x + bit % PARTS, PARTS * y + bit / PARTS]);
                    rest &= rest - 1;
                }
            }
        }
        open
    }

    /// Those quarters of parts of cells that no disk covers whole. The parts are the sixty-fourths, or those quartered so
    /// many times.
    pub(crate) fn quarters(&self, parts: &[[u32; 2]], times: u32) -> Vec<[u32; 2]> {
        let quarter = 0.5 / (f64::from(PARTS * self.side) * f64::from(1u32 << times));
        let mut open = Vec::with_capacity(parts.len());
        for part in parts.iter().filter(|part| !self.is_covered(part.map(|c| c >> times))) {
            let cell = part.map(|c| (c >> times) / PARTS);
            let middle = part.map(|c| f64::from(2 * c + 1) * quarter);
            for (i, far) in (0..).zip(self.farthest(cell, middle, quarter)) {
                if far >= self.squared {
                    open.push([2 * part[0] + i % 2, 2 * part[1] + i / 2]);
                }
            }
        }
        open
    }

    /// For each quarter of a square, how near to a point the whole of it is: the least distance, squared, from a point to
    /// the farthest corner.
    fn farthest(&self, cell: [u32; 2], [x, y]: [f64; 2], quarter: f64) -> [f64; 4] {
        let mut least = [[f64::INFINITY; READ]; 4];
        for row in self.around(cell) {
            let far = |distance: f64| (distance.abs() + 0.5 * quarter) * (distance.abs() + 0.5 * quarter);
            let both = |c: f64| [far(c + 0.5 * quarter), far(c - 0.5 * quarter)];
            let [a, b, c, d] = &mut least;
            for i in 0..READ {
                let ([left, right], [below, above]) = (both(row[i][0] - x), both(row[i][1] - y));
                a[i] = lesser(left + below, a[i]);
                b[i] = lesser(right + below, b[i]);
                c[i] = lesser(left + above, c[i]);
                d[i] = lesser(right + above, d[i]);
            }
        }
        least.map(|quarter| quarter.into_iter().fold(f64::INFINITY, lesser))
    }
}

/// The lesser of two numbers, neither of which is NaN: one instruction.
fn lesser(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

/// Along a side of a cell, to how many steps [`COVERED`] knows where a point is.
const STEPS: usize = 16;

/// Steps along a side of all that a disk reaches.
const WINDOW: usize = AROUND * STEPS;

/// The sixty-fourths of the middle one of five by five cells that a disk covers wherever in its step its point is, for
/// every step of the five by five. The radius is the least, `√2` cells.
static COVERED: LazyLock<Vec<u64>> = LazyLock::new(|| {
    let (parts, middle) = (PARTS as usize, MARGIN as usize * STEPS);
    let size = STEPS / parts;
    // from anywhere in a step to the farther side of a part
    let far = |step: usize, part: usize| (step + 1).abs_diff(part).max(step.abs_diff(part + size));
    let mask = |x, y| {
        (0..parts * parts).fold(0, |mask, bit| {
            let (dx, dy) = (far(x, middle + bit % parts * size), far(y, middle + bit / parts * size));
            mask | u64::from(dx * dx + dy * dy < 2 * STEPS * STEPS) << bit
        })
    };
    (0..WINDOW * WINDOW).map(|i| mask(i % WINDOW, i / WINDOW)).collect()
});
