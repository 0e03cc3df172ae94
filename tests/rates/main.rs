//! Conversion of sampling rates, against what it promises.

mod blocks_of_any_size_give_the_same_bits;
mod lengths_and_times_are_exact;
mod qualities_keep_their_promises;
mod responses_bound_what_conversions_do;
mod tones;
