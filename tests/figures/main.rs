//! The figures asked for their data: everything claimed holds, and the numbers are the published ones.

mod claims_hold;
mod claims_hold_over_their_ranges;
mod numbers_formal;
