//! `nyquist resize` as a user meets it.
#![cfg(feature = "cli")]

mod light_and_sizes;
mod running;
mod what_is_carried_over;
mod what_is_refused;
