//! Non-uniform transforms in the plane.

use crate::engine::fft::{Butterflies, Fft, Pool, RealFft};
use crate::engine::nonuniform::line::{checked, fits, lend};
use crate::engine::nonuniform::local::{gather_plane, spread_plane};
use crate::engine::nonuniform::placed::Placed;
use crate::engine::nonuniform::position::{Position, Ruler};
use crate::engine::nonuniform::shape::{Shape, gains};
use crate::engine::nonuniform::taps::{Taps, with_width};
use crate::engine::real::Real;
use crate::engine::simd::{Loop, vectorised};
use crate::error::{Result, within};
use crate::parallel;
use num_complex::Complex;

/// The transforms between real values at any points of a rectangle that repeats itself and its harmonics `0 ≤ u ≤ U`,
/// `|v| ≤ V`; those of negative `u` are conjugates, since values are real.
///
/// As [`Nufft`](crate::engine::nonuniform::Nufft), for whose errors two axes share the tolerance. Spectra are kept
/// column by column: the harmonic `(u, v)` is number `u·(2V + 1) + v + V`.
///
/// ```
/// use nyquist::engine::nonuniform::PlaneNufft;
/// // two impulses half a period apart along x: harmonics of odd u cancel
/// let nufft = PlaneNufft::<f64>::new([3, 2], [1, 1], 1e-12)?;
/// let spectrum = nufft.spectrum(&nufft.place(&[[0.0, 0.5], [0.5, 0.5]])?, &[1.0, 1.0])?;
/// assert!((spectrum[2 * 5 + 1 + 2] + 2.0).norm() < 4e-12 && spectrum[1 * 5 + 1 + 2].norm() < 4e-12);
/// # Ok::<(), nyquist::error::Error>(())
/// ```
#[derive(Debug)]
pub struct PlaneNufft<T> {
    degrees: [usize; 2],
    rulers: [Ruler; 2],
    cells: [usize; 2],
    taps: Taps<T>,
    gains: [Vec<T>; 2],
    rows: RealFft<T>,
    columns: Fft<T>,
    grids: Pool<T>,
    halves: Pool<T>,
    rooms: Pool<T>,
}

/// The greatest degree along an axis: grids of up to 2²⁶ cells and 2¹⁵ bins.
const MOST_DEGREE: usize = 1 << 11;
/// The cells of a bin: 64 columns and 32 rows, whose windows stay in the nearest cache.
const BIN_BITS: [u32; 2] = [6, 5];
/// The columns of a bin.
const TILE: usize = 1 << BIN_BITS[0];
/// The rows of a band, spread and transformed together.
const BAND: usize = 1 << BIN_BITS[1];
/// How many columns are gathered at a time: as many complex numbers as two lines of a cache hold.
const TOGETHER: usize = 8;

const ROOMS: &str = "rooms are as long as their transform";

impl<T: Real> PlaneNufft<T> {
    /// A plan for harmonics up to `degrees` of periods of so many units along x and y, to a relative error of
    /// `tolerance`, as fast as this processor can.
    ///
    /// # Errors
    /// A degree beyond 2¹¹, a period of zero or beyond 2²⁶, or a tolerance that is not within
    /// [`least_tolerance`](crate::engine::nonuniform::least_tolerance)` ..= 0.1`.
    pub fn new(degrees: [usize; 2], periods: [usize; 2], tolerance: f64) -> Result<Self> {
        Self::with(degrees, periods, tolerance, Butterflies::Fastest)
    }

