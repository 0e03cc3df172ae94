//! Discrete signals and their spectra: [`Samples`], [`Bins`], and the discrete Fourier transform in physical units.

mod bins;
pub mod convolution;
pub mod dft;
pub mod dtft;
pub mod harmonics;
pub mod nonuniform;
pub mod occupied;
pub mod power;
mod samples;
pub mod segments;
pub mod spectrogram;
pub mod welch;
pub mod window;

pub use bins::Bins;
pub use samples::Samples;
