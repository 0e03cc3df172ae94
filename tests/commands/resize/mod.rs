//! `nyquist resize` as a user meets it.

mod light_and_sizes;
mod material;
mod what_is_carried_over;
mod what_is_refused;
