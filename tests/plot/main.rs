//! The drawn pictures.
#![cfg(feature = "plot")]

mod colours;
mod formats;
mod pictures;
mod samples;
mod text;
