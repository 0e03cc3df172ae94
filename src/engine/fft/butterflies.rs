//! Transforms that fit into a cache: the only place that knows rustfft.

use crate::engine::real::Real;
use num_complex::Complex;
use rustfft::{Fft, FftPlanner, FftPlannerScalar};
use std::fmt;
use std::sync::Arc;

/// Which butterflies a plan is built of.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Butterflies {
    /// Plain arithmetic: the same bits on every processor.
    Scalar,
    /// Whatever is fastest on this processor (AVX, SSE, NEON); the last bits depend on which that is.
    #[default]
    Fastest,
}

/// The plain sum of one length, in place. (The inverse is the conjugate of the forward sum of conjugates, which costs
/// nothing where numbers are read and written anyway.)
pub(super) struct Short<T>(Arc<dyn Fft<T>>);

impl<T: Real> Short<T> {
    /// `X_k = Σ_j x_j e^{−2πijk/n}`.
    pub(super) fn new(n: usize, butterflies: Butterflies) -> Self {
        Self(match butterflies {
            Butterflies::Scalar => FftPlannerScalar::new().plan_fft_forward(n),
            Butterflies::Fastest => FftPlanner::new().plan_fft_forward(n),
        })
    }

    /// How many numbers.
    pub(super) fn len(&self) -> usize {
        self.0.len()
    }

    /// How much room [`run`](Self::run) needs.
    pub(super) fn room(&self) -> usize {
        self.0.get_inplace_scratch_len()
    }

    /// The transform; what is left in `room` may be anything.
    pub(super) fn run(&self, values: &mut [Complex<T>], room: &mut [Complex<T>]) {
        self.0.process_with_scratch(values, room);
    }

    /// How much room [`run_beside`](Self::run_beside) needs.
    pub(super) fn room_beside(&self) -> usize {
        self.0.get_immutable_scratch_len()
    }

    /// The transform of what another place has.
    pub(super) fn run_beside(&self, values: &[Complex<T>], out: &mut [Complex<T>], room: &mut [Complex<T>]) {
        self.0.process_immutable_with_scratch(values, out, room);
    }
}

impl<T> fmt::Debug for Short<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Short({})", self.0.len())
    }
}
