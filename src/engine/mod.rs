//! Engines: the textbook's operations for bulk data, in `f32` or `f64`, on as many threads as the current pool has.
//!
//! The face of the library calls them where it pays; they can be called directly, too.

pub mod fft;
pub mod film;
pub mod nonuniform;
pub mod real;
pub mod resize;
pub(crate) mod simd;

pub use simd::Arithmetic;
