//! The Fourier engine: transforms of any length in `f32` and `f64`, planned once and used by any number of threads.
//!
//! | plan | transforms |
//! | --- | --- |
//! | [`Fft`] | complex numbers, the plain sum `X_k = Σ_j x_j e^{−2πijk/n}` and the one with the positive exponent |
//! | [`RealFft`] | `n` real numbers to the `n/2 + 1` frequencies that symmetry does not repeat, and back |
//! | [`PhysicalFft`], [`PhysicalRealFft`] | samples on an [`Axis`](crate::axis::Axis) to samples of `F(ν)`: step, phase of the start, rising frequencies |
//! | [`PlaneFft`] | images on a [`Grid`](crate::grid::Grid) to spectra and power spectra, and back |
//!
//! The butterflies of [`Butterflies::Scalar`] are rustfft's, in pieces that fit into a cache. Of
//! [`Butterflies::Fastest`] two kinds are our own, between whose passes numbers stay apart into real and imaginary parts:
//! where processors have vectors of 512 bits, those for multiples of 256 above it that have no prime factors but 2, 3, 5 and
//! 7; and everywhere those for columns of images 32·`k` wide and as smooth in height. The others are rustfft's. Around them:
//!
//! - what units, phases and order need is part of the factors of our own passes on the way to centred frequencies; elsewhere
//!   it is done, as what symmetry needs is, in the one pass over the result that putting it in order needs anyway; the phases are products of two from short
//!   tables, not a sine and a cosine for each;
//! - from 2¹⁷ complex numbers on a length that is a multiple of 16 is cut into sixteen rows (Gentleman & Sande 1966), so
//!   that all threads work on one transform;
//! - a large length with a large prime factor becomes a convolution with a chirp (Bluestein 1970) whose spectrum stays in
//!   the order in which it comes; of real numbers only `1.5n` instead of `2n` numbers of it are needed.
//!
//! What is cut depends on the length alone: the bits do not depend on the number of threads. With
//! [`Butterflies::Scalar`] they do not depend on the processor either; [`Butterflies::Fastest`] differs from it by
//! rounding.
//!
//! # Errors of rounding
//!
//! The root of the mean squared error, relative to the root of the mean square of the result, is at most `8ε·log₂n`
//! (Higham 2002, theorem 24.2: `log₂n` levels, each with twiddle factors right to a few `ε` and a few roundings), whatever
//! the way; of a convolution with a chirp at most `8ε·3·log₂(4n)`, since three transforms of up to `4n` numbers follow on
//! one another. Measured, it is about `0.3ε·√log₂n`.
//!
//! ```
//! use nyquist::engine::fft::RealFft;
//! let plan = RealFft::<f32>::new(8)?;
//! let wave: Vec<f32> = (0..8).map(|j| (std::f32::consts::PI * j as f32 / 2.0).cos()).collect();
//! let mut half = vec![Default::default(); 5];
//! plan.forward(&wave, &mut half)?;
//! assert!((half[2].re - 4.0).abs() < 1e-5); // two periods in eight samples
//! # Ok::<(), nyquist::error::Error>(())
//! ```

mod block;
mod butterflies;
mod chirp;
mod columns;
mod complex;
mod core;
mod halves;
mod length;
mod order;
mod physical;
mod plane;
mod plane_rows;
mod pool;
mod radix;
mod real_fft;
mod roots;
mod rows;
mod standing;
mod streams;
mod vectors;

pub use butterflies::Butterflies;
pub use complex::Fft;
pub(in crate::engine) use length::fast_multiple;
pub use length::{fast_length, long_length};
pub(crate) use physical::phase;
pub use physical::{PhysicalFft, PhysicalRealFft};
pub use plane::PlaneFft;
pub(crate) use pool::Pool;
pub use real_fft::RealFft;
