//! What is said of pictures, held against what is done to them.

mod bands_are_those_of_the_energy;
mod making;
mod moire_lands_where_it_was_predicted;
mod what_folds_is_what_was_predicted;
