//! Sampling and reconstruction.

pub mod axis;
pub mod beyond;
pub mod comb;
pub mod error;
pub mod figure;
pub mod kernel;
pub mod laws;
pub mod num;
pub mod nyquist;
#[cfg(feature = "plot")]
pub mod plot;
pub mod reconstruct;
pub mod residual;
pub mod resolve;
pub mod sampled;
pub mod signal;
pub mod spectrum;
pub mod text;

/// What users, notebooks and exercises import; nothing inside the library does.
pub mod prelude {
    pub use crate::axis::{Axis, Edge, Unit};
    pub use crate::error::{Error, Result};
    pub use crate::kernel::{Claims, Kernel};
    pub use crate::nyquist::{Alias, Verdict, fold, nyquist_frequency, nyquist_rate};
    pub use crate::residual::Residual;
    pub use crate::sampled::{Bins, Samples};
    pub use crate::signal::{Differentiable, FourierPair, Signal, from_fn};
    pub use crate::spectrum::{Impulse, Spectrum};
    pub use crate::text::{Lang, Text};
}
