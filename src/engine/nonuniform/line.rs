//! Non-uniform transforms on the line.

use crate::engine::fft::{Butterflies, Pool, RealFft};
use crate::engine::nonuniform::local::{gather, spread};
use crate::engine::nonuniform::placed::Placed;
use crate::engine::nonuniform::position::{Position, Ruler};
use crate::engine::nonuniform::shape::{Shape, gains};
use crate::engine::nonuniform::taps::{Taps, with_width};
use crate::engine::real::Real;
use crate::engine::simd::{Loop, vectorised};
use crate::error::{Error, Result, within};
use crate::parallel;
use num_complex::Complex;

/// The transforms between real values at any points of a period and the harmonics `0 ≤ k ≤ K` of that period, in `O(K
/// log K + m log 1/ε)`: of type 1, [`spectrum`](Self::spectrum), and of type 2, [`values`](Self::values), each other's
/// adjoint.
///
/// Real values have a Hermitian spectrum, so that one half of it is enough, the grid is real, and so are its transforms
/// and the sums over windows: half the work of the complex ones. Positions are counted in units of which a period has
/// `period`: 1, or the number of samples.
///
/// **Error.** For tolerance `ε`, `|F̃_k − F_k| ≤ ε·Σ|w_j|` and `|f̃(x) − f(x)| ≤ ε·Σ|c_k|` for every input, beside
/// rounding, which for `f64` is some `10⁻¹⁵` of that. In the root mean square, in which such tolerances are commonly
/// meant, the error is several times smaller than `ε·‖F‖` for inputs without structure.
///
/// **Plan.** `Send + Sync`; it keeps the memory that its transforms need, once for every call that runs at the same time:
/// up to about `48·σK` bytes in `f64`, a third each for the grid, its spectrum and the transform between them, `σ` from 1.25
/// to 2, and 8 for every point.
///
/// Dutt and Rokhlin, *Fast Fourier transforms for nonequispaced data*, 1993; Barnett, Magland and af Klinteberg, *A
/// parallel nonuniform fast Fourier transform library based on an “exponential of semicircle” kernel*, 2019.
///
/// ```
/// use nyquist::engine::nonuniform::Nufft;
/// // three impulses at the thirds of a period: lines at every third harmonic
/// let nufft = Nufft::<f64>::new(7, 3, 1e-12)?;
/// let lines = nufft.spectrum(&nufft.place(&[0.0, 1.0, 2.0])?, &[1.0, 1.0, 1.0])?;
/// assert!((0..8).all(|k| (lines[k] - if k % 3 == 0 { 3.0 } else { 0.0 }).norm() < 3e-12));
/// # Ok::<(), nyquist::error::Error>(())
/// ```
#[derive(Debug)]
pub struct Nufft<T> {
    degree: usize,
    ruler: Ruler,
    cells: usize,
    taps: Taps<T>,
    gains: Vec<T>,
    fft: RealFft<T>,
    halves: Pool<T>,
    grids: Pool<T>,
    rooms: Pool<T>,
}

/// The greatest degree, 2²⁵: with positions below it, products with numbers of cells are exact.
pub(super) const MOST_DEGREE: usize = 1 << 25;
/// How many bits count the cells of a bin: 4096 cells, 32 kB of `f64`.
const BIN_BITS: u32 = 12;
const BIN: usize = 1 << BIN_BITS;
/// How many harmonics are multiplied by their gains at a time.
const BLOCK: usize = 1 << 14;

/// The least tolerance that the rounding of these numbers leaves room for: about `450·ε` in `f64` and `80·ε` in `f32`, for
/// transforms of up to 2²⁰ values, whose rounding grows with the logarithm of their length and with the gains that undo the
/// window.
///
/// ```
/// use nyquist::engine::nonuniform::least_tolerance;
/// assert_eq!([least_tolerance::<f64>(), least_tolerance::<f32>()], [1e-13, 1e-5]);
/// ```
pub fn least_tolerance<T: Real>() -> f64 {
    if T::epsilon() < T::of(1e-10) { 1e-13 } else { 1e-5 }
}

