//! Discrete signals and their spectra: [`Samples`], [`Bins`], and the discrete Fourier transform in physical units.

mod bins;
mod samples;

pub use bins::Bins;
pub use samples::Samples;