    /// A plan of chosen butterflies.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn with(degrees: [usize; 2], periods: [usize; 2], tolerance: f64, butterflies: Butterflies) -> Result<Self> {
        for (degree, period) in degrees.into_iter().zip(periods) {
            within("the degree of a non-uniform transform", degree as f64, 0.0, MOST_DEGREE as f64)?;
            within("the units of a period", period as f64, 1.0, f64::from(1 << 26))?;
        }
        let modes = 4.0 * degrees[0] as f64 * degrees[1] as f64;
        // nanoseconds, measured: the transforms, and the sums for a sixteenth as many points as there are modes
        let cost = |[nx, ny]: [f64; 2], width: f64| {
            0.4 * nx * ny * nx.max(ny).log2() + modes / 16.0 * (10.0 + 0.4 * width * width)
        };
        let Shape { window, cells, allowed } = Shape::of(degrees, 0.5 * checked::<T>(tolerance)?, BAND, cost);
        let ruler = |axis: usize| Ruler::new(periods[axis], cells[axis], window.width(), BIN_BITS[axis]);
        Ok(Self {
            degrees,
            rulers: [ruler(0), ruler(1)],
            cells,
            taps: Taps::new(&window, allowed),
            gains: [0, 1].map(|axis| gains(&window, degrees[axis], cells[axis])),
            rows: RealFft::with(cells[0], butterflies)?,
            columns: Fft::with(cells[1], butterflies)?,
            grids: Pool::new(),
            halves: Pool::new(),
            rooms: Pool::new(),
        })
    }

    /// The highest harmonics, `U` and `V`.
    pub fn degrees(&self) -> [usize; 2] {
        self.degrees
    }

    /// How many harmonics a spectrum has, `(U + 1)(2V + 1)`.
    pub fn modes(&self) -> usize {
        (self.degrees[0] + 1) * self.height()
    }

    /// The harmonics of one column, `2V + 1`.
    fn height(&self) -> usize {
        2 * self.degrees[1] + 1
    }

    /// From one row of cells to the next, a window's width longer than the grid.
    fn pitch(&self) -> usize {
        self.cells[0] + self.taps.width()
    }

    /// Points, for any number of transforms. Positions beyond the period are taken around it.
    ///
    /// # Errors
    /// Positions that are not finite.
    pub fn place<P: Position>(&self, points: &[[P; 2]]) -> Result<Placed<2>> {
        let mut placed = Placed::none(self.rulers);
        self.place_into(points, &mut placed)?;
        Ok(placed)
    }

    /// [`place`](Self::place) with memory that has been used before.
    ///
    /// # Errors
    /// As `place`, and then there are no points; memory of another transform's points.
    pub fn place_into<P: Position>(&self, points: &[[P; 2]], placed: &mut Placed<2>) -> Result<()> {
        placed.on(&self.rulers)?;
        placed.fill(points)
    }

    /// Type 1: `F_{uv} = Σ_j w_j e^{−2πi(ux_j/X + vy_j/Y)}` for periods `X`, `Y`.
    ///
    /// # Errors
    /// As many weights as there are not points; points placed for another transform.
    pub fn spectrum(&self, points: &Placed<2>, weights: &[T]) -> Result<Vec<Complex<T>>> {
        let mut spectrum = vec![Complex::default(); self.modes()];
        self.spectrum_into(points, weights, &mut spectrum)?;
        Ok(spectrum)
    }

    /// [`spectrum`](Self::spectrum) into memory that is there already.
    ///
    /// # Errors
    /// As `spectrum`; as much room as there are not harmonics.
    pub fn spectrum_into(&self, points: &Placed<2>, weights: &[T], spectrum: &mut [Complex<T>]) -> Result<()> {
        self.harmonics(points, weights, spectrum, |harmonic| harmonic)
    }

    /// The power `|F_{uv}|²` alone, which saves half of the result's way through memory.
    ///
    /// # Errors
    /// As [`spectrum_into`](Self::spectrum_into).
    pub fn power_into(&self, points: &Placed<2>, weights: &[T], power: &mut [T]) -> Result<()> {
        self.harmonics(points, weights, power, |harmonic| harmonic.norm_sqr())
    }

    fn harmonics<O: Send>(
        &self,
        points: &Placed<2>,
        weights: &[T],
        out: &mut [O],
        write: impl Fn(Complex<T>) -> O + Sync + Send,
    ) -> Result<()> {
        fits("the weights of points", points.on(&self.rulers)?.len(), weights.len())?;
        fits("room for a spectrum", self.modes(), out.len())?;
        let (bands, band) = (self.cells[1] / BAND, (BAND + self.taps.width()) * self.pitch());
        let across = self.degrees[0] + 1;
        self.halves.lend(self.cells[1] * across, |half| {
            lend(&self.grids, bands * band, |cells| {
                lend(&self.rooms, weights.len(), |sorted| {
                    points.sort(weights, sorted);
                    parallel::chunks(cells, band, |band, cells| {
                        cells.fill(T::zero());
                        vectorised(Spread { plan: self, points, band, sorted, cells });
                    });
                });
                parallel::chunks(half, BAND * across, |i, half| {
                    let before = &cells[(i + bands - 1) % bands * band + BAND * self.pitch()..];
                    self.transform_rows(&cells[i * band..][..BAND * self.pitch()], before, half);
                });
            });
            parallel::chunks(out, TOGETHER * self.height(), |block, out| {
                self.transform_columns(half, block, out, &write);
            });
        });
        Ok(())
    }

    /// The harmonics along x of a band's rows, with what the windows of the band before it have left for them; eight
    /// columns of the band after eight.
    fn transform_rows(&self, here: &[T], before: &[T], half: &mut [Complex<T>]) {
        let (nx, width, pitch) = (self.cells[0], self.taps.width(), self.pitch());
        self.rooms.lend(nx / 2 + nx / 2 + 1, |room| {
            let (values, line) = room.split_at_mut(nx / 2);
            let values: &mut [T] = bytemuck::cast_slice_mut(values);
            for (i, row) in here.chunks_exact(pitch).enumerate() {
                values.copy_from_slice(&row[..nx]);
                add(&mut values[..width], &row[nx..]);
                if i < width {
                    let row = &before[i * pitch..][..pitch];
                    add(values, &row[..nx]);
                    add(&mut values[..width], &row[nx..]);
                }
                self.rows.forward(values, line).expect(ROOMS);
                for (block, part) in line[..=self.degrees[0]].chunks(TOGETHER).enumerate() {
                    half[block * TOGETHER * BAND + i * part.len()..][..part.len()].copy_from_slice(part);
                }
            }
        });
    }

    /// Columns of the spectrum from harmonics along x.
    fn transform_columns<O>(&self, half: &[Complex<T>], block: usize, out: &mut [O], write: impl Fn(Complex<T>) -> O) {
        let (ny, top, first) = (self.cells[1], self.degrees[1], block * TOGETHER);
        let count = out.len() / self.height();
        self.rooms.lend((count + 1) * ny, |room| {
            let (columns, column) = room.split_at_mut(count * ny);
            for (band, half) in half.chunks_exact(BAND * (self.degrees[0] + 1)).enumerate() {
                for (j, row) in half[first * BAND..][..count * BAND].chunks_exact(count).enumerate() {
                    row.iter().enumerate().for_each(|(i, v)| columns[i * ny + band * BAND + j] = *v);
                }
            }
            let columns = columns.chunks_exact(ny).zip(out.chunks_exact_mut(self.height()));
            for (u, (from, out)) in (first..).zip(columns) {
                self.columns.forward(from, column).expect(ROOMS);
                let (below, above) = out.split_at_mut(top);
                let (gain, gains) = (self.gains[0][u], &self.gains[1]);
                let scaled = |(out, (v, g)): (&mut O, (&Complex<T>, &T))| *out = write(v.scale(gain * *g));
                above.iter_mut().zip(column.iter().zip(gains)).for_each(&scaled);
                below.iter_mut().zip(column[ny - top..].iter().zip(gains[1..].iter().rev())).for_each(&scaled);
            }
        });
    }

    /// Type 2: `f(x_j, y_j) = Σ c_{uv} e^{2πi(ux_j/X + vy_j/Y)}` over all `|u| ≤ U`, `|v| ≤ V`, with `c_{−u,−v} =
    /// c̄_{uv}`. Of the harmonics with `u = 0`, of which both halves are given, the real part of the sum counts.
    ///
    /// # Errors
    /// As many coefficients as there are not harmonics; points placed for another transform.
    pub fn values(&self, modes: &[Complex<T>], points: &Placed<2>) -> Result<Vec<T>> {
        let mut values = vec![T::zero(); points.len()];
        self.values_into(modes, points, &mut values)?;
        Ok(values)
    }

    /// [`values`](Self::values) into memory that is there already.
    ///
    /// # Errors
    /// As `values`; as much room as there are not points.
    pub fn values_into(&self, modes: &[Complex<T>], points: &Placed<2>, values: &mut [T]) -> Result<()> {
        fits("the coefficients of harmonics", self.modes(), modes.len())?;
        fits("room for values", points.on(&self.rulers)?.len(), values.len())?;
        let (ny, width, pitch) = (self.cells[1], self.taps.width(), self.pitch());
        lend(&self.grids, (ny + width) * pitch, |grid| {
            self.halves.lend((self.degrees[0] + 1) * ny, |columns| {
                parallel::chunks(columns, ny, |u, column| self.restore_column(modes, u, column));
                parallel::chunks(&mut grid[..ny * pitch], BAND * pitch, |band, rows| {
                    self.restore_rows(columns, band, rows);
                });
            });
            grid.copy_within(..width * pitch, ny * pitch);
            lend(&self.rooms, values.len(), |sorted| {
                let (grid, tiles) = (&*grid, self.rulers[0].bins());
                points.each(sorted, values, |bin, values| {
                    let cells = &grid[bin / tiles * BAND * pitch + bin % tiles * TILE..];
                    vectorised(Gather { plan: self, points, bin, cells, values });
                });
            });
        });
        Ok(())
    }

    /// A column of the grid's spectrum along x from one of the spectrum.
    fn restore_column(&self, modes: &[Complex<T>], u: usize, column: &mut [Complex<T>]) {
        let (ny, top) = (self.cells[1], self.degrees[1]);
        self.rooms.lend(ny, |padded| {
            padded.fill(Complex::default());
            for (k, mode) in modes[u * self.height()..][..self.height()].iter().enumerate() {
                let at = if k < top { ny + k - top } else { k - top };
                padded[at] = mode.scale(self.gains[0][u] * self.gains[1][k.abs_diff(top)]);
            }
            self.columns.inverse(padded, column).expect(ROOMS);
        });
    }

    /// Rows of the grid, each followed by a window's width of its start.
    fn restore_rows(&self, columns: &[Complex<T>], band: usize, rows: &mut [T]) {
        let [nx, ny] = self.cells;
        self.rooms.lend(nx / 2 + 1, |line| {
            line[self.degrees[0] + 1..].fill(Complex::default());
            for (j, row) in (band * BAND..).zip(rows.chunks_exact_mut(self.pitch())) {
                for (value, column) in line.iter_mut().zip(columns.chunks_exact(ny)) {
                    *value = column[j];
                }
                let (cells, beyond) = row.split_at_mut(nx);
                self.rows.inverse(line, cells).expect(ROOMS);
                beyond.copy_from_slice(&cells[..beyond.len()]);
            }
        });
    }
}

