//! Looking into sound: what is said of it is what is there, and what is predicted is what happens.

mod averaged_spectra_hold_the_power;
mod bands_and_floors_are_those_of_the_making;
mod blocks_of_any_size_say_the_same;
mod endings_are_told_apart;
mod material;
mod predictions_come_true;
mod spectrograms_keep_the_power;
