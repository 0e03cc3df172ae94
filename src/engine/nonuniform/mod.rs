//! Fourier transforms between values at any points and harmonics, fast and to a stated error: for sums over 10⁶ points
//! and as many harmonics, which would take 10¹² products.
//!
//! Points are spread over a grid by a window of a few cells, or values gathered from it; a fast transform of the
//! grid does the rest, and the window's own spectrum is divided out. Everything is for real values, whose spectra are
//! Hermitian: half the grid, half the transforms, half the sums.
//!
//! | from | to | by |
//! | --- | --- | --- |
//! | weights at points | harmonics (type 1) | [`Nufft::spectrum`], [`PlaneNufft::spectrum`] |
//! | harmonics | values at points (type 2) | [`Nufft::values`], [`PlaneNufft::values`] |
//! | samples of a period | values between them | [`PeriodicInterpolator`] |
//!
//! The bits do not depend on the number of threads. With [`Butterflies::Scalar`](crate::engine::fft::Butterflies::Scalar)
//! nothing but the transcendental functions that plans are made of depends on the processor.

mod interpolator;
mod line;
mod local;
mod placed;
mod plane;
mod position;
mod shape;
mod taps;
mod window;

pub use interpolator::PeriodicInterpolator;
pub use line::{Nufft, least_tolerance};
pub use placed::Placed;
pub use plane::PlaneNufft;
pub use position::Position;
pub(crate) use taps::{PIECE_BITS, Taps};
pub(crate) use window::Window;
