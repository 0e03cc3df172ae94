//! Transforms that fit into a cache: our own where they are faster, and the only place that knows rustfft.

use crate::engine::fft::vectors::{InTurn, InTurnTo, Passes};
use crate::engine::real::Real;
use crate::engine::simd::widest;
use num_complex::Complex;
use rustfft::{Fft, FftPlanner, FftPlannerScalar};
use std::fmt;
use std::sync::Arc;

/// Which butterflies a plan is built of.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Butterflies {
    /// Plain arithmetic: the same bits on every processor.
    Scalar,
    /// Whatever is fastest on this processor (AVX-512, AVX, SSE, NEON); the last bits depend on which that is.
    #[default]
    Fastest,
}

/// The plain sum of one length, in place. (The inverse is the conjugate of the forward sum of conjugates, which costs
/// nothing where numbers are read and written anyway.)
pub(super) enum Short<T> {
    /// As rustfft plans it.
    Planned(Arc<dyn Fft<T>>),
    /// In passes of vectors.
    Passes(Box<Passes<T>>),
}

impl<T: Real> Short<T> {
    /// `X_k = Σ_j x_j e^{−2πijk/n}`.
    pub(super) fn new(n: usize, butterflies: Butterflies) -> Self {
        match butterflies {
            Butterflies::Scalar => Self::Planned(FftPlannerScalar::new().plan_fft_forward(n)),
            // rustfft has no AVX-512, and is faster with what it has
            Butterflies::Fastest if widest() < 64 => Self::Planned(FftPlanner::new().plan_fft_forward(n)),
            Butterflies::Fastest => match Passes::new(n) {
                Some(passes) => Self::Passes(Box::new(passes)),
                None => Self::Planned(FftPlanner::new().plan_fft_forward(n)),
            },
        }
    }

    /// How many numbers.
    pub(super) fn len(&self) -> usize {
        match self {
            Self::Planned(fft) => fft.len(),
            Self::Passes(passes) => passes.len(),
        }
    }

    /// How much room [`run`](Self::run) needs.
    pub(super) fn room(&self) -> usize {
        match self {
            Self::Planned(fft) => fft.get_inplace_scratch_len(),
            Self::Passes(passes) => passes.room(),
        }
    }

    /// The transform; what is left in `room` may be anything.
    pub(super) fn run(&self, values: &mut [Complex<T>], room: &mut [Complex<T>]) {
        match self {
            Self::Planned(fft) => fft.process_with_scratch(values, room),
            Self::Passes(passes) => {
                passes.begin(InTurn(values), room);
                passes.end(InTurnTo(values), room);
            }
        }
    }

    /// How much room [`run_beside`](Self::run_beside) needs.
    pub(super) fn room_beside(&self) -> usize {
        match self {
            Self::Planned(fft) => fft.get_immutable_scratch_len(),
            Self::Passes(passes) => passes.room(),
        }
    }

    /// The transform of what another place has.
    pub(super) fn run_beside(&self, values: &[Complex<T>], out: &mut [Complex<T>], room: &mut [Complex<T>]) {
        match self {
            Self::Planned(fft) => fft.process_immutable_with_scratch(values, out, room),
            Self::Passes(passes) => passes.run(InTurn(values), InTurnTo(out), room),
        }
    }
}

impl<T> fmt::Debug for Short<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(if matches!(self, Self::Planned(_)) { "Planned" } else { "Passes" })
    }
}