impl<T: Real> Nufft<T> {
    /// A plan for harmonics up to `degree` of a period of `period` units, to a relative error of `tolerance`, as fast as
    /// this processor can.
    ///
    /// # Errors
    /// A degree beyond 2²⁵, a period of zero units or more than 2²⁶, or a tolerance that is not within
    /// [`least_tolerance`]` ..= 0.1`.
    pub fn new(degree: usize, period: usize, tolerance: f64) -> Result<Self> {
        Self::with(degree, period, tolerance, Butterflies::Fastest)
    }

    /// A plan of chosen butterflies.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn with(degree: usize, period: usize, tolerance: f64, butterflies: Butterflies) -> Result<Self> {
        within("the degree of a non-uniform transform", degree as f64, 0.0, MOST_DEGREE as f64)?;
        within("the units of a period", period as f64, 1.0, 2.0 * MOST_DEGREE as f64)?;
        // nanoseconds, measured: the transform, and the sums for as many points as there are modes
        let sums = |width: f64| 2.0 * degree as f64 * (4.0 + 1.8 * width);
        let cost = |[cells]: [f64; 1], width: f64| 0.25 * cells * cells.log2() + sums(width);
        let Shape { window, cells: [cells], allowed } = Shape::of([degree], checked::<T>(tolerance)?, 2, cost);
        Ok(Self {
            degree,
            ruler: Ruler::new(period, cells, window.width(), BIN_BITS),
            cells,
            taps: Taps::new(&window, allowed),
            gains: gains(&window, degree, cells),
            fft: RealFft::with(cells, butterflies)?,
            halves: Pool::new(),
            grids: Pool::new(),
            rooms: Pool::new(),
        })
    }

    /// The highest harmonic, `K`.
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// Points, for any number of transforms. Positions beyond the period are taken around it.
    ///
    /// # Errors
    /// Positions that are not finite.
    pub fn place<P: Position>(&self, points: &[P]) -> Result<Placed<1>> {
        let mut placed = Placed::none([self.ruler]);
        self.place_into(points, &mut placed)?;
        Ok(placed)
    }

    /// [`place`](Self::place) with memory that has been used before.
    ///
    /// # Errors
    /// As `place`, and then there are no points; memory of another transform's points.
    pub fn place_into<P: Position>(&self, points: &[P], placed: &mut Placed<1>) -> Result<()> {
        placed.on(&[self.ruler])?;
        placed.fill(points.as_chunks().0)
    }

    /// Type 1: `F_k = Σ_j w_j e^{−2πikx_j/period}`, `0 ≤ k ≤ K`; those of negative `k` are their conjugates.
    ///
    /// # Errors
    /// As many weights as there are not points; points placed for another transform.
    pub fn spectrum(&self, points: &Placed<1>, weights: &[T]) -> Result<Vec<Complex<T>>> {
        let mut spectrum = vec![Complex::default(); self.degree + 1];
        self.spectrum_into(points, weights, &mut spectrum)?;
        Ok(spectrum)
    }

    /// [`spectrum`](Self::spectrum) into memory that is there already.
    ///
    /// # Errors
    /// As `spectrum`; as much room as there are not harmonics.
    pub fn spectrum_into(&self, points: &Placed<1>, weights: &[T], spectrum: &mut [Complex<T>]) -> Result<()> {
        fits("the weights of points", points.on(&[self.ruler])?.len(), weights.len())?;
        fits("room for a spectrum", self.degree + 1, spectrum.len())?;
        lend(&self.grids, self.cells, |grid| {
            lend(&self.rooms, weights.len(), |sorted| {
                points.sort(weights, sorted);
                self.spread(points, sorted, grid);
            });
            self.halves.lend(self.cells / 2 + 1, |half| {
                self.fft.forward(grid, half)?;
                let half = &*half;
                parallel::chunks(spectrum, BLOCK, |block, out| {
                    let first = block * BLOCK;
                    let gained = half[first..].iter().zip(&self.gains[first..]);
                    out.iter_mut().zip(gained).for_each(|(out, (value, gain))| *out = value.scale(*gain));
                });
                Ok(())
            })
        })
    }

    /// Weights, sorted as their points are, over the grid. What reaches beyond a bin is kept beside it and added in one
    /// order: the bits do not depend on threads.
    fn spread(&self, points: &Placed<1>, sorted: &[T], grid: &mut [T]) {
        let width = self.taps.width();
        let mut beyond = vec![T::zero(); self.ruler.bins() * width];
        let mut bins: Vec<_> = grid.chunks_mut(BIN).zip(beyond.chunks_exact_mut(width)).collect();
        parallel::chunks(&mut bins, 1, |bin, pieces| {
            for (grid, beyond) in pieces {
                let mut cells = vec![T::zero(); grid.len() + width];
                vectorised(Spread { taps: &self.taps, points, bin, sorted, cells: &mut cells });
                grid.copy_from_slice(&cells[..grid.len()]);
                beyond.copy_from_slice(&cells[grid.len()..]);
            }
        });
        for (bin, beyond) in beyond.chunks_exact(width).enumerate() {
            let end = self.cells.min((bin + 1) * BIN);
            beyond.iter().enumerate().for_each(|(i, v)| grid[(end + i) % self.cells] += *v);
        }
    }

    /// Type 2: `f(x_j) = Σ_{|k| ≤ K} c_k e^{2πikx_j/period}` for `c_0, …, c_K`, with `c_{−k} = c̄_k`. The imaginary
    /// part of `c_0`, which no real signal has, is not looked at.
    ///
    /// # Errors
    /// As many coefficients as there are not harmonics; points placed for another transform.
    pub fn values(&self, modes: &[Complex<T>], points: &Placed<1>) -> Result<Vec<T>> {
        let mut values = vec![T::zero(); points.len()];
        self.values_into(modes, points, &mut values)?;
        Ok(values)
    }

    /// [`values`](Self::values) into memory that is there already.
    ///
    /// # Errors
    /// As `values`; as much room as there are not points.
    pub fn values_into(&self, modes: &[Complex<T>], points: &Placed<1>, values: &mut [T]) -> Result<()> {
        fits("the coefficients of harmonics", self.degree + 1, modes.len())?;
        self.values_of(points, values, T::one(), |half| {
            half.copy_from_slice(modes);
            Ok(())
        })
    }

    /// The values of the coefficients that `modes` writes, times a factor.
    pub(super) fn values_of(
        &self,
        points: &Placed<1>,
        values: &mut [T],
        factor: T,
        modes: impl FnOnce(&mut [Complex<T>]) -> Result<()>,
    ) -> Result<()> {
        fits("room for values", points.on(&[self.ruler])?.len(), values.len())?;
        lend(&self.grids, self.grid_len(), |grid| {
            self.grid_of(factor, modes, grid)?;
            self.read(grid, points, values);
            Ok(())
        })
    }

    /// The length of a [`grid`](Self::grid).
    fn grid_len(&self) -> usize {
        self.cells + self.taps.width()
    }

    /// The grid from which [`value`](Self::value) takes values: for whoever does not know the points beforehand.
    ///
    /// # Errors
    /// As many coefficients as there are not harmonics.
    pub fn grid(&self, modes: &[Complex<T>]) -> Result<Vec<T>> {
        fits("the coefficients of harmonics", self.degree + 1, modes.len())?;
        let mut grid = vec![T::zero(); self.grid_len()];
        self.grid_of(
            T::one(),
            |half| {
                half.copy_from_slice(modes);
                Ok(())
            },
            &mut grid,
        )?;
        Ok(grid)
    }

    fn grid_of(&self, factor: T, modes: impl FnOnce(&mut [Complex<T>]) -> Result<()>, grid: &mut [T]) -> Result<()> {
        let (cells, beyond) = grid.split_at_mut(self.cells);
        self.halves.lend(self.cells / 2 + 1, |half| {
            let (low, high) = half.split_at_mut(self.degree + 1);
            modes(low)?;
            parallel::chunks(low, BLOCK, |block, low| {
                let gains = self.gains[block * BLOCK..].iter();
                low.iter_mut().zip(gains).for_each(|(mode, gain)| *mode = mode.scale(*gain * factor));
            });
            high.fill(Complex::default());
            self.fft.inverse(half, cells)
        })?;
        beyond.copy_from_slice(&cells[..beyond.len()]);
        Ok(())
    }

    /// The value at one point from a [`grid`](Self::grid), to the bit what [`values`](Self::values) has there; not a number
    /// where the position is none.
    ///
    /// # Errors
    /// A grid of another plan.
    pub fn value(&self, grid: &[T], position: impl Position) -> Result<T> {
        fits("the grid of a transform", self.grid_len(), grid.len())?;
        let period = self.ruler.period();
        let inside = if position.is_inside(period) { Ok(position) } else { position.brought_inside(period) };
        let Ok(inside) = inside else { return Ok(T::nan()) };
        let (bin, code) = self.ruler.bin(inside.parts());
        let cells = &grid[bin as usize * BIN..];
        Ok(with_width!(self.taps.width(), W => gather(&self.taps.fixed::<W>(), cells, code)))
    }

    /// The values at many points from a [`grid`](Self::grid).
    ///
    /// # Errors
    /// A grid of another plan; points placed for one; as much room as there are not points.
    pub fn values_from(&self, grid: &[T], points: &Placed<1>, values: &mut [T]) -> Result<()> {
        fits("the grid of a transform", self.grid_len(), grid.len())?;
        fits("room for values", points.on(&[self.ruler])?.len(), values.len())?;
        self.read(grid, points, values);
        Ok(())
    }

    fn read(&self, grid: &[T], points: &Placed<1>, values: &mut [T]) {
        lend(&self.rooms, values.len(), |sorted| {
            points.each(sorted, values, |bin, values| {
                vectorised(Gather { taps: &self.taps, points, bin, cells: &grid[bin * BIN..], values });
            });
        });
    }
}

