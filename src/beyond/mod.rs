//! Beyond uniform samples of a low band: what else determines a signal, and at what price.

pub mod bandpass;
pub mod derivative;
pub mod interlaced;
pub mod irregular;
pub mod jitter;
pub mod refined;
mod staircase;
mod toeplitz;
pub mod weighted;

pub use bandpass::BandPass;
pub use derivative::DerivativeSamples;
pub use interlaced::Interlaced;
pub use irregular::{Irregular, Recovery};
pub use jitter::{Jitter, JitteredComb};
pub use refined::{Refined, Refinement};
pub use weighted::Weighted;
