//! The drawn pictures.
#![cfg(feature = "plot")]

mod colours;
mod formats;
mod samples;
mod text;
