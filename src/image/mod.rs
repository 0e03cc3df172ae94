//! Discrete images and their spectra: [`Image`] and [`ImageBins`], the transform between them, and what is done to
//! images: filtering, convolution, decimation, resizing.
//!
//! Images are linear light. Bytes of files are not: they are converted at the door.

mod bins;
pub mod convolution;
pub mod decimate;
pub mod dft;
pub mod filter;
pub mod lattice;
pub mod periodic;
pub mod projection;
pub mod radial;
mod raster;
pub mod resize;
pub mod resizing;
mod rgb;
pub mod weights;

pub use bins::ImageBins;
pub use raster::Image;
pub use rgb::Rgb;
