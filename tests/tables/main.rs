//! Tables of times and values: reading them, how they were sampled, what is in them, and values between their rows.

mod energies_are_where_the_signal_has_them;
mod least_squares_restore_irregular_samples;
mod lines_are_found_at_any_positions;
mod long_sums_keep_their_bound;
mod positions_are_told_apart;
mod predictions_come_true;
mod tables_are_read_as_they_were_meant;
mod values_between_samples_are_those_of_the_signal;
