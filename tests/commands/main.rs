//! The command line as a user meets it: exit codes, words, files.
#![cfg(feature = "cli")]

mod check_sound;
mod check_table;
mod exercise;
mod figures;
mod interpolate;
mod interruption;
mod pictures;
mod points;
mod render;
mod resample;
mod resize;
mod running;
mod spectrum_sound;
mod spectrum_table;