/// One bin's weights over its cells.
struct Spread<'a, T> {
    taps: &'a Taps<T>,
    points: &'a Placed<1>,
    bin: usize,
    sorted: &'a [T],
    cells: &'a mut [T],
}

impl<T: Real> Loop for Spread<'_, T> {
    #[inline(always)]
    fn run(self) {
        with_width!(self.taps.width(), W => {
            let taps = self.taps.fixed::<W>();
            for (codes, weights) in self.points.beside(self.bin, self.sorted) {
                for ([code], weight) in codes.iter().zip(weights) {
                    spread(&taps, self.cells, *code, *weight);
                }
            }
        });
    }
}

/// The values of one bin's points from its cells.
struct Gather<'a, T> {
    taps: &'a Taps<T>,
    points: &'a Placed<1>,
    bin: usize,
    cells: &'a [T],
    values: &'a mut [T],
}

impl<T: Real> Loop for Gather<'_, T> {
    #[inline(always)]
    fn run(self) {
        with_width!(self.taps.width(), W => {
            let taps = self.taps.fixed::<W>();
            let mut values = self.values;
            for codes in self.points.codes(self.bin) {
                let (here, rest) = values.split_at_mut(codes.len());
                for (value, [code]) in here.iter_mut().zip(codes) {
                    *value = gather(&taps, self.cells, *code);
                }
                values = rest;
            }
        });
    }
}

/// `f` with room for so many real numbers, whatever they are.
pub(super) fn lend<T: Real, R>(pool: &Pool<T>, len: usize, f: impl FnOnce(&mut [T]) -> R) -> R {
    pool.lend(len.div_ceil(2), |room| f(&mut bytemuck::cast_slice_mut(room)[..len]))
}

pub(super) fn checked<T: Real>(tolerance: f64) -> Result<f64> {
    within("the tolerance of a non-uniform transform", tolerance, least_tolerance::<T>(), 0.1)
}

pub(super) fn fits(what: &'static str, expected: usize, got: usize) -> Result<()> {
    if expected == got { Ok(()) } else { Err(Error::Length { what, expected, got }) }
}
