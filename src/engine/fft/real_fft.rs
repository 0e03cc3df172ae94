//! Transforms of real numbers: the plain sums.

use crate::engine::fft::butterflies::Butterflies;
use crate::engine::fft::complex::{at_least_one, same};
use crate::engine::fft::core::Core;
use crate::engine::fft::halves::{Backwards, Extended, Folded, Halves, Unpacked, Zeroed, packed};
use crate::engine::fft::order::{InOrder, pieces};
use crate::engine::fft::roots::Turns;
use crate::engine::fft::standing::{Conjugated, fold, unfold};
use crate::engine::real::Real;
use crate::engine::simd::vectorised;
use crate::error::Result;
use num_complex::Complex;

/// A plan for `n` real numbers and the `n/2 + 1` frequencies that symmetry does not repeat, in either direction.
///
/// An even number of real values is transformed as half as many complex ones (Sorensen et al. 1987), an odd one as it is.
/// As [`Fft`](crate::engine::fft::Fft), a plan may be shared, keeps its memory, and uses all threads where it is large.
///
/// ```
/// use nyquist::engine::fft::RealFft;
/// let plan = RealFft::<f64>::new(5)?;
/// let values = [3.0, -1.0, 4.0, 1.0, -5.0];
/// let (mut half, mut back) = (vec![Default::default(); 3], [0.0; 5]);
/// plan.forward(&values, &mut half)?;
/// assert!((half[0].re - 2.0).abs() < 1e-15); // their sum
/// plan.inverse(&half, &mut back)?;
/// assert!(values.iter().zip(back).all(|(a, b)| (5.0 * a - b).abs() < 1e-14)); // not divided by n
/// # Ok::<(), nyquist::error::Error>(())
/// ```
#[derive(Debug)]
pub struct RealFft<T> {
    n: usize,
    way: Way<T>,
}

#[derive(Debug)]
enum Way<T> {
    /// An even number of them as half as many complex ones, put together by `−i·e^{−2πik/n}`.
    Even { core: Core<T>, roots: Turns<T> },
    /// An odd number of them as they are, and a way back if that is another one.
    Odd { core: Core<T>, back: Option<Core<T>> },
}

impl<T: Real> RealFft<T> {
    /// A plan as fast as this processor can.
    ///
    /// # Errors
    /// An `n` of zero.
    pub fn new(n: usize) -> Result<Self> {
        Self::with(n, Butterflies::Fastest)
    }

    /// A plan of chosen butterflies.
    ///
    /// # Errors
    /// An `n` of zero.
    pub fn with(n: usize, butterflies: Butterflies) -> Result<Self> {
        at_least_one(n)?;
        let half = n / 2;
        let way = if n.is_multiple_of(2) {
            let roots = Turns::roots_a_quarter_back(n, half.max(1));
            Way::Even { core: Core::new(half, half, butterflies), roots }
        } else {
            let core = Core::new(n, half + 1, butterflies);
            let back = (!core.keeps_all()).then(|| Core::new(n, n, butterflies));
            Way::Odd { core, back }
        };
        Ok(Self { n, way })
    }

    /// `X_k = Σ_j x_j e^{−2πijk/n}` for `0 ≤ k ≤ n/2`.
    ///
    /// # Errors
    /// An input of another length than `n`, an output of another one than `n/2 + 1`.
    pub fn forward(&self, input: &[T], output: &mut [Complex<T>]) -> Result<()> {
        self.forward_times(input, None, output)
    }

    /// The same times a factor each, which has a ½ in it for even `n`.
    pub(super) fn forward_times(
        &self,
        input: &[T],
        factors: Option<&Turns<T>>,
        output: &mut [Complex<T>],
    ) -> Result<()> {
        same(self.n, input.len())?;
        same(self.n / 2 + 1, output.len())?;
        match &self.way {
            Way::Even { core, roots } if core.is_whole() => {
                core.run_to(&packed(input), &mut output[..self.n / 2]);
                unfold(output, roots, factors);
            }
            Way::Even { core, roots } => core.run(&packed(input), |frequencies| {
                Halves { frequencies, roots, factors }.to(output);
            }),
            Way::Odd { core, .. } => core.run(&Zeroed(input), |frequencies| {
                pieces(output, |first, out| vectorised(InOrder { frequencies, first, shift: 0, factors, out }));
            }),
        }
        Ok(())
    }

    /// `x_j = Σ_k X_k e^{+2πijk/n}` over all `n` frequencies, not divided by `n`. The imaginary parts at zero and, for even
    /// `n`, at `n/2`, which no real signal has, are not looked at.
    ///
    /// # Errors
    /// An input of another length than `n/2 + 1`, an output of another one than `n`.
    pub fn inverse(&self, input: &[Complex<T>], output: &mut [T]) -> Result<()> {
        same(self.n / 2 + 1, input.len())?;
        same(self.n, output.len())?;
        match &self.way {
            Way::Even { core, roots } if core.is_whole() => {
                let pairs = bytemuck::cast_slice_mut(output);
                fold(input, roots, pairs);
                core.run_standing(pairs);
                vectorised(Conjugated(pairs));
            }
            Way::Even { core, roots } => core.run(&Folded { half: input, roots }, |frequencies| {
                pieces(output, |first, out| vectorised(Unpacked { frequencies, first, out }));
            }),
            Way::Odd { core, back } => {
                let core = back.as_ref().unwrap_or(core);
                core.run(&Extended { half: input, n: self.n }, |frequencies| {
                    pieces(output, |first, out| vectorised(Backwards { frequencies, first, out }));
                });
            }
        }
        Ok(())
    }
}