/// The weights of one band over its cells, tile by tile.
struct Spread<'a, T> {
    plan: &'a PlaneNufft<T>,
    points: &'a Placed<2>,
    band: usize,
    sorted: &'a [T],
    cells: &'a mut [T],
}

impl<T: Real> Loop for Spread<'_, T> {
    #[inline(always)]
    fn run(self) {
        let (taps, pitch, tiles) = (&self.plan.taps, self.plan.pitch(), self.plan.rulers[0].bins());
        with_width!(taps.width(), W => {
            let taps = taps.fixed::<W>();
            for tile in 0..tiles {
                let cells = &mut self.cells[tile * TILE..];
                for (codes, weights) in self.points.beside(self.band * tiles + tile, self.sorted) {
                    for (code, weight) in codes.iter().zip(weights) {
                        spread_plane(&taps, cells, pitch, *code, *weight);
                    }
                }
            }
        });
    }
}

/// The values of one bin's points from its cells.
struct Gather<'a, T> {
    plan: &'a PlaneNufft<T>,
    points: &'a Placed<2>,
    bin: usize,
    cells: &'a [T],
    values: &'a mut [T],
}

impl<T: Real> Loop for Gather<'_, T> {
    #[inline(always)]
    fn run(self) {
        let (taps, pitch) = (&self.plan.taps, self.plan.pitch());
        with_width!(taps.width(), W => {
            let taps = taps.fixed::<W>();
            let mut values = self.values;
            for codes in self.points.codes(self.bin) {
                let (here, rest) = values.split_at_mut(codes.len());
                for (value, code) in here.iter_mut().zip(codes) {
                    *value = gather_plane(&taps, self.cells, pitch, *code);
                }
                values = rest;
            }
        });
    }
}

fn add<T: Real>(to: &mut [T], from: &[T]) {
    to.iter_mut().zip(from).for_each(|(to, v)| *to += *v);
}
