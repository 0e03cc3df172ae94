//! Transforms in physical units.

use crate::axis::Axis;
use crate::engine::fft::butterflies::Butterflies;
use crate::engine::fft::complex::same;
use crate::engine::fft::core::Core;
use crate::engine::fft::order::{InOrder, pieces};
use crate::engine::fft::pool::Pool;
use crate::engine::fft::real_fft::RealFft;
use crate::engine::fft::roots::Turns;
use crate::engine::fft::rows::{Line, Numbers, Source, WIDTH};
use crate::engine::fft::standing::centre;
use crate::engine::fft::vectors::{InTurn, InTurnTo, Number, Output, Passes};
use crate::engine::real::Real;
use crate::engine::simd::{Simd, vectorised};
use crate::error::Result;
use crate::num::{cos_pi, sin_pi};
use num_complex::Complex;

/// A plan for complex samples on one axis, and for samples of their spectrum.
///
/// The conventions are those of [`sampled::dft::forward`](crate::sampled::dft::forward): frequencies of the dual axis,
/// rising, zero at index `n/2`; the step and the phase of the start are part of the transform, not a pass after it.
///
/// ```
/// use nyquist::engine::fft::PhysicalFft;
/// use nyquist::prelude::*;
/// use num_complex::Complex;
/// // a Gaussian far from zero: its phase is as right as its size
/// let f = Shifted::new(1.0e6 + 0.25, Gaussian::new(1.0)?)?;
/// let axis = Axis::nodes(1.0e6 - 7.0..1.0e6 + 7.0, 98)?;
/// let values: Vec<Complex<f64>> = axis.iter().map(|x| f.at(x).into()).collect();
/// let mut bins = values.clone();
/// PhysicalFft::new(axis).forward(&values, &mut bins)?;
/// let size = |nu: f64| Gaussian::new(1.0).map(|f| f.spectrum().density(nu).norm());
/// assert!(axis.dual().iter().zip(&bins).all(|(nu, z)| (z.norm() - size(nu).unwrap_or(0.0)).abs() < 1e-9));
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug)]
pub struct PhysicalFft<T> {
    core: Core<T>,
    /// The way there with units and phases in its own factors, if it is done in passes.
    passes: Option<Passes<T>>,
    rooms: Pool<T>,
    /// `T·e^{−2πiν_p·start}` at the frequencies of the dual axis.
    there: Turns<T>,
    /// `e^{−2πiν_p·start}/span`.
    back: Turns<T>,
}

impl<T: Real> PhysicalFft<T> {
    /// A plan as fast as this processor can.
    pub fn new(axis: Axis) -> Self {
        Self::with(axis, Butterflies::Fastest)
    }

    /// A plan of chosen butterflies.
    pub fn with(axis: Axis, butterflies: Butterflies) -> Self {
        let n = axis.len();
        let centred = |gain| Turns::new(n, phase(-((n / 2) as i64), axis) * gain, |k| phase(k as i64, axis));
        let (there, back) = (centred(axis.step()), centred(1.0 / axis.span()));
        let core = Core::new(n, n, butterflies);
        let passes = if core.has_passes() { Passes::with(n, axis.step(), |k| phase(k, axis)) } else { None };
        Self { core, passes, rooms: Pool::new(), there, back }
    }

    /// `F(ν_k) = T Σ_j f(x_j) e^{−2πiν_k x_j}`, rising from `−n/2`.
    ///
    /// # Errors
    /// Slices of another length than the axis.
    pub fn forward(&self, input: &[Complex<T>], output: &mut [Complex<T>]) -> Result<()> {
        let n = self.core.len();
        same(n, input.len())?;
        same(n, output.len())?;
        if let Some(passes) = &self.passes {
            self.rooms.lend(passes.room(), |room| passes.run(InTurn(input), Centred(output), room));
            return Ok(());
        }
        if n.is_multiple_of(2) && self.core.is_whole() {
            self.core.run_to(&Numbers(input), output);
            centre(output, &self.there);
            return Ok(());
        }
        let (shift, factors) = (n / 2, Some(&self.there));
        self.core.run(&Numbers(input), |frequencies| {
            pieces(output, |first, out| vectorised(InOrder { frequencies, first, shift, factors, out }));
        });
        Ok(())
    }

    /// `f(x_j) = (1/span) Σ_k F(ν_k) e^{2πiν_k x_j}`.
    ///
    /// # Errors
    /// Slices of another length than the axis.
    pub fn inverse(&self, input: &[Complex<T>], output: &mut [Complex<T>]) -> Result<()> {
        same(self.core.len(), input.len())?;
        same(self.core.len(), output.len())?;
        self.core.run_to(&Plain { bins: input, factors: &self.back }, output);
        output.iter_mut().for_each(|z| *z = z.conj());
        Ok(())
    }
}

