//! Transforms of images in physical units.

use crate::axis::Axis;
use crate::engine::fft::butterflies::{Butterflies, Short};
use crate::engine::fft::columns::{Pairs, Same, Tile, block, gather_row, transform_columns};
use crate::engine::fft::complex::same;
use crate::engine::fft::physical::phase;
use crate::engine::fft::plane_rows::{Apart, HermitianPart, ImageRows, Power, Spectrum, together};
use crate::engine::fft::pool::Pool;
use crate::engine::fft::roots::{Turns, rounded};
use crate::engine::fft::vectors::Abreast;
use crate::engine::real::Real;
use crate::engine::simd::vectorised;
use crate::error::Result;
use crate::grid::Grid;
use crate::parallel;
use num_complex::Complex;

/// How many rows share their work space.
const TOGETHER: usize = 8;

/// A plan for images on one grid: their spectra and power spectra, and the way back.
///
/// The conventions are those of [`image::dft::forward`](crate::image::dft::forward): samples of the continuous transform
/// at the frequencies of the dual grid, rising along both axes, zero at column `width/2` and row `height/2`; images and
/// spectra row after row.
///
/// First the columns, two real ones as one complex, in blocks that fit into a cache (side by side where they stand, if
/// the image is a multiple of 32 wide and its height has no prime factors but 2, 3, 5 and 7); then the rows, up to half
/// the height, each of which is written twice: symmetry has the rest. The complex half plane between the two passes is
/// written once and read once, the result is written from front to back, and a power spectrum never exists as complex
/// numbers. Any size, `O(n log n)`; memory beside the image and the result: `8·n` bytes in `f64`, `4·n` in `f32`, kept
/// for the next image, and a kilobyte for each row and thread. The bits do not depend on the number of threads.
///
/// ```
/// use nyquist::engine::fft::PlaneFft;
/// use nyquist::prelude::*;
/// // a Gaussian, not in the middle of its picture, against its spectrum in closed form
/// let spot = Moved::new([1.5, -0.5], GaussianSpot::turned([1.0, 2.0], 0.6)?)?;
/// let image = Image::of(&spot, Grid::cells(-14.0..14.0, 100, -14.0..12.0, 91)?);
/// let mut power = vec![0.0; image.grid().len()];
/// PlaneFft::new(image.grid()).power(image.values(), &mut power)?;
/// let (spectrum, area) = (spot.spectrum(), image.grid().area());
/// let exact = |[u, v]: [f64; 2]| spectrum.density(u, v).norm_sqr() / area;
/// assert!(image.grid().dual().iter().zip(&power).all(|(nu, p)| (p - exact(nu)).abs() < 1e-14));
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug)]
pub struct PlaneFft<T> {
    grid: Grid,
    across: Short<T>,
    down: Short<T>,
    /// The columns of images on the way there, if they are transformed side by side.
    abreast: Option<Abreast<T>>,
    /// `Δx·e^{−2πiu_k·start}` at the frequencies of the dual axis.
    turns: Turns<T>,
    tiles: Pool<T>,
    rooms: Pool<T>,
}

impl<T: Real> PlaneFft<T> {
    /// A plan for images on `grid`, as fast as this processor can.
    pub fn new(grid: Grid) -> Self {
        Self::with(grid, Butterflies::Fastest)
    }

    /// A plan of chosen butterflies.
    pub fn with(grid: Grid, butterflies: Butterflies) -> Self {
        let (nx, x) = (grid.width(), grid.x());
        let (across, down) = (Short::new(nx, butterflies), Short::new(grid.height(), butterflies));
        let turns = Turns::new(nx, phase(-((nx / 2) as i64), x) * x.step(), |k| phase(k as i64, x));
        let abreast = match butterflies {
            Butterflies::Scalar => None,
            Butterflies::Fastest => Abreast::new(nx, grid.height()),
        };
        Self { grid, across, down, abreast, turns, tiles: Pool::new(), rooms: Pool::new() }
    }

    /// The power spectrum `|F|²/area`, whose sum times the area of a bin is the mean square of the image (Parseval).
    ///
    /// # Errors
    /// A number of pixels, or of values to be written, other than the grid has positions.
    pub fn power(&self, image: &[T], out: &mut [T]) -> Result<()> {
        same(self.grid.len(), image.len())?;
        same(self.grid.len(), out.len())?;
        // the rows are twice the spectrum
        let scale = T::of(0.25 * self.grid.pixel_area() * self.grid.pixel_area() / self.grid.area());
        self.rows_of_spectrum(image, out, |_, row, here, there| vectorised(Power { row, scale, here, there }));
        Ok(())
    }

