//! Figures beyond the lecture's slides: their ids start with `x`, so that they come last.

pub mod bandpass;
pub mod chirp;
pub mod cubics;
pub mod filters;
pub mod generalised;
pub mod irregular;
pub mod truncation;