/// Places of an even number of bins in rising order.
struct Centred<'a, T>(&'a mut [Complex<T>]);

impl<T: Real> Output<T> for Centred<'_, T> {
    #[inline(always)]
    fn write<S: Simd>(&mut self, simd: S, at: usize, z: Number<T, S>) {
        let middle = self.0.len() / 2;
        InTurnTo(self.0).write(simd, if at < middle { at + middle } else { at - middle }, z);
    }
}

/// Conjugated bins in the plain order, times their factors.
struct Plain<'a, T> {
    bins: &'a [Complex<T>],
    factors: &'a Turns<T>,
}

impl<T: Real> Source<T> for Plain<'_, T> {
    #[inline(always)]
    fn read(&self, at: usize, count: usize, line: &mut Line<T>) {
        let (n, shift) = (self.bins.len(), self.bins.len() / 2);
        let from = if at + shift < n { at + shift } else { at + shift - n };
        if from + count <= n {
            line.read(&self.bins[from..from + count]);
            line.conjugate();
            line.times(&self.factors.line(from));
        } else {
            for i in 0..count.min(WIDTH) {
                let k = if from + i < n { from + i } else { from + i - n };
                let value = self.bins[k].conj() * self.factors.at(k);
                (line.re[i], line.im[i]) = (value.re, value.im);
            }
        }
    }
}

/// A plan for real samples on one axis, and the half of their spectrum that symmetry does not repeat: the frequencies
/// `k/span` for `0 ≤ k ≤ n/2`.
///
/// ```
/// use nyquist::engine::fft::PhysicalRealFft;
/// use nyquist::prelude::*;
/// // a Gaussian that is not centred, on a record that does not start at zero
/// let f = Shifted::new(3.0, Gaussian::new(1.0)?)?;
/// let samples = Samples::of(&f, Axis::nodes(-4.0..10.0, 91)?);
/// let mut half = vec![Default::default(); 46];
/// PhysicalRealFft::new(samples.axis()).forward(samples.values(), &mut half)?;
/// let errors = (0..46).map(|k| (half[k] - f.spectrum().density(k as f64 / 14.0)).norm());
/// assert!(errors.fold(0.0, f64::max) < 1e-14);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug)]
pub struct PhysicalRealFft<T> {
    fft: RealFft<T>,
    /// `T·e^{−2πiν_k·start}`, half of it where two spectra are added.
    there: Turns<T>,
}

impl<T: Real> PhysicalRealFft<T> {
    /// A plan as fast as this processor can.
    pub fn new(axis: Axis) -> Self {
        Self::with(axis, Butterflies::Fastest)
    }

    /// A plan of chosen butterflies.
    pub fn with(axis: Axis, butterflies: Butterflies) -> Self {
        let n = axis.len();
        // where two spectra are added the sum is twice the mean
        let gain = if n.is_multiple_of(2) { 0.5 * axis.step() } else { axis.step() };
        let there = Turns::new(n / 2 + 1, gain.into(), |k| phase(k as i64, axis));
        Self { fft: RealFft::with(n, butterflies).expect("an axis has at least one position"), there }
    }

    /// `F(ν_k) = T Σ_j f(x_j) e^{−2πiν_k x_j}` for `0 ≤ k ≤ n/2`.
    ///
    /// # Errors
    /// An input of another length than the axis has, an output of another one than `n/2 + 1`.
    pub fn forward(&self, input: &[T], output: &mut [Complex<T>]) -> Result<()> {
        self.fft.forward_times(input, Some(&self.there), output)
    }
}

/// `e^{−2πiν_k·start}`, `ν_k = k/span`, right to a few roundings however far from zero the record starts: the turns
/// `k·start/(n·step)` are computed with twice the precision (Dekker 1971), and whole ones are dropped before they are
/// multiplied by π.
pub(crate) fn phase(k: i64, axis: Axis) -> Complex<f64> {
    let (k, n) = (k as f64, axis.len() as f64);
    let steps = axis.start() / axis.step();
    let rest = (-steps).mul_add(axis.step(), axis.start()) / axis.step();
    let product = k * steps;
    let missed = k.mul_add(steps, -product) + k * rest;
    let turns = 2.0 * ((product % n + missed) / n);
    Complex::new(cos_pi(turns), -sin_pi(turns))
}