    /// `F(u_k, v_l) = ΔxΔy Σ f(x_i, y_j) e^{−2πi(u_k x_i + v_l y_j)}`.
    ///
    /// # Errors
    /// As [`power`](Self::power).
    pub fn forward(&self, image: &[T], out: &mut [Complex<T>]) -> Result<()> {
        same(self.grid.len(), image.len())?;
        same(self.grid.len(), out.len())?;
        let y = self.grid.y();
        let half = |l: i64| rounded(phase(l, y) * (0.5 * y.step()));
        // −ny/2 stands first, ny/2 nowhere
        let signed = |l: usize| if 2 * l == y.len() { -(l as i64) } else { l as i64 };
        self.rows_of_spectrum(image, out, |l, row, here, there| {
            vectorised(Spectrum {
                row,
                turns: &self.turns,
                here: here.map(|out| (out, half(signed(l)))),
                there: there.map(|out| (out, half(-(l as i64)))),
            });
        });
        Ok(())
    }

    /// `f(x_i, y_j) = (1/area) Σ F(u_k, v_l) e^{2πi(u_k x_i + v_l y_j)}`, real part: the image back from its spectrum. Of
    /// numbers that are not the spectrum of a real image only the Hermitian part counts.
    ///
    /// # Errors
    /// As [`power`](Self::power).
    pub fn inverse(&self, bins: &[Complex<T>], out: &mut [T]) -> Result<()> {
        let (nx, ny) = (self.grid.width(), self.grid.height());
        same(nx * ny, bins.len())?;
        same(nx * ny, out.len())?;
        // F̄·e^{−2πi…}: the conjugate of what stands in the sum
        let turns = |axis: Axis, gain: f64| {
            let half = (axis.len() / 2) as i64;
            (0..axis.len() as i64).map(|k| rounded(phase(k - half, axis) * gain)).collect::<Vec<Complex<T>>>()
        };
        let (across, down) = (turns(self.grid.x(), 0.5), turns(self.grid.y(), 1.0 / self.grid.area()));
        let rows = HermitianPart { bins, across: &across, down: &down };
        let kept = nx / 2 + 1;
        self.tiles.lend(kept * ny, |tiles| {
            transform_columns::<T, Same>(&self.down, kept, &rows, tiles, &self.rooms);
            let tiles = &*tiles;
            parallel::chunks(out, TOGETHER * nx, |chunk, rows| {
                // from a line of the cache on, too
                let padded = (2 * kept).next_multiple_of(8);
                self.rooms.lend(padded + nx + self.across.room(), |work| {
                    let (halves, work) = work.split_at_mut(padded);
                    let (first, second) = halves[..2 * kept].split_at_mut(kept);
                    let (both, room) = work.split_at_mut(nx);
                    for (i, pair) in rows.chunks_mut(2 * nx).enumerate() {
                        let j = chunk * TOGETHER + 2 * i;
                        gather_row(tiles, ny, block::<T>(), j, first);
                        // the last of an odd number of rows is alone
                        gather_row(tiles, ny, block::<T>(), (j + 1).min(ny - 1), second);
                        together(first, second, both);
                        self.across.run(both, room);
                        vectorised(Apart { both, pair });
                    }
                });
            });
        });
        Ok(())
    }

    /// Twice the plain spectrum of a real image row by row: `f` of the number of each row up to half the height, its
    /// frequencies in plain order, and the rows of `out` for it and for its opposite, where there are such.
    fn rows_of_spectrum<O: Send>(
        &self,
        image: &[T],
        out: &mut [O],
        f: impl Fn(usize, &[Complex<T>], Option<&mut [O]>, Option<&mut [O]>) + Sync + Send,
    ) {
        let (nx, ny) = (self.grid.width(), self.grid.height());
        let kept = <Pairs as Tile<T>>::kept(ny);
        let (negative, positive) = out.split_at_mut(ny / 2 * nx);
        let here = positive.chunks_exact_mut(nx).map(Some).chain(std::iter::repeat_with(|| None));
        let there = std::iter::once(None).chain(negative.rchunks_exact_mut(nx).map(Some));
        let there = there.chain(std::iter::repeat_with(|| None));
        let mut rows: Vec<_> = here.zip(there).take(kept).collect();
        self.tiles.lend(kept * nx, |tiles| {
            match &self.abreast {
                Some(columns) => columns.transform(image, tiles, &self.rooms),
                None => {
                    let rows = ImageRows { image, width: nx };
                    transform_columns::<T, Pairs>(&self.down, nx, &rows, tiles, &self.rooms);
                }
            }
            let tiles = &*tiles;
            parallel::chunks(&mut rows, TOGETHER, |chunk, rows| {
                self.rooms.lend(nx + self.across.room(), |work| {
                    let (row, room) = work.split_at_mut(nx);
                    for (i, (here, there)) in rows.iter_mut().enumerate() {
                        let l = TOGETHER * chunk + i;
                        match &self.abreast {
                            Some(columns) => columns.row(tiles, l, row),
                            None => gather_row(tiles, kept, 2 * block::<T>(), l, row),
                        }
                        self.across.run(row, room);
                        f(l, row, here.as_deref_mut(), there.as_deref_mut());
                    }
                });
            });
        });
    }
}
