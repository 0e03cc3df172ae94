//! Samples of a period at many points between them.

use crate::engine::fft::{Butterflies, RealFft};
use crate::engine::nonuniform::line::{MOST_DEGREE, Nufft, fits};
use crate::engine::nonuniform::placed::Placed;
use crate::engine::nonuniform::position::Position;
use crate::engine::real::Real;
use crate::error::{Result, within};
use num_complex::Complex;

/// The band-limited signal of a period through `n` equally spaced samples, at any points, in `O(n log n + m log 1/ε)`:
/// for records of one length, each at many points.
///
/// `f(x) = Σ_{|k| ≤ n/2} (X_k/n) e^{2πikx/n}` with `X = DFT(samples)` and positions counted in samples; for even `n`
/// the harmonic `n/2` is the cosine that its samples determine. It is the sum of `Dirichlet` kernels over the samples,
/// `Σ f_i D(x − i)`, what [`Edge::Wrap`](crate::axis::Edge::Wrap) makes of the ideal kernel, and costs `O(n·m)` there.
///
/// The steps: a real transform of the samples; their spectrum, divided by the window's; a real transform onto a finer
/// grid; sums over windows, of points that were sorted. Errors and bits are those of [`Nufft`]: `|f̃ − f| ≤
/// ε·Σ|X_k|/n`.
///
/// ```
/// use nyquist::engine::nonuniform::PeriodicInterpolator;
/// // a cosine of period 5 through 5 samples, at 2.3 samples, and 10⁶ periods later without a loss
/// let samples: Vec<f64> = (0..5u32).map(|i| nyquist::num::cos_pi(0.4 * f64::from(i))).collect();
/// let between = PeriodicInterpolator::new(5, 1e-12)?;
/// let values = between.values(&samples, &between.place(&[(2, 0.3), (5_000_002, 0.3)])?)?;
/// assert!((values[0] - nyquist::num::cos_pi(0.4 * 2.3)).abs() < 1e-12 && values[0] == values[1]);
/// # Ok::<(), nyquist::error::Error>(())
/// ```
#[derive(Debug)]
pub struct PeriodicInterpolator<T> {
    len: usize,
    fft: RealFft<T>,
    nufft: Nufft<T>,
}

impl<T: Real> PeriodicInterpolator<T> {
    /// A plan for records of `len` samples, to a relative error of `tolerance`, as fast as this processor can.
    ///
    /// # Errors
    /// No samples, or more than 2²⁶; a tolerance that is not within
    /// [`least_tolerance`](crate::engine::nonuniform::least_tolerance)` ..= 0.1`.
    pub fn new(len: usize, tolerance: f64) -> Result<Self> {
        Self::with(len, tolerance, Butterflies::Fastest)
    }

    /// A plan of chosen butterflies.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn with(len: usize, tolerance: f64, butterflies: Butterflies) -> Result<Self> {
        within("the samples of a period", len as f64, 1.0, 2.0 * MOST_DEGREE as f64)?;
        let nufft = Nufft::with(len / 2, len, tolerance, butterflies)?;
        Ok(Self { len, fft: RealFft::with(len, butterflies)?, nufft })
    }

    /// Points, counted in samples from the first one, for any number of records.
    ///
    /// # Errors
    /// Positions that are not finite.
    pub fn place<P: Position>(&self, positions: &[P]) -> Result<Placed<1>> {
        self.nufft.place(positions)
    }

    /// [`place`](Self::place) with memory that has been used before.
    ///
    /// # Errors
    /// As `place`, and then there are no points; memory of another transform's points.
    pub fn place_into<P: Position>(&self, positions: &[P], placed: &mut Placed<1>) -> Result<()> {
        self.nufft.place_into(positions, placed)
    }

    /// The values at the points.
    ///
    /// # Errors
    /// Another number of samples; points placed for another transform.
    pub fn values(&self, samples: &[T], points: &Placed<1>) -> Result<Vec<T>> {
        let mut values = vec![T::zero(); points.len()];
        self.values_into(samples, points, &mut values)?;
        Ok(values)
    }

    /// [`values`](Self::values) into memory that is there already.
    ///
    /// # Errors
    /// As `values`; as much room as there are not points.
    pub fn values_into(&self, samples: &[T], points: &Placed<1>, values: &mut [T]) -> Result<()> {
        fits("samples of a period", self.len, samples.len())?;
        self.nufft.values_of(points, values, T::of(1.0 / self.len as f64), |half| {
            self.fft.forward(samples, half)?;
            if self.len.is_multiple_of(2) {
                // half of the cosine that its samples determine
                let last = &mut half[self.len / 2];
                *last = Complex::new(last.re * T::of(0.5), T::zero());
            }
            Ok(())
        })
    }
}
