//! Engines: the textbook's operations for bulk data, in `f32` or `f64`, on as many threads as the current pool has.
//!
//! The face of the library calls them where it pays; they can be called directly, too.

pub mod fft;
pub mod nonuniform;
pub mod real;
mod simd;
